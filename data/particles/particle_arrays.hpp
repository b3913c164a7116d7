// The arrays of a snapshot that decide which particles count, and how much, checked once for all
// who work on whole snapshots: the labeler and the classifier must agree on what they refuse.
// Masses weight the features; phases keep fluids apart; ids key random numbers.
#pragma once

#include "snapshot.hpp"
#include "support_radii.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus {

/// Classes of particles as files have them: VTK takes unsigned bytes for colors and shows them as
/// such, signed ones as numbers.
inline std::vector<std::int8_t> stored_classes(const std::vector<std::uint8_t>& classes) {
    return {classes.begin(), classes.end()};
}

/// Particles that something is wrong with.
struct ParticlesAtFault {
    std::uint64_t count = 0;
    std::uint64_t first = 0; ///< its number in the file

    void add(std::uint64_t number) {
        first = count == 0 || number < first ? number : first;
        ++count;
    }
};

/// What is wrong with the positions of a state, gathered from its parts.
struct PositionFaults {
    std::uint64_t particles = 0; ///< looked at
    ParticlesAtFault not_finite;
    ParticlesAtFault too_far;
    double coarsest_step = 0;   ///< of the usable ones (position_step), in support radii
    std::uint64_t coarsest = 0; ///< whose that is
};

/// What checked_positions() returns for a part of a state, adding to the faults of the whole.
std::vector<std::uint8_t> usable_positions(const Snapshot& snapshot, const SupportRadii& radii,
                                           PositionFaults& faults);

/// Throws InputError as checked_positions does; the snapshot says what type positions are stored
/// in.
void refuse_faults(const Snapshot& snapshot, const PositionFaults& faults);

/// As doubtful_positions.
std::string doubt_of(const Snapshot& snapshot, const PositionFaults& faults);

/// 1 for each particle whose position can be worked with, else 0: it is finite, and not so far from
/// the origin that the type it is stored in cannot tell it from its neighbors
/// (runtime/neighbors/position_resolution.hpp). Throws InputError where there is a 0 (how many, and
/// the first index), unless skip_invalid.
std::vector<std::uint8_t> checked_positions(const Snapshot& snapshot, const SupportRadii& radii,
                                            bool skip_invalid);

/// One line for standard error where valid particles lie so far from the origin that labels are
/// doubtful; else empty.
std::string doubtful_positions(const Snapshot& snapshot, const SupportRadii& radii,
                               const std::vector<std::uint8_t>& valid);

/// The support radii of the particles with finite positions: the one that the snapshot has for all,
/// else its array `support_radius`. Throws InputError where there is neither; whether the values
/// can be used is for the neighbor search to say.
SupportRadii support_radii(const Snapshot& snapshot);

/// The values of the array `mass` in kg, or none where there is no such array: all masses are equal
/// then and need no weighting. Throws InputError where the mass of a valid particle is not positive
/// and finite.
std::vector<double> checked_masses(const Snapshot& snapshot,
                                   const std::vector<std::uint8_t>& valid);

/// Throws InputError, naming the index, where a boundary particle's position is not finite or, in
/// two dimensions, not in the fluid's plane.
void check_boundary(const Snapshot& snapshot);

/// The values of an array of whole numbers (`id`, `phase`), or none where there is no such array.
/// Integers of every type keep all their digits; unsigned ones beyond the range wrap around, so
/// that different values stay different. Throws InputError where a valid particle has a
/// floating-point value that is no whole number; 0 stands for those of other particles.
std::vector<std::int64_t> integer_values(const Snapshot& snapshot, std::string_view name,
                                         const std::vector<std::uint8_t>& valid);

} // namespace meniscus
