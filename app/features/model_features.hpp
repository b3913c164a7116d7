// The features that a model's lines are of, for one labelled state: what is drawn, on a page or in
// a plot.
#pragma once

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>
#include <meniscus/data/particles/snapshot.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace meniscus {

/// By their places in feature_list, one value a particle, worked out anew as the audit does; and
/// the paper's two, whose neighbor count tells who is alone. `state` is the snapshot's own.
std::map<std::size_t, std::vector<double>> feature_values(const Snapshot& snapshot,
                                                          const LabelledState& state,
                                                          const Model& model, int threads);

/// What a line of the model is scaled by for this state, feature by feature.
std::array<double, 2> feature_scales(const FeaturePair& pair, const LabelledState& state,
                                     const Model& model);

/// The snapshot's particles that the file calls valid, which are those of its labelled state.
std::vector<std::size_t> places_of_valid(const Snapshot& snapshot);

} // namespace meniscus
