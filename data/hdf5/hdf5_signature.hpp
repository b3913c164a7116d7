// What an HDF5 file begins with, which tells it from others before the library looks at it.
#pragma once

#include <filesystem>

namespace meniscus {

/// True where HDF5's signature stands at the beginning of the file, or after a block of its user's
/// own. Throws InputError where the file is missing, empty or no regular file.
bool is_hdf5(const std::filesystem::path& file);

} // namespace meniscus
