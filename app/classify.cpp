// meniscus classify: the runtime on files. Writes what a solver that uses the model would see.
#include "label.hpp"
#include "surface_tension.hpp"

#include <meniscus/classifier/audit/audit.hpp>
#include <meniscus/classifier/model/classify_snapshot.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/surface/surface_particles.hpp>
#include <meniscus/runtime/version.hpp>

#include <fmt/format.h>
#include <memory>

namespace meniscus {
namespace {

struct ClassifyCommand {
    InputsAndFolder files;
    InputOptions input;
    Path model;
    Path boundary; ///< file of boundary particles; empty: those of the input itself
    SurfaceChoices surface;
    bool skip_invalid = false;
    int threads = 0;
    bool quiet = false;
};

/// 1 for each particle that add_surface() has found to be surface.
std::vector<std::uint8_t> surface_of(const Snapshot& snapshot) {
    std::vector<std::uint8_t> surface;
    for (const double of_particle : scalar_values(snapshot, "surface_class"))
        surface.push_back(of_particle == static_cast<double>(SurfaceClass::surface) ? 1 : 0);
    return surface;
}

void classify_file(const Path& input, const Path& output, const Model& model,
                   const std::string& model_hash, const Boundary& boundary,
                   const SurfaceTensionOptions& options, const ClassifyCommand& command) {
    Snapshot snapshot = read_input(input, command.input);
    set_boundary(snapshot, boundary);
    set_periodic(snapshot, command.input);
    set_input_provenance(snapshot, input);
    const auto earlier = earlier_output(output, "predicted_surface");
    if (!command.files.overwrite)
        check_made_from_same(output, earlier, snapshot);
    const Classes classes =
        classify_snapshot(snapshot, model, {command.skip_invalid, command.threads});
    set_array(snapshot, {"predicted_surface", 1, classes.surface});
    set_array(snapshot, {"valid", 1, classes.valid});
    const SurfaceReport report = add_surface(snapshot, classes, model, options,
                                             command.surface.balance_momentum, command.threads);
    snapshot.provenance["program"] = std::string("meniscus ") + program_version;
    snapshot.provenance["model_hash"] = model_hash;
    {
        const WriteGuard guard;
        write_vtkhdf(snapshot, output);
    }
    for (const std::string& warning : classes.warnings)
        print_error_line("warning: " + input.string() + ": " + warning);
    warn_of_support_radius(input, snapshot, classes.valid, surface_of(snapshot));
    if (!command.quiet)
        print_text(fmt::format("{}: {} particles in {}D, {}{}\n{}{}", printable(output.string()),
                               snapshot.size(), snapshot.dimension,
                               snapshot.boundary.empty() ? ""
                                                         : fmt::format("{} boundary particles, ",
                                                                       snapshot.boundary.size()),
                               report.found, reading_notes(snapshot), report.note));
}

void run_classify(const ClassifyCommand& command) {
    const SurfaceTensionOptions options = surface_options(command.surface);
    const Model model = read_model(command.model);
    const std::string model_hash = file_hash(command.model);
    const auto outputs = output_files(command.files, {command.model, command.boundary});
    const Boundary boundary = read_boundary(command.boundary);
    make_writable_folder(command.files.folder);
    for (std::size_t f = 0; f < outputs.size(); ++f)
        naming_file(command.files.inputs[f], [&] {
            classify_file(command.files.inputs[f], outputs[f], model, model_hash, boundary, options,
                          command);
        });
}

} // namespace

void add_classify(CLI::App& command) {
    auto options = std::make_shared<ClassifyCommand>();
    auto* verb = command.add_subcommand(
        "classify",
        "Apply a model to snapshots, as a solver would: class of each particle, and normal, "
        "curvature and force of those at the surface");
    verb->add_option("INPUT", options->files.inputs, "Snapshots, as for label")->required();
    verb->add_option("--model", options->model, "Model file")->required();
    verb->add_option("-o,--output", options->files.folder,
                     "Folder for the classified snapshots, DIR/<stem of INPUT>.vtkhdf")
        ->required();
    add_overwrite_option(*verb, options->files);
    add_input_options(*verb, options->input);
    verb->add_option("--boundary", options->boundary,
                     "File with the boundary particles for all inputs, which cover, and count "
                     "where the model says so (default: those that an input holds itself)");
    verb->add_flag(
        "--skip-invalid", options->skip_invalid,
        "Leave particles out, with valid = 0, whose position is not finite or lies too far "
        "out for its number type");
    add_surface_options(*verb, options->surface);
    add_threads_option(*verb, options->threads);
    add_quiet_option(*verb, options->quiet);
    verb->callback([options] { run_classify(*options); });
}

} // namespace meniscus
