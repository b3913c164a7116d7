// A state as the SPH step holds it (sph/fluid/fluid.hpp), with its neighbor lists and densities, so
// that what the step is made of can be called on it without a simulation. Particles keep their
// order. Compiled for the instruction set of the program that includes it.
#pragma once

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/sph/fluid/pair_sums.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Of water, kg/m^3: in Akinci's model cohesion and curvature weigh as the unit of density has it.
inline constexpr double step_rest_density = 1000;

template <class Real, int Dimension>
class StepFluid {
public:
    Fluid<Real, Dimension> fluid;

    /// `positions` has Dimension values a particle, `lists` those closer than the support radius;
    /// of particles that each have that volume, so that the density is about 1 inside.
    StepFluid(const std::vector<Real>& positions, const NeighborLists& lists, Real support_radius,
              Real particle_volume) {
        const Real h = support_radius;
        fluid.units = {static_cast<double>(h), step_rest_density, {}};
        fluid.mass = particle_volume / (Dimension == 3 ? h * h * h : h * h);
        fluid.loop.loop.threads = 1;
        resize(positions.size() / Dimension);
        Row<Real> low{};
        for (std::size_t i = 0; i < fluid.count; ++i) {
            fluid.place[i] = row_of(&positions[Dimension * i], 1 / h);
            low = {std::min(low.x, fluid.place[i].x), std::min(low.y, fluid.place[i].y),
                   std::min(low.z, fluid.place[i].z), 0};
        }
        fluid.place.back() = {low.x - 10, low.y - 10, low.z - 10, 0};
        fluid.velocity.back() = {0, 0, 0, 1}; // a density to divide by
        fluid.wall_place = {fluid.place.back()};
        fluid.wall_normal.resize(1);
        take_lists(lists);
        find_densities(fluid);
    }
    StepFluid(const StepFluid&) = delete;
    StepFluid& operator=(const StepFluid&) = delete;

private:
    std::vector<std::uint32_t> neighbors;
    std::vector<std::uint32_t> wall_neighbors; ///< none

    void resize(std::size_t count) {
        fluid.count = count;
        fluid.place.resize(count + 1);
        fluid.velocity.resize(count + 1);
        fluid.acceleration.resize(count);
        fluid.density.resize(count);
        fluid.wall_density.resize(count);
        fluid.wall_gradient.resize(count);
        fluid.wall_ahead.resize(count);
        for (std::size_t i = 0; i < count; ++i)
            fluid.id.push_back(static_cast<std::uint32_t>(i));
    }

    static Row<Real> row_of(const Real* position, Real inverse_radius) {
        Row<Real> row;
        row.x = position[0] * inverse_radius;
        row.y = position[1] * inverse_radius;
        if constexpr (Dimension == 3)
            row.z = position[2] * inverse_radius;
        return row;
    }

    /// Filled up to whole lanes with the particle that is far from all.
    void take_lists(const NeighborLists& lists) {
        const auto far = static_cast<std::uint32_t>(fluid.count);
        LaneLists& lanes = fluid.neighbors;
        std::vector<std::size_t> begins;
        for (std::size_t i = 0; i < fluid.count; ++i) {
            begins.push_back(neighbors.size());
            lanes.count.push_back(
                static_cast<std::uint32_t>(lists.offsets[i + 1] - lists.offsets[i]));
            for (std::size_t n = lists.offsets[i]; n < lists.offsets[i + 1]; ++n)
                neighbors.push_back(lists.neighbors[n]);
            neighbors.resize(begins.back() + lanes.padded_count(i), far);
        }
        for (const std::size_t begin : begins)
            lanes.begin.push_back(neighbors.data() + begin);
        fluid.wall_neighbors.begin.assign(fluid.count, wall_neighbors.data());
        fluid.wall_neighbors.count.assign(fluid.count, 0);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
