// meniscus calibrate: the curvature map, from clouds of known curvature.
#include "command_line.hpp"
#include "threads.hpp"
#include "usage.hpp"

#include <meniscus/classifier/curvature/curvature_model.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <fmt/format.h>
#include <memory>
#include <optional>

namespace meniscus {
namespace {

struct CalibrateCommand {
    Path configuration;
    Path output;
    bool quiet = false;
};

CurvatureModel calibrated(const CalibrateCommand& command) {
    const Calibration calibration = read_calibration(command.configuration);
    std::optional<ProgressBar> bar;
    return naming_file(command.configuration, [&] {
        return calibrate(calibration, [&](std::size_t done, std::size_t total) {
            if (!bar)
                bar.emplace("filling clouds", total, command.quiet);
            bar->show(done);
        });
    });
}

void run_calibrate(const CalibrateCommand& command) {
    check_is_not_an_input(command.output, {command.configuration});
    check_can_be_written(command.output);
    check_threads_start(0);
    const CurvatureModel model = calibrated(command);
    {
        const WriteGuard guard;
        write_whole(command.output, curvature_model_to_json(model));
    }
    if (command.quiet)
        return;
    print_text(fmt::format("{}: h kappa =", printable(command.output.string())));
    for (std::size_t term = 0; term < curvature_terms().size(); ++term)
        if (model.map.coefficients[term] != 0)
            print_text(
                fmt::format(" {:+.5f} {}", model.map.coefficients[term], curvature_terms()[term]));
    print_text(fmt::format(" ({} particles of {} clouds)\n", model.particles, model.cloud_count));
    for (const std::string& line : residual_lines(model))
        print_text(fmt::format("  {}\n", line));
}

} // namespace

void add_calibrate(CLI::App& command) {
    auto options = std::make_shared<CalibrateCommand>();
    auto* verb = command.add_subcommand(
        "calibrate", "Fit the curvature map to clouds of known curvature (needs libtorch)");
    verb->add_option("CONFIG", options->configuration,
                     "Which clouds: a file such as configs/curvature/solver_like_3d.json")
        ->required();
    verb->add_option("-o,--output", options->output, "Curvature model (JSON)")->required();
    add_quiet_option(*verb, options->quiet);
    add_examples(*verb,
                 {{"meniscus calibrate configs/curvature/solver_like_3d.json -o curvature.json",
                   "the map that ships"}});
    verb->callback([options] { run_calibrate(*options); });
}

} // namespace meniscus
