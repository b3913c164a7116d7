// How fast an iteration for pressures may go. On a lattice at rest the pressures of a wave of wave
// vector k change the compression by |S(k)|^2 times what they are, S(k) = sum_j grad W_ij sin(k .
// x_ij), where the diagonal of the system says sum_j |grad W_ij|^2. The ratio of the two is largest
// for long waves, and the larger, the more neighbors there are: from 2.8 at a support of 2 spacings
// in three dimensions to 20 at 4.2. Relaxed Jacobi iterations grow without end where their factor
// times it is above 2.
#pragma once

#include <meniscus/sph/fluid/fluid.hpp>

#include <meniscus/runtime/math/angles.hpp>

#include <array>
#include <cmath>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Calls visit(x, grad W / x factor) with each neighbor of a particle on a lattice: its step in
/// support radii, and what makes of it the kernel's gradient.
template <class Real, int Dimension, class Kernel, class Visit>
void visit_lattice(const Kernel& kernel, double spacing, const Visit& visit) {
    const int reach = static_cast<int>(1 / spacing) + 1;
    const int depth = Dimension == 3 ? reach : 0;
    for (int x = -reach; x <= reach; ++x)
        for (int y = -reach; y <= reach; ++y)
            for (int z = -depth; z <= depth; ++z) {
                const std::array<double, 3> step = {spacing * x, spacing * y, spacing * z};
                const double squared = step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
                visit(step, static_cast<double>(kernel.gradient(
                                all_lanes<Lanes<Real>>(static_cast<Real>(squared)))[0]));
            }
}

/// sum_j |grad W_ij|^2 of a particle inside a lattice at rest; `spacing` in support radii.
template <class Real, int Dimension, class Kernel>
double lattice_gradients(const Kernel& kernel, double spacing) {
    double sum = 0;
    visit_lattice<Real, Dimension>(kernel, spacing, [&](const auto& step, double slope) {
        sum += slope * slope * (step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
    });
    return sum;
}

/// |S(k)|^2 along the diagonal of the first `axes` axes, `phase` being that from particle to
/// particle along each.
template <class Real, int Dimension, class Kernel>
double lattice_wave(const Kernel& kernel, double spacing, int axes, double phase) {
    std::array<double, 3> sum{};
    visit_lattice<Real, Dimension>(kernel, spacing, [&](const auto& step, double slope) {
        double turn = 0;
        for (int axis = 0; axis < axes; ++axis)
            turn += phase / spacing * step[axis];
        for (int axis = 0; axis < Dimension; ++axis)
            sum[axis] += slope * std::sin(turn) * step[axis];
    });
    return sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2];
}

/// The share of a solver's relaxation that is stable for the fluid's kernel and spacing: 1 up to a
/// ratio of 3, below which one half has been safe, less beyond.
template <class Real, int Dimension>
Real stable_share(const Fluid<Real, Dimension>& fluid) {
    constexpr double safe = 3;
    constexpr int waves = 32;
    return with_kernel<Real, Dimension>(fluid.kernel, [&](auto kernel) {
        double largest = 0;
        for (int axes = 1; axes <= Dimension; ++axes)
            for (int wave = 1; wave <= waves; ++wave)
                largest = std::max(largest, lattice_wave<Real, Dimension>(kernel, fluid.spacing,
                                                                          axes, pi * wave / waves));
        const double ratio = largest / lattice_gradients<Real, Dimension>(kernel, fluid.spacing);
        return static_cast<Real>(std::min(1.0, safe / ratio));
    });
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
