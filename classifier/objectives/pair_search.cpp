#include "pair_search.hpp"

#include "neyman_pearson.hpp"
#include "scene_errors.hpp"
#include "trainer.hpp"

#include <algorithm>

namespace meniscus {
namespace {

int sums_of(std::size_t feature, int dimension) {
    return dimension == 2 ? feature_list[feature].terms_in_2d : feature_list[feature].terms_in_3d;
}

PairResult result_of(const FeaturePair& pair, const Line& line, int dimension,
                     const std::vector<SceneErrors>& scenes) {
    PairResult result;
    result.features = pair;
    result.line = line;
    result.false_positive_rate = mean_false_positive_rate(scenes);
    result.sums = sums_of(pair.first, dimension) + sums_of(pair.second, dimension);
    ErrorCounts all;
    for (const SceneErrors& scene : scenes)
        all.add(scene);
    result.candidates = fraction(all.surface_particles - all.false_negatives + all.false_positives,
                                 all.surface_particles);
    return result;
}

PairResult try_pair(const FeaturePair& pair, const StatesOfPair& states_of, double label_threshold,
                    const Model* first, const std::vector<LabelledState>& first_states) {
    std::vector<LabelledState> states = states_of(pair);
    const int dimension = states.front().dimension;
    if (first == nullptr) {
        const Line line = min_false_positives(states, label_threshold);
        return result_of(pair, line, dimension, count_errors(states, line, label_threshold));
    }
    Model both = *first;
    const auto scenes = add_second_line(both, first_states, std::move(states));
    return result_of(pair, both.second->line, dimension, scenes);
}

} // namespace

std::vector<PairResult> search_pairs(const StatesOfPair& states_of, double label_threshold,
                                     const Model* first) {
    std::vector<LabelledState> first_states;
    if (first != nullptr)
        first_states = states_of(first->features);
    std::vector<PairResult> results;
    for (std::size_t a = 0; a < feature_count; ++a)
        for (std::size_t b = a + 1; b < feature_count; ++b) {
            // Fractions are x: lines are over the first, in units of the second.
            const bool turned = feature_list[b].is_fraction && !feature_list[a].is_fraction;
            const FeaturePair pair = turned ? FeaturePair{b, a} : FeaturePair{a, b};
            results.push_back(try_pair(pair, states_of, label_threshold, first, first_states));
        }
    std::stable_sort(results.begin(), results.end(), [](const auto& a, const auto& b) {
        return a.false_positive_rate < b.false_positive_rate;
    });
    return results;
}

} // namespace meniscus
