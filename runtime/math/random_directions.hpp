// Random directions, evenly distributed over the sphere (in two dimensions the circle): points of
// the unit disc, drawn by rejection, projected to the circle or mapped to the sphere (Marsaglia
// 1972). The points have integer coordinates, so that whether one lies in the disc is decided
// exactly, and what follows rounds alike everywhere: the same bits on every x86-64, even where the
// compiler contracts multiplications and additions. Only -ffast-math may change the last ones.
#pragma once

#include "../simd/instruction_set.hpp"
#include "coordinates.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Well mixed 64 bits of a number (SplitMix64's output function, Steele et al. 2014).
MENISCUS_HOST_DEVICE constexpr std::uint64_t mix_bits(std::uint64_t value) {
    value += 0x9e3779b97f4a7c15ULL;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
    value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
    return value ^ (value >> 31);
}

/// A stream of independent directions. Streams of different keys are independent of each other.
class RandomDirections {
public:
    /// `key` and `subkey` say which stream, for instance a seed and a particle's id.
    RandomDirections(std::uint64_t key, std::uint64_t subkey)
        : state_(mix_bits(mix_bits(key) ^ subkey)) {}

    /// The next unit vector, in two or three dimensions.
    template <int Dimension>
    Coordinates<double, Dimension> next() {
        static_assert(Dimension == 2 || Dimension == 3);
        const DiscPoint point = next_in_disc();
        const auto x = static_cast<double>(point.x);
        const auto y = static_cast<double>(point.y);
        const auto square = static_cast<double>(point.square);
        if constexpr (Dimension == 2) {
            const double radius = std::sqrt(square);
            return {x / radius, y / radius};
        } else {
            const double part = square * 0x1p-62; // of the disc's squared radius
            const double scale = std::sqrt(1 - part) * 0x1p-30;
            return {x * scale, y * scale, 1 - 2 * part};
        }
    }

private:
    struct DiscPoint {
        std::int64_t x, y, square; ///< square = x * x + y * y
    };

    /// Evenly distributed in the disc of radius 2^31, without its center.
    DiscPoint next_in_disc() {
        for (;;) {
            const std::uint64_t bits = mix_bits(state_);
            state_ += 0x9e3779b97f4a7c15ULL;
            const auto x = static_cast<std::int64_t>(bits >> 32) - 0x80000000LL;
            const auto y = static_cast<std::int64_t>(bits & 0xffffffffULL) - 0x80000000LL;
            const std::uint64_t square = // up to 2^63
                static_cast<std::uint64_t>(x * x) + static_cast<std::uint64_t>(y * y);
            if (square != 0 && square < 1ULL << 62)
                return {x, y, static_cast<std::int64_t>(square)};
        }
    }

    std::uint64_t state_;
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
