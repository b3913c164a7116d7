// Whether the paper's two features are the best ones to draw a line in: all pairs of
// particle_features.hpp by the false positives of the best line without a false negative, by what
// that line misses in a scene that it was not trained on, and by their cost. Beside them each
// feature with a threshold alone, and in the paper's own plane what no line could do better: a
// threshold of the offset for each neighbor count.
#pragma once

#include "support/fluid_state.hpp"
#include "support/timing.hpp"

namespace meniscus {

struct FeaturePairOptions {
    double label_threshold = 0; ///< surface means that more than this is uncovered, in [0, 1)
    int threads = 1;            ///< that train; times are of one
    TimingOptions timing;
};

/// Columns: features, kind ("line", "threshold" or "table"), false_positive_rate (percent of all
/// particles, mean over scenes, of the line trained on all states, which misses none),
/// left_out_false_negatives (particles, added up over lines trained on all scenes but one and
/// judged on that one; empty where there is only one scene), left_out_miss_rate (they in percent of
/// the surface particles of their scene, mean over scenes), left_out_false_positive_rate (as the
/// first), time (ns a particle for both features over given lists, in float; empty for tables,
/// which cost what the paper's pair does), best (of those with less false positives, less missed in
/// left-out scenes and less time). Scenes weigh the same. Particles without a counted neighbor are
/// surface by any line. States must all be of the same dimension. Throws InputError where the
/// surface particles do not span a plane of features, in all scenes but one already.
Table feature_pairs(const std::vector<FluidState<float>>& states,
                    const FeaturePairOptions& options);

} // namespace meniscus
