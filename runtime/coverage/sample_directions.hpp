// The directions in which a particle's sphere is sampled. They come in sets of equal size, and a
// particle takes the set that its id says, so that particles do not share their error (2020 paper,
// section 3.3: a table of 16,384 directions; here that many are cut into sets).
//
// The uncovered part of a surface particle faces away from the fluid, and roughly where is known
// before sampling, from the center of mass of the neighbors. Outward directions make use of it:
// they are given in a frame whose axis points that way, three fifths of them lie within 60 degrees
// of it, where the uncovered part has its edge, and each carries the area that it stands for.
// Within each ring around the axis they are spread evenly, and the sets differ by random shifts, so
// that the estimate has no bias. The angle of normals then takes about a quarter of the samples
// that Halton's sequence needs for the same error (docs/normals.md).
//
// How many samples: a fixed number, or by the time step, N = t_s C_SD (2020 paper, section 3.4.3),
// which makes the number of samples per simulated time independent of the step.
#pragma once

#include "../math/angles.hpp"
#include "../math/random_directions.hpp"
#include "../math/vector3.hpp"
#include "../simd/vector.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Directions of all sets together, at least one set.
inline constexpr std::size_t direction_table_size = 16384;

/// The most samples a particle can have, and the fewest that outward directions allow.
inline constexpr std::size_t max_samples = direction_table_size;
inline constexpr std::size_t min_samples = 4;

/// Samples a particle for a time step (s) and a sampling density C_SD (1/s; the paper takes 10,000
/// to 100,000): their product, but not below `minimum` nor above max_samples. `minimum` for
/// anything that is not a number.
constexpr std::size_t samples_for_time_step(double time_step, double sampling_density,
                                            std::size_t minimum) {
    const double wanted = time_step * sampling_density;
    if (!(wanted > static_cast<double>(minimum)))
        return minimum;
    return wanted < static_cast<double>(max_samples) ? static_cast<std::size_t>(wanted)
                                                     : max_samples;
}

/// Sets of weighted directions. Filled once by one of the functions below, read by all callers.
struct SampleDirections {
    std::size_t samples = 0; ///< a particle
    std::size_t stride = 0;  ///< samples filled up to whole blocks, by copies of weight 0
    std::size_t sets = 0;
    bool outward = false;       ///< in a frame whose z axis (in 2D x axis) points out of the fluid
    std::vector<float> x, y, z; ///< unit vectors; z is 0 in two dimensions
    std::vector<float> weight;  ///< part of the whole sphere; those of a set add up to 1

    /// Where the set of a particle begins.
    [[nodiscard]] std::size_t set_begin(std::uint64_t particle_id) const {
        return mix_bits(particle_id) % sets * stride;
    }
};

namespace sample_directions {

/// Sets are filled up to a multiple of this many directions.
inline constexpr std::size_t block = 64;

inline constexpr std::size_t max_sets = 128;

/// A number in [0, 1) for each key.
inline double random_fraction(std::uint64_t key) {
    return static_cast<double>(mix_bits(key) >> 11) * 0x1p-53;
}

inline double fraction_of(double value) {
    return value - std::floor(value);
}

/// Three rings around the outward axis: within 60 degrees of it, from there to 90, and behind.
inline constexpr std::size_t rings = 3;

/// Where they end: part of the sphere's area (the circle's length) that is nearer to the axis.
template <int Dimension>
inline constexpr double ring_ends[rings] = {Dimension == 2 ? 1.0 / 3 : 0.25, 0.5, 1};

/// How many of the samples lie in a ring: three fifths in the first, a fifth in each other.
inline std::size_t ring_samples(std::size_t samples, std::size_t ring) {
    const std::size_t outer = samples < 10 ? 1 : samples / 5;
    return ring == 0 ? samples - 2 * outer : outer;
}

/// The direction with `part` of the area nearer to the axis, at `turn` around it; in two dimensions
/// on the side that the turn says.
template <int Dimension>
Vector3 direction_at(double part, double turn) {
    if constexpr (Dimension == 2) {
        const auto [cosine, sine] = cosine_and_sine_of_turn(part / 2);
        return {cosine, turn < 0.5 ? sine : -sine, 0};
    } else {
        const double height = 1 - 2 * part;
        const double radius = std::sqrt(1 - height * height);
        const auto [cosine, sine] = cosine_and_sine_of_turn(turn);
        return {radius * cosine, radius * sine, height};
    }
}

} // namespace sample_directions

/// Fills `directions` with sets of `samples` (at least 1) directions each. The caller's
/// `direction(set, k)` returns direction k of a set as an array of three doubles, z = 0 in 2D, and
/// `weight(k)` the part of the sphere that it stands for. Allocates only the first time.
template <class Direction, class Weight>
void fill_directions(std::size_t samples, bool outward, const Direction& direction,
                     const Weight& weight, SampleDirections& directions) {
    using namespace sample_directions;
    directions.samples = samples;
    directions.stride = (samples + block - 1) / block * block;
    directions.sets = std::clamp(direction_table_size / samples, std::size_t{1}, max_sets);
    directions.outward = outward;
    for (auto* values : {&directions.x, &directions.y, &directions.z, &directions.weight}) {
        values->reserve(direction_table_size + max_sets * block);
        values->resize(directions.sets * directions.stride);
    }
    for (std::size_t set = 0; set < directions.sets; ++set)
        for (std::size_t k = 0; k < directions.stride; ++k) {
            const bool is_copy = k >= samples;
            const auto place = direction(set, is_copy ? samples - 1 : k);
            const std::size_t n = set * directions.stride + k;
            directions.x[n] = static_cast<float>(place[0]);
            directions.y[n] = static_cast<float>(place[1]);
            directions.z[n] = static_cast<float>(place[2]);
            directions.weight[n] = is_copy ? 0 : static_cast<float>(weight(k));
        }
}

/// Outward directions, `samples` (at least min_samples) a particle. The same bits everywhere for
/// the same seed.
template <int Dimension>
void fill_outward_directions(std::size_t samples, std::uint64_t seed,
                             SampleDirections& directions) {
    using namespace sample_directions;
    constexpr double golden_turn = 0.61803398874989484820;
    const auto end_of = [](std::size_t ring) { return ring_ends<Dimension>[ring]; };
    const auto begin_of = [=](std::size_t ring) { return ring == 0 ? 0 : end_of(ring - 1); };
    const std::size_t inner = ring_samples(samples, 0);
    const std::size_t outer = ring_samples(samples, 1);
    const auto ring_of = [=](std::size_t k) { return k < inner ? 0 : 1 + (k - inner) / outer; };
    fill_directions(
        samples, true,
        [&](std::size_t set, std::size_t k) {
            const std::uint64_t key = mix_bits(seed) + 4 * set;
            const std::size_t ring = ring_of(k);
            const std::size_t order = ring == 0 ? k : (k - inner) % outer;
            const double along = (static_cast<double>(order) + random_fraction(key + ring)) /
                                 static_cast<double>(ring_samples(samples, ring));
            // On the circle a ring is two arcs: the first half of it on one side, from the far
            // end inwards, the second on the other.
            const double from_axis = Dimension == 2 ? std::fabs(2 * along - 1) : along;
            const double part = begin_of(ring) + (end_of(ring) - begin_of(ring)) * from_axis;
            const double turn =
                Dimension == 2
                    ? along
                    : fraction_of(golden_turn * static_cast<double>(k) + random_fraction(key + 3));
            return direction_at<Dimension>(part, turn);
        },
        [&](std::size_t k) {
            const std::size_t ring = ring_of(k);
            return (end_of(ring) - begin_of(ring)) /
                   static_cast<double>(ring_samples(samples, ring));
        },
        directions);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
