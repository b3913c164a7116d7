// HDF5 where memory comes to its end. Of its errors a few mean that there was none, which is not
// the file's fault; it crashes where it cannot get what it starts with, and where memory is wanting
// when it tidies up at a program's end. For the sources of data/ and for programs.
#pragma once

namespace meniscus {

/// Starts the library in this process, for which it takes less than 1 MiB. Throws std::bad_alloc
/// where there is no more.
void start_hdf5();

/// HDF5 does not tidy up when this process ends. For programs, which have closed their files by
/// then; to be called before anything else of HDF5.
void leave_hdf5_as_it_is();

/// Whether HDF5 has lacked memory in this process, as far as its errors under QuietErrors
/// (hdf5_handles.hpp) say.
bool hdf5_lacked_memory();

} // namespace meniscus
