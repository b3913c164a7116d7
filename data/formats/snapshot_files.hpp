// Snapshot files in and out. Reading tells the format by a file's content, never by its name
// (snapshot_formats.hpp has the list). Writing is always VTKHDF (vtkhdf.hpp), whole or not at all.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>

#include <filesystem>

namespace meniscus {

/// Reads a snapshot of any known format. Throws InputError, naming the file, what was expected
/// and what was found, where the file is missing, empty, truncated, of no known format, or
/// inconsistent. Non-finite positions are not an error here: who needs them finite checks.
Snapshot read_snapshot(const std::filesystem::path& file);

} // namespace meniscus
