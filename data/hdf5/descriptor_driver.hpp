// HDF5 on one open descriptor: the library is handed the file that it may read and gets no other,
// whatever names stand in it. For the sources of data/ only.
#pragma once

#include "hdf5_handles.hpp"

#include <cstdint>

namespace meniscus {

/// Opens the file behind a descriptor, of so many bytes, for reading; negative where HDF5 finds it
/// damaged. The descriptor must stay open meanwhile. Reading never moves its position, and HDF5
/// fails to open whatever else the file refers to by this driver.
Handle open_descriptor(int descriptor, std::uint64_t bytes);

} // namespace meniscus
