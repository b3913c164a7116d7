// Fluids as the step has them, made of plain ones with lists by comparing all pairs: particles keep
// their order, and neither cells nor sorting take part.
#pragma once

#include "plain_fluid.hpp"

#include <meniscus/sph/fluid/pair_sums.hpp>

#include <gtest/gtest.h>
#include <random>

namespace meniscus {

/// A number type and a number of dimensions.
template <class RealType, int dimension_value>
struct Setting {
    using Real = RealType;
    static constexpr int dimension = dimension_value;
    /// Of what sums over some dozens of neighbors are off, relative to their largest terms.
    static constexpr double tolerance = sizeof(Real) == 4 ? 1e-5 : 1e-13;
};
using Settings =
    testing::Types<Setting<float, 2>, Setting<float, 3>, Setting<double, 2>, Setting<double, 3>>;

inline constexpr std::array<KernelKind, 2> all_kernels = {KernelKind::cubic_spline,
                                                          KernelKind::mueller};

/// A number that comes back as it is from the units and the type of a step.
template <class Real>
double rounded_in_step(double number, double unit) {
    return static_cast<double>(static_cast<Real>(number / unit)) * unit;
}

/// The step's view of a fluid, with densities. Rounds the plain one's places and velocities as the
/// step does, so that only sums differ.
template <class Real, int Dimension>
class SampleFluid {
public:
    Fluid<Real, Dimension> fluid;

    explicit SampleFluid(PlainFluid& plain) {
        fluid.units = {plain.h, plain.rest_density, {}};
        fluid.kernel = plain.kernel_kind;
        fluid.loop.loop.threads = 1;
        fluid.mass =
            static_cast<Real>(plain.mass / (plain.rest_density * std::pow(plain.h, Dimension)));
        plain.velocities.resize(plain.size());
        resize(plain.size());
        for (std::size_t i = 0; i < plain.size(); ++i) {
            fluid.place[i] = row_of(plain.positions[i], plain.h);
            fluid.velocity[i] = row_of(plain.velocities[i], plain.h);
        }
        fluid.place.back() = {-1000, -1000, -1000, 0};
        fluid.velocity.back() = {0, 0, 0, 1};
        fluid.wall_place.resize(plain.walls.size() + 1);
        for (std::size_t b = 0; b < plain.walls.size(); ++b) {
            fluid.wall_place[b] = row_of(plain.walls[b], plain.h);
            fluid.wall_place[b].w =
                static_cast<Real>(plain.wall_volumes[b] / std::pow(plain.h, Dimension));
        }
        fluid.wall_place.back() = fluid.place.back();
        fluid.wall_normal.resize(plain.walls.size() + 1);
        fill(fluid.place, true, lists, fluid.neighbors);
        fill(fluid.wall_place, false, wall_lists, fluid.wall_neighbors);
        find_densities(fluid);
    }
    SampleFluid(const SampleFluid&) = delete;
    SampleFluid& operator=(const SampleFluid&) = delete;

    /// Of particle i, m/s^2.
    [[nodiscard]] Place acceleration(std::size_t i) const {
        return in_metres(fluid.acceleration[i]);
    }
    /// A row of the step in SI units: of a place, a velocity or an acceleration.
    [[nodiscard]] Place in_metres(const Row<Real>& row) const {
        const double h = fluid.units.support_radius;
        return {h * static_cast<double>(row.x), h * static_cast<double>(row.y),
                h * static_cast<double>(row.z)};
    }

private:
    std::vector<std::vector<std::uint32_t>> lists;
    std::vector<std::vector<std::uint32_t>> wall_lists;

    void resize(std::size_t count) {
        fluid.count = count;
        fluid.place.resize(count + 1);
        fluid.velocity.resize(count + 1);
        fluid.acceleration.resize(count);
        fluid.density.resize(count);
        fluid.wall_density.resize(count);
        fluid.wall_gradient.resize(count);
        fluid.wall_ahead.resize(count);
        fluid.id.resize(count);
        for (std::size_t i = 0; i < count; ++i)
            fluid.id[i] = static_cast<std::uint32_t>(i);
    }

    static Row<Real> row_of(Place& vector, double unit) {
        for (double& coordinate : vector)
            coordinate = rounded_in_step<Real>(coordinate, unit);
        return {static_cast<Real>(vector[0] / unit), static_cast<Real>(vector[1] / unit),
                static_cast<Real>(vector[2] / unit), 0};
    }

    /// The rows, but the last, closer than 1 to each place.
    void fill(const std::vector<Row<Real>>& rows, bool self,
              std::vector<std::vector<std::uint32_t>>& storage, LaneLists& lane_lists) {
        const auto far = static_cast<std::uint32_t>(rows.size() - 1);
        storage.resize(fluid.count);
        for (std::size_t i = 0; i < fluid.count; ++i) {
            for (std::uint32_t j = 0; j < far; ++j) {
                const Row<Real> step = plus(fluid.place[i], Real(-1), rows[j]);
                if ((!self || i != j) && dot_rows(step, step) < 1)
                    storage[i].push_back(j);
            }
            lane_lists.count.push_back(static_cast<std::uint32_t>(storage[i].size()));
            storage[i].resize(lane_lists.padded_count(i), far);
            lane_lists.begin.push_back(storage[i].data());
        }
    }
};

/// Random numbers in [-1, 1), the same for one seed.
class RandomNumbers {
public:
    explicit RandomNumbers(unsigned seed) : generator(seed) {}
    double operator()() { return static_cast<double>(generator()) * 0x1p-31 - 1; }
    Place vector(int dimension) {
        Place place{};
        for (int axis = 0; axis < dimension; ++axis)
            place[axis] = (*this)();
        return place;
    }

private:
    std::mt19937 generator; // its numbers, unlike distributions, are the same everywhere
};

/// A ball (in 2D a disk) cut out of a lattice with a particle at the center, at 1.05 times the rest
/// density, and random velocities; particles are moved by up to `jitter` spacings.
inline PlainFluid lattice_ball(int dimension, KernelKind kernel, double h, double jitter) {
    PlainFluid fluid;
    fluid.dimension = dimension;
    fluid.kernel_kind = kernel;
    fluid.h = h;
    fluid.spacing = h / 2.5;
    fluid.rest_density = 1000;
    fluid.mass = 1050 * std::pow(fluid.spacing, dimension);
    RandomNumbers random(7);
    const int radius = dimension == 3 ? 3 : 5;
    for (int x = -radius; x <= radius; ++x)
        for (int y = -radius; y <= radius; ++y)
            for (int z = -radius * (dimension - 2); z <= radius * (dimension - 2); ++z) {
                if (x * x + y * y + z * z > radius * radius + 1)
                    continue;
                const Place lattice = {static_cast<double>(x), static_cast<double>(y),
                                       static_cast<double>(z)};
                fluid.positions.push_back(product_of(
                    fluid.spacing, sum_of(lattice, product_of(jitter, random.vector(dimension)))));
                fluid.velocities.push_back(product_of(h, random.vector(dimension)));
            }
    return fluid;
}

/// Two particles `distance` apart, along no axis.
inline PlainFluid particle_pair(int dimension, KernelKind kernel, double h, double distance) {
    PlainFluid fluid;
    fluid.dimension = dimension;
    fluid.kernel_kind = kernel;
    fluid.h = h;
    fluid.spacing = h / 2.5;
    fluid.rest_density = 1000;
    fluid.mass = 1000 * std::pow(fluid.spacing, dimension);
    const Place direction = dimension == 3 ? Place{2.0 / 7, 3.0 / 7, 6.0 / 7} : Place{0.6, 0.8, 0};
    fluid.positions = {{}, product_of(-distance, direction)};
    return fluid;
}

/// The largest length among vectors.
inline double max_over(const std::vector<Place>& vectors) {
    double max = 0;
    for (const Place& vector : vectors)
        max = std::max(max, length_of(vector));
    return max;
}

} // namespace meniscus
