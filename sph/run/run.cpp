#include "run.hpp"

#include "checkpoint.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/version.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <omp.h>
#include <vector>

namespace meniscus {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* extension = ".vtkhdf";

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// When frames are due.
struct FrameTimes {
    double interval;
    double duration;
    double rounding;    ///< of times: what lies closer is the same
    std::uint64_t last; ///< frame, the one at the duration

    explicit FrameTimes(const Scene& scene)
        : interval(scene.frame_interval), duration(scene.duration), rounding(1e-9 * interval),
          last(static_cast<std::uint64_t>(std::ceil(duration / interval - 1e-9))) {}

    [[nodiscard]] double operator()(std::uint64_t frame) const {
        return std::min(duration, static_cast<double>(frame) * interval);
    }
};

/// The longest that a step may be, s, when a frame is due in `remaining`: such that the steps up to
/// it end there, with none much smaller than the others where they are about as long as the usual
/// one. `rounding` is far below both.
double longest_step(double remaining, double usual, double rounding) {
    const bool one_step_is_enough = remaining <= usual + rounding;
    const bool more_than_two_remain = remaining >= 2 * usual - rounding;
    return one_step_is_enough || more_than_two_remain ? remaining : remaining / 2;
}

bool is_frame_of(const Scene& scene, const fs::path& file) {
    const std::string stem = file.stem().string();
    const std::string start = scene.name + "_";
    return file.extension() == extension && stem.size() >= start.size() + 4 &&
           stem.rfind(start, 0) == 0 &&
           stem.find_first_not_of("0123456789", start.size()) == std::string::npos;
}

std::vector<fs::path> frames_in(const Scene& scene, const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> frames;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (is_frame_of(scene, entry.path()))
            frames.push_back(entry.path());
    if (error)
        throw InputError(folder.string() + ": cannot be listed: " + error.message());
    std::sort(frames.begin(), frames.end());
    return frames;
}

void remove_file(const fs::path& file) {
    std::error_code error;
    fs::remove(file, error);
    if (error)
        throw InputError(file.string() + ": cannot be removed: " + error.message());
}

/// Makes room for a run that starts over. The checkpoint goes first, so that nobody goes on from it
/// when not all is gone.
void remove_earlier_run(const Scene& scene, const fs::path& folder) {
    remove_file(checkpoint_file(scene, folder));
    remove_file(log_file(scene, folder));
    for (const fs::path& frame : frames_in(scene, folder))
        remove_file(frame);
}

/// A run writes its first checkpoint before its first frame, so these frames are of another one.
void check_has_no_frames(const Scene& scene, const fs::path& folder) {
    const auto frames = frames_in(scene, folder);
    if (!frames.empty())
        throw InputError(frames[0].string() + ": the folder has frames of scene '" + scene.name +
                         "' and no checkpoint to go on from; choose another folder, or --restart, "
                         "which removes them");
}

/// Whether a run can have come to where a checkpoint says: whoever changes one can give it the
/// right sum, too.
void check_progress(const Checkpoint& at, const FrameTimes& frame_time, const fs::path& file) {
    const double time = at.state.time;
    const StepSums& sums = at.since_frame;
    const auto refuse_unless = [&](bool fine, const std::string& what) {
        if (!fine)
            throw InputError(file.string() + ": is damaged: no run of the scene has " + what +
                             "; --restart starts the scene over");
    };
    refuse_unless(at.next_frame <= frame_time.last + 1,
                  std::to_string(at.next_frame) + " frames behind it");
    const double from = at.next_frame == 0 ? 0 : frame_time(at.next_frame - 1);
    refuse_unless(time >= from - frame_time.rounding &&
                      time <= frame_time(at.next_frame) + frame_time.rounding,
                  "a time of " + number_text(time) + " s before frame " +
                      std::to_string(at.next_frame));
    refuse_unless(at.usual_step >= 0 && at.usual_step <= frame_time.duration + frame_time.rounding,
                  "a time step of " + number_text(at.usual_step) + " s");
    refuse_unless(sums.steps <= at.state.steps && sums.unconverged_steps <= sums.steps &&
                      sums.time >= 0 && sums.time <= frame_time.duration + frame_time.rounding,
                  "these sums over its steps");
    const bool is_plain = std::all_of(at.log.begin(), at.log.end(),
                                      [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); });
    const auto lines = std::count(at.log.begin(), at.log.end(), '\n');
    refuse_unless(is_plain && at.log.rfind(log_header(), 0) == 0 &&
                      static_cast<std::uint64_t>(lines) == at.next_frame + 1,
                  "this log");
}

struct Stage {
    const char* name;
    double StageTimes::*seconds;
};

constexpr Stage stages[] = {
    {"sort", &StageTimes::sort},           {"neighbors", &StageTimes::neighbors},
    {"density", &StageTimes::density},     {"surface_tension", &StageTimes::surface_tension},
    {"viscosity", &StageTimes::viscosity}, {"divergence", &StageTimes::divergence},
    {"pressure", &StageTimes::pressure},   {"motion", &StageTimes::motion}};

void add_step(StepProfile& profile, const StepReport& report, double seconds) {
    profile.sums.add(report);
    profile.total += seconds;
    for (const Stage& stage : stages)
        profile.seconds.*stage.seconds += report.seconds.*stage.seconds;
}

class Run {
public:
    Run(const Scene& its_scene, const RunOptions& its_options)
        : scene(its_scene), options(its_options), text(scene_text(scene)), frame_time(scene) {
        result.threads = options.threads > 0 ? options.threads : omp_get_max_threads();
    }

    RunResult run() {
        begin();
        while (!result.finished) {
            if (simulation->time() >= frame_time(at.next_frame) - frame_time.rounding)
                write_frame();
            result.finished = is_finished();
            const bool stops = result.finished || options.stop();
            if (stops || seconds_since(last_checkpoint) >= options.checkpoint_interval)
                save();
            if (stops)
                break;
            advance();
        }
        result.time = simulation ? simulation->time() : result.start;
        result.removed = simulation ? result.particles - simulation->size() : 0;
        result.frames = at.next_frame;
        return result;
    }

private:
    const Scene& scene;
    const RunOptions& options;
    const std::string text;
    const FrameTimes frame_time;
    Checkpoint at; ///< its state is filled only while it is written or read
    std::unique_ptr<Simulation> simulation; ///< none where the run had been finished before
    Clock::time_point last_checkpoint;
    RunResult result;

    [[nodiscard]] bool is_finished() const { return at.next_frame > frame_time.last; }

    void begin() {
        const fs::path file = checkpoint_file(scene, options.folder);
        if (!options.restart && fs::exists(file)) {
            resume(file);
            return;
        }
        if (!options.restart)
            check_has_no_frames(scene, options.folder);
        simulation = simulate(scene, filled(), result.threads);
        result.parted = simulation->parted();
        if (options.restart)
            remove_earlier_run(scene, options.folder);
        at.log = log_header();
        save();
    }

    void resume(const fs::path& file) {
        at = read_checkpoint(file, text);
        check_progress(at, frame_time, file);
        result.start = at.state.time;
        result.particles = at.state.positions.size();
        result.finished = is_finished();
        if (!result.finished)
            simulation = resumed(filled(), file);
        at.state = {};
        last_checkpoint = Clock::now();
    }

    std::unique_ptr<Simulation> resumed(const SceneParticles& particles, const fs::path& file) {
        if (particles.positions.size() < at.state.positions.size())
            throw InputError(file.string() + ": has " + std::to_string(at.state.positions.size()) +
                             " particles, expected no more than the scene's " +
                             std::to_string(particles.positions.size()) +
                             "; --restart starts the scene over");
        return simulate(scene, particles, at.state, result.threads);
    }

    SceneParticles filled() {
        SceneParticles particles = fill_scene(scene);
        result.particles = particles.positions.size();
        result.wall_particles = particles.walls.size();
        return particles;
    }

    void save() {
        at.state = simulation->state();
        write_checkpoint(at, scene, text, checkpoint_file(scene, options.folder));
        at.state = {};
        last_checkpoint = Clock::now();
    }

    void write_frame() {
        const double time = frame_time(at.next_frame);
        Snapshot frame = simulation->snapshot();
        frame.time = time;
        frame.provenance["program"] = std::string("meniscus ") + program_version;
        frame.provenance["scene_text"] = text;
        write_vtkhdf(frame, frame_file(scene, options.folder, at.next_frame));
        at.log += log_row(at.next_frame, time, at.since_frame, simulation->balance());
        write_whole(log_file(scene, options.folder), at.log);
        at.since_frame = {};
        ++at.next_frame;
    }

    void advance() {
        const double longest = longest_step(frame_time(at.next_frame) - simulation->time(),
                                            at.usual_step, frame_time.rounding);
        const Clock::time_point start = Clock::now();
        const StepReport report = step(longest);
        add_step(result.profile, report, seconds_since(start));
        at.usual_step = report.time_step < longest ? report.time_step
                                                   : std::max(at.usual_step, report.time_step);
        at.since_frame.add(report);
        options.on_step(report);
    }

    StepReport step(double longest) {
        try {
            return simulation->step(longest);
        } catch (const Divergence& error) {
            throw Divergence(std::string(error.what()) + "; the last good frame is " +
                             frame_file(scene, options.folder, at.next_frame - 1).string());
        }
    }
};

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

RunResult run_scene(const Scene& scene, const RunOptions& options) {
    return Run(scene, options).run();
}

std::string profile_text(const Scene& scene, const RunResult& result) {
    const StepSums& sums = result.profile.sums;
    const auto mean = [&](auto sum) {
        return sums.steps == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(sums.steps);
    };
    Json profile{{"scene", scene.name},
                 {"variant", scene.variant},
                 {"particles", result.particles},
                 {"wall_particles", result.wall_particles},
                 {"threads", result.threads},
                 {"steps", sums.steps},
                 {"simulated_seconds", sums.time},
                 {"mean_pressure_iterations", mean(sums.pressure_iterations)},
                 {"mean_divergence_iterations", mean(sums.divergence_iterations)}};
    Json& milliseconds = profile["mean_milliseconds"];
    for (const Stage& stage : stages)
        milliseconds[stage.name] = 1000 * mean(result.profile.seconds.*stage.seconds);
    milliseconds["total"] = 1000 * mean(result.profile.total);
    return profile.dump(2) + "\n";
}

} // namespace meniscus
