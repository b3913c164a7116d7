// meniscus simulate: runs a scene and writes its frames, its log and its checkpoints.
#include "command_line.hpp"
#include "frame_series.hpp"
#include "scene_choice.hpp"
#include "scene_model.hpp"
#include "usage.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/sph/run/run.hpp>
#include <meniscus/sph/scene/files_read.hpp>
#include <meniscus/sph/scene/methods.hpp>
#include <meniscus/sph/scene/scene_size.hpp>

#include <fmt/format.h>
#include <memory>
#include <optional>

namespace meniscus {
namespace {

struct SimulateCommand {
    Path scene;
    Path folder;
    Path profile; ///< file; empty for none
    std::string variant;
    std::vector<std::string> changes;
    std::string duration; ///< s; empty: the scene's
    RunOptions run;
    bool quiet = false;
};

/// Says how far a run is and, from what this process has done of it, when it will end.
class RunStatus {
public:
    RunStatus(double its_duration, bool quiet) : duration(its_duration), line(quiet) {}

    void show(const StepReport& report) {
        line.show([&] {
            if (start < 0) { // of what is measured, not of the run
                start = report.time;
                started = Clock::now();
            }
            return text(report);
        });
    }

private:
    using Clock = std::chrono::steady_clock;
    double duration;
    StatusLine line;
    double start = -1;
    Clock::time_point started;

    [[nodiscard]] std::string text(const StepReport& report) const {
        const double passed = std::chrono::duration<double>(Clock::now() - started).count();
        const double done = report.time - start;
        const std::string left =
            done > 0 ? ", " + span_text(passed * (duration - report.time) / done) + " left" : "";
        return fmt::format("{:.4f} / {} s ({:.0f} %), step {:.3g} ms, {} + {} iterations{}",
                           report.time, rounded_text(duration, 4), 100 * report.time / duration,
                           1000 * report.time_step, report.pressure_iterations,
                           report.divergence_iterations, left);
    }
};

/// What takes long before the first step is said beforehand.
void announce(const Scene& scene) {
    constexpr double many = 1e7;
    const SceneSize size = expected_size(scene);
    if (size.fluid + size.walls > many)
        print_error_line(fmt::format(
            "scene '{}' has about {:.2g} fluid and {:.2g} wall particles, which take about {:.2g} "
            "GB and long to fill; a larger particle_spacing makes it smaller",
            scene.name, size.fluid, size.walls, size.memory / 1e9));
}

/// What is likely not meant.
void print_warnings(const Scene& scene) {
    const double stable = longest_stable_step(scene);
    if (scene.time_step.fixed.value_or(0) > stable)
        print_error_line(fmt::format(
            "warning: scene '{}': the fixed time step, {:.3g} s, is longer than {:.3g} s, which "
            "solver, viscosity, surface tension and gravity leave stable",
            scene.name, *scene.time_step.fixed, stable));
}

void print_result(const Scene& scene, const Path& folder, const RunResult& result) {
    const std::string shown = printable(folder.string());
    const StepSums& sums = result.profile.sums;
    if (result.finished && sums.steps == 0) {
        print_text(
            fmt::format("{}: scene '{}' is finished already, {} frames; --restart starts it over\n",
                        shown, scene.name, result.frames));
        return;
    }
    const std::string resumed =
        result.start > 0 ? fmt::format(" from {} s on", rounded_text(result.start, 6)) : "";
    if (result.parted > 0)
        print_text(fmt::format(
            "{}: {} particles started more than a tenth denser than at rest, too close to "
            "walls or each other; they were moved apart before the first step\n",
            shown, result.parted));
    if (result.removed > 0)
        print_text(fmt::format("{}: {} particles left the domain and were removed\n", shown,
                               result.removed));
    const std::string unconverged =
        sums.unconverged_steps > 0
            ? fmt::format(", {} of them not converged", sums.unconverged_steps)
            : "";
    print_text(fmt::format("{}: scene '{}'{}, {} particles, {} frames, {} steps{}, {} s\n", shown,
                           scene.name, resumed, result.particles, result.frames, sums.steps,
                           unconverged, rounded_text(result.time, 6)));
}

void check_profile(const SimulateCommand& command, const Scene& scene) {
    check_is_not_an_input(command.profile, {command.scene});
    check_is_not_an_input(command.profile, files_read_by(scene));
    if (!command.profile.empty() && is_written_by_run(command.profile, scene, command.folder))
        throw InputError(command.profile.string() +
                         ": is a file that the run itself writes; choose another name with "
                         "--profile");
}

std::vector<Path> frames_of(const Scene& scene, const Path& folder, std::uint64_t count) {
    std::vector<Path> frames;
    for (std::uint64_t frame = 0; frame < count; ++frame)
        frames.push_back(frame_file(scene, folder, frame));
    return frames;
}

void run_simulate(const SimulateCommand& command) {
    std::vector<std::string> changes = command.changes;
    if (!command.duration.empty())
        changes.push_back("duration=" + command.duration);
    Scene scene = chosen_scene(command.scene, command.variant, changes, command.quiet);
    use_model_file(scene);
    print_warnings(scene);
    if (!command.profile.empty())
        check_can_be_written(command.profile);
    make_writable_folder(command.folder);
    check_profile(command, scene);
    announce(scene);
    RunResult result;
    {
        std::optional<WriteGuard> guard;
        RunStatus status(scene.duration, command.quiet);
        RunOptions options = command.run;
        options.folder = command.folder;
        options.inputs = {command.scene};
        // An interrupt waits for the step, and for the checkpoint after it.
        options.before_writing = [&] { guard.emplace(); };
        options.on_step = [&](const StepReport& report) { status.show(report); };
        options.stop = interrupt_is_waiting;
        result = run_scene(scene, options);
        write_frame_series(frames_of(scene, command.folder, result.frames));
        if (!command.profile.empty() && result.profile.sums.steps > 0)
            write_whole(command.profile, profile_text(scene, result));
    }
    if (!command.quiet)
        print_result(scene, command.folder, result);
}

void add_run_options(CLI::App& verb, RunOptions& run) {
    verb.add_option("--checkpoint-interval", run.checkpoint_interval,
                    "Time between two checkpoints in s, not simulated but on the clock")
        ->check(CLI::Range(0.0, 1e9))
        ->capture_default_str();
    verb.add_flag(
        "--restart", run.restart,
        "Start over: removes frames, log and checkpoint that the record of an earlier run "
        "of the scene in the folder lists, from which the run would go on otherwise");
    verb.add_flag(
        "--accept-loss", run.accept_loss,
        "Go on although frames or the log of the run are missing or damaged: those frames "
        "stay as they are, the log is written anew (default: refuse)");
    add_threads_option(verb, run.threads);
}

} // namespace

void add_simulate(CLI::App& command) {
    auto options = std::make_shared<SimulateCommand>();
    auto* verb = command.add_subcommand(
        "simulate",
        "Run a scene: a snapshot for each frame, DIR/<scene>_<frame>.vtkhdf, and a log, "
        "DIR/<scene>_log.csv. The same command goes on where it was ended");
    verb->add_option("SCENE", options->scene,
                     fmt::format("Scene file (JSON, see docs/scenes.md), or the name of one that "
                                 "ships: {}",
                                 fmt::join(shipped_scene_names(), ", ")))
        ->required();
    verb->add_option("-o,--output", options->folder, "Folder for what the run writes")
        ->type_name("DIR")
        ->required();
    verb->add_option("--variant", options->variant, "Variant of the scene that its file names");
    verb->add_option("--set", options->changes,
                     "Change of the scene, KEY=VALUE, such as pressure.solver=iisph; the value is "
                     "JSON or a text, null takes the key out. May be given several times")
        ->allow_extra_args(false)
        ->type_name("KEY=VALUE");
    verb->add_option("--duration", options->duration,
                     "Simulated time in s; the same as --set "
                     "duration=VALUE. A run that is there goes on to a longer one");
    verb->add_option("--profile", options->profile,
                     "JSON file for mean times of the steps' stages");
    add_run_options(*verb, options->run);
    add_quiet_option(*verb, options->quiet);
    add_examples(
        *verb,
        {{"meniscus simulate dam_break -o frames", "a scene that ships, or go on with it"},
         {"meniscus simulate scene.json -o frames --variant paper --set pressure.solver=iisph",
          "another size and another solver"}});
    verb->callback([options] { run_simulate(*options); });
}

} // namespace meniscus
