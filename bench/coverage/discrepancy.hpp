// How uneven a set of directions is: the difference between the share of directions that a part of
// the circle or sphere holds and that part's share of the whole, over many parts.
#pragma once

#include <meniscus/labeler/sampling/directions.hpp>

namespace meniscus {

/// Largest difference over the arcs of the circle that begin at the x axis, exactly.
double star_discrepancy(const std::vector<Direction>& directions);

/// Largest difference over a fixed million of spherical caps: 1000 random centers, 1000 heights.
double cap_discrepancy(const std::vector<Direction>& directions);

/// Root mean square of the difference over all spherical caps, centers and areas evenly weighted,
/// exactly, by Stolarsky's invariance principle (1973). Takes time with the square of the number of
/// directions.
double mean_cap_discrepancy(const std::vector<Direction>& directions);

} // namespace meniscus
