#include "directions.hpp"

#include <meniscus/runtime/math/angles.hpp>

#include <cmath>

namespace meniscus {

Direction direction_from_square(int dimension, double u, double v) {
    const auto [cosine, sine] = cosine_and_sine_of_turn(v);
    if (dimension == 2)
        return {cosine, sine, 0};
    const double z = 1 - 2 * u;
    const double radius = std::sqrt(1 - z * z);
    return {radius * cosine, radius * sine, z};
}

double random_fraction(std::uint64_t bits) {
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

} // namespace meniscus
