#include "torch_particles.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <random>

namespace meniscus::torch_fit {
namespace {

constexpr std::size_t max_sample = std::size_t{1} << 19;
constexpr std::int64_t batch_size = 2048;
constexpr int batches = 4000;
// Two ReLU units die easily; of several starts most succeed.
constexpr int restarts = 5;
constexpr double learning_rate = 0.02;

/// Uniform numbers from 0 to below `bound`: std::uniform_int_distribution is another one with every
/// standard library.
std::size_t draw(std::mt19937_64& random, std::size_t bound) {
    return random() % bound;
}

/// At most about `limit` particles, the same number of each part (all of a smaller one), chosen by
/// the seed; their weights make up for those left out.
Particles sample(const MeniscusTrainingSet& set, std::size_t limit, std::mt19937_64& random) {
    const std::size_t quota = std::max<std::size_t>(limit / set.part_count, 1);
    Particles particles;
    for (std::size_t p = 0; p < set.part_count; ++p) {
        const MeniscusTrainingPart& part = set.parts[p];
        const std::size_t chosen = std::min(quota, part.particles);
        // Selection sampling (Knuth, The Art of Computer Programming 2, 3.4.2, algorithm S).
        std::size_t left = chosen;
        for (std::size_t i = 0; i < part.particles && left > 0; ++i)
            if (chosen == part.particles || draw(random, part.particles - i) < left) {
                --left;
                if (part.neighbor_count[i] != 0)
                    particles.add(part, i, set.label_threshold,
                                  part.weight * static_cast<double>(part.particles) /
                                      static_cast<double>(chosen));
            }
    }
    return particles;
}

/// Two inputs, two ReLU units, two sigmoid outputs: surface, and not surface.
struct Network : torch::nn::Module {
    Network() {
        register_module("hidden", hidden);
        register_module("output", output);
        to(torch::kFloat64);
    }

    torch::Tensor logits(const torch::Tensor& features) {
        return output->forward(torch::relu(hidden->forward(features)));
    }

    torch::nn::Linear hidden{2, 2};
    torch::nn::Linear output{2, 2};
};

/// Binary cross entropy of both outputs, each particle by its weight.
torch::Tensor loss_of(Network& network, const torch::Tensor& features, const torch::Tensor& labels,
                      const torch::Tensor& weights) {
    const auto targets = torch::cat({labels, 1 - labels}, 1);
    return torch::binary_cross_entropy_with_logits(
        network.logits(features), targets, weights.expand_as(targets), {}, at::Reduction::Mean);
}

torch::Tensor permutation(std::int64_t size, std::mt19937_64& random) {
    auto order = torch::arange(size, torch::kInt64);
    auto* const entries = order.data_ptr<std::int64_t>();
    for (std::int64_t i = size - 1; i > 0; --i)
        std::swap(entries[i], entries[draw(random, static_cast<std::size_t>(i) + 1)]);
    return order;
}

/// Trains one network from its initial weights; returns its loss on all data.
double train_network(Network& network, const Tensors& data, std::mt19937_64& random) {
    torch::optim::Adam optimizer(network.parameters(), torch::optim::AdamOptions(learning_rate));
    auto& options = static_cast<torch::optim::AdamOptions&>(optimizer.param_groups()[0].options());
    const std::int64_t size = data.labels.size(0);
    Tensors shuffled = data;
    std::int64_t begin = size;
    for (int batch = 0; batch < batches; ++batch) {
        if (begin >= size) {
            const auto order = permutation(size, random);
            shuffled = {data.features.index_select(0, order), data.labels.index_select(0, order),
                        data.weights.index_select(0, order)};
            begin = 0;
        }
        // Down to a hundredth, so that the last batches no longer move the boundary.
        options.lr(learning_rate * std::pow(0.01, batch / (batches - 1.0)));
        const std::int64_t length = std::min(batch_size, size - begin);
        optimizer.zero_grad();
        loss_of(network, shuffled.features.narrow(0, begin, length),
                shuffled.labels.narrow(0, begin, length), shuffled.weights.narrow(0, begin, length))
            .backward();
        optimizer.step();
        begin += length;
    }
    const torch::NoGradGuard no_gradient;
    return loss_of(network, data.features, data.labels, data.weights).item<double>();
}

/// How much rather surface than not a trained network takes a particle for, by its outputs before
/// the sigmoid: zero on the decision boundary. In plain numbers, because it is asked point by
/// point.
struct Decision {
    explicit Decision(const Network& network) {
        const auto hidden = network.hidden->weight;
        const auto output = network.output->weight;
        for (int unit = 0; unit < 2; ++unit) {
            x[unit] = hidden[unit][0].item<double>();
            y[unit] = hidden[unit][1].item<double>();
            bias[unit] = network.hidden->bias[unit].item<double>();
            output_weight[unit] = (output[0][unit] - output[1][unit]).item<double>();
        }
        output_bias = (network.output->bias[0] - network.output->bias[1]).item<double>();
    }

    [[nodiscard]] double operator()(double at_x, double at_y) const {
        double sum = output_bias;
        for (int unit = 0; unit < 2; ++unit)
            sum +=
                output_weight[unit] * std::max(0.0, x[unit] * at_x + y[unit] * at_y + bias[unit]);
        return sum;
    }

    double x[2];
    double y[2];
    double bias[2];
    double output_weight[2];
    double output_bias;
};

/// The trained network of least loss among several starts.
Decision best_decision(const Tensors& data, std::uint64_t seed) {
    double min_loss = std::numeric_limits<double>::infinity();
    std::optional<Decision> best;
    for (int start = 0; start < restarts; ++start) {
        std::mt19937_64 random(seed * restarts + static_cast<std::uint64_t>(start));
        torch::manual_seed(random());
        Network network;
        const double loss = train_network(network, data, random);
        if (loss < min_loss) {
            min_loss = loss;
            best.emplace(network);
        }
    }
    if (!best)
        throw std::runtime_error("no network converged; check the labels");
    return *best;
}

/// The y in [least, largest] at which the decision turns from surface to not surface, or NaN.
double boundary_at(const Decision& decision, double x, double min, double max) {
    if (!(decision(x, min) > 0 && decision(x, max) < 0))
        return std::numeric_limits<double>::quiet_NaN();
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = (min + max) / 2;
        (decision(x, middle) > 0 ? min : max) = middle;
    }
    return (min + max) / 2;
}

/// Sums of a weighted least-squares line y = slope x + constant.
struct LineSums {
    double weight = 0;
    double x = 0;
    double y = 0;
    double xx = 0;
    double xy = 0;

    void add(double at_x, double at_y, double with_weight) {
        weight += with_weight;
        x += with_weight * at_x;
        y += with_weight * at_y;
        xx += with_weight * at_x * at_x;
        xy += with_weight * at_x * at_y;
    }
};

/// How densely particles lie around a point: each counts by its weight, the less the farther.
double density_at(const Particles& particles, double x, double y) {
    // In standard deviations. The tail falls with the fourth power: where a gap separates the
    // classes no particle is near, and the nearest of the far ones still decide.
    constexpr double nearness = 0.25;
    double density = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double distance_x = (particles.features[2 * i] - x) / nearness;
        const double distance_y = (particles.features[2 * i + 1] - y) / nearness;
        const double closeness = 1 / (1 + distance_x * distance_x + distance_y * distance_y);
        density += particles.weights[i] * closeness * closeness;
    }
    return density;
}

/// The straight line closest to the decision boundary inside the range of the particles, in the
/// least-squares sense over y; points of the boundary count by the density of particles there. All
/// in standardized features.
MeniscusFit follow_boundary(const Decision& decision, const Particles& particles,
                            const Standardization& scale) {
    constexpr int columns = 256;
    double min[2] = {particles.features[0], particles.features[1]};
    double max[2] = {min[0], min[1]};
    for (std::size_t i = 0; i < particles.features.size(); ++i) {
        min[i % 2] = std::min(min[i % 2], particles.features[i]);
        max[i % 2] = std::max(max[i % 2], particles.features[i]);
    }
    LineSums sums;
    for (int column = 0; column < columns; ++column) {
        const double x = min[0] + (column + 0.5) / columns * (max[0] - min[0]);
        const double y = boundary_at(decision, x, min[1], max[1]);
        if (!std::isnan(y))
            sums.add(x, y, density_at(particles, x, y));
    }
    const double variance = sums.xx * sums.weight - sums.x * sums.x;
    if (!(variance > 0))
        throw std::runtime_error("the network's decision boundary does not pass through the "
                                 "particles; try another --seed or objective");
    const double slope = (sums.xy * sums.weight - sums.x * sums.y) / variance;
    return line_of_separator(slope, -1, (sums.y - slope * sums.x) / sums.weight, scale);
}

MeniscusFit fit_network(const MeniscusTrainingSet& set) {
    const Standardization scale = standardization(set);
    std::mt19937_64 random(set.seed);
    Particles particles = sample(set, max_sample, random);
    scale.apply(particles);
    const double mean_weight =
        std::accumulate(particles.weights.begin(), particles.weights.end(), 0.0) /
        static_cast<double>(particles.size());
    for (double& weight : particles.weights)
        weight /= mean_weight;
    return follow_boundary(best_decision(tensors_of(particles), set.seed), particles, scale);
}

} // namespace
} // namespace meniscus::torch_fit

void meniscus_fit_network(const MeniscusTrainingSet* set, MeniscusFit* fit) {
    using namespace meniscus::torch_fit;
    *fit = guarded_line([&] { return fit_network(*set); });
}
