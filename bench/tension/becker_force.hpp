// The pairwise force of Becker and Teschner 2007, which surface tension is compared with:
//     f_i = -kappa sum_j m_j W(|x_ij|) x_ij
// over all neighbors of all particles, W the cubic spline. As fast as the runtime's own kernels:
// the neighbors of a particle are fetched into a row, and the row is worked on a vector at a time.
#pragma once

#include <meniscus/runtime/neighbors/parallel_loop.hpp>
#include <meniscus/runtime/simd/vector.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace meniscus {

/// Neighbors of one particle, in units of the support radius. One for each concurrent caller.
struct alignas(128) BeckerRow { // apart, since two threads write to neighbors
    std::vector<float> x, y, z;
    std::size_t count = 0;

    void add(const std::array<float, 3>& displacement, float inverse_radius) {
        if (count + wide_float_count >= x.size())
            for (auto* values : {&x, &y, &z})
                values->resize(2 * count + 64);
        x[count] = displacement[0] * inverse_radius;
        y[count] = displacement[1] * inverse_radius;
        z[count++] = displacement[2] * inverse_radius;
    }

    /// Sum of W(|x|) x without the kernel's normalization. Beyond the support W is 0.
    [[nodiscard]] std::array<float, 3> weighted_sum() {
        for (std::size_t n = count; n < count + wide_float_count; ++n)
            x[n] = y[n] = z[n] = 0;
        WideFloat sum_x = {}, sum_y = {}, sum_z = {};
        for (std::size_t n = 0; n < count; n += wide_float_count) {
            const WideFloat along = load<WideFloat>(&x[n]);
            const WideFloat aside = load<WideFloat>(&y[n]);
            const WideFloat up = load<WideFloat>(&z[n]);
            const WideFloat q = square_root(along * along + aside * aside + up * up);
            const WideFloat rest = larger(1 - q, WideFloat{});
            const WideFloat inner = 1 - 6 * q * q * (1 - q);
            const WideFloat weight = q <= 0.5F ? inner : 2 * rest * rest * rest;
            sum_x += weight * along;
            sum_y += weight * aside;
            sum_z += weight * up;
        }
        std::array<float, 3> sum = {0, 0, 0};
        for (std::size_t lane = 0; lane < wide_float_count; ++lane) {
            sum[0] += sum_x[lane];
            sum[1] += sum_y[lane];
            sum[2] += sum_z[lane];
        }
        return sum;
    }
};

/// Sets the force on each of `count` particles, of the same mass; `strength` is kappa times that
/// mass and the kernel's normalization. `rows` has one entry a worker.
template <class View, class Loop>
void find_becker_force(const View& view, std::size_t count, float support_radius, float strength,
                       const Loop& loop, BeckerRow* rows,
                       std::vector<std::array<float, 3>>& force) {
    force.resize(count);
    const float inverse_radius = 1 / support_radius;
    loop(count, [&](std::size_t begin, std::size_t end, int worker) {
        BeckerRow& row = rows[worker];
        for (std::size_t i = begin; i < end; ++i) {
            row.count = 0;
            view(i, [&](std::size_t /*j*/, const std::array<float, 3>& displacement, float) {
                row.add(displacement, inverse_radius);
            });
            if (row.x.empty())
                row.x.resize(64), row.y.resize(64), row.z.resize(64);
            const auto sum = row.weighted_sum();
            for (int axis = 0; axis < 3; ++axis)
                force[i][axis] = strength * support_radius * sum[axis];
        }
    });
}

} // namespace meniscus
