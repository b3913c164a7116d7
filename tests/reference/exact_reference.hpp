// Exact coverage the plain way: on the circle of each cap the intervals that the others cover, by
// their angles, sorted and merged. One cap at a time in double, without vectors, cells or care for
// what nearly coincides: the oracle of the tests and the baseline of the benchmark.
#pragma once

#include <meniscus/labeler/sampling/directions.hpp>

#include <vector>

namespace meniscus {

/// lambda of a sphere of radius 1 with neighbors' spheres of radius `radius_ratio` at
/// `displacements` (in units of the support radius). Good to about 1e-9 where no circles touch, cut
/// in one point with a third, or coincide; anything may happen where they do.
double uncovered_fraction_reference(const std::vector<Direction>& displacements,
                                    double radius_ratio);

} // namespace meniscus
