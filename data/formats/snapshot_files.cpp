#include "snapshot_files.hpp"

#include "detail/frames.hpp"
#include "detail/particle_roles.hpp"
#include "detail/unknown_files.hpp"
#include "snapshot_formats.hpp"
#include <meniscus/data/particles/flat_states.hpp>
#include <meniscus/data/particles/known_names.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

namespace meniscus {
namespace {

/// What all formats have in common: names, roles of particles, and the plane.
void settle(Snapshot& snapshot, const ReadChoices& choices) {
    if (snapshot.point_data.size() > max_arrays)
        throw InputError("expected at most " + std::to_string(max_arrays) + " arrays, found " +
                         std::to_string(snapshot.point_data.size()));
    choose_particles(snapshot, choices); // by the names of the file
    use_our_names(snapshot);
    if (choices.is_boundary)
        return;
    if (choices.dimension == 2)
        demand_plane(snapshot);
    else if (choices.dimension == 3)
        snapshot.dimension = 3;
    else if (!snapshot.dimension_is_stated)
        settle_plane(snapshot);
}

} // namespace

Snapshot read_snapshot(const std::filesystem::path& file, const ReadChoices& choices) {
    std::string known;
    for (const SnapshotFormat& format : snapshot_formats()) {
        if (format.detect(file)) {
            return naming_file(file, [&] {
                if (!format.holds_frames)
                    expect_no_frame(choices);
                Snapshot snapshot = format.read(file, choices);
                settle(snapshot, choices);
                return snapshot;
            });
        }
        known += (known.empty() ? "" : ", ") + format.name;
    }
    throw InputError(file.string() + ": expected a snapshot in a known format (" + known +
                     "), found " + description_of(file));
}

} // namespace meniscus
