// The density loop that the classifier is fused into for the benchmark, as an SPH code has it:
// neighbor lists, cubic spline kernel (Monaghan 1992), mass of each neighbor.
#pragma once

#include <meniscus/data/neighbor_search.hpp>
#include <meniscus/runtime/classifier.hpp>
#include <meniscus/runtime/surface_coefficients.hpp>

#include <array>
#include <cmath>

namespace meniscus {

enum class Fused { nothing, equal_masses, masses };

/// Densities (kg/m^3), and with a fused classifier the class of each particle. Without, the loop is
/// the same less the calls.
template <class Real, Fused fused>
void density_loop(const Real* positions, const Real* masses, const NeighborLists& lists,
                  std::size_t count, Real support_radius, Real* densities, std::uint8_t* surface) {
    const Real inverse = 1 / support_radius;
    const Real scale = static_cast<Real>(8 / 3.14159265358979) * inverse * inverse * inverse;
    const auto range = neighbor_range<Real>(support_radius, SurfaceCoefficients::radius_ratio);
    const auto line = surface_line<SurfaceCoefficients, Real>();
    for (std::size_t i = 0; i < count; ++i) {
        Real density = scale * masses[i];
        FeatureSum<Real, 3> sum;
        for (std::size_t n = lists.offsets[i]; n < lists.offsets[i + 1]; ++n) {
            const std::size_t j = lists.neighbors[n];
            const std::array<Real, 3> x = {positions[3 * j] - positions[3 * i],
                                           positions[3 * j + 1] - positions[3 * i + 1],
                                           positions[3 * j + 2] - positions[3 * i + 2]};
            const Real distance_squared = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
            if constexpr (fused == Fused::equal_masses)
                sum.add_equal_mass(x, distance_squared, range);
            if constexpr (fused == Fused::masses)
                sum.add(x, distance_squared, masses[j], range);
            const Real q = std::sqrt(distance_squared) * inverse;
            Real kernel = 0;
            if (q <= Real(0.5))
                kernel = 6 * q * q * (q - 1) + 1;
            else if (q < 1)
                kernel = 2 * (1 - q) * (1 - q) * (1 - q);
            density += masses[j] * scale * kernel;
        }
        densities[i] = density;
        if constexpr (fused != Fused::nothing)
            surface[i] = static_cast<std::uint8_t>(is_surface(sum, line, support_radius));
    }
}

} // namespace meniscus
