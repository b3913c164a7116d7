// The slope at which most weight is told apart, from the slopes at which particles begin and cease
// to be. Sorting all of these takes memory for all; here they are counted in bins first, which
// bounds what any slope of a bin can have, and only those of bins that may hold the best one are
// visited again and sorted. The answer is that of sorting all, to the bit.
#pragma once

#include <meniscus/data/ranks/ranks.hpp>

#include <cmath>
#include <cstdint>
#include <functional>

namespace meniscus {

/// A slope at which a particle begins (positive weight) or ceases to be told apart.
struct SlopeEvent {
    double k; ///< above 0
    std::int64_t weight;
};

/// A slope in the middle of the widest of the best intervals between events.
struct SlopeChoice {
    std::int64_t weight = -1; ///< told apart
    double begin = 0;         ///< of the interval, as an angle
    double width = 0;

    [[nodiscard]] double slope(double unit) const { return std::tan(begin + width / 2) * unit; }
};

/// Visits this rank's events, in any order, and returns the weight of what is told apart from slope
/// 0 on. Called twice, with the same events.
using VisitEvents = std::function<std::int64_t(const std::function<void(const SlopeEvent&)>&)>;

/// The best slope from 0 to max_slope; angles are those of k / slope_unit. `particles` of all ranks
/// says how many bins are worth their memory. Throws FailureError
/// where more events than memory should be taken for lie so close to the best slope that they have
/// to be sorted.
SlopeChoice best_slope(const VisitEvents& visit_events, std::uint64_t particles, double max_slope,
                       double slope_unit, Ranks& ranks);

} // namespace meniscus
