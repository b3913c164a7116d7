#include "crown_shape.hpp"

#include "support/statistics.hpp"

#include <meniscus/runtime/math/angles.hpp>

#include <cmath>

namespace meniscus {

double crown_slope(const Positions& positions, double height) {
    Slope slope;
    for (const auto& place : positions)
        if (place[1] > height)
            slope.add(place[1], std::hypot(place[0], place[2]));
    return 90 - std::atan(slope.value()) * 180 / pi;
}

} // namespace meniscus
