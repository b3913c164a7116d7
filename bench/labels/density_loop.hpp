// The density loop that the classifier is fused into for the benchmark, as an SPH code has it:
// neighbor lists, cubic spline kernel (Monaghan 1992), mass of each neighbor.
#pragma once

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/runtime/coefficients/surface_3d.hpp>
#include <meniscus/runtime/features/classifier.hpp>
#include <meniscus/runtime/math/cubic_spline.hpp>

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
    const Real scale = static_cast<Real>(cubic_spline_scale<3>) * inverse * inverse * inverse;
    const auto range = neighbor_range<Real>(support_radius, Surface3D::radius_ratio);
    const auto line = surface_line<Surface3D, Real>(2);
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
            density += masses[j] * scale * cubic_spline(q);
        }
        densities[i] = density;
        if constexpr (fused != Fused::nothing)
            surface[i] = static_cast<std::uint8_t>(is_surface(sum, line, support_radius));
    }
}

} // namespace meniscus
