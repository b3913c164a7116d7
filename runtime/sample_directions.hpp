// The directions in which a particle's sphere is sampled. They come in sets of equal size, and a
// particle takes the set that its id says, so that particles do not share their error (2020 paper,
// section 3.3: a table of 16,384 directions; here that many are cut into sets).
//
// The uncovered part of a surface particle faces away from the fluid, and roughly where is known
// before sampling, from the center of mass of the neighbors. Outward directions make use of it:
// they are given in a frame whose axis points that way, three quarters of them lie in the half
// before it, and each carries the area that it stands for. Within each half they are spread
// evenly, and the sets differ by random shifts, so that the estimate has no bias. That halves the
// error of evenly spread directions for the same number of samples (docs/normals.md).
//
// How many samples: a fixed number, or by the time step, N = t_s C_SD (2020 paper, section 3.4.3),
// which makes the number of samples per simulated time independent of the step.
#pragma once

#include "angles.hpp"
#include "random_directions.hpp"
#include "vector3.hpp"
#include "wide.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Directions of all sets together, at least one set.
inline constexpr std::size_t direction_table_size = 16384;

/// The most samples a particle can have, and the fewest that outward directions allow.
inline constexpr std::size_t most_samples = direction_table_size;
inline constexpr std::size_t fewest_samples = 4;

/// Samples a particle for a time step (s) and a sampling density C_SD (1/s; the paper takes 10,000
/// to 100,000): their product, but not below `minimum` nor above most_samples. `minimum` for
/// anything that is not a number.
constexpr std::size_t samples_for_time_step(double time_step, double sampling_density,
                                            std::size_t minimum) {
    const double wanted = time_step * sampling_density;
    if (!(wanted > static_cast<double>(minimum)))
        return minimum;
    return wanted < static_cast<double>(most_samples) ? static_cast<std::size_t>(wanted)
                                                      : most_samples;
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

inline constexpr std::size_t most_sets = 128;

/// A number in [0, 1) for each key.
inline double random_fraction(std::uint64_t key) {
    return static_cast<double>(mix_bits(key) >> 11) * 0x1p-53;
}

inline double fraction_of(double value) {
    return value - std::floor(value);
}

/// The point of the half sphere (half circle) before or behind the plane through the center that
/// has `part` of its area above it (beside it) and lies at `turn` around the axis.
template <int Dimension>
Vector3 point_in_half(double part, double turn, bool before) {
    if constexpr (Dimension == 2) {
        const auto [cosine, sine] = cosine_and_sine_of_turn(fraction_of(0.5 * part + 0.75));
        return before ? Vector3{cosine, sine, 0} : Vector3{-cosine, -sine, 0};
    } else {
        const double height = before ? 1 - part : -part;
        const double radius = std::sqrt(1 - height * height);
        const auto [cosine, sine] = cosine_and_sine_of_turn(turn);
        return {radius * cosine, radius * sine, height};
    }
}

} // namespace sample_directions

/// Fills `directions` with sets of `samples` (1 to most_samples) directions each. The caller's
/// `direction(set, k)` returns direction k of a set as an array of three doubles, z = 0 in 2D, and
/// `weight(k)` the part of the sphere that it stands for. Allocates only the first time.
template <class Direction, class Weight>
void fill_directions(std::size_t samples, bool outward, const Direction& direction,
                     const Weight& weight, SampleDirections& directions) {
    using namespace sample_directions;
    directions.samples = samples;
    directions.stride = (samples + block - 1) / block * block;
    directions.sets = std::min(direction_table_size / samples, most_sets);
    directions.outward = outward;
    for (auto* values : {&directions.x, &directions.y, &directions.z, &directions.weight}) {
        values->reserve(direction_table_size + most_sets * block);
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

/// Outward directions, `samples` (fewest_samples to most_samples) a particle. The same bits
/// everywhere for the same seed.
template <int Dimension>
void fill_outward_directions(std::size_t samples, std::uint64_t seed,
                             SampleDirections& directions) {
    using namespace sample_directions;
    constexpr double golden_turn = 0.61803398874989484820;
    const std::size_t before = samples - samples / 4;
    const std::size_t behind = samples - before;
    fill_directions(
        samples, true,
        [&](std::size_t set, std::size_t k) {
            const std::uint64_t key = mix_bits(seed) + 4 * set;
            const bool is_before = k < before;
            const std::size_t order = is_before ? k : k - before;
            const double shift = random_fraction(is_before ? key : key + 1);
            const double part = (static_cast<double>(order) + shift) /
                                static_cast<double>(is_before ? before : behind);
            const double turn =
                fraction_of(golden_turn * static_cast<double>(k) + random_fraction(key + 2));
            return point_in_half<Dimension>(part, turn, is_before);
        },
        [&](std::size_t k) { return 0.5 / static_cast<double>(k < before ? before : behind); },
        directions);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
