// The line with the fewest false positives among all lines without a false negative, exactly. For a
// slope k the best d is the one of the shift, so the line rests on a vertex of the convex hull of
// the surface particles, and only k remains to be chosen. Each interior particle is told apart on
// one open interval of slopes: between the two tangents from it to that hull. The best slope lies
// where most of these intervals overlap, each weighted so that all scenes weigh the same.
// Sweeping over the interval ends finds it; no descent, no grid (detail/best_slope.hpp).
//
// In the paper's plane surface lies below a line that rises (a particle farther off its neighbors'
// center of mass is never less likely to be surface). In any other plane lines fall too, and
// surface may lie above them: the same search in the plane and its three reflections.
#pragma once

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/classifier/training_set/campaign.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <vector>

namespace meniscus {

/// Slopes of the search reach to this on either side: there the rounding margin of d alone has
/// grown to 1, in the paper's plane a whole neighbor, that is, the line is as good as vertical.
double max_slope(const FeaturePair& features = {});

/// The half-plane of least mean over scenes of (false positives / particles) subject to no false
/// negative, d_margin(k) included in d. Where several slopes are equally good, the middle of the
/// widest interval of them, by angle in a plane in which both features span about one. Visits the
/// states four times (thirteen where surface may lie on any side) and keeps some ten MiB, and the
/// slopes near the best one. States must be of one kind. Throws InputError where no surface
/// particle has neighbors, or where there is no interior particle; on all ranks alike.
Line best_line(const Campaign& campaign, double label_threshold);

/// The same for states in memory.
Line min_false_positives(const std::vector<LabelledState>& states, double label_threshold);

} // namespace meniscus
