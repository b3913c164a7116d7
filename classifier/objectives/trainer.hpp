// Training finds the half-plane of two features, y <= k x + d in the paper's plane, that takes no
// surface particle of the training set for an interior one (2020 paper, section 3.1). Objectives
// (objectives.hpp) differ in how they find k; all end with the same exact step, the shift
// (shift.hpp).
// --keep-k takes the slope of another model, for a new scene. Surface means lambda > label
// threshold. Particles without a counted neighbor are surface whatever the line, so they never
// constrain it.
#pragma once

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

struct TrainingOptions {
    std::string objective = "neyman-pearson"; ///< a name of objectives()
    double label_threshold = 0;               ///< surface means lambda above this, in [0, 1)
    std::optional<Model> keep_k;              ///< keep this model's slope, shift only d
    std::uint64_t seed = 1;                   ///< of `network`: initial weights and batches
};

/// Trains a model and fills in all that it says of its training set. Throws InputError where there
/// is no state, no surface or no interior particle, where states are of different kinds, where an
/// option is out of range, or where the objective is not for their features; FailureError where
/// libtorch is needed and not there, or where its fit finds no line.
Model train(const std::vector<LabelledState>& states, const TrainingOptions& options);

} // namespace meniscus
