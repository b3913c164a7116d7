// meniscus audit: false negatives and false positives of a model, of another code's free-surface
// detector or of its flags, scene by scene.
#include "file_batch.hpp"
#include "input_files.hpp"
#include "shipped_models.hpp"
#include "usage.hpp"

#include <meniscus/app/ranks/ranks_of_program.hpp>
#include <meniscus/app/report/report.hpp>
#include <meniscus/classifier/audit/audit.hpp>
#include <meniscus/data/ranks/packing.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <memory>
#include <optional>

namespace meniscus {

/// On its way to whoever adds up; of a model, which has no detector's responses.
template <class Pack>
static void carry(Pack& pack, AuditedFile& file) {
    AuditRow& row = file.row;
    pack.number(static_cast<ErrorCounts&>(row));
    carry(pack, row.scene);
    carry(pack, row.files);
    for (std::size_t* count : {&row.files_trained_on, &row.false_negatives_float,
                               &row.false_positives_float, &row.features_differ})
        pack.number(*count);
    carry(pack, row.unseen_rates);
    carry(pack, file.use.file);
    carry(pack, file.use.spacing_ratio);
    carry(pack, file.use.bulk_neighbor_count);
    carry(pack, file.warnings);
}

namespace {

struct AuditCommand {
    std::vector<Path> inputs;
    std::optional<std::string> model; ///< file or name; without, the one that fits
    std::string detector;
    std::optional<double> detector_threshold;
    std::string flag;
    std::optional<std::int64_t> flag_min;
    AuditOptions audit;
    std::string format = "table";
    std::optional<Path> report; ///< page to write
    std::optional<std::size_t> max_false_negatives;
    std::optional<double> max_false_positive_rate;
    bool quiet = false;
    bool keep_going = false;
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
    const int judged = int(command.model.has_value()) + int(!command.detector.empty()) +
                       int(!command.flag.empty());
    if (judged > 1)
        throw InputError("--model, --detector and --flag stand in each other's place; give one");
    if (command.detector_threshold && command.detector.empty())
        throw InputError("--detector-threshold is for --detector; for flags there is --flag-min");
    if (command.flag_min && command.flag.empty())
        throw InputError("--flag-min is for --flag; for detectors there is --detector-threshold");
}

std::string detector_names() {
    std::string names;
    for (const DetectorKind& kind : detector_kinds())
        names += (names.empty() ? "" : ", ") + kind.name;
    return names;
}

struct AuditedFiles {
    std::vector<AuditedFile> files;
    std::optional<InputError> at_fault; ///< of others, with keep_going
};

/// Audits the files, in parallel where they are many.
AuditedFiles audit_files(const Model& model, const std::vector<Path>& files,
                         const AuditCommand& command) {
    std::vector<std::optional<AuditedFile>> each(files.size());
    FileBatch batch = {"auditing",    "audited",         {}, command.audit.threads,
                       command.quiet, command.keep_going};
    batch.collect = [&](std::size_t f, const std::string& found) {
        each[f] = unpacked<AuditedFile>(found);
    };
    AuditedFiles audited;
    try {
        for_each_file(files, batch, [&](std::size_t f, int threads) {
            AuditOptions options = command.audit;
            options.threads = threads;
            FileReport report;
            report.found = packed(audit_file(model, files[f], options));
            return report;
        });
    } catch (const InputError& error) {
        if (std::none_of(each.begin(), each.end(),
                         [](const auto& one) { return one.has_value(); }) ||
            !command.keep_going)
            throw;
        audited.at_fault = error;
    }
    for (auto& one : each)
        if (one)
            audited.files.push_back(std::move(*one));
    return audited;
}

/// The model that was asked for, else of those that ship the one for the first file.
NamedModel model_for(const std::vector<Path>& files, const AuditCommand& command) {
    if (command.model)
        return named_model(*command.model);
    NamedModel chosen = model_that_fits(read_labelled_state(files.front(), command.audit.scene));
    if (!command.quiet && command.format == "table")
        print_text(fmt::format("model {}, of those that ship the one for {}\n", chosen.name,
                               range_text(chosen.model)));
    return chosen;
}

/// Judges what the command says; `at_fault`: what stops none of the others.
AuditReport make_report(const std::vector<Path>& files, const AuditCommand& command,
                        std::optional<InputError>& at_fault) {
    if (!command.detector.empty())
        return audit_detector(command.detector, command.detector_threshold, files, command.audit);
    if (!command.flag.empty())
        return audit_flag({command.flag, command.flag_min.value_or(AuditedFlag{}.min)}, files,
                          command.audit);
    const Model model = model_for(files, command).model;
    AuditedFiles audited = audit_files(model, files, command);
    at_fault = audited.at_fault;
    return audit_report(model, command.audit, audited.files);
}

void check_page(const Path& page, const std::vector<Path>& files, const AuditCommand& command) {
    if (!command.detector.empty() || !command.flag.empty())
        throw InputError("--report draws a model's line; leave it out with --detector and --flag");
    check_can_be_written(page);
    check_is_not_an_input(page, files);
    check_is_not_an_input(page, {command.model.value_or("")});
}

void run_audit(const AuditCommand& command) {
    check_what_is_judged(command);
    if (std::isnan(command.max_false_positive_rate.value_or(0)))
        throw InputError("--max-false-positive-rate must be a number from 0 to 1, found nan");
    check_label_threshold(command.audit.label_threshold.value_or(0));
    const std::vector<Path> files = input_files(command.inputs);
    if (command.report)
        check_page(*command.report, files, command);
    std::optional<InputError> at_fault;
    const AuditReport report = make_report(files, command, at_fault);
    if (is_other_rank())
        return;
    for (const std::string& warning : report.warnings)
        print_error_line("warning: " + warning);
    const auto print = command.format == "json"  ? to_json
                       : command.format == "csv" ? to_csv
                                                 : to_table;
    if (!command.quiet || command.format != "table")
        print_text(print(report));
    if (command.report) {
        AuditOptions options = command.audit;
        options.label_threshold = report.label_threshold;
        write_report(*command.report, report_page(report, files, options));
    }
    if (at_fault)
        throw *at_fault;
    check_limits(command, report);
}

} // namespace

void add_audit(CLI::App& command) {
    auto options = std::make_shared<AuditCommand>();
    auto* verb = command.add_subcommand("audit", "Count false negatives and false positives");
    verb->add_option("LABELLED", options->inputs,
                     fmt::format("Snapshots that `meniscus label` has written: {}", input_kinds))
        ->required();
    verb->add_option("--model", options->model,
                     "Model file, or the name of one that ships (default: of these the one that "
                     "fits the first file's dimension and h in spacings)")
        ->type_name("FILE");
    verb->add_option("--detector", options->detector,
                     "In place of a model, the free-surface detector of another code: " +
                         detector_names());
    verb->add_option("--detector-threshold", options->detector_threshold,
                     "Its threshold, in the code's own quantity (default: its authors')");
    verb->add_option("--flag", options->flag,
                     "In place of a model, an array of flags that the snapshots have");
    verb->add_option("--flag-min", options->flag_min,
                     "A flag of at least this is surface (default 1; 2 for DualSPHysics' FSType)");
    verb->add_option("--label-threshold", options->audit.label_threshold,
                     fmt::format("Surface means an uncovered fraction above this (default: the "
                                 "model's own; for a detector or flags {})",
                                 detector_label_threshold));
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
    add_keep_going_option(*verb, options->keep_going);
    verb->add_flag(
        "-q,--quiet", options->quiet,
        "Print no table, only errors and warnings; json and csv are printed all the same");
    add_examples(*verb,
                 {{"meniscus audit labelled/ --model model.json",
                   "false negatives and false positives of each scene"},
                  {"meniscus audit labelled/ --model model.json --max-false-negatives 0 --quiet",
                   "status 1 where a surface particle is missed"}});
    verb->callback([options] { run_audit(*options); });
}

} // namespace meniscus
