// How far apart labels may be that are made of the same positions in other arithmetic: in float or
// double, contracted, with another instruction set, or with -ffast-math. Included by programs that
// are each built with flags of their own; what they compare with is the labeler, whose arithmetic
// is fixed (docs/labels.md).
//
// A label can change only where the particle stands on one of three limits: its lambda is all but
// 0, a neighbor stands at a distance at which it begins or ceases to count, or its features lie on
// the line. The band is how far from the limit.
#pragma once

#include "host_state.hpp"

#include <meniscus/labeler/labeler.hpp>
#include <meniscus/runtime/surface/shipped_classifier.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus::test {

/// How far from its limit a label may still change.
struct RoundingBand {
    double lambda;   ///< fraction of the sphere
    double distance; ///< of a neighbor, over h
    double line;     ///< neighbors
};

/// In float and double, whatever the flags (docs/hard_cases.md says why).
template <class Real>
inline constexpr RoundingBand rounding_band =
    std::is_same_v<Real, double> ? RoundingBand{1e-7, 1e-14, 1e-10}
                                 : RoundingBand{1e-6, 1e-6, 1e-4};

/// What another arithmetic changed.
struct LabelChanges {
    std::size_t particles = 0;
    std::size_t by_coverage = 0;
    std::size_t by_line = 0;
    std::size_t outside = 0;       ///< of either: farther from every limit than the band
    double farthest_lambda = 0;    ///< from 0, of labels that coverage changed
    double farthest_distance = 0;  ///< of a neighbor from a limit, over h, where lambda was farther
    double farthest_from_line = 0; ///< in neighbors, of those that the line changed
    double max_lambda_error = 0;   ///< of particles with no neighbor at a limit
};

namespace rounding {

inline constexpr double radius_ratio = 0.8;

/// How near to a limit the nearest of all neighbors of a particle stands, over h.
template <class Real, int Dimension>
double nearest_to_limit(const HostState<Real, Dimension>& state, std::size_t i) {
    double nearest = 1;
    state.view()(i, [&](std::size_t, const auto& step, Real) {
        double squared = 0;
        for (int axis = 0; axis < Dimension; ++axis) {
            const double part = static_cast<double>(step[axis]) / static_cast<double>(state.radius);
            squared += part * part;
        }
        for (const double limit : {1 - neighbor_band, (1 - radius_ratio) * (1 + neighbor_band)})
            nearest = std::min(nearest, std::abs(std::sqrt(squared) - limit));
    });
    return nearest;
}

/// Exact coverage of all particles in the arithmetic of this program.
template <class Real, int Dimension>
std::vector<double> lambda_of(const HostState<Real, Dimension>& state) {
    static const HeldCells cells;
    SurfaceParticles<Real, Dimension> list;
    SurfaceTensionOptions options;
    options.coverage = CoverageMethod::exact;
    std::vector<ExposureMemory> memory(1);
    find_candidates<Real, Dimension>(state.view(), state.size(), state.radii(),
                                     {Real(0), Real(1e9)}, radius_ratio, SerialLoop{}, list);
    find_exposure<Real, Dimension>(state.view(), NoBoundary{}, state.radii(), nullptr,
                                   SampleDirections{}, cells, options, SerialLoop{}, memory.data(),
                                   list);
    return {list.uncovered_fraction.begin(), list.uncovered_fraction.end()};
}

} // namespace rounding

/// Adds what this program's arithmetic in Real changes of the labels of a fluid without boundary,
/// whose positions Real holds to the bit.
template <class Real, int Dimension>
void add_changes(const HardCase& fluid, LabelChanges& changes) {
    const HostState<Real, Dimension> state(fluid);
    LabelOptions options;
    options.threads = 1; // most fluids here are small
    const Labels labels = label_particles(snapshot_of(fluid), fluid.support_radius, options);
    const auto lambda = rounding::lambda_of(state);
    const auto line = shipped_first_line(Dimension, 2);
    const SurfaceLine<Real> own_line{static_cast<Real>(line.k), static_cast<Real>(line.d)};
    const auto range =
        neighbor_range<Real>(static_cast<double>(state.radius), rounding::radius_ratio);
    constexpr RoundingBand band = rounding_band<Real>;
    changes.particles += state.size();
    for (std::size_t i = 0; i < state.size(); ++i) {
        const double reference = labels.uncovered_fraction[i];
        const double off = rounding::nearest_to_limit(state, i);
        const bool counts_surely = off > band.distance;
        if (counts_surely)
            changes.max_lambda_error =
                std::max(changes.max_lambda_error, std::abs(lambda[i] - reference));
        if ((lambda[i] > zero_uncovered_fraction) != (labels.surface[i] != 0)) {
            ++changes.by_coverage;
            const double farther = std::max(lambda[i], reference);
            if (counts_surely || farther <= band.lambda)
                changes.farthest_lambda = std::max(changes.farthest_lambda, farther);
            else
                changes.farthest_distance = std::max(changes.farthest_distance, off);
            changes.outside += counts_surely && farther > band.lambda ? 1 : 0;
        }
        const auto sum = sum_features<Real, Dimension>(state.view(), i, range);
        const double above = labels.neighbor_count[i] - line.k * labels.mass_offset[i] - line.d;
        const bool by_reference = above <= 0 || labels.neighbor_count[i] == 0;
        if (is_surface(sum, own_line, state.radius) != by_reference) {
            ++changes.by_line;
            if (counts_surely)
                changes.farthest_from_line = std::max(changes.farthest_from_line, std::abs(above));
            changes.outside += counts_surely && std::abs(above) > band.line ? 1 : 0;
        }
    }
}

template <class Real>
void add_changes(const HardCase& fluid, LabelChanges& changes) {
    if (fluid.dimension == 2)
        add_changes<Real, 2>(fluid, changes);
    else
        add_changes<Real, 3>(fluid, changes);
}

} // namespace meniscus::test
