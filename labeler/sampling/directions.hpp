// Sampling schemes: sequences of unit vectors that stand for the sphere around a particle (in two
// dimensions the circle, with z = 0). detail/sampling_schemes.hpp has the list of them. All
// arithmetic is addition, multiplication, division and square root, which every x86-64 machine
// rounds alike, so a scheme gives the same bits everywhere. Vectors are of length 1 within 1e-15:
// the test of coverage (monte_carlo/coverage.hpp) takes that for granted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
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

/// The names that sampling_scheme() knows, for messages and help.
std::string sampling_scheme_names();

/// The scheme of that name; throws InputError with the known names where there is none.
SamplingScheme sampling_scheme(std::string_view name);

/// Area-preserving map from the unit square to the sphere (u along the axis, v around it), from
/// [0, 1) to the circle by v alone in two dimensions.
Direction direction_from_square(int dimension, double u, double v);

/// The number in [0, 1) that 64 random bits stand for.
double random_fraction(std::uint64_t bits);

} // namespace meniscus
