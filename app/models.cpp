// meniscus models: the lines that ship, and which one fits a state.
#include "input_files.hpp"
#include "label.hpp"
#include "shipped_files.hpp"
#include "shipped_models.hpp"
#include "usage.hpp"

#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/text/text.hpp>

#include <fmt/format.h>
#include <memory>

namespace meniscus {
namespace {

struct ModelsCommand {
    std::vector<Path> inputs;
    InputOptions input;
    int threads = 0;
};

std::string fit_line(const Path& file, const ModelsCommand& command, const ModelChoice& choice) {
    const Snapshot snapshot = read_input(file, command.input);
    const SupportRadii radii = support_radii(snapshot);
    const auto valid = checked_positions(snapshot, radii, true);
    const double ratio = measured_spacing_ratio(snapshot, radii, valid, command.threads);
    return fmt::format("{}: {} (h is {:.2f} spacings in {}D)\n", printable(file.string()),
                       choice.at(snapshot.dimension, ratio).name, ratio, snapshot.dimension);
}

void print_table() {
    std::string text =
        fmt::format("{:<22} {:<34} {:>10}   {}\n", "model", "for", "surface: >", "line");
    for (const NamedModel& one : all_shipped_models())
        text += fmt::format("{:<22} {:<34} {:>8} %   {}{}\n", one.name, range_text(one.model),
                            100 * one.model.label_threshold,
                            line_text(one.model.line, one.model.features, 4),
                            one.model.second ? ", and a second one" : "");
    print_text(text +
               fmt::format("\nIn {}. --model takes a name as well as a file; where it is left "
                           "out, the one\nis taken that fits dimension and h.\n",
                           shipped_models().string()));
}

void run_models(const ModelsCommand& command) {
    if (command.inputs.empty())
        return print_table();
    const ModelChoice choice;
    for (const Path& file : input_files(command.inputs))
        print_text(naming_file(file, [&] { return fit_line(file, command, choice); }));
}

} // namespace

void add_models(CLI::App& command) {
    auto options = std::make_shared<ModelsCommand>();
    auto* verb = command.add_subcommand(
        "models", "List the models that ship or, of snapshots, name the one that fits each");
    verb->add_option("INPUT", options->inputs, "Snapshots, as for label; without any, the list")
        ->type_name("FILE");
    add_input_options(*verb, options->input);
    add_threads_option(*verb, options->threads);
    add_examples(*verb, {{"meniscus models", "the lines that ship, and what each is for"},
                         {"meniscus models out/ --support-radius 0.1",
                          "which of them fits the states in a folder"}});
    verb->callback([options] { run_models(*options); });
}

} // namespace meniscus
