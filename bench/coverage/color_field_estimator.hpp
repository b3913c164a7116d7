// Normals and curvature of the surface from a smoothed color field, as models have them that sample
// nothing: the normal is the field's gradient, and the curvature its Laplacian over the gradient's
// length (Mueller et al. 2003, eqs. 15 to 18) or the divergence of the unit normals around, divided
// by what the kernel finds of them (Morris 2000, eqs. 20 to 24). In support radii.
#pragma once

#include "support/fluid_state.hpp"
#include "support/loops.hpp"
#include "tension/step_fluid.hpp"

#include <meniscus/runtime/math/vector3.hpp>
#include <meniscus/sph/tension/color_field.hpp>

namespace meniscus {

/// Particles that a thread takes at a time: they are few.
inline constexpr std::size_t estimator_chunk = 8;

template <int Dimension>
class ColorFieldEstimator {
public:
    /// Around the particles in `surface`, indices of the state, which must both outlive this.
    ColorFieldEstimator(const FluidState<double>& state, const std::vector<std::size_t>& surface)
        : step(state.positions, state.lists, state.support_radius, state.particle_volume),
          particles(surface), normals(state.size()), curvatures(surface.size()) {
        for (std::size_t i = 0; i < state.size(); ++i)
            step.fluid.place[i].w = step.fluid.mass / step.fluid.density[i];
        std::vector<std::uint8_t> is_needed(state.size());
        for (const std::size_t i : surface) {
            is_needed[i] = 1;
            for (std::size_t n = state.lists.offsets[i]; n < state.lists.offsets[i + 1]; ++n)
                is_needed[state.lists.neighbors[n]] = 1;
        }
        for (std::size_t i = 0; i < state.size(); ++i)
            if (is_needed[i] != 0)
                around.push_back(i);
    }

    void find_by_laplacian(int threads) {
        over(particles, threads, [&](std::size_t k, std::size_t i) {
            const auto [gradient, laplacian] = color_field_at(step.fluid, i, kernel);
            const double length = set_normal(i, gradient);
            curvatures[k] = normals[i].w > 0 ? laplacian / ((1 - Dimension) * length) : 0;
        });
    }

    void find_by_divergence(int threads) {
        over(around, threads, [&](std::size_t /*k*/, std::size_t i) {
            set_normal(i, color_field_at(step.fluid, i, kernel).gradient);
        });
        over(particles, threads, [&](std::size_t k, std::size_t i) {
            curvatures[k] = normals[i].w > 0 ? divergence(i) / (Dimension - 1) : 0;
        });
    }

    // What was found of surface[k].
    [[nodiscard]] std::size_t size() const { return particles.size(); }
    [[nodiscard]] bool has_normal(std::size_t k) const { return normals[particles[k]].w > 0; }
    /// Out of the fluid, of length 1; zero where the gradient is none of a surface.
    [[nodiscard]] Vector3 normal(std::size_t k) const {
        const Row<double>& row = normals[particles[k]];
        return {row.x, row.y, row.z};
    }
    /// The mean one.
    [[nodiscard]] double curvature(std::size_t k) const { return curvatures[k]; }

private:
    StepFluid<double, Dimension> step;
    const std::vector<std::size_t>& particles;
    std::vector<std::size_t> around;  ///< they and their neighbors
    std::vector<Row<double>> normals; ///< of all particles; w: 1 where there is one, else 0
    std::vector<double> curvatures;
    CubicSpline<double, Dimension> kernel;

    template <class Body>
    static void over(const std::vector<std::size_t>& some, int threads, const Body& body) {
        const auto over_some = [&](std::size_t begin, std::size_t end, int /*worker*/) {
            for (std::size_t k = begin; k < end; ++k)
                body(k, some[k]);
        };
        over_particles(some.size(), threads, over_some, estimator_chunk);
    }

    /// Returns the gradient's length.
    double set_normal(std::size_t i, const Row<double>& gradient) {
        const double length = std::sqrt(dot_rows(gradient, gradient));
        const bool has_one = length > min_color_gradient;
        normals[i] = plus(Row<double>{}, has_one ? -1 / length : 0, gradient);
        normals[i].w = has_one ? 1 : 0;
        return length;
    }

    [[nodiscard]] double divergence(std::size_t i) const {
        const auto& fluid = step.fluid;
        double sum = 0;
        double found = fluid.place[i].w * kernel.value(Lanes<double>{})[0];
        const std::uint32_t* list = fluid.neighbors.begin[i];
        for (std::uint32_t n = 0; n < fluid.neighbors.count[i]; ++n) {
            const std::uint32_t j = list[n];
            const Row<double> x_ij = plus(fluid.place[i], -1.0, fluid.place[j]);
            const Row<double> turn = plus(normals[j], -1.0, normals[i]);
            const double volume = normals[j].w * fluid.place[j].w;
            sum += volume * fluid.slopes[i][n] * dot_rows(turn, x_ij);
            found += volume * kernel.value(all_lanes<Lanes<double>>(dot_rows(x_ij, x_ij)))[0];
        }
        return sum / found;
    }
};

} // namespace meniscus
