// What an HDF5 file begins with, which tells it from others before the library looks at it.
#pragma once

#include <filesystem>

namespace meniscus {

/// True where HDF5's signature stands at the beginning of the file, or after a block of its user's
/// own. Throws InputError where the file is missing, empty or no regular file.
bool is_hdf5(const std::filesystem::path& file);

/// True where a file that begins as those that we write is as long as it says there; false for HDF5
/// files of other versions, too. Throws as is_hdf5 does.
bool is_own_hdf5_of_full_length(const std::filesystem::path& file);

} // namespace meniscus
