#include "run_files.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/same_file.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

constexpr const char* extension = ".vtkhdf";

/// The number in a frame's name; nothing where the run writes no frame of that name.
std::optional<std::uint64_t> frame_number(const fs::path& file, const Scene& scene) {
    const std::string stem = file.stem().string();
    const std::string start = scene.name + "_";
    std::uint64_t number = 0;
    if (stem.size() <= start.size() || stem.rfind(start, 0) != 0 ||
        read_number(std::string_view(stem).substr(start.size()), number) != std::errc() ||
        number > last_frame(scene.duration, scene.frame_interval) ||
        frame_file(scene, {}, number) != file.filename())
        return {};
    return number;
}

/// The frames that are there and that the run is to write, in order.
std::vector<fs::path> frames_in(const Scene& scene, const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> frames;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error))
        if (frame_number(entry->path(), scene))
            frames.push_back(entry->path());
    if (error)
        fail_for(error.value(), folder.string() + ": cannot be listed: " + error.message());
    std::sort(frames.begin(), frames.end());
    return frames;
}

bool is_there(const fs::path& file) {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(file, ignored));
}

void remove_file(const fs::path& file) {
    std::error_code error;
    fs::remove(file, error);
    if (error)
        fail_for(error.value(), file.string() + ": cannot be removed: " + error.message());
}

bool starts_with(const std::string& text, const std::string& start) {
    return text.compare(0, start.size(), start) == 0;
}

std::string damage_of_log(const fs::path& file, const std::string& log, bool is_whole) {
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(file, error);
    if (error)
        return "is missing";
    const std::string text = bytes > 0 ? read_whole(file) : std::string();
    return (is_whole ? text == log : starts_with(text, log))
               ? ""
               : "has not the rows that it was written with";
}

} // namespace

fs::path frame_file(const Scene& scene, const fs::path& folder, std::uint64_t frame) {
    std::string number = std::to_string(frame);
    number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
    return folder / (scene.name + "_" + number + extension);
}

fs::path log_file(const Scene& scene, const fs::path& folder) {
    return folder / (scene.name + "_log.csv");
}

fs::path checkpoint_file(const Scene& scene, const fs::path& folder) {
    return folder / (scene.name + "_checkpoint" + extension);
}

fs::path record_file(const Scene& scene, const fs::path& folder) {
    return folder / (scene.name + "_files.txt");
}

std::uint64_t last_frame(double duration, double frame_interval) {
    return static_cast<std::uint64_t>(std::ceil(duration / frame_interval - 1e-9));
}

bool is_written_by_run(const fs::path& file, const Scene& scene, const fs::path& folder) {
    for (const fs::path& output :
         {log_file(scene, folder), checkpoint_file(scene, folder), record_file(scene, folder)})
        if (is_same_file(file, output))
            return true;
    if (frame_number(file, scene) && is_same_file(file, folder / file.filename()))
        return true;
    const auto frames = frames_in(scene, folder);
    return std::any_of(frames.begin(), frames.end(),
                       [&](const fs::path& frame) { return is_same_file(file, frame); });
}

void check_inputs_stay(const std::vector<fs::path>& inputs, const Scene& scene,
                       const fs::path& folder) {
    for (const fs::path& input : inputs)
        if (is_written_by_run(input, scene, folder))
            throw InputError(input.string() + ": scene '" + scene.name +
                             "' reads it, and its run in " + folder.string() +
                             " would overwrite it; give the scene another name, or choose another "
                             "folder with -o");
}

void check_inputs_are_not_listed(const std::vector<fs::path>& inputs, const fs::path& folder,
                                 const RunRecord& record) {
    for (const fs::path& input : inputs)
        for (const RecordedFile& one : record.files())
            if (is_same_file(input, folder / one.name))
                throw InputError(input.string() +
                                 ": the scene reads it, and --restart would remove it, since the "
                                 "run before wrote it; move it to another folder, or choose "
                                 "another one with -o");
}

void check_nothing_is_in_the_way(const Scene& scene, const fs::path& folder,
                                 const RunRecord* record) {
    std::vector<fs::path> outputs = frames_in(scene, folder);
    outputs.insert(outputs.begin(), {checkpoint_file(scene, folder), log_file(scene, folder)});
    for (const fs::path& file : outputs)
        if (is_there(file) &&
            (record == nullptr || record->find(file.filename().string()) == nullptr))
            throw InputError(file.string() +
                             ": the run would overwrite it, and no record of an earlier run lists "
                             "it; move it away, or choose another folder with -o");
}

void check_has_no_frames(const Scene& scene, const fs::path& folder, const RunRecord& record) {
    for (const RecordedFile& one : record.files())
        if (one.hash != unsettled && is_there(folder / one.name))
            throw InputError((folder / one.name).string() + ": the folder has frames of scene '" +
                             scene.name +
                             "' and no checkpoint to go on from; choose another folder, or "
                             "--restart, which removes them");
}

void remove_recorded(const Scene& scene, const fs::path& folder, RunRecord& record) {
    for (const RecordedFile& one : record.files())
        if (is_replaced(folder / one.name, one))
            throw InputError((folder / one.name).string() +
                             ": is not what the run wrote, and --restart would remove it; move it "
                             "away, or choose another folder with -o");
    // First, so that nobody goes on from it when not all is gone.
    remove_file(checkpoint_file(scene, folder));
    for (const RecordedFile& one : record.files())
        remove_file(folder / one.name);
    record.clear();
}

std::vector<DamagedFile> damaged_files(const Scene& scene, const fs::path& folder,
                                       const RunRecord& record, std::uint64_t frames,
                                       const std::string& log, bool is_whole) {
    std::vector<DamagedFile> damaged;
    for (std::uint64_t frame = 0; frame < frames; ++frame) {
        const fs::path file = frame_file(scene, folder, frame);
        const std::string damage = damage_of(file, record.find(file.filename().string()));
        if (!damage.empty())
            damaged.push_back({file, damage});
    }
    const fs::path file = log_file(scene, folder);
    const std::string damage = frames > 0 ? damage_of_log(file, log, is_whole) : "";
    if (!damage.empty())
        damaged.push_back({file, damage});
    return damaged;
}

} // namespace meniscus
