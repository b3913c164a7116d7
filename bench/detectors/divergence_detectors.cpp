// The divergence of position (Lee et al. 2008), -sum_j V_j W'(r_ij) r_ij: the dimension inside a
// fluid, less where neighbors are missing. A particle is surface where it stays below a threshold:
//  - DualSPHysics' older shifting (ShiftTFS in JSphShifting): 2.75 in space, 1.5 in the plane, as
//    its guide advises; the latter is Lee et al.'s.
//  - SPHinXsys (FreeSurfaceIndication in surface_indication.cpp): three quarters of the dimension,
//    and whatever lies within a smoothing length (half the support radius of its kernel) of such a
//    particle. Its SpatialTemporal variant says the same here: it keeps a particle below the
//    threshold from becoming surface if in the step before neither it nor a neighbor was, but
//    a state has no step before, and with the state itself for that, as in a fluid at rest, all
//    below the threshold were surface then.
//  - DualSPHysics' advanced shifting (JSphCpu_preloop.cpp): of those below 2.75, in the plane 1.7,
//    the ones that have no neighbor in the umbrella of Marrone et al. along the renormalized
//    gradient of the constant 1. Isolated particles are surface without a look at the umbrella.
//
// Where the last departs from what its authors run:
//  - An isolated particle has a divergence below 1.8 (in the plane 1.1) and less than 0.4 of the
//    neighbors of a full support. The program divides the other way round, and in space has the
//    support radius to the fourth power, so that what it finds depends on the unit of length.
//  - It looks at particles that in the step before were at the surface or beside it; in its first
//    step it looks at all, as here.
// All usually run with wider supports than two spacings and with other kernels than the cubic
// spline, and count boundary particles, which states do not have.
#include "cones.hpp"
#include "detector.hpp"

#include <meniscus/runtime/math/angles.hpp>
#include <meniscus/runtime/neighbors/parallel_loop.hpp>

#include <memory>

namespace meniscus {
namespace {

/// Sets the entry of each particle whose divergence is below the threshold.
template <class Real, int Dimension, class Loop>
void find_outer(const FluidState<Real>& state, double threshold, const Loop& loop,
                std::vector<std::uint8_t>& outer) {
    outer.resize(state.size());
    const GradientSums<Real, Dimension> sums{state};
    const auto limit = static_cast<Real>(threshold);
    loop(state.size(), [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t i = begin; i < end; ++i)
            outer[i] = static_cast<std::uint8_t>(position_divergence(sums, i) < limit);
    });
}

template <class Real, int Dimension>
Detection detect_by_divergence(const FluidState<Real>& state, int threads, double threshold) {
    return [&state, threads, threshold](std::vector<std::uint8_t>& surface) {
        find_outer<Real, Dimension>(state, threshold, OpenMpLoop{threads}, surface);
    };
}

/// Adds the particles that have one of `outer` within half the support radius.
template <class Real, int Dimension, class Loop>
void add_second_layer(const FluidState<Real>& state, const std::vector<std::uint8_t>& outer,
                      const Loop& loop, std::vector<std::uint8_t>& surface) {
    const Real length_squared = state.support_radius * state.support_radius / 4;
    const Real* x = state.positions.data();
    const auto has_outer_neighbor = [&](std::size_t i) {
        for (std::size_t n = state.lists.offsets[i]; n < state.lists.offsets[i + 1]; ++n) {
            const std::size_t j = state.lists.neighbors[n];
            if (outer[j] == 0)
                continue;
            Real squared = 0;
            for (std::size_t axis = 0; axis < Dimension; ++axis) {
                const Real step = x[Dimension * j + axis] - x[Dimension * i + axis];
                squared += step * step;
            }
            if (squared < length_squared)
                return true;
        }
        return false;
    };
    loop(state.size(), [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t i = begin; i < end; ++i)
            surface[i] = static_cast<std::uint8_t>(outer[i] != 0 || has_outer_neighbor(i));
    });
}

template <class Real, int Dimension>
Detection detect_two_layers(const FluidState<Real>& state, int threads, double threshold) {
    auto outer = std::make_shared<std::vector<std::uint8_t>>();
    return [&state, threads, threshold, outer](std::vector<std::uint8_t>& surface) {
        const OpenMpLoop loop{threads};
        surface.resize(state.size());
        find_outer<Real, Dimension>(state, threshold, loop, *outer);
        add_second_layer<Real, Dimension>(state, *outer, loop, surface);
    };
}

/// Whether particle i has less than 0.4 of the neighbors of a full support.
template <class Real, int Dimension>
bool has_few_neighbors(const FluidState<Real>& state, std::size_t i) {
    const double h = static_cast<double>(state.support_radius);
    const double support = Dimension == 3 ? 4 * pi / 3 * h * h * h : pi * h * h;
    const std::size_t count = state.lists.offsets[i + 1] - state.lists.offsets[i];
    return static_cast<double>(count) * static_cast<double>(state.particle_volume) < 0.4 * support;
}

template <class Real, int Dimension>
bool has_empty_umbrella(const GradientSums<Real, Dimension>& sums, std::size_t i) {
    using Cone = std::conditional_t<Dimension == 3, Umbrella<Real>, AxiswiseUmbrella<Real>>;
    const auto around =
        renormalization(sums, i, [](const auto&) { return all_lanes<Pack<Real>>(Real(1)); });
    return !is_covered<Real, Dimension>(sums.state, i, around.matrix.inverse() * -around.gradient,
                                        Cone{sums.state.support_radius / 2});
}

template <class Real, int Dimension>
Detection detect_by_divergence_and_umbrella(const FluidState<Real>& state, int threads) {
    constexpr auto threshold = static_cast<Real>(Dimension == 3 ? 2.75 : 1.7);
    constexpr auto isolated = static_cast<Real>(Dimension == 3 ? 1.8 : 1.1);
    return [&state, threads](std::vector<std::uint8_t>& surface) {
        const OpenMpLoop loop{threads};
        surface.resize(state.size());
        const GradientSums<Real, Dimension> sums{state};
        // The matrix is for the few below the threshold.
        const auto is_surface = [&](std::size_t i) {
            const Real divergence = position_divergence(sums, i);
            if (!(divergence < threshold))
                return false;
            return (divergence < isolated && has_few_neighbors<Real, Dimension>(state, i)) ||
                   has_empty_umbrella(sums, i);
        };
        loop(state.size(), [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t i = begin; i < end; ++i)
                surface[i] = static_cast<std::uint8_t>(is_surface(i));
        });
    };
}

template <class Real, int Dimension>
void add(std::vector<Detector<Real>>& all) {
    constexpr bool in_space = Dimension == 3;
    all.push_back({"divergence below 0.75 D, second layer", "divergence", "SPHinXsys, at rest",
                   [](const FluidState<Real>& state, int threads) {
                       return detect_two_layers<Real, Dimension>(state, threads, 0.75 * Dimension);
                   }});
    all.push_back({in_space ? "divergence below 2.75" : "divergence below 1.5", "divergence",
                   in_space ? "DualSPHysics, older shifting"
                            : "Lee et al. 2008, DualSPHysics, older shifting",
                   [](const FluidState<Real>& state, int threads) {
                       return detect_by_divergence<Real, Dimension>(state, threads,
                                                                    in_space ? 2.75 : 1.5);
                   }});
    all.push_back(
        {in_space ? "divergence below 2.75, then cone" : "divergence below 1.7, then cone",
         "divergence", "DualSPHysics, advanced shifting",
         detect_by_divergence_and_umbrella<Real, Dimension>});
}

} // namespace

template <class Real>
void add_divergence_detectors(int dimension, std::vector<Detector<Real>>& all) {
    if (dimension == 2)
        add<Real, 2>(all);
    else
        add<Real, 3>(all);
}

template void add_divergence_detectors(int, std::vector<Detector<float>>&);
template void add_divergence_detectors(int, std::vector<Detector<double>>&);

} // namespace meniscus
