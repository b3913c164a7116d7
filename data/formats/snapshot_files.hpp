// Snapshot files in and out. Reading tells the format by a file's content, never by its name
// (snapshot_formats.hpp has the list). Writing is always VTKHDF (vtkhdf.hpp), whole or not at all.
#pragma once

#include "read_choices.hpp"
#include <meniscus/data/particles/snapshot.hpp>

#include <filesystem>

namespace meniscus {

/// Reads a snapshot of any known format. Arrays get our names (known_names.hpp), walls that lie
/// among the particles become the boundary (particle_roles.hpp), and a state that is flat in any
/// plane of the axes is two-dimensional, in x and y (flat_states.hpp); `notes` says so. Throws
/// InputError, naming the file, what was expected and what was found, where the file is missing,
/// empty, truncated, of no known format, or inconsistent. Non-finite positions are not an error
/// here: who needs them finite checks.
Snapshot read_snapshot(const std::filesystem::path& file, const ReadChoices& choices = {});

} // namespace meniscus
