// meniscus demo: the whole chain on the samples that ship with the project.
#include "label.hpp"
#include "shipped_files.hpp"
#include "threads.hpp"
#include "usage.hpp"

#include <meniscus/app/report/report.hpp>
#include <meniscus/classifier/audit/audit.hpp>
#include <meniscus/classifier/export/header_export.hpp>
#include <meniscus/classifier/objectives/trainer.hpp>
#include <meniscus/data/particles/feature_names.hpp>
#include <meniscus/data/text/files.hpp>

#include <fmt/format.h>
#include <memory>
#include <optional>

namespace meniscus {
namespace {

struct DemoCommand {
    Path folder = "meniscus-demo";
    double label_threshold = default_label_threshold;
    std::optional<Path> report; ///< page to write
    bool quiet = false;
};

std::vector<LabelledState> states_of(const std::vector<Path>& labelled,
                                     const FeaturePair& features) {
    std::vector<LabelledState> states;
    states.reserve(labelled.size());
    for (const Path& file : labelled)
        states.push_back(read_labelled_state(file, "", features));
    return states;
}

/// Two lines, of the features of those that ship.
Model train_on(const std::vector<Path>& labelled, double label_threshold) {
    const auto states = states_of(labelled, {});
    TrainingOptions options;
    options.label_threshold = label_threshold;
    Model model = train(states, options);
    add_second_line(
        model, states,
        states_of(labelled, feature_pair({MassOffset::name, DirectionEigenvalue::name})));
    return model;
}

void run_demo(const DemoCommand& command) {
    check_threads_start(0);
    make_writable_folder(command.folder);
    if (command.report)
        check_can_be_written(*command.report);
    LabelCommand labelling;
    labelling.files = {sample_snapshots(), command.folder / "labelled"};
    labelling.quiet = command.quiet;
    labelling.label.features = {feature_named(DirectionEigenvalue::name)};
    if (!command.quiet)
        print_text(fmt::format("Labelling {} snapshots:\n", labelling.files.inputs.size()));
    const auto labelled = run_label(labelling);

    const Model model = train_on(labelled, command.label_threshold);
    const Path model_file = command.folder / "model.json";
    const Path header_file = command.folder / "surface_coefficients.hpp";
    const std::string header = coefficient_header(model, "SurfaceCoefficients");
    {
        const WriteGuard guard;
        write_whole(model_file, model_to_json(model));
        write_whole(header_file, header);
    }
    AuditOptions options;
    options.label_threshold = command.label_threshold;
    AuditReport report = audit(model, labelled, options);
    report.model.file = model_file.string();
    if (command.report)
        write_report(*command.report, report_page(report, labelled, options));
    if (command.quiet)
        return;
    print_text(fmt::format(
        "\nThe lines, of the mass offset x and the neighbor count y, and of what passes the "
        "first:\n  {}\n  {}\n  {}\n",
        line_text(model.line, model.features, 6),
        line_text(model.second->line, model.second->features, 6), printable(model_file.string())));
    print_text(
        fmt::format("\nAudit on the snapshots that it was trained on:\n{}", to_table(report)));
    print_text(fmt::format("\nThe header for your solver, {}:\n\n{}",
                           printable(header_file.string()), header));
}

} // namespace

void add_demo(CLI::App& command) {
    auto options = std::make_shared<DemoCommand>();
    auto* verb = command.add_subcommand(
        "demo", "Label, train, export and audit on the snapshots that ship with the project");
    verb->add_option("-o,--output", options->folder, "Folder for what it writes")
        ->capture_default_str();
    verb->add_option("--label-threshold", options->label_threshold,
                     "Surface means an uncovered fraction above this")
        ->capture_default_str();
    verb->add_option("--report", options->report,
                     "Page of HTML to write: the states, their features and the line, to look at "
                     "in any browser");
    add_quiet_option(*verb, options->quiet);
    add_examples(*verb, {{"meniscus demo", "everything, in meniscus-demo/"}});
    verb->callback([options] { run_demo(*options); });
}

} // namespace meniscus
