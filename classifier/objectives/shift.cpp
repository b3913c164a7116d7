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

double min_d(const std::vector<LabelledState>& states, double label_threshold, double k,
             bool above) {
    if (!std::isfinite(k))
        throw InputError("the slope k of a line must be finite, found " + number_text(k));
    const double side = above ? -1 : 1;
    double height = -std::numeric_limits<double>::infinity();
    for (const LabelledState& state : states)
        for (std::size_t i = 0; i < state.size(); ++i)
            if (state.uncovered_fraction[i] > label_threshold && state.concerns_line(i))
                height = std::max(height, side * (state.y(i) - k * state.x(i)));
    if (std::isinf(height))
        throw InputError("no surface particle has neighbors (uncovered fraction above " +
                         number_text(label_threshold) +
                         "), so nothing holds the line; give other files");
    return side * (height + d_margin(k, states.front().features));
}

Line shift_line(const std::vector<LabelledState>& states, double label_threshold, double k,
                bool above) {
    return {k, min_d(states, label_threshold, k, above), above};
}

} // namespace meniscus
