// meniscus bench: speed against error, of this project and of what others use, on this machine.
#include "shipped_files.hpp"

#include "comparison/detector_comparison.hpp"
#include "comparison/plot.hpp"

#include <meniscus/data/errors.hpp>
#include <meniscus/data/snapshot_files.hpp>
#include <meniscus/version.hpp>

#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <omp.h>

namespace meniscus {
namespace {

struct BenchCommand {
    std::vector<Path> inputs;
    Path folder = "meniscus-bench";
    std::vector<std::string> tables;
    int threads = 0;
    TimingOptions timing;
    bool quiet = false;
};

/// What the tables are made from and where they go.
struct Bench {
    const BenchCommand& command;
    int threads;
    Path models;
    std::vector<FluidState<float>> states;
    std::vector<Table> tables;

    void add(Table table, const std::vector<Plot>& plots) {
        for (const Plot& plot : plots)
            draw(table, plot, command.folder);
        if (!command.quiet)
            fmt::print("\n{}\n\n{}", table.title, markdown(table));
        std::fflush(stdout);
        tables.push_back(std::move(table));
    }

    [[nodiscard]] std::vector<FluidState<float>> states_of(int dimension) const {
        std::vector<FluidState<float>> some;
        for (const auto& state : states)
            if (state.dimension == dimension)
                some.push_back(state);
        return some;
    }
};

void bench_detectors(Bench& bench) {
    for (const int dimension : {3, 2}) {
        const auto states = bench.states_of(dimension);
        if (states.empty())
            continue;
        Table table = compare_detectors(states, detectors<float>(dimension, bench.models),
                                        bench.threads, bench.command.timing);
        Plot missed{table.name + "_missed.svg", table.title + ": what they miss", "time",
                    "false_negatives", "group"};
        Plot let_through{table.name + "_let_through.svg", table.title + ": what they let through",
                         "time", "false_positive_rate", "group"};
        missed.label = let_through.label = "number";
        bench.add(std::move(table), {missed, let_through});
    }
}

struct NamedTable {
    const char* name;
    const char* what;
    void (*make)(Bench&);
};

constexpr NamedTable known_tables[] = {
    {"detectors", "surface detectors of this project and of others", bench_detectors},
};

std::string table_names() {
    std::string names;
    for (const NamedTable& table : known_tables)
        names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", table.name, table.what);
    return names;
}

void write_report(const Bench& bench) {
    nlohmann::json inputs = nlohmann::json::array();
    for (const auto& state : bench.states)
        inputs.push_back({{"name", state.name}, {"scene", state.scene}, {"size", state.size()}});
    nlohmann::json tables = nlohmann::json::array();
    for (const Table& table : bench.tables)
        tables.push_back(to_json(table));
    const nlohmann::json report = {{"program", std::string("meniscus ") + program_version},
                                   {"machine", machine()},
                                   {"threads", bench.threads},
                                   {"repetitions", bench.command.timing.repetitions},
                                   {"states", inputs},
                                   {"tables", tables}};
    const WriteGuard guard;
    write_whole(bench.command.folder / "speed_against_error.json", report.dump(1) + "\n");
}

void print_machine(const Bench& bench) {
    const auto about = machine();
    std::size_t particles = 0;
    for (const auto& state : bench.states)
        particles += state.size();
    fmt::print("{}, {} cores ({}); {}, {}; medians of {} runs and their quartiles; {} states, {} "
               "particles\n",
               about["processor"].get<std::string>(), about["cores"].get<int>(),
               about["caches"].get<std::string>(), about["compiler"].get<std::string>(),
               about["build"].get<std::string>(), bench.command.timing.repetitions,
               bench.states.size(), particles);
}

bool is_wanted(const BenchCommand& command, const std::string& table) {
    return command.tables.empty() ||
           std::find(command.tables.begin(), command.tables.end(), table) != command.tables.end();
}

void run_bench(const BenchCommand& command) {
    require_gnuplot();
    make_writable_folder(command.folder);
    Bench bench{command,
                command.threads > 0 ? command.threads : omp_get_max_threads(),
                shipped_models(),
                {},
                {}};
    for (const Path& file : command.inputs.empty() ? sample_snapshots() : command.inputs)
        bench.states.push_back(read_fluid_state<float>(file));
    if (!command.quiet)
        print_machine(bench);
    for (const NamedTable& table : known_tables)
        if (is_wanted(command, table.name))
            table.make(bench);
    write_report(bench);
}

} // namespace

void add_bench(CLI::App& command) {
    auto options = std::make_shared<BenchCommand>();
    auto* verb = command.add_subcommand(
        "bench", "Measure speed against error, of this project's methods and of others', on this "
                 "machine: tables, DIR/speed_against_error.json, and plots as DIR/*.svg");
    verb->add_option("INPUT", options->inputs,
                     "Snapshots that store their support radius; without any, those that come with "
                     "the project");
    verb->add_option("-o,--output", options->folder, "Folder for what it writes")
        ->capture_default_str();
    std::vector<std::string> names;
    for (const NamedTable& table : known_tables)
        names.emplace_back(table.name);
    verb->add_option("--tables", options->tables, "Which ones: " + table_names() + "; all of them")
        ->delimiter(',')
        ->check(CLI::IsMember(names));
    verb->add_option("--repetitions", options->timing.repetitions,
                     "Runs that a median is taken of; three of what takes long")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    add_threads_option(*verb, options->threads);
    add_quiet_option(*verb, options->quiet);
    verb->callback([options] { run_bench(*options); });
}

} // namespace meniscus
