// meniscus export: a model of either kind as a coefficient header for a solver.
#include "command_line.hpp"
#include "usage.hpp"

#include <meniscus/classifier/curvature/curvature_model.hpp>
#include <meniscus/classifier/export/header_export.hpp>
#include <meniscus/classifier/model/model.hpp>
#include <meniscus/data/text/files.hpp>

#include <fmt/format.h>
#include <memory>
#include <optional>

namespace meniscus {
namespace {

struct ExportCommand {
    Path model;
    Path output;
    std::optional<std::string> name; ///< without it, by the kind of model
    bool quiet = false;
};

/// The struct's name and the header.
std::pair<std::string, std::string> named_header(const ExportCommand& command) {
    if (!is_curvature_model(command.model)) {
        const std::string name = command.name.value_or("SurfaceCoefficients");
        return {name, coefficient_header(read_model(command.model), name)};
    }
    const CurvatureModel model = read_curvature_model(command.model);
    const std::string name = command.name.value_or(
        model.map.dimension == 2 ? "CurvatureCoefficients2D" : "CurvatureCoefficients");
    return {name, coefficient_header(model, name)};
}

void run_export(const ExportCommand& command) {
    check_is_not_an_input(command.output, {command.model});
    check_can_be_written(command.output);
    const auto [name, header] = named_header(command);
    const WriteGuard guard;
    write_whole(command.output, header);
    if (!command.quiet)
        print_text(
            fmt::format("{}: struct meniscus::{}\n", printable(command.output.string()), name));
}

} // namespace

void add_export(CLI::App& command) {
    auto options = std::make_shared<ExportCommand>();
    auto* verb = command.add_subcommand("export", "Write a model as a C++ coefficient header");
    verb->add_option("MODEL", options->model, "Model that train or calibrate wrote")->required();
    verb->add_option("-o,--output", options->output, "Header to write")->required();
    verb->add_option(
        "--name", options->name,
        "Name of the struct in namespace meniscus; SurfaceCoefficients, or of a curvature "
        "model CurvatureCoefficients, in two dimensions CurvatureCoefficients2D");
    add_quiet_option(*verb, options->quiet);
    add_examples(*verb, {{"meniscus export model.json -o surface_coefficients.hpp",
                          "the header that a solver includes"}});
    verb->callback([options] { run_export(*options); });
}

} // namespace meniscus
