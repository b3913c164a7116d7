#include "torch_particles.hpp"

namespace meniscus::torch_fit {
namespace {

/// Mean over each group of the rows of `values`, which are weighted already.
torch::Tensor group_means(const torch::Tensor& values, const torch::Tensor& group,
                          std::int64_t groups) {
    return torch::zeros({groups, values.size(1)}, values.options()).index_add(0, group, values);
}

/// The loss is quadratic in the coefficients: the sum over groups of variance and penalized squared
/// mean, which are least squares of deviations from the means and of the means.
MeniscusCurvatureFit fit_curvature(const MeniscusCurvatureSet& set) {
    const auto rows = static_cast<std::int64_t>(set.rows);
    const auto terms = static_cast<std::int64_t>(set.terms);
    const auto real = torch::dtype(torch::kFloat64);
    const auto features = torch::from_blob(const_cast<double*>(set.features), {rows, terms}, real);
    const auto truth = torch::from_blob(const_cast<double*>(set.truth), {rows, 1}, real);
    const auto weight = torch::from_blob(const_cast<double*>(set.weight), {rows, 1}, real);
    const auto group =
        torch::from_blob(const_cast<std::int64_t*>(set.group), {rows}, torch::dtype(torch::kInt64));
    const auto groups = static_cast<std::int64_t>(set.groups);
    const auto share = weight / group_means(weight, group, groups).index_select(0, group);
    const auto all = torch::cat({features, truth}, 1);
    const auto means = group_means(share * all, group, groups);
    const auto deviations = share.sqrt() * (all - means.index_select(0, group));
    const auto system = torch::cat({deviations, std::sqrt(set.bias_penalty) * means}, 0);
    const auto solution =
        std::get<0>(torch::linalg_lstsq(system.narrow(1, 0, terms), system.narrow(1, terms, 1)));
    MeniscusCurvatureFit fit{};
    for (std::int64_t term = 0; term < terms; ++term) {
        fit.coefficients[term] = solution[term][0].item<double>();
        if (!std::isfinite(fit.coefficients[term]))
            throw std::runtime_error("the clouds do not tell the terms apart; give more shapes");
    }
    return fit;
}

} // namespace
} // namespace meniscus::torch_fit

void meniscus_fit_curvature(const MeniscusCurvatureSet* set, MeniscusCurvatureFit* fit) {
    using namespace meniscus::torch_fit;
    *fit = guarded<MeniscusCurvatureFit>([&] { return fit_curvature(*set); });
}
