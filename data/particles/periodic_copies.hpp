// Periodic boxes: particles near a side have copies beyond the opposite one, which cover and count
// as boundary particles do, but are not labelled.
#pragma once

#include "snapshot.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

/// The sides of the box along an axis of the file, where it is periodic.
struct PeriodicSides {
    double low;
    double high;
};

using PeriodicBox = std::array<std::optional<PeriodicSides>, 3>;

/// The box of "x=0:1,z=0:2", or of the lengths "1,2,3" of x, y and z from 0. Throws InputError
/// where the text is neither, or a side is empty.
PeriodicBox periodic_box(const std::string& text);

/// Adds the copies within the largest support radius (m) of the sides, to the boundary, in place of
/// those that the snapshot already has. Axes are those of the file, before a flat state was turned.
/// Throws InputError where the box is smaller than the radius, where a particle is farther outside
/// than that, or where there are several phases, which copies would cover alike.
void add_periodic_copies(Snapshot& snapshot, const PeriodicBox& box, double radius);

/// For rows of a state that is not in memory, whose first is particle `first`: 1 for each that may
/// have copies, on which add_periodic_copies then adds what it adds on all of them. The frame says
/// how the state was turned. Throws likewise.
std::vector<std::uint8_t> near_periodic_sides(const Positions& rows, std::uint64_t first,
                                              const Snapshot& frame, const PeriodicBox& box,
                                              double radius);

/// Takes out the copies that an earlier run has added.
void remove_periodic_copies(Snapshot& snapshot);

} // namespace meniscus
