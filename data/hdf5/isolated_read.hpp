// Reading in a child process. On some damaged files the HDF5 library crashes, never comes to an
// end, or takes all memory, which no check before it can foresee, and a file can name others that
// it wants read. So it reads in a forked child whose time and memory are limited and which can open
// nothing but the one file (confinement.hpp), and the snapshot comes back through a pipe. Whatever
// happens to the child, the parent gets a snapshot or an error.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>

namespace meniscus {

/// A file that is open for reading; the path is its name in messages.
struct OpenedFile {
    std::filesystem::path path;
    int descriptor;
    std::uint64_t bytes;
};

using SnapshotReader = std::function<Snapshot(const OpenedFile&)>;

/// What a child may use, memory in addition to what its parent has in use; a file that needs more
/// counts as damaged, but for the time on the wall, which the machine may be to blame for.
struct ReadLimits {
    std::uint64_t memory_bytes;
    std::uint64_t processor_seconds;
    std::chrono::milliseconds wall_time = std::chrono::hours(1);
};

/// Limits far beyond what any whole file of that size needs.
ReadLimits limits_for(std::uint64_t file_bytes);

/// Calls `read` on the opened file in a child process and returns its snapshot. An InputError or
/// FailureError there becomes the same here. Throws InputError where `file` is no regular file that
/// can be opened, and, saying that it is damaged, where the child crashes or exceeds a limit;
/// FailureError where the machine cannot start or finish it. The child has no environment, no other
/// open file and, but under kernels without seccomp, no way to open one; it ignores the terminal's
/// signals, prints nothing, leaves no core, and dies with its parent. Memory is not limited under
/// AddressSanitizer, which reserves more than any limit.
/// Other threads may do what they like meanwhile, and use HDF5 themselves where it is built for
/// threads (H5is_library_threadsafe), as Debian's is; where it is not, calls to this are calls to
/// HDF5.
Snapshot read_isolated(const std::filesystem::path& file, const SnapshotReader& read,
                       const ReadLimits& limits);

/// The same within limits_for the file's size.
Snapshot read_isolated(const std::filesystem::path& file, const SnapshotReader& read);

} // namespace meniscus
