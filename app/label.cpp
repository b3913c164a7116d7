// meniscus label: ground truth for snapshots of any format.
#include "label.hpp"

#include <meniscus/app/report/report.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/particles/feature_names.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/particles/periodic_copies.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/labeler/sampling/directions.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <memory>
#include <numeric>

namespace meniscus {
namespace {

/// True where `output` holds the labels that would be made again.
bool is_up_to_date(const Path& output, const Snapshot& input) {
    const auto existing = earlier_output(output, "uncovered_fraction");
    return existing && existing->scene == input.scene && existing->dimension == input.dimension &&
           existing->particle_spacing == input.particle_spacing &&
           (!input.particle_volume || existing->particle_volume == input.particle_volume) &&
           existing->provenance == input.provenance;
}

void report(const Path& output, const Snapshot& snapshot, const Labels& labels,
            double boundary_weight, bool quiet) {
    for (const std::string& warning : labels.warnings)
        print_error_line("warning: " + output.string() + ": " + warning);
    const double mean = mean_neighbor_count(labels);
    const auto [lowest, highest] = plausible_neighbor_counts(snapshot.dimension);
    const bool warned = warn_of_support_radius(output, snapshot, labels.valid, labels.surface);
    if (!warned && snapshot.size() > 0 && (mean < lowest || mean > highest))
        print_error_line(
            fmt::format("warning: {}: a mean neighbor count of {:.1f} is implausible in {}D "
                        "(expected {} to {}); is the {} right?",
                        output.string(), mean, snapshot.dimension, lowest, highest,
                        support_radius_text(snapshot)));
    if (quiet)
        return;
    const auto surface = std::accumulate(labels.surface.begin(), labels.surface.end(), 0UL);
    const auto valid = std::accumulate(labels.valid.begin(), labels.valid.end(), 0UL);
    fmt::print("{}: {} particles in {}D, {} surface, mean neighbor count {:.1f}, h = {:.2f} "
               "spacings{}{}\n{}",
               output.string(), snapshot.size(), snapshot.dimension, surface, mean,
               labels.spacing_ratio,
               snapshot.boundary.empty()
                   ? ""
                   : fmt::format(", {} boundary particles cover{}", snapshot.boundary.size(),
                                 boundary_weight > 0 ? " and count" : ""),
               valid == snapshot.size() ? ""
                                        : fmt::format(", {} left out as not finite or too far out",
                                                      snapshot.size() - valid),
               reading_notes(snapshot));
}

void label_file(const Path& input, const Path& output, const Boundary& boundary,
                const LabelCommand& command) {
    Snapshot snapshot = read_input(input, command.input);
    if (command.no_boundary) {
        remove_periodic_copies(snapshot);
        snapshot.boundary.clear();
    }
    set_boundary(snapshot, boundary);
    set_periodic(snapshot, command.input);
    const SupportRadii radii = support_radii(snapshot);
    set_label_provenance(snapshot, radii, command.label);
    snapshot.provenance["input_hash"] = file_hash(input);
    if (is_up_to_date(output, snapshot)) {
        if (!command.quiet)
            fmt::print("{}: up to date\n", output.string());
        return;
    }
    const Labels labels = [&] {
        ProgressBar bar(output.filename().string(), snapshot.size(), command.quiet);
        LabelOptions options = command.label;
        options.progress = [&](std::size_t done) { bar.show(done); };
        return label_particles(snapshot, radii, options);
    }();
    add_labels(snapshot, labels, radii, command.label);
    {
        const WriteGuard guard;
        write_vtkhdf(snapshot, output);
    }
    report(output, snapshot, labels, command.label.boundary_weight, command.quiet);
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

std::optional<Snapshot> earlier_output(const Path& output, const char* array) {
    if (!std::filesystem::exists(output))
        return {};
    if (is_vtkhdf(output)) {
        Snapshot existing = read_vtkhdf(output);
        if (find_array(existing, array) != nullptr)
            return existing;
    }
    throw InputError(fmt::format("{}: exists and is no snapshot with '{}'; remove it or choose "
                                 "another folder with -o",
                                 output.string(), array));
}

std::vector<Path> run_label(const LabelCommand& command) {
    auto outputs = output_files(command.files);
    const Boundary boundary = read_boundary(command.boundary);
    make_writable_folder(command.files.folder);
    if (command.report) {
        check_can_be_written(*command.report);
        check_is_not_an_input(*command.report, command.files.inputs);
    }
    for (std::size_t f = 0; f < outputs.size(); ++f)
        naming_file(command.files.inputs[f],
                    [&] { label_file(command.files.inputs[f], outputs[f], boundary, command); });
    if (command.report)
        write_report(*command.report, report_page(outputs, {0, {}, command.label.threads}));
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
            "Snapshots, told by their content: the project's own .vtkhdf, VTK's .vtk, .vtu "
            "and .vtp, Partio's .bgeo, HDF5 of PySPH, GADGET and H5Part, CSV with named "
            "columns, .ply, NumPy's .npy, extended .xyz, LAMMPS dumps")
        ->required();
    verb->add_option("-o,--output", options->files.folder,
                     "Folder for the labelled snapshots, DIR/<stem of INPUT>.vtkhdf")
        ->required();
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
    verb->add_option("--report", options->report,
                     "Page of HTML to write: the states and what covers each particle, to look at "
                     "in any browser");
    add_threads_option(*verb, options->label.threads);
    add_quiet_option(*verb, options->quiet);
    verb->callback([options, settle_method] {
        settle_method();
        run_label(*options);
    });
}

} // namespace meniscus
