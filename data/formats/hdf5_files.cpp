// Snapshots in HDF5 files, read in a child process (isolated_read.hpp).
#include "snapshot_formats.hpp"

#include "detail/frames.hpp"
#include "detail/hdf5_formats.hpp"
#include <meniscus/data/hdf5/hdf5_signature.hpp>
#include <meniscus/data/hdf5/isolated_read.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

std::string known_names() {
    std::string names;
    for (const Hdf5Format& format : hdf5_formats())
        names += (names.empty() ? "" : ", ") + std::string(format.name);
    return names;
}

/// The child that reads can open nothing more.
std::string metadata_beside(const fs::path& file) {
    const fs::path beside = file.parent_path() / "metadata.json";
    std::error_code ignored;
    constexpr std::uintmax_t max_bytes = 1 << 20;
    const bool is_there = fs::is_regular_file(beside, ignored);
    return is_there && fs::file_size(beside, ignored) - 1 < max_bytes
               ? read_whole(beside, max_bytes)
               : "";
}

Snapshot read(const OpenedFile& file, const std::string& metadata, const ReadChoices& choices) {
    Hdf5Source source = open_source(file);
    source.metadata = metadata;
    for (const Hdf5Format& format : hdf5_formats())
        if (format.holds(source)) {
            if (!format.holds_frames)
                expect_no_frame(choices);
            return format.read(source, choices);
        }
    throw InputError(file.path.string() + ": expected a snapshot in a known format of HDF5 (" +
                     known_names() + "), found another HDF5 file; export it in one of these");
}

Snapshot read_hdf5(const fs::path& file, const ReadChoices& choices) {
    const std::string metadata = metadata_beside(file);
    return read_isolated(file,
                         [&](const OpenedFile& given) { return read(given, metadata, choices); });
}

} // namespace

SnapshotFormat hdf5_format() {
    return {known_names(), is_hdf5, read_hdf5, true};
}

} // namespace meniscus
