// meniscus audit: false negatives and false positives of a model, of another code's free-surface
// detector or of its flags, scene by scene.
#include "command_line.hpp"

#include <meniscus/classifier/audit/audit.hpp>
#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <memory>
#include <optional>

namespace meniscus {
namespace {

struct AuditCommand {
    std::vector<Path> inputs;
    Path model;
    std::string detector;
    std::optional<double> detector_threshold;
    std::string flag;
    std::optional<std::int64_t> flag_min;
    std::optional<double> label_threshold;
    AuditOptions audit;
    std::string format = "table";
    std::optional<std::size_t> max_false_negatives;
    std::optional<double> max_false_positive_rate;
    bool quiet = false;
};

void check_limits(const AuditCommand& command, const AuditReport& report) {
    const std::size_t missed =
        std::max(report.total.false_negatives, report.total.false_negatives_float);
    if (command.max_false_negatives && missed > *command.max_false_negatives)
        throw LimitExceeded(fmt::format("{} false negatives, more than --max-false-negatives {}",
                                        missed, *command.max_false_negatives));
    for (const AuditRow& row : report.scenes)
        if (command.max_false_positive_rate &&
            !(false_positive_rate(row) <= *command.max_false_positive_rate))
            throw LimitExceeded(fmt::format(
                "scene {} has a false-positive rate of {}, more than --max-false-positive-rate {}",
                row.scene, false_positive_rate(row), *command.max_false_positive_rate));
}

/// One thing is judged, and options of another say nothing of it.
void check_what_is_judged(const AuditCommand& command) {
    const int judged =
        int(!command.model.empty()) + int(!command.detector.empty()) + int(!command.flag.empty());
    if (judged == 0)
        throw InputError("one of --model, --detector and --flag is required: a model file, a "
                         "detector of another code, or the name of an array of flags");
    if (judged > 1)
        throw InputError("--model, --detector and --flag stand in each other's place; give one");
    if (command.detector_threshold && command.detector.empty())
        throw InputError("--detector-threshold is for --detector; for flags there is --flag-min");
    if (command.flag_min && command.flag.empty())
        throw InputError("--flag-min is for --flag; for detectors there is --detector-threshold");
}

AuditReport make_report(const AuditCommand& command) {
    AuditOptions options = command.audit;
    options.label_threshold =
        command.label_threshold.value_or(command.model.empty() ? detector_label_threshold : 0);
    if (!command.detector.empty())
        return audit_detector(command.detector, command.detector_threshold, command.inputs,
                              options);
    if (!command.flag.empty())
        return audit_flag({command.flag, command.flag_min.value_or(AuditedFlag{}.min)},
                          command.inputs, options);
    return audit(read_model(command.model), command.inputs, options);
}

std::string detector_names() {
    std::string names;
    for (const DetectorKind& kind : detector_kinds())
        names += (names.empty() ? "" : ", ") + kind.name;
    return names;
}

void run_audit(const AuditCommand& command) {
    check_what_is_judged(command);
    if (std::isnan(command.max_false_positive_rate.value_or(0)))
        throw InputError("--max-false-positive-rate must be a number from 0 to 1, found nan");
    const AuditReport report = make_report(command);
    for (const std::string& warning : report.warnings)
        print_error_line("warning: " + warning);
    const auto print = command.format == "json"  ? to_json
                       : command.format == "csv" ? to_csv
                                                 : to_table;
    if (!command.quiet || command.format != "table")
        print_text(print(report));
    check_limits(command, report);
}

} // namespace

void add_audit(CLI::App& command) {
    auto options = std::make_shared<AuditCommand>();
    auto* verb = command.add_subcommand("audit", "Count false negatives and false positives");
    verb->add_option("LABELLED", options->inputs, "Snapshots that `meniscus label` has written")
        ->required();
    verb->add_option("--model", options->model, "Model file");
    verb->add_option("--detector", options->detector,
                     "In place of a model, the free-surface detector of another code: " +
                         detector_names());
    verb->add_option("--detector-threshold", options->detector_threshold,
                     "Its threshold, in the code's own quantity; default: its authors'");
    verb->add_option("--flag", options->flag,
                     "In place of a model, an array of flags that the snapshots have");
    verb->add_option("--flag-min", options->flag_min,
                     "A flag of at least this is surface (default 1; 2 for DualSPHysics' FSType)");
    verb->add_option("--label-threshold", options->label_threshold,
                     "Surface means an uncovered fraction above this; default: 0 for a model, "
                     "0.02 for a detector or flags");
    verb->add_option("--scene", options->audit.scene,
                     "Scene of all snapshots, in place of their own");
    verb->add_option("--format", options->format, "table, json or csv")
        ->check(CLI::IsMember({"table", "json", "csv"}))
        ->capture_default_str();
    verb->add_option("--max-false-negatives", options->max_false_negatives,
                     "Exit with status 1 above this many, over all files, in float or double")
        ->check(whole_numbers());
    verb->add_option("--max-false-positive-rate", options->max_false_positive_rate,
                     "Exit with status 1 where a scene's rate over all particles is above this")
        ->check(CLI::Range(0.0, 1.0));
    add_threads_option(*verb, options->audit.threads);
    verb->add_flag(
        "-q,--quiet", options->quiet,
        "Print no table, only errors and warnings; json and csv are printed all the same");
    verb->callback([options] { run_audit(*options); });
}

} // namespace meniscus
