// How both libtorch fits go through the particles. They stay in the caller's arrays: a fit takes
// them in chunks or draws a bounded sample, so that the tensors in memory do not grow with the
// training set. For the sources of the libtorch module only.
#pragma once

#include "torch_trainer.hpp"

#include <torch/torch.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

namespace meniscus::torch_fit {

/// Particles with neighbors, as rows (x, y), with label (1 surface, 0 interior) and weight.
struct Particles {
    std::vector<double> features;
    std::vector<double> labels;
    std::vector<double> weights;

    [[nodiscard]] std::size_t size() const { return labels.size(); }

    void add(const MeniscusTrainingPart& part, std::size_t i, double threshold, double weight) {
        features.push_back(part.mass_offset[i]);
        features.push_back(part.count_scale * part.neighbor_count[i]);
        labels.push_back(part.uncovered_fraction[i] > threshold ? 1 : 0);
        weights.push_back(weight);
    }

    void clear() {
        features.clear();
        labels.clear();
        weights.clear();
    }
};

/// The same as tensors of one row a particle.
struct Tensors {
    torch::Tensor features;
    torch::Tensor labels;
    torch::Tensor weights;
};

/// Tensors that share the particles' memory.
inline Tensors tensors_of(Particles& particles) {
    const auto rows = static_cast<std::int64_t>(particles.size());
    return {torch::from_blob(particles.features.data(), {rows, 2}, torch::kFloat64),
            torch::from_blob(particles.labels.data(), {rows, 1}, torch::kFloat64),
            torch::from_blob(particles.weights.data(), {rows, 1}, torch::kFloat64)};
}

/// Calls visit(Particles&) for all particles with neighbors, at most `limit` at a time.
template <class Visit>
void for_each_chunk(const MeniscusTrainingSet& set, std::size_t limit, Visit&& visit) {
    Particles chunk;
    for (std::size_t p = 0; p < set.part_count; ++p)
        for (std::size_t i = 0; i < set.parts[p].particles; ++i) {
            if (set.parts[p].neighbor_count[i] == 0)
                continue;
            chunk.add(set.parts[p], i, set.label_threshold, set.parts[p].weight);
            if (chunk.size() == limit) {
                visit(chunk);
                chunk.clear();
            }
        }
    if (chunk.size() != 0)
        visit(chunk);
}

/// Particles of a chunk: enough that libtorch's overhead is small beside the arithmetic.
inline constexpr std::size_t chunk_size = std::size_t{1} << 16;

/// Brings both features to mean 0 and deviation 1, which the optimizers need.
struct Standardization {
    double mean[2] = {0, 0};
    double deviation[2] = {1, 1};

    void apply(Particles& particles) const {
        for (std::size_t i = 0; i < particles.features.size(); ++i)
            particles.features[i] = (particles.features[i] - mean[i % 2]) / deviation[i % 2];
    }
};

/// By weighted mean and deviation over all particles with neighbors.
inline Standardization standardization(const MeniscusTrainingSet& set) {
    double total = 0;
    double sum[2] = {0, 0};
    double sum_of_squares[2] = {0, 0};
    for_each_chunk(set, chunk_size, [&](const Particles& chunk) {
        for (std::size_t i = 0; i < chunk.size(); ++i) {
            total += chunk.weights[i];
            for (std::size_t f = 0; f < 2; ++f) {
                const double value = chunk.features[2 * i + f];
                sum[f] += chunk.weights[i] * value;
                sum_of_squares[f] += chunk.weights[i] * value * value;
            }
        }
    });
    Standardization result;
    for (std::size_t f = 0; f < 2; ++f) {
        result.mean[f] = sum[f] / total;
        const double variance = sum_of_squares[f] / total - result.mean[f] * result.mean[f];
        result.deviation[f] = variance > 0 ? std::sqrt(variance) : 1;
    }
    return result;
}

/// The line on which a standardized x + b standardized y + c is zero. Surface lies below it, so b
/// must be negative.
inline MeniscusFit line_of_separator(double a, double b, double c, const Standardization& scale) {
    if (!(b < 0))
        throw std::runtime_error("the fit finds that surface particles have more neighbors than "
                                 "interior ones; check the labels");
    MeniscusFit fit{};
    const double slope = -a / b;
    fit.k = slope * scale.deviation[1] / scale.deviation[0];
    fit.d = scale.mean[1] - scale.deviation[1] * c / b - fit.k * scale.mean[0];
    return fit;
}

/// Runs a fit on one thread, because sums over several depend on their number; what it throws
/// becomes the message of the result.
template <class Result, class Fit>
Result guarded(Fit&& fit) {
    Result result{};
    try {
        at::set_num_threads(1);
        result = fit();
    } catch (const c10::Error& error) {
        std::snprintf(result.message, sizeof result.message, "%s", error.what_without_backtrace());
    } catch (const std::exception& error) {
        std::snprintf(result.message, sizeof result.message, "%s", error.what());
    }
    return result;
}

/// The same for the fit of a line, which must be finite.
template <class Fit>
MeniscusFit guarded_line(Fit&& fit) {
    return guarded<MeniscusFit>([&] {
        const MeniscusFit line = fit();
        if (!std::isfinite(line.k) || !std::isfinite(line.d))
            throw std::runtime_error("the fit does not converge; check the labels");
        return line;
    });
}

} // namespace meniscus::torch_fit
