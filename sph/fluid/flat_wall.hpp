// How much volume a boundary particle of a flat wall stands for. Walls are one layer, which has to
// stand for all that the kernel would find behind it; the volumes of walls of any shape are
// measured in this one (Akinci et al. 2012, eq. 4).
#pragma once

#include "kernels.hpp"

#include <cmath>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The sum of W over a lattice plane (in 2D a row) `layer` spacings away; `spacing` in support
/// radii.
template <class Real, int Dimension, class Kernel>
double layer_sum(const Kernel& kernel, double spacing, double layer) {
    const int reach = static_cast<int>(1 / spacing) + 1;
    const int reach_aside = Dimension == 3 ? reach : 0;
    double sum = 0;
    for (int x = -reach; x <= reach; ++x)
        for (int y = -reach_aside; y <= reach_aside; ++y) {
            const double squared = spacing * spacing * (x * x + y * y + layer * layer);
            sum += static_cast<double>(
                kernel.value(all_lanes<Lanes<Real>>(static_cast<Real>(squared)))[0]);
        }
    return sum;
}

/// The volume, in support radii to the power of Dimension, with which particles on a lattice one
/// spacing off the wall have the density that they have inside. For the cubic spline at two
/// spacings it is 0.70 / sum_k W_bk, the factor in use for it.
template <class Real, int Dimension, class Kernel>
Real flat_wall_volume(const Kernel& kernel, double spacing) {
    const int reach = static_cast<int>(1 / spacing) + 1;
    double behind = 0;
    for (int layer = 1; layer <= reach; ++layer)
        behind += layer_sum<Real, Dimension>(kernel, spacing, layer);
    return static_cast<Real>(std::pow(spacing, Dimension) * behind /
                             layer_sum<Real, Dimension>(kernel, spacing, 1));
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
