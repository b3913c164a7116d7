// The errors of a line on labelled states, scene by scene: what training minimizes.
#pragma once

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/classifier/training_set/campaign.hpp>
#include <meniscus/classifier/training_set/error_counts.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <string>
#include <vector>

namespace meniscus {

struct SceneErrors : ErrorCounts {
    std::string scene;
};

/// Applies the line to every particle (predicts_surface). One entry a scene, in order of first
/// appearance.
std::vector<SceneErrors> count_errors(const std::vector<LabelledState>& states, const Line& line,
                                      double label_threshold);

/// The same for a campaign: numbers of particles alone, on all ranks.
std::vector<SceneErrors> count_errors(const Campaign& campaign, const Line& line,
                                      double label_threshold);

/// What training minimizes: false positives over particles of each scene, averaged over scenes.
double mean_false_positive_rate(const std::vector<SceneErrors>& scenes);

} // namespace meniscus
