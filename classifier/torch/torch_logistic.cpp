#include "torch_particles.hpp"

namespace meniscus::torch_fit {
namespace {

MeniscusFit fit_logistic(const MeniscusTrainingSet& set) {
    const Standardization scale = standardization(set);
    // Keeps the weights finite where a line separates the classes without error.
    constexpr double ridge = 1e-6;
    auto weights = torch::zeros({2, 1}, torch::dtype(torch::kFloat64).requires_grad(true));
    auto bias = torch::zeros({1}, torch::dtype(torch::kFloat64).requires_grad(true));
    torch::optim::LBFGS optimizer({weights, bias}, torch::optim::LBFGSOptions(1)
                                                       .max_iter(200)
                                                       .tolerance_grad(1e-10)
                                                       .tolerance_change(1e-14)
                                                       .line_search_fn("strong_wolfe"));
    optimizer.step([&]() {
        optimizer.zero_grad();
        auto loss = ridge * (weights * weights).sum();
        loss.backward();
        double total = loss.item<double>();
        for_each_chunk(set, chunk_size, [&](Particles& chunk) {
            scale.apply(chunk);
            const Tensors tensors = tensors_of(chunk);
            const auto part = torch::binary_cross_entropy_with_logits(
                torch::matmul(tensors.features, weights) + bias, tensors.labels, tensors.weights,
                {}, at::Reduction::Sum);
            part.backward(); // gradients add up over chunks
            total += part.template item<double>();
        });
        return torch::full({1}, total, torch::kFloat64);
    });
    return line_of_separator(weights[0].item<double>(), weights[1].item<double>(),
                             bias.item<double>(), scale);
}

} // namespace
} // namespace meniscus::torch_fit

void meniscus_fit_logistic(const MeniscusTrainingSet* set, MeniscusFit* fit) {
    using namespace meniscus::torch_fit;
    *fit = guarded_line([&] { return fit_logistic(*set); });
}
