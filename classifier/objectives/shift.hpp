// The shift that every objective ends with (2020 paper, section 3.1): for a slope k, the d that
// leaves no false negative and lets the least through, plus a margin for rounding.
#pragma once

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/classifier/training_set/campaign.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <vector>

namespace meniscus {

/// The part of d that is there for rounding, in units of the second feature, so that a host that
/// works out the features in float, in another order of summation, still misses no surface
/// particle: the bound of the first one's error for each unit of slope, and that of the second
/// whatever the slope. docs/training.md derives them.
double d_margin(double k, const FeaturePair& features = {});

/// The smallest d for slope k that leaves no surface particle above the line, plus d_margin(k);
/// with surface above the line, the largest that leaves none below it, less the margin. Throws
/// InputError where k is not finite or where there is no surface particle with neighbors.
double min_d(const std::vector<LabelledState>& states, double label_threshold, double k,
             bool above = false);

/// The line of slope k with min_d of a campaign's states; throws on all ranks alike.
Line shift_line(const Campaign& campaign, double label_threshold, double k, bool above = false);

/// The line of slope k with min_d.
Line shift_line(const std::vector<LabelledState>& states, double label_threshold, double k,
                bool above = false);

} // namespace meniscus
