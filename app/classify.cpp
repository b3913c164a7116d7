// meniscus classify: the runtime on files. Writes what a solver that uses the model would see.
#include "classify_in_slabs.hpp"
#include "earlier_outputs.hpp"
#include "file_batch.hpp"
#include "input_files.hpp"
#include "input_options.hpp"
#include "large_states.hpp"
#include "shipped_models.hpp"
#include "surface_tension.hpp"
#include "usage.hpp"

#include <meniscus/app/ranks/ranks_of_program.hpp>
#include <meniscus/app/report/report.hpp>
#include <meniscus/classifier/audit/audit.hpp>
#include <meniscus/classifier/model/classify_snapshot.hpp>
#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/data/threads/threads.hpp>
#include <meniscus/labeler/labeler.hpp>
#include <meniscus/runtime/surface/surface_particles.hpp>
#include <meniscus/runtime/version.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace meniscus {
namespace {

struct ClassifyCommand {
    InputsAndFolder files;
    InputOptions input;
    std::optional<std::string> model; ///< file or name; without, the one that fits
    Path boundary; ///< file of boundary particles; empty: those of the input itself
    SurfaceChoices surface;
    std::optional<Path> report; ///< page to write
    bool skip_invalid = false;
    std::uint64_t memory = 0; ///< bytes; 0: no limit
    int threads = 0;
    bool quiet = false;
    bool keep_going = false;
};

/// 1 for each particle that add_surface() has found to be surface.
std::vector<std::uint8_t> surface_of(const Snapshot& snapshot) {
    std::vector<std::uint8_t> surface;
    for (const double of_particle : scalar_values(snapshot, "surface_class"))
        surface.push_back(of_particle == static_cast<double>(SurfaceClass::surface) ? 1 : 0);
    return surface;
}

/// What is the same for all inputs.
struct Classifier {
    std::optional<NamedModel> model;   ///< the one that was given, or
    std::optional<ModelChoice> choice; ///< those that each input's is chosen from
    SurfaceTensionOptions options;
    Boundary boundary;
};

/// The model for a state, and what there is to note of it.
std::pair<const NamedModel&, std::string> model_for(const Classifier& classifier, int dimension,
                                                    const std::function<double()>& spacing_ratio) {
    if (classifier.model)
        return {*classifier.model, ""};
    const NamedModel& chosen = classifier.choice->at(dimension, spacing_ratio());
    return {chosen, fmt::format("    model {}, of those that ship the one for {}\n", chosen.name,
                                range_text(chosen.model))};
}

std::pair<const NamedModel&, std::string>
model_for(const Classifier& classifier, const Snapshot& snapshot, bool skip_invalid, int threads) {
    return model_for(classifier, snapshot.dimension, [&] {
        const SupportRadii radii = support_radii(snapshot);
        const auto valid = checked_positions(snapshot, radii, skip_invalid);
        return measured_spacing_ratio(snapshot, radii, valid, threads);
    });
}

/// `snapshot`: for what the file says of all its particles.
std::string text_of(const Path& output, std::uint64_t particles, const Snapshot& snapshot,
                    const SurfaceReport& found) {
    return fmt::format("{}: {} particles in {}D, {}{}\n{}{}", printable(output.string()), particles,
                       snapshot.dimension,
                       snapshot.boundary.empty()
                           ? ""
                           : fmt::format("{} boundary particles, ", snapshot.boundary.size()),
                       found.found, reading_notes(snapshot), found.note);
}

FileReport report_of(const Path& input, const Path& output, const Snapshot& snapshot,
                     const Classes& classes, const SurfaceReport& found) {
    FileReport report;
    for (const std::string& warning : classes.warnings)
        report.warnings.push_back(input.string() + ": " + warning);
    const auto surface = surface_of(snapshot);
    if (const auto doubt = support_radius_warning(input, snapshot, classes.valid, surface))
        report.warnings.push_back(*doubt);
    report.counts = {
        snapshot.size(),
        static_cast<std::size_t>(std::count(classes.surface.begin(), classes.surface.end(), 1)),
        static_cast<std::size_t>(std::count(surface.begin(), surface.end(), 1))};
    report.text = text_of(output, snapshot.size(), snapshot, found);
    return report;
}

/// All that the command adds to an input and its options.
std::vector<std::string> request_words(const ClassifyCommand& command,
                                       const Classifier& classifier) {
    std::vector<std::string> words = {classifier.model ? classifier.model->hash
                                                       : classifier.choice->hash(),
                                      command.skip_invalid ? "skip invalid" : "",
                                      command.surface.balance_momentum ? "balance momentum" : ""};
    for (const auto& [name, value] : surface_option_texts(classifier.options))
        words.push_back(name + '=' + value);
    return words;
}

/// An input and what is to be made of it.
struct ClassifyJob {
    const Path& input;
    const Path& output;
    const Classifier& classifier;
    const ClassifyCommand& command;
    int threads;
    std::uint64_t memory; ///< bytes that the job may take; 0: no limit
    std::string request;
    std::optional<Snapshot> earlier; ///< what stands at the output
};

void note_origin(const ClassifyJob& job, Snapshot& snapshot) {
    set_input_provenance(snapshot, job.input);
    if (!job.command.files.overwrite)
        check_made_from_same(job.output, job.earlier, snapshot);
}

void note_classes(const ClassifyJob& job, const NamedModel& model, Snapshot& snapshot) {
    snapshot.provenance["program"] = std::string("meniscus ") + program_version;
    snapshot.provenance["model_hash"] = model.hash;
    snapshot.provenance["request"] = job.request;
}

FileReport classify_in_one_pass(const ClassifyJob& job) {
    const ClassifyCommand& command = job.command;
    Snapshot snapshot = read_input(job.input, command.input);
    set_boundary(snapshot, job.classifier.boundary);
    set_periodic(snapshot, command.input);
    note_origin(job, snapshot);
    const auto [chosen, note] =
        model_for(job.classifier, snapshot, command.skip_invalid, job.threads);
    const Classes classes =
        classify_snapshot(snapshot, chosen.model, {command.skip_invalid, job.threads});
    set_array(snapshot, {"predicted_surface", 1, stored_classes(classes.surface)});
    set_array(snapshot, {"valid", 1, stored_classes(classes.valid)});
    SurfaceReport found = add_surface(snapshot, classes, chosen.model, job.classifier.options,
                                      command.surface.balance_momentum, job.threads);
    found.note += note;
    note_classes(job, chosen, snapshot);
    const WriteGuard guard;
    write_vtkhdf(snapshot, job.output);
    return report_of(job.input, job.output, snapshot, classes, found);
}

/// What classify_in_slabs found, in a line as report_of has it.
FileReport report_of_slabs(const ClassifyJob& job, const LargeState& large,
                           const ClassesInFile& classes, const SurfaceReport& found) {
    const Snapshot& frame = large.state.frame;
    FileReport report;
    for (const std::string& warning : classes.warnings)
        report.warnings.push_back(job.input.string() + ": " + warning);
    report.counts = {large.state.size, classes.counts.candidates, classes.counts.surface};
    report.text = text_of(job.output, large.state.size, frame, found);
    return report;
}

FileReport classify_large(const ClassifyJob& job, LargeState large, Ranks& ranks) {
    set_periodic(large, job.command.input, ranks);
    Snapshot& frame = large.state.frame;
    note_origin(job, frame);
    const NamedModel* chosen = nullptr;
    std::string note;
    const auto choose = [&](double ratio) -> const Model& {
        const auto [model, its_note] =
            model_for(job.classifier, frame.dimension, [&] { return ratio; });
        chosen = &model;
        note = its_note;
        return model.model;
    };
    const ClassesInFile classes = classify_in_slabs(
        large.state, {choose, job.classifier.options, job.command.skip_invalid, job.threads},
        {job.memory, job.command.files.folder}, ranks);
    add_empty_classes(frame);
    SurfaceReport found = note_surface(frame, classes.counts, chosen->model, job.classifier.options,
                                       classes.spacing_ratio, false);
    found.note += note;
    note_classes(job, *chosen, frame);
    const std::uint64_t sent = write_large(
        large, frame,
        [&](const PointArray& array, std::uint64_t first, std::uint64_t count) {
            return class_values(array, *classes.rows, first, count);
        },
        job.output, ranks);
    FileReport report = report_of_slabs(job, large, classes, found);
    report.text += slab_line({classes.slabs, classes.halo, classes.bytes_sent + sent}, ranks);
    return report;
}

/// A file that is worked on beside others, with one thread, gets its share of the memory.
std::uint64_t memory_of(const ClassifyCommand& command, int threads) {
    const int beside = threads == 1 ? thread_count(command.threads) : 1;
    return command.memory / static_cast<std::uint64_t>(beside);
}

std::optional<LargeState> large_to_classify(const Path& input, const Classifier& classifier,
                                            int threads, const ClassifyCommand& command) {
    return large_state(input, classifier.boundary,
                       {"classify", memory_of(command, threads), command.input, false,
                        command.surface.balance_momentum
                            ? "--balance-momentum sums over whole bodies of fluid"
                            : ""},
                       memory_to_classify);
}

/// Classifies one of the command's files; a state that is too large together with the other ranks,
/// each of which calls this then.
FileReport classify_file(const Path& input, const Path& output, const Classifier& classifier,
                         int threads, const ClassifyCommand& command, Ranks& ranks) {
    ClassifyJob job = {input, output, classifier, command, threads, memory_of(command, threads),
                       {},    {}};
    bool is_done = false;
    std::optional<LargeState> large;
    do_together(ranks, [&] {
        job.request = request_of("classify", input, command.input, classifier.boundary,
                                 request_words(command, classifier));
        is_done = is_up_to_date(output, job.request);
        if (is_done)
            return;
        job.earlier = earlier_output(output, "predicted_surface");
        large = large_to_classify(input, classifier, threads, command);
    });
    if (is_done)
        return {{}, printable(output.string()) + ": up to date\n", true, {}};
    return large ? classify_large(job, std::move(*large), ranks) : classify_in_one_pass(job);
}

/// What was classified with the labels beside it that the model was to find.
Snapshot read_and_label(const Path& output, const Model& model, const ClassifyCommand& command) {
    Snapshot snapshot = read_snapshot(output);
    LabelOptions options;
    options.radius_ratio = model.radius_ratio;
    options.boundary_weight = model.boundary_weight;
    options.skip_invalid = command.skip_invalid;
    options.threads = command.threads;
    const SupportRadii radii = support_radii(snapshot);
    add_labels(snapshot, label_particles(snapshot, radii, options), radii, options);
    return snapshot;
}

/// Writes the page of what was classified by the first output's model, whose misses the states'
/// labels tell.
void write_page(const ClassifyCommand& command, const Classifier& classifier,
                const std::vector<Path>& outputs) {
    const auto chosen =
        model_for(classifier, read_snapshot(outputs.front()), command.skip_invalid, command.threads)
            .first;
    std::vector<Path> drawn;
    for (const Path& output : outputs) {
        if (read_vtkhdf_header(output).provenance.at("model_hash") == chosen.hash)
            drawn.push_back(output);
        else
            print_error_line(fmt::format("warning: {}: is not in the report, which is of model {}; "
                                         "give files of another model by themselves",
                                         output.string(), chosen.name));
    }
    AuditOptions options;
    options.threads = command.threads;
    options.read = [&](const Path& output) {
        return read_and_label(output, chosen.model, command);
    };
    AuditReport report = audit(chosen.model, drawn, options);
    report.model.file = chosen.name;
    options.label_threshold = report.label_threshold;
    write_report(*command.report, report_page(report, drawn, options));
}

void run_classify(const ClassifyCommand& command) {
    Classifier classifier;
    classifier.options = surface_options(command.surface);
    if (!command.model)
        classifier.choice.emplace();
    else
        classifier.model = named_model(*command.model);
    InputsAndFolder files = command.files;
    files.inputs = input_files(files.inputs);
    const auto outputs =
        output_files(files, {command.model.value_or(""), command.boundary}, command.input.frame);
    classifier.boundary = read_boundary(command.boundary);
    make_writable_folder(files.folder);
    if (command.report) {
        check_can_be_written(*command.report);
        check_is_not_an_input(*command.report, files.inputs);
    }
    FileBatch batch = {"classifying",   "classified",  {"particles", "candidates", "surface"},
                       command.threads, command.quiet, command.keep_going};
    const auto classify_one = [&](std::size_t f, int threads, Ranks& ranks) {
        return naming_file(files.inputs[f], [&] {
            return classify_file(files.inputs[f], outputs[f], classifier, threads, command, ranks);
        });
    };
    batch.is_shared = [&](std::size_t f) {
        return large_to_classify(files.inputs[f], classifier, 0, command).has_value();
    };
    batch.work_together = [&](std::size_t f) {
        return classify_one(f, command.threads, ranks_of_program());
    };
    write_for_each_file(files.inputs, outputs, batch, [&](std::size_t f, int threads) {
        return classify_one(f, threads, one_process());
    });
    if (command.report && !is_other_rank())
        write_page(command, classifier, outputs);
}

} // namespace

void add_classify(CLI::App& command) {
    auto options = std::make_shared<ClassifyCommand>();
    auto* verb = command.add_subcommand(
        "classify",
        "Apply a model to snapshots, as a solver would: class of each particle, and normal, "
        "curvature and force of those at the surface");
    verb->add_option("INPUT", options->files.inputs, "Snapshots, as for label")->required();
    verb->add_option("--model", options->model,
                     "Model file, or the name of one that ships (default: of these the one that "
                     "fits each input's dimension and h in spacings; see meniscus models)")
        ->type_name("FILE");
    verb->add_option("-o,--output", options->files.folder,
                     "Folder for the classified snapshots, DIR/<stem of INPUT>.vtkhdf")
        ->type_name("DIR")
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
    add_memory_option(*verb, options->memory,
                      "States that would take more are classified in slabs, with the same result; "
                      "for the project's own files");
    verb->add_option("--report", options->report,
                     "Page of HTML to write: the states with their classes, labelled to show what "
                     "the model misses, to look at in any browser");
    add_threads_option(*verb, options->threads);
    add_keep_going_option(*verb, options->keep_going);
    add_quiet_option(*verb, options->quiet);
    add_examples(
        *verb,
        {{"meniscus classify out/ -o classified --support-radius 0.1", "by the model that fits"},
         {"meniscus classify dam_7.vtk -o classified --model model.json --surface-tension 0.072",
          "by a model of your own, with forces for sigma in N/m"}});
    verb->callback([options] { run_classify(*options); });
}

} // namespace meniscus
