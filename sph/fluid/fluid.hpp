// The fluid as one step sees it, and the sums over neighbors that the step is made of. Inside a
// step lengths are in support radii h, masses in rest_density h^D, so densities are relative to the
// rest density, velocities are in h/s and pressures in rest_density h^2/s^2: numbers of order one
// for any scene, and no constant of a kernel can overflow. Particles are in cell order.
//
// All pairs of a solver are sums of one of a few kinds (pair_sums.hpp); a new solver or model needs
// visit_neighbors() at most.
#pragma once

#include "cells.hpp"
#include "kernels.hpp"

#include <cstdint>
#include <exception>
#include <omp.h>
#include <vector>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// One stretch of whole parts for each thread (parallel_loop.hpp), the same in each pass: what a
/// thread wrote in the last pass is still close to it.
struct StretchLoop {
    static constexpr std::size_t part_size = 256;

    int threads = omp_get_max_threads();

    [[nodiscard]] int workers() const { return threads; }

    template <class Body>
    void operator()(std::size_t count, Body&& body) const {
        const std::size_t parts = (count + part_size - 1) / part_size;
        const auto stretches = static_cast<std::size_t>(threads);
        std::exception_ptr thrown; // none may leave the parallel region
#pragma omp parallel for schedule(static, 1) num_threads(threads)
        for (int worker = 0; worker < threads; ++worker) {
            const auto number = static_cast<std::size_t>(worker);
            const std::size_t begin = parts * number / stretches * part_size;
            const std::size_t end = std::min(parts * (number + 1) / stretches * part_size, count);
            try {
                if (begin < end)
                    body(begin, end, worker);
            } catch (...) {
#pragma omp critical(meniscus_stretch_thrown)
                thrown = std::current_exception();
            }
        }
        if (thrown)
            std::rethrow_exception(thrown);
    }
};

/// A pass over all particles, and sums over it that do not depend on the number of threads.
struct ParticleLoop {
    StretchLoop loop;

    [[nodiscard]] int workers() const { return loop.workers(); }

    /// Calls body(i) for each particle.
    template <class Body>
    void each(std::size_t count, const Body& body) const {
        loop(count, [&](std::size_t begin, std::size_t end, int /*worker*/) {
            for (std::size_t i = begin; i < end; ++i)
                body(i);
        });
    }

    /// The sum of value(i), in double.
    template <class Value>
    [[nodiscard]] double sum(std::size_t count, const Value& value) const {
        std::vector<double> parts(count / part_size + 1, 0.0);
        each_part(count, [&](std::size_t part, std::size_t begin, std::size_t end) {
            double sum = 0;
            for (std::size_t i = begin; i < end; ++i)
                sum += static_cast<double>(value(i));
            parts[part] = sum;
        });
        double total = 0;
        for (const double part : parts)
            total += part;
        return total;
    }

    /// The largest value(i), or `least`.
    template <class Value>
    [[nodiscard]] double max(std::size_t count, double min, const Value& value) const {
        std::vector<double> parts(count / part_size + 1, min);
        each_part(count, [&](std::size_t part, std::size_t begin, std::size_t end) {
            double max = min;
            for (std::size_t i = begin; i < end; ++i)
                max = std::max(max, static_cast<double>(value(i)));
            parts[part] = max;
        });
        return *std::max_element(parts.begin(), parts.end());
    }

    /// Calls body(part, begin, end) for each part of the particles; part p begins at p * part_size.
    template <class Body>
    void each_part(std::size_t count, const Body& body) const {
        const std::size_t parts = (count + part_size - 1) / part_size;
        loop(parts * part_size, [&](std::size_t begin, std::size_t end, int /*worker*/) {
            for (std::size_t part = begin / part_size; part * part_size < end; ++part)
                body(part, part * part_size, std::min((part + 1) * part_size, count));
        });
    }

    static constexpr std::size_t part_size = StretchLoop::part_size;
};

/// Neighbor lists. Those of a particle are followed by copies of one that is far from all, up to a
/// whole number of lanes, so that no loop has a remainder.
struct LaneLists {
    std::vector<const std::uint32_t*> begin; ///< of each particle
    std::vector<std::uint32_t> count;        ///< of each particle, without what fills the lanes

    [[nodiscard]] std::uint32_t padded_count(std::size_t i) const {
        return (count[i] + lane_count - 1) / lane_count * lane_count;
    }
};

/// Scales between SI units and those of a step.
struct StepUnits {
    double support_radius = 1; ///< h, m
    double rest_density = 1;   ///< kg/m^3 (in 2D kg/m^2)
    Place origin{};            ///< m; places are relative to it
};

/// By how much of W wall particles count at a height over their plane (wall_layer.hpp).
template <class Real>
struct WallShare {
    Real inverse_spacing = 1; ///< of the fluid at rest, in support radii
    Real steepness = 0;       ///< how fast it falls with the height at one spacing, per spacing
    Real far = 1;             ///< what it ends at
};

template <class Real, int Dimension>
struct Fluid {
    StepUnits units;
    KernelKind kernel = KernelKind::cubic_spline;
    ParticleLoop loop;
    Real mass = 0;      ///< of each particle
    double spacing = 1; ///< of particles at rest

    std::size_t count = 0; ///< of particles; arrays with one more entry end in one far from all
    std::vector<Row<Real>> place;    ///< one more; w is free for a loop's own use
    std::vector<Row<Real>> velocity; ///< one more; w: density, from find_densities() on
    /// What accelerate() rounded off the velocities, where a step is so short that it matters:
    /// `keeps_rounding`. The velocities of the state hold it.
    std::vector<Row<Real>> rounding;
    bool keeps_rounding = false;
    std::vector<Row<Real>> acceleration; ///< of all forces but pressure
    std::vector<Real> density;           ///< walls included
    std::vector<Real> wall_density;      ///< the walls' part of it
    /// The gradient of wall_density (Akinci et al. 2012): all that a pressure solver needs of walls
    /// at rest.
    std::vector<Row<Real>> wall_gradient;
    /// What walls would add if they counted wholly wherever they are (wall_layer.hpp): gradient,
    /// and in w the density. It reaches farther, and tells what is about to run into a wall.
    std::vector<Row<Real>> wall_ahead;
    std::vector<std::uint32_t> id;
    LaneLists neighbors;
    /// W'(q) / q of each pair of a list, from find_densities() on: the gradient is that times x_i -
    /// x_j. Iterations then need neither a square root nor a division.
    std::vector<const Real*> slopes;
    std::vector<std::vector<Real>> slope_buffers; ///< one for each part of ParticleLoop

    std::vector<Row<Real>> wall_place; ///< w: psi_b = V_b, relative to the rest density; one more
    LaneLists wall_neighbors;          ///< of fluid particles
    std::vector<Row<Real>>
        wall_normal; ///< one a place, to either side; w: 1 flat to 0 (wall_layer.hpp)
    WallShare<Real> wall_share;
    std::vector<float> wall_contact_angle; ///< one a place, degrees; empty: none of their own
    /// What psi_b is over 1 / sum_b' W_bb', the volume that classifiers weigh wall particles by
    /// (runtime/neighbors/boundary.hpp).
    Real wall_volume_share = 1;
};

/// Eight neighbors of a particle i.
template <class Real, int Dimension>
struct NeighborLanes {
    Lanes<Real> step[Dimension];  ///< x_i - x_j
    Lanes<Real> distance_squared; ///< |x_i - x_j|^2
    Lanes<Real> w;                ///< of their rows
    const std::uint32_t* index;   ///< which
    std::uint32_t at;             ///< of the first, in the list of i
};

/// Calls visit(neighbors) for eight at a time. What fills the last eight up lies beyond the support
/// radius, where kernels are 0.
template <class Real, int Dimension, class Visit>
MENISCUS_INLINE void visit_lists(const Row<Real>* rows, const Row<Real>& center,
                                 const LaneLists& lists, std::size_t i, const Visit& visit) {
    const std::uint32_t* const list = lists.begin[i];
    const std::uint32_t count = lists.padded_count(i);
    for (std::uint32_t at = 0; at < count; at += lane_count) {
        const RowLanes<Real> row = gather_rows(rows, list + at);
        NeighborLanes<Real, Dimension> lanes;
        lanes.index = list + at;
        lanes.at = at;
        lanes.step[0] = center.x - row.x;
        lanes.step[1] = center.y - row.y;
        lanes.distance_squared = lanes.step[0] * lanes.step[0] + lanes.step[1] * lanes.step[1];
        if constexpr (Dimension == 3) {
            lanes.step[2] = center.z - row.z;
            lanes.distance_squared += lanes.step[2] * lanes.step[2];
        }
        lanes.w = row.w;
        visit(lanes);
    }
}

/// The fluid neighbors of particle i.
template <class Real, int Dimension, class Visit>
MENISCUS_INLINE void visit_neighbors(const Fluid<Real, Dimension>& fluid, std::size_t i,
                                     const Visit& visit) {
    visit_lists<Real, Dimension>(fluid.place.data(), fluid.place[i], fluid.neighbors, i, visit);
}

/// The slopes of eight neighbors of particle i.
template <class Real, int Dimension>
MENISCUS_INLINE Lanes<Real> slopes_of(const Fluid<Real, Dimension>& fluid, std::size_t i,
                                      const NeighborLanes<Real, Dimension>& lanes) {
    return load<Lanes<Real>>(fluid.slopes[i] + lanes.at);
}

/// The wall particles around fluid particle i; w is psi_b.
template <class Real, int Dimension, class Visit>
MENISCUS_INLINE void visit_walls(const Fluid<Real, Dimension>& fluid, std::size_t i,
                                 const Visit& visit) {
    visit_lists<Real, Dimension>(fluid.wall_place.data(), fluid.place[i], fluid.wall_neighbors, i,
                                 visit);
}

/// Adds up vectors lane by lane.
template <class Real, int Dimension>
struct VectorSum {
    Lanes<Real> sum[Dimension] = {};

    /// Adds factor * step.
    MENISCUS_INLINE void add(Lanes<Real> factor, const Lanes<Real> (&step)[Dimension]) {
        for (int axis = 0; axis < Dimension; ++axis)
            sum[axis] += factor * step[axis];
    }
    [[nodiscard]] MENISCUS_INLINE Row<Real> total() const {
        Row<Real> row;
        row.x = sum_of_lanes(sum[0]);
        row.y = sum_of_lanes(sum[1]);
        if constexpr (Dimension == 3)
            row.z = sum_of_lanes(sum[2]);
        return row;
    }
};

/// Rows as vectors; w plays no part.
template <class Real>
MENISCUS_INLINE Row<Real> plus(const Row<Real>& a, Real factor, const Row<Real>& b) {
    return {a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z, a.w};
}

template <class Real>
MENISCUS_INLINE Real dot_rows(const Row<Real>& a, const Row<Real>& b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

/// What a + b loses to rounding (Knuth's two-sum).
template <class Real>
MENISCUS_INLINE Real lost_in_sum(Real a, Real b) {
    const Real sum = a + b;
    const Real b_taken = sum - a;
    return (a - (sum - b_taken)) + (b - b_taken);
}

/// Adds factor * acceleration to the velocity of particle i.
template <class Real, int Dimension>
MENISCUS_INLINE void accelerate(Fluid<Real, Dimension>& fluid, std::size_t i, Real factor,
                                const Row<Real>& acceleration) {
    Row<Real>& velocity = fluid.velocity[i];
    if (fluid.keeps_rounding) {
        Row<Real>& lost = fluid.rounding[i];
        lost.x += lost_in_sum(velocity.x, factor * acceleration.x);
        lost.y += lost_in_sum(velocity.y, factor * acceleration.y);
        lost.z += lost_in_sum(velocity.z, factor * acceleration.z);
    }
    velocity = plus(velocity, factor, acceleration);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
