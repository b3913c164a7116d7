// Support radii, one for all particles or one for each. Where they differ (the 2020 paper's outlook
// on multi-scale SPH leaves it open), every pair is measured in its own mean radius
//     h_ij = (h_i + h_j) / 2:
// particles closer than h_ij are neighbors, and a neighbor covers the cap that it would in a
// uniform fluid of radius h_ij, r1 = h_ij and r2 = 0.8 h_ij. Caps then stay smaller than half the
// sphere whatever the radii, and where all are equal nothing changes. A neighbor stands for (h_j /
// h_ij)^D particles of the pair's mean size: half a ball of either resolution then counts the same.
#pragma once

#include "../simd/instruction_set.hpp"

#include <cstddef>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The same radius h (m, positive) for all.
template <class Real>
struct UniformRadius {
    static constexpr bool varies = false;

    Real radius;
    Real inverse = 1 / radius;

    [[nodiscard]] MENISCUS_HOST_DEVICE Real of(std::size_t /*particle*/) const { return radius; }
    /// 1 / h_ij in 1/m.
    [[nodiscard]] MENISCUS_HOST_DEVICE Real inverse_of_pair(std::size_t /*i*/,
                                                            std::size_t /*j*/) const {
        return inverse;
    }
};

/// One radius a particle (m, positive), which every j that a view delivers must have.
template <class Real>
struct VaryingRadii {
    static constexpr bool varies = true;

    const Real* radii;

    [[nodiscard]] MENISCUS_HOST_DEVICE Real of(std::size_t particle) const {
        return radii[particle];
    }
    [[nodiscard]] MENISCUS_HOST_DEVICE Real inverse_of_pair(std::size_t i, std::size_t j) const {
        return 2 / (radii[i] + radii[j]);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
