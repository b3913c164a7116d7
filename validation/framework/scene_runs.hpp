// Scenes that a study runs: to their end, or to where they diverge, with checkpoints, so that one
// that was stopped goes on.
#pragma once

#include "study.hpp"

#include <meniscus/sph/run/run.hpp>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace meniscus {

/// The columns of a run's log, by name, one value a frame.
using RunLog = std::map<std::string, std::vector<double>>;

struct SceneRun {
    Scene scene;
    RunResult result; ///< of what this process did
    RunLog log;
    std::vector<std::filesystem::path> frames;
    std::string failure; ///< empty: it came to its end
};

/// The scene of a run.
Scene scene_of(const StudyRun& run);

/// Runs it in the place's folder. Throws Stopped, and what run_scene() throws but Divergence.
SceneRun run_to_end(const Scene& scene, const Workplace& place);

/// The values of a column from the time on. Throws std::out_of_range where the log has no such
/// column.
std::vector<double> values_from(const RunLog& log, const std::string& column, double time);

/// Seconds of a stage that one second of the simulation took; all stages without one.
double seconds_a_second(const RunResult& result, double StageTimes::*stage);
double seconds_a_second(const RunResult& result);

/// Milliseconds a step likewise.
double milliseconds_a_step(const RunResult& result, double StageTimes::*stage);
double milliseconds_a_step(const RunResult& result);

} // namespace meniscus
