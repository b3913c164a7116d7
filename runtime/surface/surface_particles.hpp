// The surface particles of one step: found in two stages, and kept in a list of their own, so that
// all that follows costs time for them alone.
// 1. find_candidates: the line lets through every surface particle and some others
// (classifier.hpp); a second line (second_line.hpp) keeps fewer of them.
// 2. find_exposure: how much of each candidate's sphere is uncovered, and where, sampled or exact.
//    A sample that lies uncovered beyond rounding proves a candidate surface. One without any is
//    decided by the exact test, so that the surface is complete whatever the number of samples; or
//    dropped, as the 2020 paper does, which loses particles whose opening falls between samples.
// The second stage also notes which candidates are neighbors of each other, for the averages over
// the surface that normals and curvature take (eq. 4).
#pragma once

#include "../coverage/exact_coverage.hpp"
#include "../coverage/held_cells.hpp"
#include "../coverage/sampled_coverage.hpp"
#include "../features/classifier.hpp"
#include "../features/scaled_features.hpp"
#include "../features/second_line.hpp"
#include "../math/coordinates.hpp"
#include "../neighbors/boundary.hpp"
#include "../neighbors/parallel_loop.hpp"
#include "surface_options.hpp"
#include "wall_contact.hpp"

#include <cstdint>
#include <vector>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// What becomes of a particle. In the order of SPlisHSPlasH's Surf.Class field: 0, 0.5, 1.
enum class SurfaceClass : std::uint8_t {
    interior = 0, ///< by the line
    covered = 1,  ///< let through by the line, but covered
    surface = 2,
};

/// A particle next to a surface particle on the surface.
template <class Real, int Dimension>
struct SurfacePair {
    std::uint32_t slot;                ///< of the neighbor
    Real weight;                       ///< W = 1 - |x_j - x_i| / h (2020 paper, eq. 5)
    Coordinates<Real, Dimension> step; ///< (x_j - x_i) / h_i
};

/// The candidates of one step, in slots 0 to size() - 1 in the order of their particles, and what
/// the stages found out. Vectors keep their capacity from step to step.
template <class Real, int Dimension>
struct SurfaceParticles {
    using Vector = Coordinates<Real, Dimension>;

    std::vector<std::uint32_t> particle;     ///< of each slot
    std::vector<std::int32_t> slot_of;       ///< one entry a particle of the host; -1: interior
    std::vector<SurfaceClass> surface_class; ///< of each slot: covered or surface
    std::vector<Real> uncovered_fraction;    ///< lambda of each slot
    std::vector<Real> exposure; ///< length of the integral of the direction over the uncovered part
    std::vector<Real> weight;   ///< in forces and averages, 0 to 1 (exposure_weight)
    std::vector<Vector> normal; ///< unit vector out of the fluid; zero where covered
    std::vector<Real> turning;  ///< of the normals, 1/m (curvature_map.hpp)
    std::vector<Real> curvature;                       ///< mean curvature kappa, 1/m
    std::vector<Vector> force;                         ///< N
    std::vector<WallContact<Real, Dimension>> contact; ///< with a wall
    std::vector<std::size_t> pairs_begin; ///< of each slot, in `pairs`, and where the last ends
    std::vector<std::uint32_t> pairs_count;
    std::vector<SurfacePair<Real, Dimension>> pairs;

    [[nodiscard]] std::size_t size() const { return particle.size(); }

    void reserve_slots(std::size_t count, std::size_t pair_count) {
        particle.reserve(count);
        surface_class.reserve(count);
        for (auto* values : {&uncovered_fraction, &exposure, &weight, &turning, &curvature})
            values->reserve(count);
        for (auto* vectors : {&normal, &force})
            vectors->reserve(count);
        contact.reserve(count);
        pairs_begin.reserve(count + 1);
        pairs_count.reserve(count);
        pairs.reserve(pair_count + count);
    }

    /// One entry a slot in everything; so many entries for pairs.
    void resize_slots(std::size_t pair_count) {
        surface_class.resize(size());
        for (auto* values : {&uncovered_fraction, &exposure, &weight, &turning, &curvature})
            values->resize(size());
        for (auto* vectors : {&normal, &force})
            vectors->resize(size());
        contact.resize(size());
        pairs_count.resize(size());
        pairs.resize(pair_count);
    }
};

/// Below this the uncovered directions cancel out and name no normal: an isolated particle.
inline constexpr double min_exposure = 1e-6;

/// Numbers the candidates: slot_of holds the neighbor count of each and -1 for others.
template <class Real, int Dimension>
void number_candidates(SurfaceParticles<Real, Dimension>& list) {
    list.particle.clear();
    list.pairs_begin.clear();
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < list.slot_of.size(); ++i) {
        const std::int32_t neighbors = list.slot_of[i];
        if (neighbors < 0)
            continue;
        list.slot_of[i] = static_cast<std::int32_t>(list.particle.size());
        list.particle.push_back(static_cast<std::uint32_t>(i));
        list.pairs_begin.push_back(pairs);
        pairs += static_cast<std::size_t>(neighbors) + 1; // one to write to before it counts
    }
    list.pairs_begin.push_back(pairs);
    list.resize_slots(pairs);
}

/// How much a surface particle weighs in forces and averages: its exposure over that at which the
/// weight becomes 1, at most 1. Completeness of the surface and forces on it are different
/// questions: a pinhole in the second layer is surface, but as lambda goes to 0 the closed form
/// goes to h kappa = -2 and not to 0, and the normal is that of chance. Exposure is lambda for
/// small openings, and vanishes as well where a thin sheet is uncovered on both sides.
/// `full` 0: every surface particle weighs 1, as in the 2020 paper.
MENISCUS_HOST_DEVICE inline double exposure_weight(double exposure, double full) {
    return exposure < full ? exposure / full : 1;
}

/// Exposure of a particle on a flat, dense surface: the uncovered part is the cap whose edge lies
/// at the height r2 / r1.
template <int Dimension>
MENISCUS_HOST_DEVICE double flat_exposure(double radius_ratio) {
    const double square = 1 - radius_ratio * radius_ratio;
    return Dimension == 2 ? std::sqrt(square) / pi : square / 4;
}

/// Neighbors of a particle for which there is always room.
inline constexpr std::size_t usual_neighbors = 64;

/// What one concurrent caller works with.
struct ExposureMemory {
    SampledCaps caps;
    std::vector<float> hold_limits;
    ExactCoverage exact;
    GatheredNeighbors gathered;

    /// Room for so many neighbors of a particle, boundary included, and their images in a wall.
    void reserve(std::size_t neighbors) {
        const std::size_t covering = 2 * neighbors + 1;
        caps.reserve((std::max)(covering, usual_neighbors));
        hold_limits.reserve(caps.x.size());
        exact.reserve(covering);
        gathered.reserve((std::max)(neighbors, usual_neighbors));
    }
};

/// How many neighbors a candidate can have on the surface; -1 where the line says interior. Where
/// boundary particles count in the features, `boundary` has them, else it is NoBoundary.
template <class Real, int Dimension, class View, class Boundary>
MENISCUS_INLINE std::int32_t candidate_neighbors(const View& view, const Boundary& boundary,
                                                 std::size_t i, const UniformRadius<Real>& radii,
                                                 const SurfaceLine<Real>& line,
                                                 double radius_ratio) {
    const auto range = neighbor_range<Real>(static_cast<double>(radii.radius), radius_ratio);
    const auto sum = sum_features<Real, Dimension>(view, i, range);
    if constexpr (Boundary::is_there)
        return is_surface(with_boundary(sum, boundary, i, range), line, radii.radius) ? sum.count
                                                                                      : -1;
    else
        return is_surface(sum, line, radii.radius) ? sum.count : -1;
}

template <class Real, int Dimension, class View, class Boundary>
std::int32_t candidate_neighbors(const View& view, const Boundary& boundary, std::size_t i,
                                 const VaryingRadii<Real>& radii, const SurfaceLine<Real>& line,
                                 double radius_ratio) {
    const auto range = neighbor_range<Real>(1, radius_ratio);
    ScaledFeatureSum<Real, Dimension> sum;
    std::int32_t delivered = 0;
    view(i, [&](std::size_t j, const auto& displacement, Real mass) {
        add_scaled(displacement, mass, i, j, radii, range, sum);
        ++delivered;
    });
    add_scaled_boundary(boundary, i, radii, range, sum);
    return is_surface(sum, line, Real(1)) ? delivered : -1;
}

/// Fills the list with the particles of `view` (count of them) that the line lets through;
/// `radius_ratio` r2 / r1 says which neighbors count.
template <class Real, int Dimension, class View, class Radii, class Loop>
void find_candidates(const View& view, std::size_t count, const Radii& radii,
                     const SurfaceLine<Real>& line, double radius_ratio, const Loop& loop,
                     SurfaceParticles<Real, Dimension>& list) {
    list.slot_of.resize(count);
    loop(count, [&](std::size_t begin, std::size_t end, int /*worker*/) {
        for (std::size_t i = begin; i < end; ++i)
            list.slot_of[i] = candidate_neighbors<Real, Dimension>(view, NoBoundary{}, i, radii,
                                                                   line, radius_ratio);
    });
    number_candidates(list);
}

/// The same where the host classified already, as in its density loop: `candidate[i]` is not 0 for
/// candidates, `neighbor_count[i]` is FeatureSum::count.
template <class Real, int Dimension, class Count>
void take_candidates(const std::uint8_t* candidate, const Count* neighbor_count, std::size_t count,
                     SurfaceParticles<Real, Dimension>& list) {
    list.slot_of.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        list.slot_of[i] = candidate[i] != 0 ? static_cast<std::int32_t>(neighbor_count[i]) : -1;
    number_candidates(list);
}

/// Fills the list with the particles that both lines of the options let through, the second where
/// there is one. `boundary` counts in their features where the options say so. `memory` has one
/// entry a worker.
template <class Real, int Dimension, class View, class Boundary, class Radii, class Loop>
void find_candidates(const View& view, const Boundary& boundary, std::size_t count,
                     const Radii& radii, const SurfaceTensionOptions& options, const Loop& loop,
                     ExposureMemory* memory, SurfaceParticles<Real, Dimension>& list) {
    if constexpr (Boundary::is_there)
        if (options.boundary_weight == 0)
            return find_candidates(view, NoBoundary{}, count, radii, options, loop, memory, list);
    const SurfaceLine<Real> line{static_cast<Real>(options.k), static_cast<Real>(options.d)};
    const auto weighted = times_weight(boundary, static_cast<Real>(options.boundary_weight));
    list.slot_of.resize(count);
    loop(count, [&](std::size_t begin, std::size_t end, int worker) {
        GatheredNeighbors& gathered = memory[worker].gathered;
        for (std::size_t i = begin; i < end; ++i) {
            const std::int32_t neighbors = candidate_neighbors<Real, Dimension>(
                view, weighted, i, radii, line, options.radius_ratio);
            const bool stays = neighbors >= 0 &&
                               (!options.second_line.is_there ||
                                is_surface<Dimension>(view, weighted, i, radii, options.second_line,
                                                      options.radius_ratio, gathered));
            list.slot_of[i] = stays ? neighbors : -1;
        }
    });
    number_candidates(list);
}

/// The same where the host applied the first line already, as in its density loop: `candidate[i]`
/// is not 0 for those that it lets through, `neighbor_count[i]` is FeatureSum::count of the fluid.
template <class Real, int Dimension, class View, class Boundary, class Radii, class Count,
          class Loop>
void thin_candidates(const View& view, const Boundary& boundary, const std::uint8_t* candidate,
                     const Count* neighbor_count, std::size_t count, const Radii& radii,
                     const SurfaceTensionOptions& options, const Loop& loop, ExposureMemory* memory,
                     SurfaceParticles<Real, Dimension>& list) {
    if constexpr (Boundary::is_there)
        if (options.boundary_weight == 0)
            return thin_candidates(view, NoBoundary{}, candidate, neighbor_count, count, radii,
                                   options, loop, memory, list);
    const auto weighted = times_weight(boundary, static_cast<Real>(options.boundary_weight));
    list.slot_of.resize(count);
    loop(count, [&](std::size_t begin, std::size_t end, int worker) {
        GatheredNeighbors& gathered = memory[worker].gathered;
        for (std::size_t i = begin; i < end; ++i) {
            const bool stays = candidate[i] != 0 &&
                               is_surface<Dimension>(view, weighted, i, radii, options.second_line,
                                                     options.radius_ratio, gathered);
            list.slot_of[i] = stays ? static_cast<std::int32_t>(neighbor_count[i]) : -1;
        }
    });
    number_candidates(list);
}

namespace surface_particles {

inline constexpr std::size_t no_particle = ~std::size_t{0};

/// The displacement in radii of the pair.
template <class Real, int Dimension, class Displacement>
MENISCUS_INLINE Coordinates<Real, Dimension> in_radii(const Displacement& displacement,
                                                      Real inverse_radius) {
    Coordinates<Real, Dimension> step;
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        step[axis] = displacement[axis] * inverse_radius;
    return step;
}

/// A step in radii of the pair (i, j), in those of i; j may be any where radii do not vary.
template <class Real, std::size_t Size>
MENISCUS_INLINE const std::array<Real, Size>& in_own_radius(const std::array<Real, Size>& step,
                                                            const UniformRadius<Real>& /*radii*/,
                                                            std::size_t /*i*/, std::size_t /*j*/) {
    return step;
}

template <class Real, std::size_t Size>
MENISCUS_INLINE std::array<Real, Size> in_own_radius(std::array<Real, Size> step,
                                                     const VaryingRadii<Real>& radii, std::size_t i,
                                                     std::size_t j) {
    if (j == no_particle)
        return step;
    const Real pair_over_own = (radii.of(i) + radii.of(j)) / (2 * radii.of(i));
    for (Real& coordinate : step)
        coordinate *= pair_over_own;
    return step;
}

/// Calls visit(j, step) for what covers particle i: fluid neighbors, then boundary ones, whose j is
/// not an index of the fluid and comes as no_particle.
template <class Real, int Dimension, class View, class Boundary, class Radii, class Visit>
MENISCUS_INLINE void visit_covering(const View& view, const Boundary& boundary, const Radii& radii,
                                    std::size_t i, const Visit& visit) {
    view(i, [&](std::size_t j, const auto& displacement, Real /*mass*/) {
        visit(j, in_radii<Real, Dimension>(displacement, radii.inverse_of_pair(i, j)));
    });
    if constexpr (Boundary::is_there)
        boundary(i, [&](std::size_t /*j*/, const auto& displacement, Real /*mass*/) {
            visit(no_particle,
                  in_radii<Real, Dimension>(displacement, radii.inverse_of_pair(i, i)));
        });
}

/// Collects the caps of the particle in a slot and its pairs on the surface. Returns the sum of
/// displacements, which points into the fluid.
template <class Real, int Dimension, class View, class Boundary, class Radii>
MENISCUS_INLINE Vector3 collect(const View& view, const Boundary& boundary, const Radii& radii,
                                double radius_ratio, std::size_t slot,
                                SurfaceParticles<Real, Dimension>& list, SampledCaps& caps) {
    const auto range = neighbor_range<Real>(1, radius_ratio);
    const auto half_cosine = static_cast<float>((1 - radius_ratio * radius_ratio) / 2);
    const std::int32_t* const slot_of = list.slot_of.data();
    const std::size_t particles = list.slot_of.size();
    auto* const pairs = list.pairs.data() + list.pairs_begin[slot];
    // Features measure in m and this in radii, so rounding may find one neighbor more here; and a
    // host's own counts are the host's. What is too much goes to the one entry beyond, uncounted.
    const std::size_t max_pairs = list.pairs_begin[slot + 1] - list.pairs_begin[slot] - 1;
    std::uint32_t pairs_count = 0;
    Real inward[axis_count<Dimension>] = {};
    std::size_t count = 0;
    caps.reserve(usual_neighbors);
    float *x = caps.x.data(), *y = caps.y.data(), *z = caps.z.data(), *limit = caps.limit.data();
    std::size_t room = caps.x.size() - wide_float_count;
    visit_covering<Real, Dimension>(
        view, boundary, radii, list.particle[slot], [&](std::size_t j, const auto& step) {
            const Real distance_squared = squared_length<Real, Dimension>(step);
            if (!range.contains(distance_squared))
                return;
            if (count == room) {
                caps.reserve(2 * count);
                x = caps.x.data(), y = caps.y.data(), z = caps.z.data(), limit = caps.limit.data();
                room = caps.x.size() - wide_float_count;
            }
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                inward[axis] += step[axis];
            x[count] = static_cast<float>(step[0]);
            y[count] = static_cast<float>(step[1]);
            z[count] = Dimension == 3 ? static_cast<float>(step[Dimension - 1]) : 0.0F;
            limit[count] = 0.5F * static_cast<float>(distance_squared) + half_cosine;
            ++count;
            const std::int32_t neighbor = j < particles ? slot_of[j] : -1;
            auto& pair = pairs[pairs_count];
            pair.slot = static_cast<std::uint32_t>(neighbor);
            pair.weight = 1 - std::sqrt(distance_squared);
            const auto& own = in_own_radius(step, radii, list.particle[slot], j);
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                pair.step[axis] = own[axis];
            pairs_count +=
                static_cast<std::uint32_t>(int{neighbor >= 0} & int{pairs_count < max_pairs});
        });
    caps.count = count;
    list.pairs_count[slot] = pairs_count;
    Vector3 sum = {0, 0, 0};
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        sum[axis] = static_cast<double>(inward[axis]);
    return sum;
}

/// The uncovered part in closed form.
template <class Real, int Dimension, class View, class Boundary, class Radii>
UncoveredPart exact_part(const View& view, const Boundary& boundary, const Radii& radii,
                         double radius_ratio, std::size_t i, const CoverageCells& cells,
                         ExactCoverage& exact) {
    const auto range = neighbor_range<Real>(1, radius_ratio);
    exact.caps.clear();
    visit_covering<Real, Dimension>(view, boundary, radii, i,
                                    [&](std::size_t /*j*/, const auto& step) {
                                        if (range.contains(squared_length<Real, Dimension>(step)))
                                            add_cap<Dimension>(exact.caps, step, 1, radius_ratio);
                                    });
    return uncovered_part<Dimension>(cells, exact);
}

/// What a particle samples.
struct SphereSamples {
    const SampleDirections& directions;
    std::size_t set_begin;
    const CoverageCells& cells;
};

/// The uncovered part in the way that the options say, `visit_steps(visit)` calling visit(step) for
/// all that may cover.
template <int Dimension, class VisitSteps>
UncoveredPart part_between(const SurfaceTensionOptions& options, const SphereSamples& samples,
                           ExposureMemory& memory, const VisitSteps& visit_steps) {
    const double ratio = options.radius_ratio;
    const auto range = neighbor_range<double>(1, ratio);
    const bool is_exact = options.coverage == CoverageMethod::exact;
    memory.exact.caps.clear();
    memory.caps.count = 0;
    Vector3 inward = {0, 0, 0};
    visit_steps([&](const Vector3& step) {
        if (!range.contains(dot(step, step)))
            return;
        inward = sum(inward, step);
        if (is_exact)
            add_cap<Dimension>(memory.exact.caps, step, 1, ratio);
        else
            memory.caps.add(step, ratio);
    });
    if (is_exact)
        return uncovered_part<Dimension>(samples.cells, memory.exact);
    const auto sampled = sample_coverage<Dimension>(samples.directions, samples.set_begin,
                                                    scaled(-1, inward), memory.caps);
    return {static_cast<double>(sampled.fraction), sampled.moment};
}

/// What the fluid alone leaves uncovered.
template <class Real, int Dimension, class View, class Radii>
UncoveredPart part_without_boundary(const View& view, const Radii& radii,
                                    const SurfaceTensionOptions& options, std::size_t i,
                                    const SphereSamples& samples, ExposureMemory& memory) {
    return part_between<Dimension>(options, samples, memory, [&](const auto& visit) {
        visit_fluid<Real, Dimension>(view, radii, i, visit);
    });
}

/// What the fluid leaves uncovered where it goes on into a wall.
template <class Real, int Dimension, class View, class Boundary, class Radii>
UncoveredPart part_at_wall(const View& view, const Boundary& boundary, const Radii& radii,
                           const SurfaceTensionOptions& options, std::size_t i,
                           const WallContact<Real, Dimension>& contact, const Vector3& outward,
                           const SphereSamples& samples, ExposureMemory& memory) {
    return part_between<Dimension>(options, samples, memory, [&](const auto& visit) {
        visit_covering_at_wall(view, boundary, radii, i, contact, outward,
                               1 / options.spacing_ratio, visit);
    });
}

/// Looks once more at a particle that may meet a wall: `part` and `is_surface` become what they are
/// with the fluid continued into the wall, if there is a contact. Returns the contact of a surface
/// particle.
template <class Real, int Dimension, class View, class Boundary, class Radii>
WallContact<Real, Dimension>
look_at_wall(const View& view, const Boundary& boundary, const Radii& radii,
             const SurfaceTensionOptions& options, std::size_t i, const SphereSamples& samples,
             ExposureMemory& memory, UncoveredPart& part, bool& is_surface) {
    using namespace wall_contact;
    const Plane wall = plane_of<Dimension>(boundary, i, radii, 1 / options.spacing_ratio);
    if (!wall.is_there())
        return {};
    const Vector3 outward =
        is_surface
            ? part.moment
            : part_without_boundary<Real, Dimension>(view, radii, options, i, samples, memory)
                  .moment;
    const auto contact = contact_of<Real, Dimension>(
        wall, outward, contact_angle_at(boundary, wall.nearest, options.contact_angle),
        is_surface ? min_lean : min_lean_below);
    if (!contact.is_there())
        return {};
    part = part_at_wall<Real, Dimension>(view, boundary, radii, options, i, contact, outward,
                                         samples, memory);
    is_surface = is_surface || part.fraction > zero_uncovered_fraction;
    const bool is_exposed = dot(part.moment, part.moment) > min_exposure * min_exposure;
    return is_surface && is_exposed ? contact : WallContact<Real, Dimension>{};
}

/// Notes what was found of a candidate.
template <class Real, int Dimension>
void note(const UncoveredPart& part, bool is_surface, const SurfaceTensionOptions& options,
          std::size_t slot, SurfaceParticles<Real, Dimension>& list) {
    list.surface_class[slot] = is_surface ? SurfaceClass::surface : SurfaceClass::covered;
    list.uncovered_fraction[slot] = is_surface ? static_cast<Real>(part.fraction) : 0;
    const double length = std::sqrt(dot(part.moment, part.moment));
    list.exposure[slot] = is_surface ? static_cast<Real>(length) : 0;
    const double full = options.fade * flat_exposure<Dimension>(options.radius_ratio);
    list.weight[slot] = is_surface ? static_cast<Real>(exposure_weight(length, full)) : 0;
    const double scale = is_surface && length > min_exposure ? 1 / length : 0;
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        list.normal[slot][axis] = static_cast<Real>(part.moment[axis] * scale);
}

} // namespace surface_particles

/// Finds how exposed the candidates are: class, uncovered fraction, exposure, normal and pairs.
/// `ids` (one a particle; nullptr: its index) say which directions a particle samples. The result
/// depends on neither the loop nor the number of workers; `memory` has one entry a worker.
template <class Real, int Dimension, class View, class Boundary, class Radii, class Loop>
void find_exposure(const View& view, const Boundary& boundary, const Radii& radii,
                   const std::uint32_t* ids, const SampleDirections& directions,
                   const HeldCells& cells, const SurfaceTensionOptions& options, const Loop& loop,
                   ExposureMemory* memory, SurfaceParticles<Real, Dimension>& list) {
    using namespace surface_particles;
    const double ratio = options.radius_ratio;
    loop(list.size(), [&](std::size_t begin, std::size_t end, int worker) {
        auto& [caps, hold_limits, exact, gathered] = memory[worker];
        for (std::size_t slot = begin; slot < end; ++slot) {
            const std::size_t i = list.particle[slot];
            const Vector3 inward = collect(view, boundary, radii, ratio, slot, list, caps);
            UncoveredPart part{0, {0, 0, 0}};
            bool is_surface = false;
            bool is_settled = false;
            if (options.coverage == CoverageMethod::sampled) {
                const auto sampled = sample_coverage<Dimension>(
                    directions, directions.set_begin(ids != nullptr ? ids[i] : i),
                    scaled(-1, inward), caps);
                is_surface = sampled.is_certain ||
                             (options.verification == Verification::drop && sampled.fraction > 0);
                if (is_surface)
                    part = {static_cast<double>(sampled.fraction), sampled.moment};
                is_settled = is_surface || options.verification == Verification::drop ||
                             (Dimension == 3 && is_surely_covered(cells, caps, hold_limits));
            }
            if (!is_settled) {
                part = exact_part<Real, Dimension>(view, boundary, radii, ratio, i, cells.coarse,
                                                   exact);
                is_surface = part.fraction > zero_uncovered_fraction;
            }
            list.contact[slot] = {};
            if constexpr (Boundary::is_there) {
                const std::size_t set = options.coverage == CoverageMethod::sampled
                                            ? directions.set_begin(ids != nullptr ? ids[i] : i)
                                            : 0;
                list.contact[slot] = look_at_wall<Real, Dimension>(
                    view, boundary, radii, options, i, {directions, set, cells.coarse},
                    memory[worker], part, is_surface);
            }
            note(part, is_surface, options, slot, list);
        }
    });
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
