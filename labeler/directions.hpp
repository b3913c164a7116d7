// Sampling schemes: sequences of unit vectors that stand for the sphere around a particle (in two
// dimensions the circle, with z = 0). A scheme is one file with one function and one line in the
// list in directions.cpp. All arithmetic is addition, multiplication, division and square root,
// which every x86-64 machine rounds alike, so a scheme gives the same bits everywhere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus {

/// A unit vector.
using Direction = std::array<double, 3>;

struct SamplingScheme {
    std::string_view name;
    /// True where each particle draws its own directions, keyed by `particle`; false where one
    /// table serves all.
    bool per_particle;
    /// Fills `directions` for a dimension of 2 or 3.
    void (*fill)(int dimension, std::uint64_t seed, std::uint64_t particle,
                 std::vector<Direction>& directions);
};

/// All schemes.
const std::vector<SamplingScheme>& sampling_schemes();

/// The scheme of that name; throws InputError with the known names where there is none.
const SamplingScheme& sampling_scheme(std::string_view name);

/// Area-preserving map from the unit square to the sphere (u along the axis, v around it), from
/// [0, 1) to the circle by v alone in two dimensions.
Direction direction_from_square(int dimension, double u, double v);

/// Well mixed 64 bits of a number (SplitMix64's output function, Steele et al. 2014).
std::uint64_t mix_bits(std::uint64_t value);

// The schemes themselves.
void fill_halton(int dimension, std::uint64_t seed, std::uint64_t particle,
                 std::vector<Direction>& directions);
void fill_random(int dimension, std::uint64_t seed, std::uint64_t particle,
                 std::vector<Direction>& directions);

} // namespace meniscus
