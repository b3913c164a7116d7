#include "snapshot_files.hpp"

#include "snapshot_formats.hpp"
#include <meniscus/data/text/errors.hpp>

namespace meniscus {

Snapshot read_snapshot(const std::filesystem::path& file) {
    std::string known;
    for (const SnapshotFormat& format : snapshot_formats()) {
        if (format.detect(file))
            return format.read(file);
        known += (known.empty() ? "" : ", ") + format.name;
    }
    throw InputError(file.string() + ": expected a snapshot in a known format (" + known +
                     "), found something else; export it in one of these");
}

} // namespace meniscus
