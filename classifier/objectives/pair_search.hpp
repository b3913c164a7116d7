// Which two features a line is best in: the line of each pair of the list, with what it lets
// through and how many sums a neighbor adds to. For a first line, or for one that follows it.
#pragma once

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <functional>
#include <vector>

namespace meniscus {

struct PairResult {
    FeaturePair features;
    Line line;
    double false_positive_rate = 0; ///< of all particles, mean over scenes
    double candidates = 0;          ///< for each surface particle
    int sums = 0;                   ///< that a neighbor adds to, of both features
};

/// The labelled states that a line is trained on, with these features.
using StatesOfPair = std::function<std::vector<LabelledState>(const FeaturePair&)>;

/// All pairs, the fewest false positives first, without a false negative. Where `first` is not
/// nullptr, of a second line for what its line lets through. Throws InputError as
/// min_false_positives and add_second_line do, and where a feature is not stored.
std::vector<PairResult> search_pairs(const StatesOfPair& states_of, double label_threshold,
                                     const Model* first);

} // namespace meniscus
