// What the program and its libtorch module say to each other. Only the module links libtorch, and
// only training with `logistic` or `network` loads it (torch_plugin.hpp), because loading it takes
// longer than most of what the other verbs do. Hence plain structs and C functions: nothing of
// libtorch shows.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

/// One labelled state, not copied. Particles without neighbors take no part in a fit.
struct MeniscusTrainingPart {
    const double* mass_offset;        ///< feature x of each particle
    const double* neighbor_count;     ///< of each particle
    const double* uncovered_fraction; ///< lambda of each particle
    std::size_t particles;
    double count_scale; ///< feature y is this times the neighbor count
    double weight;      ///< of each particle in the loss
};

struct MeniscusTrainingSet {
    const MeniscusTrainingPart* parts;
    std::size_t part_count;
    double label_threshold; ///< surface means lambda above this
    std::uint64_t seed;
};

/// What a fit found: the slope of y = k x + d, or why there is none (one line).
struct MeniscusFit {
    double k;
    double d;
    char message[256]; ///< empty on success
};

/// Type of both fits; they never throw.
using MeniscusFitFunction = void(const MeniscusTrainingSet* set, MeniscusFit* fit);

/// Weighted logistic regression, the paper's linear separator: the line where p(surface) = 1/2.
__attribute__((visibility("default"))) MeniscusFitFunction meniscus_fit_logistic;

/// Two inputs, two ReLU units, two sigmoid outputs; the straight line that follows its decision
/// boundary best where the particles are.
__attribute__((visibility("default"))) MeniscusFitFunction meniscus_fit_network;
}
