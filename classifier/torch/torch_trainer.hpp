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

/// Rows of the fit of a curvature map, not copied: terms and truth of each sample, both over the
/// scale of its group, and its weight within it.
struct MeniscusCurvatureSet {
    const double* features; ///< rows * terms, row by row
    const double* truth;
    const double* weight;
    const std::int64_t* group; ///< from 0 to groups - 1, each at least once
    std::size_t rows;
    std::size_t terms; ///< at most 4
    std::size_t groups;
    double bias_penalty; ///< of a group's squared mean error, against its variance
};

struct MeniscusCurvatureFit {
    double coefficients[4]; ///< of the terms
    char message[256];      ///< empty on success
};

/// Type of the fits of lines; no fit throws.
using MeniscusFitFunction = void(const MeniscusTrainingSet* set, MeniscusFit* fit);

/// Weighted logistic regression, the paper's linear separator: the line where p(surface) = 1/2.
__attribute__((visibility("default"))) MeniscusFitFunction meniscus_fit_logistic;

/// Two inputs, two ReLU units, two sigmoid outputs; the straight line that follows its decision
/// boundary best where the particles are.
__attribute__((visibility("default"))) MeniscusFitFunction meniscus_fit_network;

/// Least squares of each group's variance and penalized mean error.
__attribute__((visibility("default"))) void meniscus_fit_curvature(const MeniscusCurvatureSet* set,
                                                                   MeniscusCurvatureFit* fit);
}
