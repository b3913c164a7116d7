#include "run.hpp"

#include "checkpoint.hpp"
#include "run_files.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/data/threads/threads.hpp>
#include <meniscus/runtime/version.hpp>
#include <meniscus/sph/scene/files_read.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <vector>

namespace meniscus {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// When frames are due.
struct FrameTimes {
    double interval;
    double duration;
    double rounding;    ///< of times: what lies closer is the same
    std::uint64_t last; ///< frame, the one at the duration

    FrameTimes(double its_interval, double its_duration)
        : interval(its_interval), duration(its_duration), rounding(1e-9 * interval),
          last(last_frame(duration, interval)) {}

    [[nodiscard]] double operator()(std::uint64_t frame) const {
        return std::min(duration, static_cast<double>(frame) * interval);
    }
    /// Whether the last frame comes as long after the one before as all others.
    [[nodiscard]] bool are_even() const {
        return static_cast<double>(last) * interval <= duration + rounding;
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

/// Whether a run can have come to where a checkpoint says: whoever changes one can give it the
/// right sum, too.
void check_progress(const Checkpoint& at, const FrameTimes& frame_time, const LogOptions& log,
                    const fs::path& file) {
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
    refuse_unless(is_plain && at.log.rfind(log_header(log), 0) == 0 &&
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
        : scene(its_scene), options(its_options), text(scene_text(scene)),
          frame_time(scene.frame_interval, scene.duration) {
        result.threads = thread_count(options.threads);
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
    std::optional<RunRecord> record; ///< of a run that has begun
    Checkpoint at;                   ///< its state is filled only while it is written or read
    std::unique_ptr<Simulation> simulation; ///< none where the run had been finished before
    Clock::time_point last_checkpoint;
    RunResult result;

    [[nodiscard]] bool is_finished() const { return at.next_frame > frame_time.last; }

    void begin() {
        if (fs::exists(record_file(scene, options.folder)))
            record.emplace(record_file(scene, options.folder));
        check_inputs();
        const fs::path file = checkpoint_file(scene, options.folder);
        if (!options.restart && fs::exists(file))
            resume(file);
        else
            start();
    }

    void check_inputs() const {
        std::vector<fs::path> inputs = files_read_by(scene);
        inputs.insert(inputs.end(), options.inputs.begin(), options.inputs.end());
        check_inputs_stay(inputs, scene, options.folder);
        if (record && options.restart)
            check_inputs_are_not_listed(inputs, options.folder, *record);
    }

    void start() {
        check_nothing_is_in_the_way(scene, options.folder, record ? &*record : nullptr);
        if (record && !options.restart)
            check_has_no_frames(scene, options.folder, *record);
        simulation = simulate(scene, filled(), result.threads);
        result.parted = simulation->parted();
        options.before_writing();
        open_record();
        remove_recorded(scene, options.folder, *record);
        at.log = log_header(scene.log);
        try {
            list_lasting_files();
            save();
        } catch (...) {
            record->clear();
            throw;
        }
    }

    /// Not before there is something to write, so that a scene that cannot be filled leaves
    /// nothing.
    void open_record() {
        if (record)
            return;
        record.emplace(record_file(scene, options.folder));
        if (!record->files().empty())
            throw FailureError(options.folder.string() + ": another run of scene '" + scene.name +
                               "' has begun in the folder; wait for it to end, or choose another "
                               "folder with -o");
    }

    void list_lasting_files() {
        for (const fs::path& file :
             {checkpoint_file(scene, options.folder), log_file(scene, options.folder)})
            if (record->find(file.filename().string()) == nullptr)
                record->set({file.filename().string(), 0, unsettled});
    }

    void resume(const fs::path& file) {
        at = read_checkpoint(file, text);
        check_lengthening(file);
        check_progress(at, frame_time, scene.log, file);
        result.start = at.state.time;
        result.particles = at.state.positions.size();
        result.finished = is_finished();
        if (!record)
            record.emplace(record_file(scene, options.folder));
        const auto damaged =
            damaged_files(scene, options.folder, *record, at.next_frame, at.log, result.finished);
        if (!damaged.empty() && !options.accept_loss)
            refuse(damaged);
        if (!result.finished)
            simulation = resumed(filled(), file);
        at.state = {};
        last_checkpoint = Clock::now();
        options.before_writing();
        do_without(damaged);
        list_lasting_files();
        check_nothing_is_in_the_way(scene, options.folder, &*record);
        if (simulation && at.duration < scene.duration)
            save(); // of the longer run from now on
    }

    void do_without(const std::vector<DamagedFile>& damaged) {
        const fs::path log = log_file(scene, options.folder);
        for (const DamagedFile& one : damaged)
            if (one.file != log)
                record->set({one.file.filename().string(), 0, lost});
        if (!damaged.empty())
            write_whole(log, at.log);
    }

    /// A longer run has frames at whole intervals where the shorter one ended with part of one.
    void check_lengthening(const fs::path& file) const {
        const FrameTimes before(scene.frame_interval, at.duration);
        if (frame_time.duration > before.duration && at.next_frame > before.last &&
            !before.are_even())
            throw InputError(file.string() + ": the run ended at " + number_text(at.duration) +
                             " s, within a frame_interval of " + number_text(scene.frame_interval) +
                             " s, so that a longer one has other frames; --restart starts the "
                             "scene over, another folder keeps both");
    }

    [[noreturn]] static void refuse(const std::vector<DamagedFile>& damaged) {
        constexpr std::size_t named = 3;
        std::string others;
        for (std::size_t i = 1; i < std::min(damaged.size(), named); ++i)
            others += ", " + damaged[i].file.filename().string() + " " + damaged[i].damage;
        if (damaged.size() > named)
            others += ", and so on for " + std::to_string(damaged.size() - named) + " more";
        throw InputError(damaged[0].file.string() + ": " + damaged[0].damage + others +
                         "; bring back what the run wrote, or go on without it by --accept-loss, "
                         "or start the scene over by --restart");
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
        const fs::path file = frame_file(scene, options.folder, at.next_frame);
        const std::string name = file.filename().string();
        record->set({name, 0, unsettled});
        write_vtkhdf(frame, file);
        record->set({name, fs::file_size(file), file_hash(file)});
        at.log += log_text(row_of(time), scene.log);
        write_whole(log_file(scene, options.folder), at.log);
        at.since_frame = {};
        ++at.next_frame;
    }

    [[nodiscard]] LogRow row_of(double time) const {
        LogRow row{at.next_frame, time, at.since_frame, simulation->balance(), {}};
        if (scene.log.bodies)
            row.bodies =
                find_bodies(simulation->state().positions, scene.support_radius, scene.dimension);
        return row;
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
