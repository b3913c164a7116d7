// Reading in a child process. On some damaged files the HDF5 library crashes, never comes to an
// end, or takes all memory, which no check before it can foresee. So it reads in a forked child
// whose processor time and memory are limited, and the snapshot comes back through a pipe. Whatever
// happens to the child, the parent gets a snapshot or an error.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>

namespace meniscus {

using SnapshotReader = std::function<Snapshot(const std::filesystem::path&)>;

/// What a child may use, in addition to what its parent has in use; a file that needs more counts
/// as damaged.
struct ReadLimits {
    std::uint64_t memory_bytes;
    std::uint64_t processor_seconds;
};

/// Limits far beyond what any whole file of that size needs.
ReadLimits limits_for(std::uint64_t file_bytes);

/// Calls `read(file)` in a child process and returns its snapshot. An InputError or FailureError
/// there becomes the same here. Throws InputError, saying that the file is damaged, where the child
/// crashes or exceeds a limit; FailureError where the machine cannot start or finish it. The child
/// ignores the terminal's signals, prints nothing, leaves no core, and dies with its parent.
/// Memory is not limited under AddressSanitizer, which reserves more than any limit.
/// Several threads may call it at once, while others write (hdf5_lock.hpp); not while another
/// thread is inside the HDF5 library without that lock.
Snapshot read_isolated(const std::filesystem::path& file, const SnapshotReader& read,
                       const ReadLimits& limits);

/// The same within limits_for the file's size.
Snapshot read_isolated(const std::filesystem::path& file, const SnapshotReader& read);

} // namespace meniscus
