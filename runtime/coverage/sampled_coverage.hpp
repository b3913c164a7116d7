// Which part of the sphere around a particle no neighbor covers, estimated from samples (2020
// paper, eqs. 2, 3 and 9). A neighbor at displacement u, in units of the support radius, covers a
// direction p where p lies within r2 of it:
//     |p - u| < r2 / r1, that is p . u > (u . u + 1 - (r2 / r1)^2) / 2,
// so a sample costs one product and one comparison. Samples are tested in float, a block of vectors
// at a time against one neighbor after another, until the whole block is covered.
#pragma once

#include "../neighbors/neighborhood.hpp"
#include "sample_directions.hpp"

#include <algorithm>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The neighbors of one particle. Reused from particle to particle, it allocates only where one has
/// more neighbors than any before.
struct SampledCaps {
    std::vector<float> x, y, z; ///< displacement in support radii; z is unused in two dimensions
    std::vector<float> limit;   ///< product of direction and displacement beyond which it covers
    std::size_t count = 0;

    /// Room for so many, and a vector more.
    void reserve(std::size_t capacity) {
        if (capacity + wide_float_count > x.size())
            for (auto* values : {&x, &y, &z, &limit})
                values->resize(capacity + wide_float_count);
    }

    /// Adds a neighbor at `step`, in support radii.
    void add(const Vector3& step, double radius_ratio) {
        if (count + wide_float_count >= x.size())
            reserve(2 * count + wide_float_count);
        x[count] = static_cast<float>(step[0]);
        y[count] = static_cast<float>(step[1]);
        z[count] = static_cast<float>(step[2]);
        limit[count] = static_cast<float>((dot(step, step) + 1 - radius_ratio * radius_ratio) / 2);
        ++count;
    }
};

/// What the samples say.
struct SampledPart {
    float fraction = 0;         ///< estimate of lambda, in [0, 1]
    Vector3 moment = {0, 0, 0}; ///< of the integral of the direction over it, per area of the whole
    bool is_certain = false;    ///< a sample is uncovered beyond rounding: surface without doubt
};

namespace sampled_coverage {

/// A sample whose products all stay below their limits by this is at least 1e-4 rad from every cap.
/// That leaves more uncovered than zero_uncovered_fraction, and is far above float rounding.
inline constexpr float certain_margin = 1e-4F;

/// Neighbors after which it is worth a look whether a block is covered already.
inline constexpr std::size_t neighbors_between_looks = 8;

/// Turns the displacements into a frame, where `axis` becomes z (in 2D x).
template <int Dimension>
MENISCUS_INLINE void turn_into(const std::array<Vector3, 3>& axes, SampledCaps& caps) {
    float axis[3][3];
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b)
            axis[a][b] = static_cast<float>(axes[a][b]);
    for (std::size_t n = 0; n < caps.count; n += wide_float_count) {
        const WideFloat x = load<WideFloat>(&caps.x[n]);
        const WideFloat y = load<WideFloat>(&caps.y[n]);
        if constexpr (Dimension == 2) {
            store(x * axis[0][0] + y * axis[0][1], &caps.x[n]);
            store(x * axis[1][0] + y * axis[1][1], &caps.y[n]);
        } else {
            const WideFloat z = load<WideFloat>(&caps.z[n]);
            store(x * axis[0][0] + y * axis[0][1] + z * axis[0][2], &caps.x[n]);
            store(x * axis[1][0] + y * axis[1][1] + z * axis[1][2], &caps.y[n]);
            store(x * axis[2][0] + y * axis[2][1] + z * axis[2][2], &caps.z[n]);
        }
    }
}

/// Sums are kept in as many lanes on every machine, so that they round alike.
inline constexpr std::size_t sum_lanes = 16;
inline constexpr std::size_t vectors_of_sum = sum_lanes / wide_float_count;

/// Vectors of directions that are tested together: as many as the registers hold, a multiple of
/// vectors_of_sum.
inline constexpr std::size_t vectors_at_once = MENISCUS_VECTOR_BYTES == 16   ? 4
                                               : MENISCUS_VECTOR_BYTES == 32 ? 2
                                                                             : 4;
inline constexpr std::size_t samples_at_once = vectors_at_once * wide_float_count;
static_assert(sample_directions::block % samples_at_once == 0);
static_assert(vectors_at_once % vectors_of_sum == 0);

/// Sums over the uncovered samples of a set, lane by lane.
struct SampleSums {
    WideFloat fraction[vectors_of_sum] = {}, x[vectors_of_sum] = {}, y[vectors_of_sum] = {},
              z[vectors_of_sum] = {};
    WideFloat min_excess = {}; ///< of product over limit; 0 where none is uncovered
};

/// Adds up pairs of lanes that lie half of them apart, until one is left.
MENISCUS_INLINE float sum_of_lanes(const WideFloat (&vectors)[vectors_of_sum]) {
    float lanes[sum_lanes];
    for (std::size_t v = 0; v < vectors_of_sum; ++v)
        store(vectors[v], lanes + v * wide_float_count);
    for (std::size_t half = sum_lanes / 2; half > 0; half /= 2)
        for (std::size_t lane = 0; lane < half; ++lane)
            lanes[lane] += lanes[lane + half];
    return lanes[0];
}

/// Some directions, tested together.
template <int Dimension>
struct SampleVectors {
    WideFloat x[vectors_at_once], y[vectors_at_once], z[vectors_at_once];
    WideFloat excess[vectors_at_once]; ///< the largest product with a neighbor less its limit

    MENISCUS_INLINE SampleVectors(const float* from_x, const float* from_y, const float* from_z) {
        for (std::size_t v = 0; v < vectors_at_once; ++v) {
            x[v] = load<WideFloat>(from_x + v * wide_float_count);
            y[v] = load<WideFloat>(from_y + v * wide_float_count);
            if constexpr (Dimension == 3)
                z[v] = load<WideFloat>(from_z + v * wide_float_count);
            excess[v] = WideFloat{} - 4;
        }
    }

    /// True where neighbors cover all of them; else every neighbor has been looked at.
    MENISCUS_INLINE bool are_covered(const SampledCaps& caps, const float* limit) {
        for (std::size_t n = 0; n < caps.count;) {
            const std::size_t end = (std::min)(n + neighbors_between_looks, caps.count);
            for (; n < end; ++n)
                for (std::size_t v = 0; v < vectors_at_once; ++v) {
                    WideFloat along = x[v] * caps.x[n] + y[v] * caps.y[n];
                    if constexpr (Dimension == 3)
                        along += z[v] * caps.z[n];
                    excess[v] = larger(excess[v], along - limit[n]);
                }
            WideFloat min = excess[0];
            for (std::size_t v = 1; v < vectors_at_once; ++v)
                min = smaller(min, excess[v]);
            if (!any_not_positive(min))
                return true;
        }
        return false;
    }
};

/// Adds the samples from `begin` on, as many as are tested at once.
template <int Dimension>
MENISCUS_INLINE void add_samples(const SampleDirections& directions, std::size_t begin,
                                 const SampledCaps& caps, SampleSums& sums) {
    SampleVectors<Dimension> samples(&directions.x[begin], &directions.y[begin],
                                     &directions.z[begin]);
    if (samples.are_covered(caps, caps.limit.data()))
        return;
    const auto& [x, y, z, excess] = samples;
    for (std::size_t v = 0; v < vectors_at_once; ++v) {
        const std::size_t s = v % vectors_of_sum;
        const WideFloat of_sample =
            load<WideFloat>(&directions.weight[begin + v * wide_float_count]);
        const WideFloat weight = excess[v] <= 0 ? of_sample : WideFloat{};
        sums.fraction[s] += weight;
        sums.x[s] += weight * x[v];
        sums.y[s] += weight * y[v];
        if constexpr (Dimension == 3)
            sums.z[s] += weight * z[v];
        sums.min_excess = smaller(sums.min_excess, excess[v]);
    }
}

} // namespace sampled_coverage

/// Samples the sphere of a particle whose neighbors are `caps`; `outward` (of any length, may be 0)
/// points out of the fluid as far as is known. Where the directions are outward ones, it turns the
/// caps. `set_begin` is directions.set_begin(id).
template <int Dimension>
MENISCUS_INLINE SampledPart sample_coverage(const SampleDirections& directions,
                                            std::size_t set_begin, const Vector3& outward,
                                            SampledCaps& caps) {
    using namespace sampled_coverage;
    std::array<Vector3, 3> axes = {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
    const double length = std::sqrt(dot(outward, outward));
    if (directions.outward && is_positive_and_finite(length)) {
        const Vector3 axis = scaled(1 / length, outward);
        if constexpr (Dimension == 2) {
            axes = {axis, Vector3{-axis[1], axis[0], 0}, Vector3{0, 0, 1}};
        } else {
            const Frame frame(axis);
            axes = {frame.first, frame.second, axis};
        }
        turn_into<Dimension>(axes, caps);
    }
    SampleSums sums;
    for (std::size_t k = 0; k < directions.stride; k += samples_at_once)
        add_samples<Dimension>(directions, set_begin + k, caps, sums);
    SampledPart part;
    part.fraction = (std::min)(sum_of_lanes(sums.fraction), 1.0F);
    part.is_certain = any_not_positive(sums.min_excess + certain_margin);
    const Vector3 moment = {sum_of_lanes(sums.x), sum_of_lanes(sums.y), sum_of_lanes(sums.z)};
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        part.moment = sum(part.moment, scaled(moment[axis], axes[axis]));
    return part;
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
