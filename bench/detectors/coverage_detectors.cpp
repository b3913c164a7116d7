// The definition itself: how much of a particle's sphere no neighbor covers, in closed form, or as
// the share of many directions, as the labels of the 2020 paper are made. For every particle, or
// for the candidates of the line.
//
// And a guess at it: Barecasco, Terissa and Naa 2013 (arXiv:1309.4290), Simple free-surface
// detection in two and three-dimensional SPH solver. What is uncovered should lie on the side of
// the cover vector, sum_j (x_i - x_j) / |x_i - x_j|, so a particle is covered where a neighbor lies
// in a cone around that vector; with up to 4 neighbors, in space 15, it is surface without a look.
// Cone and counts are as in programs that have the method: an opening of 60 degrees, 30 to each
// side, in both dimensions (wi-re/diffSPH), the counts as in felpzOliveira/Bubbles. As in diffSPH,
// a particle is covered where the vector vanishes: its neighbors lie evenly around it.
#include "cones.hpp"
#include "detector.hpp"
#include "support/loops.hpp"

#include <meniscus/labeler/exact/exact_labels.hpp>
#include <meniscus/labeler/monte_carlo/coverage.hpp>
#include <meniscus/runtime/math/angles.hpp>
#include <meniscus/runtime/neighbors/parallel_loop.hpp>
#include <meniscus/runtime/surface/shipped_classifier.hpp>

#include <cmath>
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
Detector<Real> exact(const std::string& name, const std::string& group, bool with_line) {
    return {name, group, "this project", [with_line](const FluidState<Real>& state, int threads) {
                const double ratio = static_cast<double>(state.support_radius) / state.spacing;
                const auto line = with_line ? shipped_first_line(Dimension, ratio) : no_line;
                return coverage_detection<Real, Dimension>(
                    state, threads, line, [](Workspace& workspace) {
                        return workspace.exact->is_uncovered(
                            Dimension, workspace.caps.displacements, radius_ratio);
                    });
            }};
}

/// The cover vector of a particle, and how many neighbors it is of: those in the particle's own
/// place have no direction.
template <class Real, int Dimension>
struct Cover {
    Vector<Real, Dimension> vector;
    Real neighbors;
};

template <class Real, int Dimension>
Cover<Real, Dimension> cover_of(const FluidState<Real>& state, std::size_t i) {
    const Pack<Real> zero{};
    const auto one = all_lanes<Pack<Real>>(Real(1));
    Pack<Real> sum[Dimension] = {};
    Pack<Real> count{};
    visit_packs<Dimension>(state, i, [&](const PairPack<Real, Dimension>& pairs) {
        const auto is_apart = pairs.squared > zero;
        const Pack<Real> per_distance = one / square_root(is_apart ? pairs.squared : one);
        for (int axis = 0; axis < Dimension; ++axis)
            sum[axis] = sum[axis] - pairs.step[axis] * per_distance;
        count += is_apart ? one : zero;
    });
    Cover<Real, Dimension> cover;
    for (int axis = 0; axis < Dimension; ++axis)
        cover.vector[axis] = sum_of_lanes(sum[axis]);
    cover.neighbors = sum_of_lanes(count);
    return cover;
}

template <class Real, int Dimension>
Detection detect_by_cover_vector(const FluidState<Real>& state, int threads) {
    constexpr auto max_count = static_cast<Real>(Dimension == 3 ? 15 : 4);
    return [&state, threads](std::vector<std::uint8_t>& surface) {
        surface.resize(state.size());
        const OpenCone<Real> cone{static_cast<Real>(std::cos(pi / 6))};
        const auto is_surface = [&](std::size_t i) {
            const Cover<Real, Dimension> cover = cover_of<Real, Dimension>(state, i);
            if (cover.neighbors <= max_count)
                return true;
            return cover.vector.squaredNorm() > 0 &&
                   !is_covered<Real, Dimension>(state, i, cover.vector, cone);
        };
        OpenMpLoop{threads}(state.size(), [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t i = begin; i < end; ++i)
                surface[i] = static_cast<std::uint8_t>(is_surface(i));
        });
    };
}

template <class Real, int Dimension>
void add_all(std::vector<Detector<Real>>& all) {
    for (const std::size_t samples : {1000, 10000, 100000})
        all.push_back(monte_carlo<Real, Dimension>(samples));
    all.push_back(exact<Real, Dimension>("exact test", "coverage of all particles", false));
    all.push_back(exact<Real, Dimension>("line and exact test", "line and test", true));
    all.push_back({"cone along the cover vector", "cover vector", "Barecasco et al. 2013",
                   detect_by_cover_vector<Real, Dimension>});
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
