// The divergence of position (Lee et al. 2008), -sum_j V_j W'(r_ij) r_ij: the dimension inside a
// fluid, less where neighbors are missing. A particle is surface where it stays below a threshold:
//  - SPHinXsys (FreeSurfaceIndication): three quarters of the dimension. It then adds what lies
//    within a smoothing length (half the support radius of its kernel) of such a particle; here
//    that is a detector of its own. Left out is its SpatialTemporal variant, which keeps particles
//    that were neither at the surface nor beside it in the step before from becoming surface: a
//    state has no step before.
//  - DualSPHysics (ShiftTFS of its shifting): 2.75 in space, 1.5 in the plane, as its guide
//  advises.
// Both usually run with wider supports than two spacings and with other kernels than the cubic
// spline, and count boundary particles, which states do not have.
#include "detector.hpp"
#include "renormalization.hpp"

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

template <class Real, int Dimension>
void add(std::vector<Detector<Real>>& all) {
    constexpr double three_quarters = 0.75 * Dimension;
    constexpr double shifting = Dimension == 3 ? 2.75 : 1.5;
    all.push_back({"divergence below 0.75 D", "divergence", "SPHinXsys, without its second layer",
                   [](const FluidState<Real>& state, int threads) {
                       return detect_by_divergence<Real, Dimension>(state, threads, three_quarters);
                   }});
    all.push_back({"divergence below 0.75 D, second layer", "divergence", "SPHinXsys",
                   [](const FluidState<Real>& state, int threads) {
                       return detect_two_layers<Real, Dimension>(state, threads, three_quarters);
                   }});
    if (shifting != three_quarters)
        all.push_back({"divergence below 2.75", "divergence", "DualSPHysics",
                       [](const FluidState<Real>& state, int threads) {
                           return detect_by_divergence<Real, Dimension>(state, threads, shifting);
                       }});
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
