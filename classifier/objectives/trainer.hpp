// Training finds the half-plane of two features, y <= k x + d in the paper's plane, that takes no
// surface particle of the training set for an interior one (2020 paper, section 3.1). Objectives
// (objectives.hpp) differ in how they find k; all end with the same exact step, the shift
// (shift.hpp).
// --keep-k takes the slope of another model, for a new scene. Surface means lambda > label
// threshold. Particles without a counted neighbor are surface whatever the line, so they never
// constrain it.
#pragma once

#include "scene_errors.hpp"

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/classifier/training_set/campaign.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

struct TrainingOptions {
    std::string objective = "neyman-pearson"; ///< a name of objectives()
    double label_threshold =
        default_label_threshold; ///< surface means lambda above this, in [0, 1)
    std::optional<Model> keep_k; ///< keep this model's slope, shift only d
    std::uint64_t seed = 1;      ///< of `network`: initial weights and batches
};

/// Trains a model and fills in all that it says of its training set. Throws InputError where there
/// is no state, no surface or no interior particle, where states are of different kinds, where an
/// option is out of range, or where the objective is not for their features; FailureError where
/// libtorch is needed and not there, or where its fit finds no line.
Model train(const std::vector<LabelledState>& states, const TrainingOptions& options);

/// The same for a campaign, which is visited five times. Throws InputError, too, where the
/// objective needs all states in memory and they are not; on all ranks alike.
Model train(const Campaign& campaign, const TrainingOptions& options);

/// Adds a second line for what the model's first lets through, of the features of `second`: the
/// states that the first was trained on, in their order, with other features. It has the fewest
/// false positives of all that miss none of the surface (neyman_pearson.hpp); errors are counted
/// anew, and returned. Throws InputError where the model's line is not in the paper's plane, or
/// where the states are not the same.
std::vector<SceneErrors> add_second_line(Model& model, const std::vector<LabelledState>& first,
                                         std::vector<LabelledState> second);

/// The errors of a model of two lines on states of the features of its first and, in the same
/// order, of its second. Throws InputError where they are not the same states.
std::vector<SceneErrors> count_errors_of_both(const Model& model,
                                              const std::vector<LabelledState>& first,
                                              std::vector<LabelledState> second);

} // namespace meniscus
