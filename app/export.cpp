// meniscus export: a model as a coefficient header for a solver.
#include "command_line.hpp"

#include <meniscus/classifier/header_export.hpp>
#include <meniscus/classifier/model.hpp>
#include <meniscus/data/snapshot_files.hpp>

#include <fmt/format.h>
#include <memory>

namespace meniscus {
namespace {

struct ExportCommand {
    Path model;
    Path output;
    std::string name = "SurfaceCoefficients";
    bool quiet = false;
};

void run_export(const ExportCommand& command) {
    check_is_not_an_input(command.output, {command.model});
    check_can_be_written(command.output);
    const Model model = read_model(command.model);
    const std::string header = coefficient_header(model, command.name);
    const WriteGuard guard;
    write_whole(command.output, header);
    if (!command.quiet)
        fmt::print("{}: struct meniscus::{}\n", command.output.string(), command.name);
}

} // namespace

void add_export(CLI::App& command) {
    auto options = std::make_shared<ExportCommand>();
    auto* verb = command.add_subcommand("export", "Write a model as a C++ coefficient header");
    verb->add_option("MODEL", options->model, "Model file")->required();
    verb->add_option("-o,--output", options->output, "Header to write")->required();
    verb->add_option("--name", options->name, "Name of the struct in namespace meniscus")
        ->capture_default_str();
    add_quiet_option(*verb, options->quiet);
    verb->callback([options] { run_export(*options); });
}

} // namespace meniscus
