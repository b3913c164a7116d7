// Snapshots between Python and C++. In Python a snapshot is a plain object with arrays
// (meniscus.Snapshot); in C++ it is what files hold (data/particles/snapshot.hpp). The number type
// of its positions is that of the array.
#pragma once

#include "arrays.hpp"

#include <meniscus/data/particles/snapshot.hpp>

#include <mutex>

namespace meniscus {

/// The snapshot that a meniscus.Snapshot holds. Throws InputError, naming the array, where one has
/// another shape than its name and the positions ask for, or a type that files cannot hold.
Snapshot snapshot_from_python(const py::handle& object);

/// The arguments of a meniscus.Snapshot, which takes over all that the snapshot holds.
py::dict snapshot_to_python(Snapshot&& snapshot);

/// Held around whatever reads or writes files: the HDF5 library serves one thread at a time. Taken
/// after the interpreter's lock is let go.
std::mutex& file_access();

} // namespace meniscus
