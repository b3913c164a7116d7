#include "shift.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus {

double d_margin(double k, const FeaturePair& features) {
    return feature_list[features.first].float_error * std::abs(k) +
           feature_list[features.second].float_error;
}

namespace {

double min_d(const Campaign& campaign, double label_threshold, double k, bool above) {
    if (!std::isfinite(k))
        throw InputError("the slope k of a line must be finite, found " + number_text(k));
    const double side = above ? -1 : 1;
    std::vector<double> height = {-std::numeric_limits<double>::infinity()};
    campaign.visit([&](std::size_t /*place*/, const LabelledState& state) {
        for (std::size_t i = 0; i < state.size(); ++i)
            if (state.uncovered_fraction[i] > label_threshold && state.concerns_line(i))
                height[0] = std::max(height[0], side * (state.y(i) - k * state.x(i)));
    });
    campaign.ranks->max(height);
    if (std::isinf(height[0]))
        throw InputError("no surface particle has neighbors (uncovered fraction above " +
                         number_text(label_threshold) +
                         "), so nothing holds the line; give other files");
    return side * (height[0] + d_margin(k, campaign.heads.front().state.features));
}

} // namespace

double min_d(const std::vector<LabelledState>& states, double label_threshold, double k,
             bool above) {
    return min_d(campaign_of(states, label_threshold), label_threshold, k, above);
}

Line shift_line(const Campaign& campaign, double label_threshold, double k, bool above) {
    return {k, min_d(campaign, label_threshold, k, above), above};
}

Line shift_line(const std::vector<LabelledState>& states, double label_threshold, double k,
                bool above) {
    return {k, min_d(states, label_threshold, k, above), above};
}

} // namespace meniscus
