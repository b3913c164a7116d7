// meniscus audit: false negatives and false positives of a model, scene by scene.
#include "command_line.hpp"

#include <meniscus/app/report/report.hpp>
#include <meniscus/classifier/audit/audit.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <optional>

namespace meniscus {
namespace {

struct AuditCommand {
    std::vector<Path> inputs;
    Path model;
    AuditOptions audit;
    std::string format = "table";
    std::optional<Path> report; ///< page to write
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

void run_audit(const AuditCommand& command) {
    if (std::isnan(command.max_false_positive_rate.value_or(0)))
        throw InputError("--max-false-positive-rate must be a number from 0 to 1, found nan");
    const Model model = read_model(command.model);
    if (command.report) {
        check_can_be_written(*command.report);
        check_is_not_an_input(*command.report, command.inputs);
        check_is_not_an_input(*command.report, {command.model});
    }
    const AuditReport report = audit(model, command.inputs, command.audit);
    for (const std::string& warning : report.warnings)
        print_error_line("warning: " + warning);
    const auto print = command.format == "json"  ? to_json
                       : command.format == "csv" ? to_csv
                                                 : to_table;
    if (!command.quiet || command.format != "table")
        fmt::print("{}", print(report));
    if (command.report)
        write_report(*command.report, report_page(report, command.inputs, command.audit));
    check_limits(command, report);
}

} // namespace

void add_audit(CLI::App& command) {
    auto options = std::make_shared<AuditCommand>();
    auto* verb =
        command.add_subcommand("audit", "Count a model's false negatives and false positives");
    verb->add_option("LABELLED", options->inputs, "Snapshots that `meniscus label` has written")
        ->required();
    verb->add_option("--model", options->model, "Model file")->required();
    verb->add_option("--label-threshold", options->audit.label_threshold,
                     "Surface means an uncovered fraction above this")
        ->capture_default_str();
    verb->add_option("--scene", options->audit.scene,
                     "Scene of all snapshots, in place of their own");
    verb->add_option("--format", options->format, "table, json or csv")
        ->check(CLI::IsMember({"table", "json", "csv"}))
        ->capture_default_str();
    verb->add_option("--report", options->report,
                     "Page of HTML to write: the states, their features and the line, to look at "
                     "in any browser");
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
