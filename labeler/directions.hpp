// Sampling schemes: sequences of unit vectors that stand for the sphere around a particle (in two
// dimensions the circle, with z = 0). A scheme is one file with one function and one line in the
// list in directions.cpp. All arithmetic is addition, multiplication, division and square root,
// which every x86-64 machine rounds alike, so a scheme gives the same bits everywhere. Vectors are
// of length 1 within 1e-15: the test of coverage (coverage.hpp) takes that for granted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus {

/// A unit vector.
using Direction = std::array<double, 3>;

struct SamplingScheme {
    std::string name;
    /// True where each particle has its own directions, keyed by `particle`; false where one table
    /// serves all.
    bool per_particle;
    /// Fills `directions` for a dimension of 2 or 3.
    std::function<void(int dimension, std::uint64_t seed, std::uint64_t particle,
                       std::vector<Direction>& directions)>
        fill;
};

/// The schemes that have a name of their own. Beside them sampling_scheme() knows Halton's sequence
/// in any two prime bases, as halton-P-Q.
const std::vector<SamplingScheme>& sampling_schemes();

/// The names that sampling_scheme() knows, for messages and help.
std::string sampling_scheme_names();

/// The scheme of that name; throws InputError with the known names where there is none.
SamplingScheme sampling_scheme(std::string_view name);

/// Area-preserving map from the unit square to the sphere (u along the axis, v around it), from
/// [0, 1) to the circle by v alone in two dimensions.
Direction direction_from_square(int dimension, double u, double v);

/// The number in [0, 1) that 64 random bits stand for.
double random_fraction(std::uint64_t bits);

// The schemes themselves.
void fill_halton(int dimension, std::uint64_t seed, std::uint64_t particle,
                 std::vector<Direction>& directions);
void fill_random(int dimension, std::uint64_t seed, std::uint64_t particle,
                 std::vector<Direction>& directions);
void fill_table(int dimension, std::uint64_t seed, std::uint64_t particle,
                std::vector<Direction>& directions);
void fill_blue_noise(int dimension, std::uint64_t seed, std::uint64_t particle,
                     std::vector<Direction>& directions);

/// halton-P-Q, Halton's sequence in base P along the axis and base Q around it (on the circle base
/// P alone), for two different primes up to largest_halton_base; nothing for any other name.
std::optional<SamplingScheme> halton_scheme(std::string_view name);
inline constexpr std::uint64_t largest_halton_base = 31;

} // namespace meniscus
