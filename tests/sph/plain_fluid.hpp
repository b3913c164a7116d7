// SPH sums over all pairs, in double and SI units, written from the papers: what the step is
// compared with. Slow and plain on purpose; shares no formula and no code with the step.
#pragma once

#include <meniscus/sph/scene/scene.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace meniscus {

inline constexpr double plain_pi = 3.14159265358979323846;

inline Place difference_of(const Place& a, const Place& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Place sum_of(const Place& a, const Place& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Place product_of(double factor, const Place& a) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}
inline double dot_of(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double length_of(const Place& a) {
    return std::sqrt(dot_of(a, a));
}

/// Kernels as the papers print them, of a distance r in m.
struct PlainKernel {
    KernelKind kind;
    int dimension;
    double h;

    /// W, in m^-D.
    [[nodiscard]] double value(double r) const {
        if (r >= h)
            return 0;
        if (kind == KernelKind::mueller)
            return poly6_factor() * std::pow(h * h - r * r, 3);
        const double q = r / h;
        return spline_factor() *
               (q <= 0.5 ? 6 * (q * q * q - q * q) + 1 : 2 * (1 - q) * (1 - q) * (1 - q));
    }

    /// dW/dr; of the spiky kernel for `mueller`.
    [[nodiscard]] double slope(double r) const {
        if (r >= h)
            return 0;
        if (kind == KernelKind::mueller)
            return -3 *
                   (dimension == 3 ? 15 / (plain_pi * std::pow(h, 6))
                                   : 10 / (plain_pi * std::pow(h, 5))) *
                   (h - r) * (h - r);
        return value_slope(r);
    }

    /// dW/dr of value().
    [[nodiscard]] double value_slope(double r) const {
        if (r >= h)
            return 0;
        if (kind == KernelKind::mueller)
            return -6 * poly6_factor() * r * std::pow(h * h - r * r, 2);
        const double q = r / h;
        return spline_factor() / h * (q <= 0.5 ? 18 * q * q - 12 * q : -6 * (1 - q) * (1 - q));
    }

    /// Laplacian of value().
    [[nodiscard]] double laplacian(double r) const {
        if (r >= h)
            return 0;
        const double bend = bend_of_value(r);
        return r == 0 ? dimension * bend : bend + (dimension - 1) * value_slope(r) / r;
    }

    /// grad W with respect to x_i; 0 where both are in one place.
    [[nodiscard]] Place gradient(const Place& x_ij) const {
        const double r = length_of(x_ij);
        return r == 0 ? Place{} : product_of(slope(r) / r, x_ij);
    }

private:
    [[nodiscard]] double poly6_factor() const {
        return dimension == 3 ? 315 / (64 * plain_pi * std::pow(h, 9))
                              : 4 / (plain_pi * std::pow(h, 8));
    }
    [[nodiscard]] double spline_factor() const {
        return dimension == 3 ? 8 / (plain_pi * h * h * h) : 40 / (7 * plain_pi * h * h);
    }
    [[nodiscard]] double bend_of_value(double r) const {
        if (kind == KernelKind::mueller)
            return poly6_factor() * (24 * r * r * (h * h - r * r) - 6 * std::pow(h * h - r * r, 2));
        const double q = r / h;
        return spline_factor() / (h * h) * (q <= 0.5 ? 36 * q - 12 : 12 * (1 - q));
    }
};

struct PlainFluid {
    int dimension = 3;
    KernelKind kernel_kind = KernelKind::cubic_spline;
    double h = 1;            ///< m
    double spacing = 0.5;    ///< m
    double rest_density = 1; ///< kg/m^3
    double mass = 1;         ///< kg
    Positions positions;
    std::vector<Place> velocities; ///< m/s
    Positions walls;
    std::vector<double> wall_volumes; ///< m^D

    [[nodiscard]] std::size_t size() const { return positions.size(); }
    [[nodiscard]] PlainKernel kernel() const { return {kernel_kind, dimension, h}; }
    [[nodiscard]] Place x_ij(std::size_t i, std::size_t j) const {
        return difference_of(positions[i], positions[j]);
    }
    [[nodiscard]] double distance(std::size_t i, std::size_t j) const {
        return length_of(x_ij(i, j));
    }
    /// Calls visit(j) for the other particles closer than h.
    template <class Visit>
    void visit(std::size_t i, const Visit& visit) const {
        for (std::size_t j = 0; j < size(); ++j)
            if (j != i && distance(i, j) < h)
                visit(j);
    }
};

/// kg/m^3 of each particle.
inline std::vector<double> densities_of(const PlainFluid& fluid) {
    const PlainKernel kernel = fluid.kernel();
    std::vector<double> densities;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        double density = fluid.mass * kernel.value(0);
        fluid.visit(
            i, [&](std::size_t j) { density += fluid.mass * kernel.value(fluid.distance(i, j)); });
        for (std::size_t b = 0; b < fluid.walls.size(); ++b)
            density += fluid.rest_density * fluid.wall_volumes[b] *
                       kernel.value(length_of(difference_of(fluid.positions[i], fluid.walls[b])));
        densities.push_back(density);
    }
    return densities;
}

} // namespace meniscus
