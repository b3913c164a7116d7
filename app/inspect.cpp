// meniscus inspect: what a file is and holds, in some lines.
#include "file_batch.hpp"
#include "input_files.hpp"
#include "inspect_arrays.hpp"
#include "label.hpp"
#include "shipped_models.hpp"
#include "usage.hpp"

#include <meniscus/data/formats/snapshot_formats.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/particles/nearest_spacing.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/sph/scene/scene.hpp>

#include <fmt/format.h>
#include <memory>

namespace meniscus {
namespace {

struct InspectCommand {
    std::vector<Path> inputs;
    InputOptions input;
    int threads = 0;
    bool keep_going = false;
    bool quiet = false;
};

std::string line(const char* name, const std::string& text) {
    return text.empty() ? "" : fmt::format("  {:<12} {}\n", name, text);
}

std::string format_of(const Path& file) {
    if (is_vtkhdf(file))
        return "VTKHDF";
    for (const SnapshotFormat& format : snapshot_formats())
        if (format.detect(file))
            return format.name;
    return "";
}

/// What the verbs of this project have made of it.
std::string made_by(const Snapshot& snapshot) {
    const auto has = [&](const char* array) { return find_array(snapshot, array) != nullptr; };
    const auto program = snapshot.provenance.find("program");
    if (program == snapshot.provenance.end())
        return "";
    return fmt::format(", {}{}{}", program->second, has("uncovered_fraction") ? ", labelled" : "",
                       has("predicted_surface") ? ", classified" : "");
}

/// Which of the models that ship fits, or why none does.
std::string fitting_model(int dimension, double spacing_ratio) {
    try {
        return ModelChoice().at(dimension, spacing_ratio).name + " fits, of those that ship";
    } catch (const InputError& error) {
        return error.what();
    }
}

/// Support radius and what follows from it.
std::string radius_lines(const Snapshot& snapshot, int threads) {
    if (!snapshot.support_radius && find_array(snapshot, "support_radius") == nullptr)
        return line("h", "not stored; label and classify need --support-radius");
    const SupportRadii radii = support_radii(snapshot);
    const auto valid = checked_positions(snapshot, radii, true);
    const double ratio = measured_spacing_ratio(snapshot, radii, valid, threads);
    const std::string length =
        radii.vary() ? fmt::format("{} to {}", short_text(radii.min), short_text(radii.max))
                     : short_text(radii.max);
    const std::string doubt = doubtful_support_radius(snapshot, radii, valid);
    return line("h", fmt::format("{} m, {:.2f} spacings of particles at rest{}", length, ratio,
                                 snapshot.particle_volume ? "" : ", as measured")) +
           line("model", doubt.empty() ? fitting_model(snapshot.dimension, ratio) : doubt);
}

std::string length_lines(const Snapshot& snapshot) {
    std::string text;
    if (snapshot.particle_spacing)
        text += line("spacing", short_text(*snapshot.particle_spacing) + " m, initially");
    if (snapshot.particle_volume)
        text += line("volume", fmt::format("{} m^{} at rest", short_text(*snapshot.particle_volume),
                                           snapshot.dimension));
    return text;
}

std::string particles_text(const Snapshot& snapshot) {
    const std::size_t finite = extent_of(snapshot.positions).finite;
    return fmt::format("{} in {}D, positions in {}{}", snapshot.size(), snapshot.dimension,
                       snapshot.position_precision == Precision::float32 ? "float" : "double",
                       finite == snapshot.size()
                           ? ""
                           : fmt::format(", {} of them not finite", snapshot.size() - finite));
}

std::string boundary_text(const Snapshot& snapshot) {
    return snapshot.boundary.empty()
               ? ""
               : fmt::format("{} particles, {}", snapshot.boundary.size(),
                             extent_text(extent_of(snapshot.boundary), snapshot.dimension));
}

std::string provenance_lines(const Snapshot& snapshot) {
    std::string text = snapshot.provenance.empty() ? "" : "  provenance\n";
    for (const auto& [name, value] : snapshot.provenance)
        text += fmt::format("    {:<28} {}\n", name,
                            value.size() > 66 ? value.substr(0, 63) + "..." : value);
    return text;
}

std::string snapshot_text(const Path& file, const InspectCommand& command) {
    const Snapshot snapshot = read_with_options(file, command.input);
    std::string text = fmt::format("{}: {}{}\n", file.string(), format_of(file), made_by(snapshot));
    text += line("particles", particles_text(snapshot));
    text += line("extent", extent_text(extent_of(snapshot.positions), snapshot.dimension));
    text += line("scene", snapshot.scene);
    text += line("time", snapshot.time ? short_text(*snapshot.time) + " s" : "");
    text += length_lines(snapshot);
    text += radius_lines(snapshot, command.threads);
    text += line("boundary", boundary_text(snapshot));
    text += line("phases", phases_text(snapshot));
    for (const std::string& note : snapshot.notes)
        text += line("note", note);
    text += snapshot.point_data.empty() ? "" : "  arrays\n";
    for (const PointArray& array : snapshot.point_data)
        text += array_lines(array);
    return text + provenance_lines(snapshot);
}

std::string model_lines(const Path& file) {
    const Model model = read_model(file);
    std::string text = fmt::format("{}: a model ({})\n", file.string(), model.objective);
    text += line("line", line_text(model.line, model.features, 6));
    if (model.second)
        text += line("second line", line_text(model.second->line, model.second->features, 6));
    text += line("for", range_text(model));
    text += line("surface", fmt::format("more than {} % uncovered", 100 * model.label_threshold));
    return text + line("trained on", fmt::format("{} files: {} false negatives, {} false positives",
                                                 model.training_files.size(), model.false_negatives,
                                                 model.false_positives));
}

std::string scene_lines(const Path& file) {
    const Scene scene = read_scene(file, "");
    std::string variants;
    for (const std::string& variant : scene_variants(file))
        variants += (variants.empty() ? "" : ", ") + variant;
    std::string text = fmt::format("{}: a scene, '{}'\n", file.string(), scene.name);
    text += line("particles",
                 fmt::format("spacing {} m, h {} m ({:.2f} spacings), {}D",
                             short_text(scene.particle_spacing), short_text(scene.support_radius),
                             spacing_ratio(scene), scene.dimension));
    text += line("duration", fmt::format("{} s, a frame each {} s", short_text(scene.duration),
                                         short_text(scene.frame_interval)));
    text += line("pressure", scene.pressure.solver);
    text += line("tension", scene.surface_tension.model);
    return text + line("variants", variants);
}

std::string file_text(const Path& file, const InspectCommand& command) {
    if (read_whole(file, 1) != "{")
        return snapshot_text(file, command);
    const Json json = parse_json(text_of_file(file, "a file"), file.string(), "a known file");
    const std::string kind = kind_of_json(json);
    if (kind == "a model")
        return model_lines(file);
    if (kind == "a scene")
        return scene_lines(file);
    return kind.empty() ? snapshot_text(file, command) // which says what is wrong
                        : fmt::format("{}: {}\n", file.string(), kind);
}

void run_inspect(const InspectCommand& command) {
    const std::vector<Path> files = input_files(command.inputs);
    const FileBatch batch = {"reading",       "read",        {},
                             command.threads, command.quiet, command.keep_going};
    for_each_file(files, batch, [&](std::size_t f, int) {
        return naming_file(files[f], [&] {
            return FileReport{{}, file_text(files[f], command), false, {}};
        });
    });
}

} // namespace

void add_inspect(CLI::App& command) {
    auto options = std::make_shared<InspectCommand>();
    auto* verb = command.add_subcommand(
        "inspect", "Say what files are and hold: extent, h in spacings, arrays with their ranges, "
                   "walls, phases, where they come from; of models and scenes too");
    verb->add_option("INPUT", options->inputs,
                     fmt::format("Snapshots of any format, models, scenes: {}", input_kinds))
        ->required()
        ->type_name("FILE");
    add_input_options(*verb, options->input);
    add_threads_option(*verb, options->threads);
    add_keep_going_option(*verb, options->keep_going);
    add_quiet_option(*verb, options->quiet);
    add_examples(*verb, {{"meniscus inspect out/dam_100.vtk --support-radius 0.1",
                          "what a solver has written, and whether h fits it"},
                         {"meniscus inspect model.json", "the line that a model file holds"}});
    verb->callback([options] { run_inspect(*options); });
}

} // namespace meniscus
