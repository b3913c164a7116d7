// States of two dimensions that lie in another plane than ours: DualSPHysics and SPlisHSPlasH have
// theirs in x and z. They are turned into x and y. So are states that are flat but for rounding.
#pragma once

#include "snapshot.hpp"

#include <string>

namespace meniscus {

/// Makes the state two-dimensional where all of it, boundary included, is flat in one plane of the
/// axes: positions and vectors of three components become those of x and y, the third coordinate is
/// the same for all, and provenance `plane` names the plane where it is not xy. Flat is what is
/// thinner than 1e-6 of its extent. What lies in a line has no other plane than xy.
void settle_plane(Snapshot& snapshot);

/// The same where the user says that the state is two-dimensional. Throws InputError, naming a
/// particle, where it is not flat.
void demand_plane(Snapshot& snapshot);

/// Turns positions as the state of that provenance was turned, for a boundary that comes from
/// another file.
void turn_into_plane(const Snapshot& state, Positions& positions);

} // namespace meniscus
