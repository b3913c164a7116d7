// The files of a run: their names, and which of those in a folder are its own. A run writes over
// and removes what its record lists, and nothing else: not what the scene reads, and not what
// somebody else has put under such a name.
#pragma once

#include "run_record.hpp"
#include <meniscus/sph/scene/scene.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace meniscus {

/// Frames are numbered from 0 with four digits or more.
std::filesystem::path frame_file(const Scene& scene, const std::filesystem::path& folder,
                                 std::uint64_t frame);
std::filesystem::path log_file(const Scene& scene, const std::filesystem::path& folder);
std::filesystem::path checkpoint_file(const Scene& scene, const std::filesystem::path& folder);
std::filesystem::path record_file(const Scene& scene, const std::filesystem::path& folder);

/// The number of a scene's last frame, the one at its duration.
std::uint64_t last_frame(double duration, double frame_interval);

/// Whether a run of the scene in the folder writes a file of that name, by whatever path or link.
bool is_written_by_run(const std::filesystem::path& file, const Scene& scene,
                       const std::filesystem::path& folder);

/// Throws InputError where the run would write over one of its inputs.
void check_inputs_stay(const std::vector<std::filesystem::path>& inputs, const Scene& scene,
                       const std::filesystem::path& folder);

/// Throws InputError where an earlier run wrote one of the inputs, which a restart would remove.
void check_inputs_are_not_listed(const std::vector<std::filesystem::path>& inputs,
                                 const std::filesystem::path& folder, const RunRecord& record);

/// Throws InputError where a file that the run is to write is there and in no record; `record`:
/// that of an earlier run, nullptr where there is none.
void check_nothing_is_in_the_way(const Scene& scene, const std::filesystem::path& folder,
                                 const RunRecord* record);

/// Throws InputError where frames of an earlier run are there.
void check_has_no_frames(const Scene& scene, const std::filesystem::path& folder,
                         const RunRecord& record);

/// Removes what the record lists, and lists nothing any more. Throws InputError, before anything is
/// removed, where somebody has replaced a frame, and where a file cannot be removed.
void remove_recorded(const Scene& scene, const std::filesystem::path& folder, RunRecord& record);

/// A file of a run that is not as the run left it, and why.
struct DamagedFile {
    std::filesystem::path file;
    std::string damage; ///< "is missing"
};

/// Those of the first `frames` frames, and of the log, which must begin with `log`, or with
/// `is_whole` be that.
std::vector<DamagedFile> damaged_files(const Scene& scene, const std::filesystem::path& folder,
                                       const RunRecord& record, std::uint64_t frames,
                                       const std::string& log, bool is_whole);

} // namespace meniscus
