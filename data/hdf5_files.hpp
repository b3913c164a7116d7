// Snapshots in HDF5 files, which are of several formats that only the groups in them tell apart. A
// further one is one reader file and one line in the list in hdf5_files.cpp.
#pragma once

#include "snapshot.hpp"

#include <filesystem>

namespace meniscus {

/// True where HDF5's signature stands at the beginning of the file, or after a block of its user's
/// own. Throws InputError where the file is missing, empty or no regular file.
bool is_hdf5(const std::filesystem::path& file);

/// Reads a snapshot in any of the formats, in a child process (isolated_read.hpp). Throws
/// InputError where the file is of none of them, damaged or inconsistent.
Snapshot read_hdf5(const std::filesystem::path& file);

} // namespace meniscus
