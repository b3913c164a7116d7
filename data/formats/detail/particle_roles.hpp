// Which particles of a file are fluid, which are walls, and which are neither. Formats with named
// arrays of particles tell them by name; here they are told by point data: by what the person who
// reads the file says ("Type=3"), else by DualSPHysics' `Type`.
#pragma once

#include <meniscus/data/formats/read_choices.hpp>
#include <meniscus/data/particles/snapshot.hpp>

#include <cstddef>
#include <vector>

namespace meniscus {

/// Keeps the rows of an array that `rows` has, in ascending order.
void keep_rows(PointArray& array, const std::vector<std::size_t>& rows);

/// Makes walls the boundary and takes out what is ignored; notes say which and by what. Throws
/// InputError, naming the choice, where there is no such point data, or no fluid particle left.
void choose_particles(Snapshot& snapshot, const ReadChoices& choices);

} // namespace meniscus
