// One particle at a time, with memory of a fixed size and no vectors: what a kernel of a GPU calls
// where a host's loop is one thread a particle. The features and the line are those of
// features/ (FeatureSum, LineSum), which kernels may call as they are. For a candidate:
//     ParticleCaps<float, 96> caps;                            // room for so many neighbors
//     caps.add<3>(step, range, radius_ratio);                  // each, in support radii
//     SampledPart part = sampled_part<3>(directions, id, caps);
//     bool is_surface = part.is_certain;                       // else, if !is_held(...), undecided
//     OneParticle<float, 3> found = one_particle<float, 3>(part, radius_ratio, fade);
// The answers are those of sample_coverage (sampled_coverage.hpp), is_surely_covered
// (held_cells.hpp) and find_force bit for bit, on a GPU where products and sums are not contracted
// (nvcc: -fmad=false). Few candidates stay undecided: they are for the exact test on the host, or
// may be dropped, which loses slivers alone.
#pragma once

#include "../coverage/held_cells.hpp"
#include "curvature.hpp"
#include "surface_force.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Where the directions lie, in the memory of whoever looks; of SampleDirections.
struct DirectionSets {
    const float* x;
    const float* y;
    const float* z;
    const float* weight;
    std::size_t stride, sets;
    bool outward;
};

/// The sets of `directions`, which must outlive it; a GPU's copy has pointers of its own.
inline DirectionSets sets_of(const SampleDirections& directions) {
    return {directions.x.data(), directions.y.data(), directions.z.data(), directions.weight.data(),
            directions.stride,   directions.sets,     directions.outward};
}

/// Caps of one particle, at most Capacity, of a host that calculates in Real.
template <class Real, std::size_t Capacity>
struct ParticleCaps {
    float x[Capacity], y[Capacity], z[Capacity], limit[Capacity]; ///< as in SampledCaps
    Real inward[3] = {0, 0, 0};                                   ///< sum of the displacements
    std::size_t count = 0;
    bool is_full = false; ///< one found no room: nothing is known of the particle

    /// Adds a neighbor at `step` = (x_j - x_i) / h, if it is in `range`, which is
    /// neighbor_range<Real>(1, radius_ratio).
    template <int Dimension>
    MENISCUS_HOST_DEVICE void add(const Real* step, const NeighborRange<Real>& range,
                                  double radius_ratio) {
        Real squared = 0;
        for (int axis = 0; axis < Dimension; ++axis)
            squared += step[axis] * step[axis];
        if (!range.contains(squared))
            return;
        is_full = is_full || count == Capacity;
        if (is_full)
            return;
        x[count] = static_cast<float>(step[0]);
        y[count] = static_cast<float>(step[1]);
        z[count] = Dimension == 3 ? static_cast<float>(step[Dimension - 1]) : 0.0F;
        limit[count] = 0.5F * static_cast<float>(squared) +
                       static_cast<float>((1 - radius_ratio * radius_ratio) / 2);
        for (int axis = 0; axis < Dimension; ++axis)
            inward[axis] += step[axis];
        ++count;
    }
};

namespace one_particle_detail {

inline constexpr std::size_t lanes = 16; ///< sampled_coverage::sum_lanes

/// As sampled_coverage::sum_of_lanes.
MENISCUS_HOST_DEVICE inline float sum_of_lanes(float (&lane)[lanes]) {
    for (std::size_t half = lanes / 2; half > 0; half /= 2)
        for (std::size_t k = 0; k < half; ++k)
            lane[k] += lane[k + half];
    return lane[0];
}

/// The largest product of a direction with a cap less its limit.
template <int Dimension>
MENISCUS_HOST_DEVICE inline float excess_of(const float (&direction)[3], const float* x,
                                            const float* y, const float* z, const float* limit,
                                            std::size_t count) {
    float excess = -4;
    for (std::size_t n = 0; n < count; ++n) {
        float along = direction[0] * x[n] + direction[1] * y[n];
        if (Dimension == 3)
            along += direction[2] * z[n];
        const float over = along - limit[n];
        excess = over > excess ? over : excess;
    }
    return excess;
}

/// The frame of the outward axis; that of the coordinates where there is none.
template <int Dimension, class Real>
MENISCUS_HOST_DEVICE inline bool set_frame(const Real (&inward)[3], double (&axes)[3][3]) {
    const Vector3 outward = {-static_cast<double>(inward[0]), -static_cast<double>(inward[1]),
                             -static_cast<double>(inward[2])};
    const double length = std::sqrt(dot(outward, outward));
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b)
            axes[a][b] = a == b ? 1 : 0;
    if (!is_positive_and_finite(length))
        return false;
    const Vector3 axis = scaled(1 / length, outward);
    const Frame frame(axis);
    for (std::size_t b = 0; b < 3; ++b) {
        axes[0][b] = Dimension == 2 ? axis[b] : frame.first[b];
        axes[1][b] = frame.second[b];
        axes[2][b] = Dimension == 2 ? (b == 2 ? 1 : 0) : axis[b];
    }
    if (Dimension == 2) {
        axes[1][0] = -axis[1];
        axes[1][1] = axis[0];
        axes[1][2] = 0;
    }
    return true;
}

template <int Dimension, class Real, std::size_t Capacity>
MENISCUS_HOST_DEVICE inline void turn(const double (&axes)[3][3],
                                      ParticleCaps<Real, Capacity>& caps) {
    for (std::size_t n = 0; n < caps.count; ++n) {
        const float step[3] = {caps.x[n], caps.y[n], caps.z[n]};
        float turned[3] = {0, 0, 0};
        for (std::size_t a = 0; a < Dimension; ++a) {
            turned[a] =
                step[0] * static_cast<float>(axes[a][0]) + step[1] * static_cast<float>(axes[a][1]);
            if (Dimension == 3)
                turned[a] += step[2] * static_cast<float>(axes[a][2]);
        }
        caps.x[n] = turned[0];
        caps.y[n] = turned[1];
        caps.z[n] = turned[2];
    }
}

} // namespace one_particle_detail

/// What the samples of the particle with that id say of it; turns the caps where directions are
/// outward ones.
template <int Dimension, class Real, std::size_t Capacity>
MENISCUS_HOST_DEVICE inline SampledPart sampled_part(const DirectionSets& directions,
                                                     std::uint64_t id,
                                                     ParticleCaps<Real, Capacity>& caps) {
    namespace detail = one_particle_detail;
    double axes[3][3];
    const bool has_frame = detail::set_frame<Dimension>(caps.inward, axes);
    const bool is_turned = directions.outward && has_frame;
    if (is_turned)
        detail::turn<Dimension>(axes, caps);
    float sums[4][detail::lanes] = {};
    float min_excess = 0;
    const std::size_t begin = mix_bits(id) % directions.sets * directions.stride;
    for (std::size_t k = 0; k < directions.stride; ++k) {
        const float direction[3] = {directions.x[begin + k], directions.y[begin + k],
                                    directions.z[begin + k]};
        const float excess =
            detail::excess_of<Dimension>(direction, caps.x, caps.y, caps.z, caps.limit, caps.count);
        if (!(excess <= 0))
            continue;
        const float weight = directions.weight[begin + k];
        const std::size_t lane = k % detail::lanes;
        sums[0][lane] += weight;
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            sums[axis + 1][lane] += weight * direction[axis];
        min_excess = excess < min_excess ? excess : min_excess;
    }
    SampledPart part;
    const float fraction = detail::sum_of_lanes(sums[0]);
    part.fraction = fraction < 1 ? fraction : 1;
    part.is_certain = !(min_excess + sampled_coverage::certain_margin > 0);
    for (std::size_t axis = 0; axis < Dimension; ++axis) {
        const double moment = static_cast<double>(detail::sum_of_lanes(sums[axis + 1]));
        for (std::size_t b = 0; b < 3; ++b)
            part.moment[b] += moment * (is_turned ? axes[axis][b] : axis == b ? 1 : 0);
    }
    return part;
}

/// The cells of CellDirections, in the memory of whoever looks.
struct CellSet {
    const float* x;
    const float* y;
    const float* z;
    std::size_t count;
    double cosine, sine; ///< of their covering radius
};

/// The cells of `cells`, which must outlive it.
template <std::size_t Count>
CellSet set_of(const CellDirections<Count>& cells) {
    return {cells.x.data(), cells.y.data(),          cells.z.data(),
            Count,          cells.cos_sin_radius[0], cells.cos_sin_radius[1]};
}

/// True where the particle is surely covered: every cell of the set is held by a cap. In three
/// dimensions; of HeldCells the coarse set first, then the fine one.
template <class Real, std::size_t Capacity>
MENISCUS_HOST_DEVICE inline bool is_held(const CellSet& cells,
                                         const ParticleCaps<Real, Capacity>& caps) {
    float holds[Capacity];
    const auto cosine = static_cast<float>(cells.cosine);
    const auto sine = static_cast<float>(cells.sine);
    for (std::size_t n = 0; n < caps.count; ++n) {
        const float limit = caps.limit[n];
        const float squared = caps.x[n] * caps.x[n] + caps.y[n] * caps.y[n] + caps.z[n] * caps.z[n];
        const float rest = squared - limit * limit;
        const float aside = std::sqrt(rest > 0 ? rest : 0.0F);
        holds[n] =
            limit * sine < aside * cosine
                ? limit * cosine + aside * sine + static_cast<float>(coverage_cells::float_error)
                : 4.0F;
    }
    for (std::size_t k = 0; k < cells.count; ++k) {
        const float direction[3] = {cells.x[k], cells.y[k], cells.z[k]};
        if (!(one_particle_detail::excess_of<3>(direction, caps.x, caps.y, caps.z, holds,
                                                caps.count) > 0))
            return false;
    }
    return true;
}

/// What the list of surface particles (surface_particles.hpp) holds of a surface particle before
/// anything is smoothed.
template <class Real, int Dimension>
struct OneParticle {
    Real uncovered_fraction; ///< lambda
    Real exposure;
    Real weight; ///< in forces, 0 to 1 (exposure_weight)
    Real normal[axis_count<Dimension>];
    Real curvature; ///< kappa times h, of the closed form (2020 paper, eqs. 10 to 17)
};

/// Of a particle that is surface.
template <class Real, int Dimension>
MENISCUS_HOST_DEVICE inline OneParticle<Real, Dimension>
one_particle(const SampledPart& part, double radius_ratio, double fade) {
    OneParticle<Real, Dimension> found;
    const double length = std::sqrt(dot(part.moment, part.moment));
    found.uncovered_fraction = static_cast<Real>(part.fraction);
    found.exposure = static_cast<Real>(length);
    found.weight =
        static_cast<Real>(exposure_weight(length, fade * flat_exposure<Dimension>(radius_ratio)));
    const double scale = length > min_exposure ? 1 / length : 0;
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        found.normal[axis] = static_cast<Real>(part.moment[axis] * scale);
    found.curvature = static_cast<Real>(
        curvature_of<Dimension>(static_cast<double>(part.fraction), radius_ratio));
    return found;
}

/// The paper's force (N) on it, -sigma kappa n times the face of a particle of that spacing (m);
/// `radius` is h in m. What is smoothed or calibrated takes its neighbors, too: paper_size() and
/// calibrated_size() of surface_force.hpp.
template <class Real, int Dimension>
MENISCUS_HOST_DEVICE inline void set_paper_force(const OneParticle<Real, Dimension>& particle,
                                                 Real sigma, Real radius, Real spacing,
                                                 Real* force) {
    const Real size = surface_force::paper_size<Dimension>(sigma, particle.curvature / radius,
                                                           spacing, particle.weight);
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        force[axis] = -size * particle.normal[axis];
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
