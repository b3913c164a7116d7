// meniscus bench: speed against error, of this project and of what others use, on this machine.
#include "input_files.hpp"
#include "shipped_files.hpp"

#include "support/page.hpp"
#include "support/plot.hpp"
#include "support/tables.hpp"
#include "usage.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/threads/threads.hpp>
#include <meniscus/runtime/version.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace meniscus {
namespace {

struct BenchCommand {
    std::vector<Path> inputs;
    Path folder = "meniscus-bench";
    Path report; ///< page to write; empty: none
    std::vector<std::string> tables;
    int threads = 0;
    TimingOptions timing;
    bool quiet = false;
};

/// What the tables are made from, and those that are made.
struct Bench {
    const BenchCommand& command;
    TableInput input;
    Tables tables;

    void write(const std::string& name, const std::string& text) const {
        check_is_not_an_input(command.folder / name, input.files);
        const WriteGuard guard;
        write_whole(command.folder / name, text);
    }

    /// Prints the table, writes it and draws its plots.
    void add(const Table& table) {
        std::string text = markdown(table);
        if (!command.quiet)
            print_text(fmt::format("\n{}\n\n{}", table.title, text));
        std::fflush(stdout);
        const WriteGuard guard;
        for (const Plot& plot : table.plots) {
            check_is_not_an_input(command.folder / plot.file, input.files);
            draw(table, plot, command.folder);
            text += fmt::format("\n![{}]({})\n", plot.title, plot.file);
        }
        write(table.name + ".md", text);
        tables.push_back(table);
    }
};

std::string table_names() {
    std::string names;
    for (const TableKind& table : compared_tables())
        names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", table.name, table.help);
    return names;
}

void write_figures(const Bench& bench) {
    nlohmann::json inputs = nlohmann::json::array();
    for (const auto& state : bench.input.states)
        inputs.push_back({{"name", printable(state.name)},
                          {"scene", printable(state.scene)},
                          {"particles", state.size()}});
    nlohmann::json tables = nlohmann::json::array();
    for (const Table& table : bench.tables)
        tables.push_back(to_json(table));
    const nlohmann::json report = {{"program", std::string("meniscus ") + program_version},
                                   {"machine", machine()},
                                   {"threads", bench.input.threads},
                                   {"repetitions", bench.command.timing.repetitions},
                                   {"states", inputs},
                                   {"tables", tables}};
    bench.write("speed_against_error.json", report.dump(1) + "\n");
}

/// What the figures belong to, for whoever reads the tables.
std::string about(const Bench& bench) {
    const auto of = machine();
    std::size_t particles = 0;
    for (const auto& state : bench.input.states)
        particles += state.size();
    return fmt::format("{}, {} cores ({}); {}, {}; labels with {}; medians of {} runs and their "
                       "quartiles, of 3 runs where one is long; {} states, {} particles\n",
                       of["processor"].get<std::string>(), of["cores"].get<int>(),
                       of["caches"].get<std::string>(), of["compiler"].get<std::string>(),
                       of["build"].get<std::string>(), of["vectors_of_labels"].get<std::string>(),
                       bench.command.timing.repetitions, bench.input.states.size(), particles);
}

bool is_wanted(const BenchCommand& command, const std::string& table) {
    return command.tables.empty() ||
           std::find(command.tables.begin(), command.tables.end(), table) != command.tables.end();
}

void run_bench(const BenchCommand& command) {
    make_writable_folder(command.folder);
    Bench bench{command, {}, {}};
    TableInput& input = bench.input;
    if (command.inputs.empty() || is_wanted(command, "line"))
        input.samples = sample_snapshots();
    input.files = command.inputs.empty() ? input.samples : input_files(command.inputs);
    input.models = shipped_models();
    input.threads = thread_count(command.threads);
    input.timing = command.timing;
    if (!command.report.empty()) {
        check_can_be_written(command.report);
        check_is_not_an_input(command.report, input.files);
    }
    for (const Path& file : input.files)
        input.states.push_back(read_fluid_state<float>(file));
    const std::string machine_text = about(bench);
    if (!command.quiet)
        print_text(machine_text);
    bench.write("machine.md", machine_text);
    for (const TableKind& table : compared_tables())
        if (is_wanted(command, table.name))
            for (const Table& made : table.make(input))
                bench.add(made);
    write_figures(bench);
    if (!command.report.empty()) {
        const WriteGuard guard;
        write_whole(command.report, tables_page("Speed against error", machine_text, bench.tables));
    }
}

} // namespace

void add_bench(CLI::App& command) {
    auto options = std::make_shared<BenchCommand>();
    auto* verb = command.add_subcommand(
        "bench", "Measure speed against error, of this project's methods and of others', on this "
                 "machine: tables as DIR/*.md, plots as DIR/*.svg, and all figures in "
                 "DIR/speed_against_error.json");
    verb->add_option("INPUT", options->inputs,
                     "Snapshots that store their support radius; without any, those that come with "
                     "the project");
    verb->add_option("-o,--output", options->folder, "Folder for what it writes")
        ->capture_default_str();
    verb->add_option("--report", options->report,
                     "Page of HTML for the tables and plots, which opens from disk");
    std::vector<std::string> names;
    for (const TableKind& table : compared_tables())
        names.emplace_back(table.name);
    verb->add_option("--tables", options->tables, "Which ones: " + table_names() + "; all of them")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(names));
    verb->add_option("--repetitions", options->timing.repetitions,
                     "Runs that a median is taken of; three of what takes long")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    add_threads_option(*verb, options->threads);
    add_quiet_option(*verb, options->quiet);
    add_examples(*verb, {{"meniscus bench --tables line", "one table, of the samples that ship"},
                         {"meniscus bench --report page.html", "all of them, and one page"}});
    verb->callback([options] { run_bench(*options); });
}

} // namespace meniscus
