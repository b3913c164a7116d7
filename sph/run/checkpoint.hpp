// A checkpoint: all that a run needs to go on bit for bit after its process ended, in one file that
// is there whole or not at all. It is a snapshot file (data/formats/vtkhdf.hpp) with the particles
// in the order that the simulation keeps them in and every number in double; docs/file_formats.md
// has the layout.
#pragma once

#include "run_log.hpp"
#include <meniscus/sph/step/simulation.hpp>

#include <cstdint>
#include <filesystem>
#include <string>

namespace meniscus {

/// How far a run has come.
struct Checkpoint {
    SimulationState state;
    std::uint64_t next_frame = 0; ///< the first one that is not written yet
    double usual_step = 0;        ///< the last time step that no frame cut short, s
    StepSums since_frame;
    std::string log;     ///< the log's text so far
    double duration = 0; ///< once read, of the scene that it was written for, s
};

/// Writes it for a scene of that text (scene_text()), whole or not at all. Throws as write_whole
/// does (data/formats/snapshot_files.hpp).
void write_checkpoint(const Checkpoint& checkpoint, const Scene& scene, const std::string& text,
                      const std::filesystem::path& file);

/// Reads it. Throws InputError, saying what to do, where the file is damaged or no checkpoint, and
/// where another scene or another version of the program made it. A scene that differs by a longer
/// duration alone is no other one.
Checkpoint read_checkpoint(const std::filesystem::path& file, const std::string& text);

/// The same from a snapshot that was read already; the path is its name in messages.
Checkpoint checkpoint_in(const Snapshot& snapshot, const std::string& text,
                         const std::filesystem::path& file);

/// SHA-256 of all that a run goes on from, which a checkpoint's provenance has as `sha256`.
std::string content_sum(const Snapshot& snapshot);

} // namespace meniscus
