// Mean curvature kappa of the surface particles, positive where the fluid is convex (a drop),
// negative in a cavity. In formulas it stands as h kappa, without unit; in the list in 1/m. On a
// dense round surface the uncovered part of a particle's sphere is a cap whose size depends on the
// curvature alone, and the relation can be inverted (2020 paper, eqs. 14 and 17). It rests on
// neighbors that cover as much as they can; those of a solver cover less, and the curvature comes
// out too large (curvature_map.hpp corrects that).
#pragma once

#include "normals.hpp"

#include <limits>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// h kappa from lambda: eq. 14 in two dimensions, eq. 17 in three. `radius_ratio` is r2 / r1 in
/// (0, 1). The formulas have their maximum, 2 / sqrt(1 - (r2 / r1)^2), where lambda reaches
/// (1 + sqrt(1 - (r2 / r1)^2)) / 2 in three dimensions, 0.8 for the usual ratio, and would fall
/// beyond; lambda is clamped there, and below at 0, where h kappa = -2.
template <int Dimension>
MENISCUS_HOST_DEVICE double curvature_of(double lambda, double radius_ratio) {
    const double cosine = std::sqrt(1 - radius_ratio * radius_ratio); // of alpha, eq. 12
    if constexpr (Dimension == 2) {
        const double max = 1 - arctangent(radius_ratio, cosine) / pi;
        const double clamped = smaller(larger(lambda, 0), max);
        const auto [along, aside] = cosine_and_sine_of_turn(clamped / 2);
        return -2 / cosine * (along * cosine - aside * radius_ratio);
    } else {
        const double clamped = smaller(larger(lambda, 0), (1 + cosine) / 2);
        const double along = 1 - 2 * clamped; // cosine of the cap's angle phi, eq. 16
        const double aside = 2 * std::sqrt(clamped * (1 - clamped));
        return -2 / cosine * (along * cosine - aside * radius_ratio);
    }
}

/// Sets the curvature of each surface particle from its lambda; 0 where covered.
template <class Real, int Dimension, class Radii, class Loop>
void find_curvature(double radius_ratio, const Radii& radii, const Loop& loop,
                    SurfaceParticles<Real, Dimension>& list) {
    loop(list.size(), [&](std::size_t begin, std::size_t end, int /*worker*/) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            const double curvature = curvature_of<Dimension>(
                static_cast<double>(list.uncovered_fraction[slot]), radius_ratio);
            list.curvature[slot] =
                list.surface_class[slot] == SurfaceClass::surface
                    ? static_cast<Real>(curvature) / radii.of(list.particle[slot])
                    : 0;
        }
    });
}

/// One smoothing pass (2020 paper, section 3.4.3): (1 - tau) of the particle's own curvature and
/// tau of the mean over the surface particles around it, weighted by W (eq. 5) and divided by the
/// sum of weights. `before` is working memory.
template <class Real, int Dimension, class Loop>
void smooth_curvature(double tau, const Loop& loop, SurfaceParticles<Real, Dimension>& list,
                      std::vector<Real>& before) {
    before.resize(list.size());
    before.swap(list.curvature);
    const auto share = static_cast<Real>(tau);
    loop(list.size(), [&](std::size_t begin, std::size_t end, int /*worker*/) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            Real sum = 0;
            Real weights = 0;
            const auto* pair = list.pairs.data() + list.pairs_begin[slot];
            for (const auto* last = pair + list.pairs_count[slot]; pair != last; ++pair) {
                const bool is_surface = list.surface_class[pair->slot] == SurfaceClass::surface;
                const Real weight = static_cast<Real>(is_surface) * pair->weight;
                sum += weight * before[pair->slot];
                weights += weight;
            }
            const bool blend = weights > 0 && list.surface_class[slot] == SurfaceClass::surface;
            list.curvature[slot] =
                blend ? (1 - share) * before[slot] + share * (sum / weights) : before[slot];
        }
    });
}

/// Curvature that is also smoothed over time steps. It outlives the step, so it is the host's;
/// where the host sorts its particles, it calls reorder().
template <class Real>
struct TemporalCurvature {
    std::vector<Real> curvature; ///< kappa in 1/m, one entry a particle, or was_not_surface
    std::vector<Real> moved;     ///< working memory
    double share = 0.5;          ///< of the last step's curvature, at least 0 and below 1

    /// Blends each surface particle's curvature with that of the last step: `share` of the old
    /// one. Particles that were not surface then take the new one as it is. A number of
    /// particles that has changed begins anew.
    template <int Dimension>
    void smooth(SurfaceParticles<Real, Dimension>& list) {
        if (curvature.size() != list.slot_of.size())
            curvature.assign(list.slot_of.size(), was_not_surface);
        const auto old_share = static_cast<Real>(share);
        for (std::size_t i = 0; i < curvature.size(); ++i) {
            const std::int32_t slot = list.slot_of[i];
            const auto place = static_cast<std::size_t>(slot);
            if (slot < 0 || list.surface_class[place] != SurfaceClass::surface) {
                curvature[i] = was_not_surface;
                continue;
            }
            if (curvature[i] != was_not_surface)
                list.curvature[place] += old_share * (curvature[i] - list.curvature[place]);
            curvature[i] = list.curvature[place];
        }
    }

    /// The particle that is now at place i was at place permutation[i] before.
    template <class Index>
    void reorder(const Index* permutation) {
        moved.resize(curvature.size());
        for (std::size_t i = 0; i < curvature.size(); ++i)
            moved[i] = curvature[static_cast<std::size_t>(permutation[i])];
        moved.swap(curvature);
    }

    /// Beyond any curvature; a number, since -ffast-math knows no NaN.
    static constexpr Real was_not_surface = (std::numeric_limits<Real>::max)();
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
