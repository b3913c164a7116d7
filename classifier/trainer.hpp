// Training finds the line y <= k x + d that takes no surface particle of the training set for an
// interior one (2020 paper, section 3.1). Every objective ends with the same exact step, the shift:
// for a slope k, the smallest d that leaves no false negative, plus a margin for rounding. They
// differ in how they find k:
//   neyman-pearson  k and d together, for the fewest false positives (neyman_pearson.hpp)
//   logistic        the slope of a linear separator, as in the paper (libtorch)
//   network         the slope of a small neural network's decision boundary (libtorch)
//   keep-k          the slope of another model, for a new scene
// Surface means lambda > label threshold. Particles without a counted neighbor are surface whatever
// the line, so they never constrain it.
#pragma once

#include "labelled_state.hpp"
#include "model.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

struct TrainingOptions {
    std::string objective = "neyman-pearson"; ///< one of training_objectives()
    double label_threshold = 0;               ///< surface means lambda above this, in [0, 1)
    std::optional<Model> keep_k;              ///< keep this model's slope, shift only d
    std::uint64_t seed = 1;                   ///< of `network`: initial weights and batches
};

/// The names that TrainingOptions::objective may have.
const std::vector<std::string>& training_objectives();

/// Trains a model and fills in all that it says of its training set. Throws InputError where there
/// is no state, no surface or no interior particle, where states are of different kinds, or where
/// an option is out of range; FailureError where libtorch is needed and not there, or where its
/// fit finds no line.
Model train(const std::vector<LabelledState>& states, const TrainingOptions& options);

/// Upper bounds, in neighbors, of what float adds to the error of k x + d: for each unit of slope
/// (the error of x), and whatever the slope (the rounding of d and of the sum). docs/training.md
/// derives them.
inline constexpr double margin_per_slope = 5e-6;
inline constexpr double margin_without_slope = 2.5e-4;

/// The part of d that is there for rounding, in neighbors, so that a host that works out the
/// features in float, in another order of summation, still misses no surface particle.
double d_margin(double k);

/// The smallest d for slope k that leaves no surface particle above the line, plus d_margin(k).
/// Throws InputError where k is not finite or where there is no surface particle with neighbors.
double smallest_d(const std::vector<LabelledState>& states, double label_threshold, double k);

/// The line of slope k with smallest_d.
Line shift_line(const std::vector<LabelledState>& states, double label_threshold, double k);

/// Predictions against labels, in particles.
struct SceneErrors {
    std::string scene;
    std::size_t particles = 0;
    std::size_t surface_particles = 0;
    std::size_t false_negatives = 0; ///< surface, taken for interior
    std::size_t false_positives = 0; ///< interior, taken for surface
};

/// Applies the line to every particle (predicts_surface). One entry a scene, in order
/// of first appearance.
std::vector<SceneErrors> count_errors(const std::vector<LabelledState>& states, const Line& line,
                                      double label_threshold);

/// What training minimizes: false positives over particles of each scene, averaged over scenes.
double mean_false_positive_rate(const std::vector<SceneErrors>& scenes);

} // namespace meniscus
