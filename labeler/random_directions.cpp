// Run-time random directions: each particle draws its own, independent and evenly distributed, from
// a stream keyed by seed and particle (2020 paper, section 3.2: the plain Monte Carlo scheme).
#include "directions.hpp"

#include <cmath>

namespace meniscus {
namespace {

/// Random numbers in [-1, 1) from a SplitMix64 stream.
struct RandomStream {
    std::uint64_t state;

    double next() {
        const std::uint64_t bits = mix_bits(state);
        state += 0x9e3779b97f4a7c15ULL;
        return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
    }
};

/// A point evenly distributed in the unit disc without its center, and its squared radius.
std::array<double, 3> point_in_disc(RandomStream& stream) {
    for (;;) {
        const double x = stream.next();
        const double y = stream.next();
        const double square = x * x + y * y;
        if (square < 1 && square > 1e-30)
            return {x, y, square};
    }
}

} // namespace

void fill_random(int dimension, std::uint64_t seed, std::uint64_t particle,
                 std::vector<Direction>& directions) {
    RandomStream stream{mix_bits(mix_bits(seed) ^ particle)};
    for (Direction& direction : directions) {
        const auto [x, y, square] = point_in_disc(stream);
        if (dimension == 2) {
            const double radius = std::sqrt(square);
            direction = {x / radius, y / radius, 0};
        } else { // Marsaglia 1972
            const double scale = 2 * std::sqrt(1 - square);
            direction = {x * scale, y * scale, 1 - 2 * square};
        }
    }
}

} // namespace meniscus
