// A run: a scene from its first state to its duration, with its frames, its log and its checkpoints
// in a folder. A run that was killed goes on from its last checkpoint, and all files are then byte
// for byte those of a run that was not. Before it does, frames and log are held against the record
// of the run (run_record.hpp). One run at a time works under a scene's name in a folder.
#pragma once

#include "run_files.hpp"
#include "run_log.hpp"
#include <meniscus/sph/step/simulation.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace meniscus {

struct RunOptions {
    std::filesystem::path folder;    ///< exists
    int threads = 0;                 ///< 0: all cores
    double checkpoint_interval = 60; ///< s of the clock on the wall
    bool restart = false; ///< removes what an earlier run of the scene left in the folder
    /// Goes on although frames or the log of the run are missing or damaged; the log is written
    /// anew.
    bool accept_loss = false;
    /// Files that must stay besides those that the scene reads, such as its own.
    std::vector<std::filesystem::path> inputs = {};
    /// Called once all is read and filled, before anything is written.
    std::function<void()> before_writing = [] {};
    std::function<void(const StepReport&)> on_step = [](const StepReport&) {};
    /// Asked after each step; where true, the run ends with a checkpoint.
    std::function<bool()> stop = [] { return false; };
};

/// What the steps of a run took, those before a resume left out.
struct StepProfile {
    StepSums sums;
    StageTimes seconds; ///< sums
    double total = 0;   ///< of whole steps, s
};

struct RunResult {
    double start = 0; ///< simulated time that it started from, s
    double time = 0;  ///< simulated time that it came to, s
    bool finished = false;
    std::uint64_t frames = 0; ///< that are there, those from before a resume too
    std::size_t particles = 0;
    std::size_t wall_particles = 0;
    std::size_t parted = 0;  ///< Simulation::parted()
    std::size_t removed = 0; ///< particles that left the domain, since the first state
    int threads = 0;
    StepProfile profile;
};

/// Runs the scene from the checkpoint in the folder or, where there is none, from its first state.
/// Frames are at 0, one interval, two..., and at the duration, which may be longer than that of the
/// checkpoint. Throws InputError where the folder holds a checkpoint that does not fit, frames of
/// the scene and no checkpoint, files that are damaged or missing, or files in the way that no
/// record lists, and where the run would write over what the scene reads; FailureError where
/// another run of that name is at work; Divergence, with the name of the last frame; and what
/// fill_scene, simulate and write_whole throw.
RunResult run_scene(const Scene& scene, const RunOptions& options);

/// The profile as JSON, times as means over the steps in ms.
std::string profile_text(const Scene& scene, const RunResult& result);

} // namespace meniscus
