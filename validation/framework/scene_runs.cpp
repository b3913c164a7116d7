#include "scene_runs.hpp"

#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <sstream>

namespace meniscus {
namespace {

RunLog read_log(const std::filesystem::path& file) {
    std::istringstream text(read_whole(file));
    std::string line;
    std::getline(text, line);
    std::vector<std::string> names;
    std::istringstream header(line);
    for (std::string name; std::getline(header, name, ',');)
        names.push_back(name);
    RunLog log;
    while (std::getline(text, line)) {
        std::istringstream row(line);
        std::string cell;
        for (std::size_t column = 0; std::getline(row, cell, ','); ++column)
            log[names.at(column)].push_back(number_from_text(cell).value());
    }
    return log;
}

/// The frame that a failure names lies in the work folder, and is gone when somebody reads it.
std::string without_frame(const std::string& failure) {
    return failure.substr(0, failure.find("; the last good frame"));
}

} // namespace

Scene scene_of(const StudyRun& run) {
    return read_scene(run.scene, run.variant, run.changes);
}

SceneRun run_to_end(const Scene& scene, const Workplace& place) {
    SceneRun done;
    done.scene = scene;
    RunOptions options;
    options.folder = place.folder;
    options.threads = place.threads;
    options.stop = place.stop;
    try {
        done.result = run_scene(scene, options);
        if (!done.result.finished)
            throw Stopped{};
    } catch (const Divergence& divergence) {
        done.failure = without_frame(divergence.what());
    }
    done.log = read_log(log_file(scene, place.folder));
    for (std::size_t frame = 0; frame < done.log["frame"].size(); ++frame)
        done.frames.push_back(frame_file(scene, place.folder, frame));
    return done;
}

std::vector<double> values_from(const RunLog& log, const std::string& column, double time) {
    const std::vector<double>& times = log.at("time");
    const std::vector<double>& values = log.at(column);
    std::vector<double> some;
    for (std::size_t frame = 0; frame < times.size(); ++frame)
        if (times[frame] >= time)
            some.push_back(values[frame]);
    return some;
}

double seconds_a_second(const RunResult& result, double StageTimes::*stage) {
    return result.profile.seconds.*stage / result.profile.sums.time;
}

double seconds_a_second(const RunResult& result) {
    return result.profile.total / result.profile.sums.time;
}

double milliseconds_a_step(const RunResult& result, double StageTimes::*stage) {
    return 1000 * result.profile.seconds.*stage / static_cast<double>(result.profile.sums.steps);
}

double milliseconds_a_step(const RunResult& result) {
    return 1000 * result.profile.total / static_cast<double>(result.profile.sums.steps);
}

} // namespace meniscus
