// meniscus label: ground truth for snapshots of any format.
#include "label.hpp"
#include "earlier_outputs.hpp"
#include "file_batch.hpp"
#include "input_files.hpp"
#include "large_states.hpp"
#include "usage.hpp"

#include <meniscus/app/ranks/ranks_of_program.hpp>
#include <meniscus/app/report/report.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/hdf5/hdf5_signature.hpp>
#include <meniscus/data/particles/feature_names.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/particles/periodic_copies.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/data/threads/threads.hpp>
#include <meniscus/labeler/sampling/directions.hpp>
#include <meniscus/labeler/slabs/label_in_slabs.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <memory>
#include <numeric>

namespace meniscus {
namespace {

/// All that LabelOptions and the command add to an input and its options.
std::vector<std::string> request_words(const LabelCommand& command) {
    const LabelOptions& label = command.label;
    const bool sampled = label.method == LabelMethod::monte_carlo;
    std::vector<std::string> words = {
        sampled ? fmt::format("{} {} {}", label.samples, label.scheme, label.seed) : "exact",
        number_text(label.radius_ratio), number_text(label.boundary_weight),
        command.no_boundary ? "no boundary" : "", label.skip_invalid ? "skip invalid" : ""};
    for (const std::size_t feature : label.features)
        words.emplace_back(feature_list[feature].name);
    return words;
}

/// What there is to say of a state that was labelled.
struct LabelSummary {
    std::uint64_t particles = 0;
    std::uint64_t surface = 0;
    std::uint64_t more = 0; ///< uncovered by more than default_label_threshold
    std::uint64_t valid = 0;
    double mean_neighbors = 0;
    double spacing_ratio = 0;
    std::vector<std::string> warnings; ///< the output's name in front
    bool is_doubtful = false;          ///< the support radius, as a warning says
};

LabelSummary summary_of(const Path& output, const Snapshot& snapshot, const Labels& labels) {
    LabelSummary summary;
    summary.particles = snapshot.size();
    summary.surface = std::accumulate(labels.surface.begin(), labels.surface.end(), 0UL);
    summary.valid = std::accumulate(labels.valid.begin(), labels.valid.end(), 0UL);
    summary.more = static_cast<std::size_t>(
        std::count_if(labels.uncovered_fraction.begin(), labels.uncovered_fraction.end(),
                      [](double lambda) { return lambda > default_label_threshold; }));
    summary.mean_neighbors = mean_neighbor_count(labels);
    summary.spacing_ratio = labels.spacing_ratio;
    for (const std::string& warning : labels.warnings)
        summary.warnings.push_back(output.string() + ": " + warning);
    if (const auto doubt = support_radius_warning(output, snapshot, labels.valid, labels.surface)) {
        summary.warnings.push_back(*doubt);
        summary.is_doubtful = true;
    }
    return summary;
}

LabelSummary summary_of(const Path& output, const RowsOfState& state, const LabelsInFile& labels) {
    LabelSummary summary{state.size, labels.surface, labels.more, labels.valid, 0, 0, {}, false};
    if (labels.valid > 0)
        summary.mean_neighbors = labels.neighbors / static_cast<double>(labels.valid);
    summary.spacing_ratio = labels.spacing_ratio;
    for (const std::string& warning : labels.warnings)
        summary.warnings.push_back(output.string() + ": " + warning);
    return summary;
}

/// `snapshot`: for what the file says of all its particles.
FileReport report_of(const Path& output, const Snapshot& snapshot, LabelSummary summary,
                     double boundary_weight) {
    const auto [lowest, highest] = plausible_neighbor_counts(snapshot.dimension);
    const double mean = summary.mean_neighbors;
    if (!summary.is_doubtful && summary.particles > 0 && (mean < lowest || mean > highest))
        summary.warnings.push_back(
            fmt::format("{}: a mean neighbor count of {:.1f} is implausible in {}D "
                        "(expected {} to {}); is the {} right?",
                        output.string(), mean, snapshot.dimension, lowest, highest,
                        support_radius_text(snapshot)));
    FileReport report;
    report.warnings = std::move(summary.warnings);
    report.counts = {summary.particles, summary.surface, summary.more};
    report.text = fmt::format(
        "{}: {} particles in {}D, {} surface, {} of them more than {} % uncovered, mean neighbor "
        "count {:.1f}, h = {:.2f} spacings{}{}\n{}",
        printable(output.string()), summary.particles, snapshot.dimension, summary.surface,
        summary.more, 100 * default_label_threshold, mean, summary.spacing_ratio,
        snapshot.boundary.empty()
            ? ""
            : fmt::format(", {} boundary particles cover{}", snapshot.boundary.size(),
                          boundary_weight > 0 ? " and count" : ""),
        summary.valid == summary.particles
            ? ""
            : fmt::format(", {} left out as not finite or too far out",
                          summary.particles - summary.valid),
        reading_notes(snapshot));
    return report;
}

Snapshot read_to_label(const Path& input, const Boundary& boundary, const LabelCommand& command) {
    Snapshot snapshot = read_input(input, command.input);
    if (command.no_boundary) {
        remove_periodic_copies(snapshot);
        snapshot.boundary.clear();
    }
    set_boundary(snapshot, boundary);
    set_periodic(snapshot, command.input);
    return snapshot;
}

/// An input and what is to be made of it.
struct LabelJob {
    const Path& input;
    const Path& output;
    const Boundary& boundary;
    const LabelCommand& command;
    const LabelOptions& options; ///< the command's, with the threads that the job may use
    const std::string& request;
    const std::optional<Snapshot>& earlier; ///< what stands at the output
    bool is_quiet;                          ///< no progress is shown
    std::uint64_t memory;                   ///< bytes that the job may take; 0: no limit
};

/// Options that show progress by a bar.
LabelOptions with_progress(LabelOptions options, ProgressBar& bar) {
    options.progress = [&bar](std::size_t done) { bar.show(done); };
    return options;
}

void note_origin(const LabelJob& job, Snapshot& snapshot) {
    set_input_provenance(snapshot, job.input);
    if (!job.command.files.overwrite)
        check_made_from_same(job.output, job.earlier, snapshot);
    snapshot.provenance["request"] = job.request;
}

FileReport label_in_one_pass(const LabelJob& job) {
    Snapshot snapshot = read_to_label(job.input, job.boundary, job.command);
    const SupportRadii radii = support_radii(snapshot);
    note_origin(job, snapshot);
    ProgressBar bar(job.output.filename().string(), snapshot.size(), job.is_quiet);
    const Labels labels = label_particles(snapshot, radii, with_progress(job.options, bar));
    add_labels(snapshot, labels, radii, job.command.label);
    const WriteGuard guard;
    write_vtkhdf(snapshot, job.output);
    return report_of(job.output, snapshot, summary_of(job.output, snapshot, labels),
                     job.command.label.boundary_weight);
}

std::vector<std::uint8_t> is_surface(const std::vector<double>& lambda) {
    std::vector<std::uint8_t> surface(lambda.size());
    std::transform(lambda.begin(), lambda.end(), surface.begin(), [](double one) {
        return static_cast<std::uint8_t>(one > zero_uncovered_fraction);
    });
    return surface;
}

/// Rows of an array that labelling adds, as the frame's empty array has them; nothing where it is
/// one of the input's own.
std::optional<ArrayValues> label_values(const PointArray& array, const RowResults& rows,
                                        std::uint64_t first, std::uint64_t count,
                                        const LabelOptions& options) {
    const auto column = [&](std::size_t number) { return rows.column(number, first, count); };
    if (array.name == "uncovered_fraction")
        return column(lambda_column);
    if (array.name == "surface")
        return stored_classes(is_surface(column(lambda_column)));
    if (array.name == "valid")
        return stored_classes(rows.was_added(first, count));
    if (array.name == "mass_offset")
        return column(mass_offset_column);
    if (array.name == "neighbor_count") {
        std::vector<double> counts = column(count_column);
        if (std::holds_alternative<std::vector<std::uint32_t>>(array.values))
            return std::vector<std::uint32_t>(counts.begin(), counts.end());
        return counts;
    }
    for (std::size_t f = 0; f < options.features.size(); ++f)
        if (array.name == feature_list[options.features[f]].name)
            return column(label_columns + f);
    return std::nullopt;
}

/// Writes what was found; returns the bytes that this rank sent.
std::uint64_t write_labels(const LargeState& large, const LabelsInFile& labels,
                           const LabelOptions& options, const Path& output, Ranks& ranks) {
    Snapshot frame = large.state.frame;
    const SupportRadii radius = *frame.support_radius;
    Labels none;
    none.features.resize(options.features.size());
    none.spacing_ratio = labels.spacing_ratio;
    add_labels(frame, none, radius, options);
    return write_large(
        large, frame,
        [&](const PointArray& array, std::uint64_t first, std::uint64_t count) {
            return label_values(array, *labels.rows, first, count, options);
        },
        output, ranks);
}

FileReport label_large(const LabelJob& job, LargeState large, Ranks& ranks) {
    set_periodic(large, job.command.input, ranks);
    note_origin(job, large.state.frame);
    const SlabOptions slabs = {job.memory, job.command.files.folder};
    ProgressBar bar(job.output.filename().string(),
                    large.state.size / static_cast<std::uint64_t>(ranks.size()),
                    job.is_quiet || ranks.rank() > 0);
    const LabelsInFile labels = label_in_slabs(large.state, with_progress(job.options, bar), slabs,
                                               default_label_threshold, ranks);
    const std::uint64_t sent =
        write_labels(large, labels, job.command.label, job.output, ranks) + labels.bytes_sent;
    FileReport report =
        report_of(job.output, large.state.frame, summary_of(job.output, large.state, labels),
                  job.command.label.boundary_weight);
    report.text += slab_line({labels.slabs, labels.halo, sent}, ranks);
    return report;
}

/// A file that is worked on beside others, with one thread, gets its share of the memory.
LargeStateOptions memory_options(const LabelCommand& command, int threads) {
    const int beside = threads == 1 ? thread_count(command.label.threads) : 1;
    return {"label", command.memory / static_cast<std::uint64_t>(beside), command.input,
            command.no_boundary, ""};
}

std::optional<LargeState> large_to_label(const Path& input, const Boundary& boundary,
                                         const LabelCommand& command, int threads) {
    return large_state(
        input, boundary, memory_options(command, threads),
        [&](const Snapshot& outline) { return memory_in_one_pass(outline, command.label); });
}

/// Labels one of the command's files, which are files and no patterns any more; a state that is too
/// large together with the other ranks, each of which calls this then.
FileReport label_file(const Path& input, const Path& output, const Boundary& boundary, int threads,
                      const LabelCommand& command, Ranks& ranks) {
    std::string request;
    bool is_done = false;
    std::optional<Snapshot> earlier;
    std::optional<LargeState> large;
    do_together(ranks, [&] {
        request = request_of("label", input, command.input, boundary, request_words(command));
        is_done = is_up_to_date(output, request);
        if (is_done)
            return;
        earlier = earlier_output(output, "uncovered_fraction");
        large = large_to_label(input, boundary, command, threads);
    });
    if (is_done)
        return {{}, printable(output.string()) + ": up to date\n", true, {}};
    LabelOptions options = command.label;
    options.threads = threads;
    const bool is_alone = command.files.inputs.size() == 1 || threads != 1;
    const LabelJob job = {input,
                          output,
                          boundary,
                          command,
                          options,
                          request,
                          earlier,
                          command.quiet || !is_alone,
                          memory_options(command, threads).memory};
    return large ? label_large(job, *large, ranks) : label_in_one_pass(job);
}

/// Refuses what no sampling scheme is called.
std::string check_scheme(const std::string& name) {
    try {
        sampling_scheme(name);
        return {};
    } catch (const InputError& error) {
        return error.what();
    }
}

} // namespace

std::vector<Path> run_label(const LabelCommand& asked) {
    LabelCommand command = asked;
    InputsAndFolder& files = command.files;
    files.inputs = input_files(files.inputs);
    auto outputs = output_files(files, {command.boundary}, command.input.frame);
    const Boundary boundary = read_boundary(command.boundary);
    make_writable_folder(files.folder);
    if (command.report) {
        check_can_be_written(*command.report);
        check_is_not_an_input(*command.report, files.inputs);
    }
    FileBatch batch = {
        "labelling",           "labelled",    {"particles", "surface", "more than 2 % uncovered"},
        command.label.threads, command.quiet, command.keep_going};
    const auto label_one = [&](std::size_t f, int threads, Ranks& ranks) {
        return naming_file(files.inputs[f], [&] {
            return label_file(files.inputs[f], outputs[f], boundary, threads, command, ranks);
        });
    };
    batch.is_shared = [&](std::size_t f) {
        return large_to_label(files.inputs[f], boundary, command, 0).has_value();
    };
    batch.work_together = [&](std::size_t f) {
        return label_one(f, command.label.threads, ranks_of_program());
    };
    write_for_each_file(files.inputs, outputs, batch, [&](std::size_t f, int threads) {
        return label_one(f, threads, one_process());
    });
    if (command.report && !is_other_rank())
        write_report(*command.report, report_page(outputs, {{}, {}, command.label.threads}));
    return outputs;
}

/// How lambda is found, and with Monte Carlo by which directions. Directions asked for without a
/// method ask for Monte Carlo.
/// What is returned settles that once the command line is read.
std::function<void()> add_method_options(CLI::App& verb, LabelOptions& options) {
    auto* method = verb.add_option_function<std::string>(
                           "--method",
                           [&options](const std::string& name) {
                               options.method =
                                   name == "exact" ? LabelMethod::exact : LabelMethod::monte_carlo;
                           },
                           "How lambda is found (default: exact, or monte-carlo where --samples, "
                           "--scheme or --seed is given)")
                       ->check(CLI::IsMember({"exact", "monte-carlo"}));
    std::vector<CLI::Option*> of_directions = {
        verb.add_option("--samples", options.samples, "Monte Carlo: directions tested a particle")
            ->check(CLI::Range(1, 1'000'000'000))
            ->capture_default_str(),
        verb.add_option("--scheme", options.scheme,
                        "Monte Carlo: sampling scheme of the directions: " +
                            sampling_scheme_names())
            ->check(check_scheme)
            ->capture_default_str(),
        verb.add_option("--seed", options.seed, "Monte Carlo: seed of the scheme")
            ->check(whole_numbers())
            ->capture_default_str()};
    return [&options, method, of_directions] {
        for (const auto* option : of_directions) {
            if (option->count() > 0 && method->count() == 0)
                options.method = LabelMethod::monte_carlo;
            if (option->count() > 0 && options.method == LabelMethod::exact)
                throw InputError(option->get_name() + " belongs to --method monte-carlo");
        }
    };
}

void add_label(CLI::App& command) {
    auto options = std::make_shared<LabelCommand>();
    auto* verb = command.add_subcommand("label", "Decide which particles of snapshots are surface");
    verb->add_option(
            "INPUT", options->files.inputs,
            fmt::format(
                "Snapshots, told by their content: the project's own .vtkhdf, VTK's .vtk, .vtu "
                "and .vtp, Partio's .bgeo, HDF5 of PySPH, GADGET, H5Part and LagrangeBench, CSV "
                "with named columns, .ply, NumPy's .npy, extended .xyz, LAMMPS dumps, "
                "DeepLagrangianFluids' .msgpack.zst. They are {}",
                input_kinds))
        ->required();
    verb->add_option("-o,--output", options->files.folder,
                     "Folder for the labelled snapshots, DIR/<stem of INPUT>.vtkhdf")
        ->type_name("DIR")
        ->required();
    add_overwrite_option(*verb, options->files);
    add_input_options(*verb, options->input);
    const auto settle_method = add_method_options(*verb, options->label);
    verb->add_option("--radius-ratio", options->label.radius_ratio,
                     "Radius of the covering spheres over h")
        ->capture_default_str();
    auto* boundary = verb->add_option(
        "--boundary", options->boundary,
        "File with the boundary particles, which cover but are not labelled, for all inputs "
        "(default: those that an input holds itself)");
    verb->add_flag("--no-boundary", options->no_boundary,
                   "Boundary particles that an input holds do not cover")
        ->excludes(boundary);
    verb->add_option_function<std::vector<std::string>>(
            "--features",
            [options](const std::vector<std::string>& names) {
                auto& features = options->label.features;
                for (const std::string& name : names)
                    if (name == "all")
                        for (std::size_t feature = 0; feature < feature_count; ++feature)
                            features.push_back(feature);
                    else
                        features.push_back(feature_named(name));
            },
            fmt::format("Features to store beside {}, of {}; or all", names_of(FeaturePair{}),
                        feature_names()))
        ->delimiter(',');
    verb->add_option("--boundary-weight", options->label.boundary_weight,
                     "Share of its volume by which a boundary particle counts in the features; 0: "
                     "it only covers")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
    verb->add_flag(
        "--skip-invalid", options->label.skip_invalid,
        "Leave particles out, with valid = 0, whose position is not finite or lies too far "
        "out for its number type");
    add_memory_option(*verb, options->memory,
                      "States that would take more are labelled in slabs, with the same result; "
                      "for the project's own files");
    verb->add_option("--report", options->report,
                     "Page of HTML to write: the states and what covers each particle, to look at "
                     "in any browser");
    add_threads_option(*verb, options->label.threads);
    add_keep_going_option(*verb, options->keep_going);
    add_quiet_option(*verb, options->quiet);
    add_examples(*verb, {{"meniscus label out/ -o labelled --support-radius 0.1",
                          "all snapshots of a folder"},
                         {"meniscus label 'out/dam_{0:500:10}.vtk' -o labelled --boundary "
                          "walls.vtk --support-radius 0.1",
                          "each tenth frame, with walls from a file of their own"}});
    verb->callback([options, settle_method] {
        settle_method();
        run_label(*options);
    });
}

} // namespace meniscus
