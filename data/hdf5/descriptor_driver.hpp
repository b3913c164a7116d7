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

/// What becomes of a file while HDF5 writes it.
struct FileBeingWritten {
    std::uint64_t bytes = 0;  ///< that the file has
    bool is_finished = false; ///< what HDF5 writes from now on is ignored, as it does on closing
    int error = 0;            ///< of the system, where writing has failed; finished then, too
};

/// Begins a file on a descriptor that is open for both, with the creation and access lists given,
/// the second of which gets the driver; negative where writing fails. What is laid out where is as
/// with HDF5's driver for files in memory. Both must outlive the file.
Handle create_on_descriptor(int descriptor, FileBeingWritten& written, hid_t creation,
                            hid_t access);

/// The error of the system (errno) by which reading a file failed last in this process; 0 where
/// none has. HDF5 does not hand it on.
int error_of_reading();

} // namespace meniscus
