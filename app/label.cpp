// meniscus label: ground truth for snapshots of any format.
#include "label.hpp"

#include <meniscus/data/errors.hpp>
#include <meniscus/data/snapshot_files.hpp>
#include <meniscus/data/text.hpp>
#include <meniscus/data/vtkhdf.hpp>
#include <meniscus/labeler/directions.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <numeric>

namespace meniscus {
namespace {

/// Everything that an output must say of itself to be kept on a rerun.
std::map<std::string, std::string> expected_provenance(const Snapshot& input,
                                                       const std::string& input_hash,
                                                       const LabelOptions& options) {
    auto provenance = input.provenance;
    for (const auto& [name, value] : label_provenance(*input.support_radius, options))
        provenance[name] = value;
    provenance["input_hash"] = input_hash;
    return provenance;
}

/// True where `output` holds the labels that would be made again.
bool is_up_to_date(const Path& output, const Snapshot& input,
                   const std::map<std::string, std::string>& expected) {
    const auto existing = earlier_output(output, "uncovered_fraction");
    return existing && existing->scene == input.scene && existing->dimension == input.dimension &&
           existing->particle_spacing == input.particle_spacing && existing->provenance == expected;
}

void report(const Path& output, const Snapshot& snapshot, const Labels& labels, bool quiet) {
    const double mean = mean_neighbor_count(labels);
    const auto [lowest, highest] = plausible_neighbor_counts(snapshot.dimension);
    if (snapshot.size() > 0 && (mean < lowest || mean > highest))
        print_error_line(fmt::format(
            "warning: {}: a mean neighbor count of {:.1f} is implausible in {}D "
            "(expected {} to {}); is the support radius of {} m right?",
            output.string(), mean, snapshot.dimension, lowest, highest, *snapshot.support_radius));
    if (quiet)
        return;
    const auto surface = std::accumulate(labels.surface.begin(), labels.surface.end(), 0UL);
    const auto valid = std::accumulate(labels.valid.begin(), labels.valid.end(), 0UL);
    fmt::print("{}: {} particles in {}D, {} surface, mean neighbor count {:.1f}{}\n",
               output.string(), snapshot.size(), snapshot.dimension, surface, mean,
               valid == snapshot.size()
                   ? ""
                   : fmt::format(", {} left out as not finite", snapshot.size() - valid));
}

void label_file(const Path& input, const Path& output, const LabelCommand& command) {
    Snapshot snapshot = read_input(input, command.input);
    const auto expected = expected_provenance(snapshot, file_hash(input), command.label);
    if (is_up_to_date(output, snapshot, expected)) {
        if (!command.quiet)
            fmt::print("{}: up to date\n", output.string());
        return;
    }
    const Labels labels = [&] {
        ProgressBar bar(output.filename().string(), snapshot.size(), command.quiet);
        LabelOptions options = command.label;
        options.progress = [&](std::size_t done) { bar.show(done); };
        return label_particles(snapshot, *snapshot.support_radius, options);
    }();
    snapshot.provenance = expected;
    add_labels(snapshot, labels, *snapshot.support_radius, command.label);
    {
        const WriteGuard guard;
        write_vtkhdf(snapshot, output);
    }
    report(output, snapshot, labels, command.quiet);
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
    make_writable_folder(command.files.folder);
    for (std::size_t f = 0; f < outputs.size(); ++f)
        naming_file(command.files.inputs[f],
                    [&] { label_file(command.files.inputs[f], outputs[f], command); });
    return outputs;
}

void add_label(CLI::App& command) {
    auto options = std::make_shared<LabelCommand>();
    auto method = std::make_shared<std::string>("monte-carlo");
    auto* verb = command.add_subcommand("label", "Decide which particles of snapshots are surface");
    verb->add_option("INPUT", options->files.inputs,
                     "Snapshots: the project's own .vtkhdf files "
                     "or SPlisHSPlasH's legacy .vtk")
        ->required();
    verb->add_option("-o,--output", options->files.folder,
                     "Folder for the labelled snapshots, DIR/<stem of INPUT>.vtkhdf")
        ->required();
    add_input_options(*verb, options->input);
    verb->add_option("--method", *method, "How lambda is found")
        ->check(CLI::IsMember({"monte-carlo"}))
        ->capture_default_str();
    verb->add_option("--samples", options->label.samples, "Directions tested a particle")
        ->check(CLI::Range(1, 1'000'000'000))
        ->capture_default_str();
    verb->add_option("--scheme", options->label.scheme,
                     "Sampling scheme of the directions: " + sampling_scheme_names())
        ->check(check_scheme)
        ->capture_default_str();
    verb->add_option("--seed", options->label.seed, "Seed of the scheme")
        ->check(whole_numbers())
        ->capture_default_str();
    verb->add_option("--radius-ratio", options->label.radius_ratio,
                     "Radius of the covering spheres over h")
        ->capture_default_str();
    verb->add_flag("--skip-invalid", options->label.skip_invalid,
                   "Leave particles whose position is not finite out, with valid = 0");
    add_threads_option(*verb, options->label.threads);
    add_quiet_option(*verb, options->quiet);
    verb->callback([options] { run_label(*options); });
}

} // namespace meniscus
