// The definition itself: how much of a particle's sphere no neighbor covers, in closed form, or as
// the share of many directions, as the labels of the 2020 paper are made. For every particle, or
// for the candidates of the line.
#include "detector.hpp"
#include "support/loops.hpp"

#include <meniscus/labeler/exact/exact_labels.hpp>
#include <meniscus/labeler/monte_carlo/coverage.hpp>
#include <meniscus/runtime/features/shipped_surface_line.hpp>

#include <memory>

namespace meniscus {
namespace {

constexpr double radius_ratio = 0.8;

/// The neighbors that cover, in support radii.
template <class Real, int Dimension>
void collect_coverers(const FluidState<Real>& state, const NeighborRange<Real>& range,
                      std::size_t i, std::vector<Direction>& coverers) {
    coverers.clear();
    const double scale = 1 / static_cast<double>(state.support_radius);
    state.template view<Dimension>()(i, [&](std::size_t, const auto& displacement, Real) {
        if (!range.contains(squared_length<Real, Dimension>(displacement)))
            return;
        Direction step = {0, 0, 0};
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            step[axis] = static_cast<double>(displacement[axis]) * scale;
        coverers.push_back(step);
    });
}

/// What a thread works with.
struct Workspace {
    Caps caps;
    std::unique_ptr<ExactLabels> exact = exact_labels();
};

/// Every particle passes it.
constexpr SurfaceLine<double> no_line = {0, 1e9};

/// A detection that calls is_surface(workspace), with the coverers in workspace.caps.displacements,
/// for each candidate of the line.
template <class Real, int Dimension, class Test>
Detection coverage_detection(const FluidState<Real>& state, int threads,
                             const SurfaceLine<double>& line, const Test& is_surface) {
    const SurfaceLine<Real> own_line{static_cast<Real>(line.k), static_cast<Real>(line.d)};
    auto memory = std::make_shared<std::vector<Workspace>>(static_cast<std::size_t>(threads));
    const auto range = neighbor_range<Real>(state.support_radius, radius_ratio);
    return [&state, threads, own_line, is_surface, memory, range](auto& surface) {
        surface.resize(state.size());
        over_particles(state.size(), threads, [&](std::size_t begin, std::size_t end, int worker) {
            Workspace& workspace = (*memory)[static_cast<std::size_t>(worker)];
            classify<Real, Dimension>(state.template view<Dimension>(), begin, end,
                                      state.support_radius, own_line, range, surface.data());
            for (std::size_t i = begin; i < end; ++i) {
                if (surface[i] == 0)
                    continue;
                collect_coverers<Real, Dimension>(state, range, i, workspace.caps.displacements);
                surface[i] = is_surface(workspace) ? 1 : 0;
            }
        });
    };
}

template <class Real, int Dimension>
Detector<Real> monte_carlo(std::size_t samples) {
    return {"Monte Carlo, " + std::to_string(samples) + " samples",
            "coverage of all particles",
            "Zorilla et al. 2020, section 3.2",
            [samples](const FluidState<Real>& state, int threads) {
                std::vector<Direction> directions(samples);
                sampling_scheme("halton").fill(Dimension, 0, 0, directions);
                const auto blocks =
                    std::make_shared<DirectionBlocks>(compact_blocks(std::move(directions)));
                return coverage_detection<Real, Dimension>(
                    state, threads, no_line, [blocks](Workspace& workspace) {
                        workspace.caps.radius_ratio = radius_ratio;
                        return count_uncovered(*blocks, workspace.caps) > 0;
                    });
            },
            true,
            true};
}

template <class Real, int Dimension>
Detector<Real> exact(const std::string& name, const std::string& group,
                     const SurfaceLine<double>& line) {
    return {name, group, "this project", [line](const FluidState<Real>& state, int threads) {
                return coverage_detection<Real, Dimension>(
                    state, threads, line, [](Workspace& workspace) {
                        return workspace.exact->is_uncovered(
                            Dimension, workspace.caps.displacements, radius_ratio);
                    });
            }};
}

template <class Real, int Dimension>
void add_all(std::vector<Detector<Real>>& all) {
    for (const std::size_t samples : {1000, 10000, 100000})
        all.push_back(monte_carlo<Real, Dimension>(samples));
    all.push_back(exact<Real, Dimension>("exact test", "coverage of all particles", no_line));
    all.push_back(exact<Real, Dimension>("line and exact test", "line and test",
                                         shipped_surface_line(Dimension)));
}

} // namespace

template <class Real>
void add_coverage_detectors(int dimension, std::vector<Detector<Real>>& all) {
    if (dimension == 2)
        add_all<Real, 2>(all);
    else
        add_all<Real, 3>(all);
}

template void add_coverage_detectors(int, std::vector<Detector<float>>&);
template void add_coverage_detectors(int, std::vector<Detector<double>>&);

} // namespace meniscus
