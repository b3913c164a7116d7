// meniscus bench: speed against error, of this project and of what others use, on this machine.
#include "shipped_files.hpp"

#include "comparison/coverage_estimators.hpp"
#include "comparison/detector_comparison.hpp"
#include "comparison/feature_pairs.hpp"
#include "comparison/line_shift.hpp"
#include "comparison/plot.hpp"
#include "comparison/tension_steps.hpp"

#include <meniscus/data/errors.hpp>
#include <meniscus/data/snapshot_files.hpp>
#include <meniscus/version.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <map>
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
    std::vector<Path> files;
    std::vector<FluidState<float>> states; ///< of the files
    std::vector<Table> tables;

    /// Prints the table, writes it and draws its plots.
    void add(Table table, const std::vector<Plot>& plots) {
        std::string text = markdown(table);
        if (!command.quiet)
            fmt::print("\n{}\n\n{}", table.title, text);
        std::fflush(stdout);
        for (const Plot& plot : plots) {
            draw(table, plot, command.folder);
            text += fmt::format("\n![{}]({})\n", plot.title, plot.file);
        }
        const WriteGuard guard;
        write_whole(command.folder / (table.name + ".md"), text);
        tables.push_back(std::move(table));
    }

    [[nodiscard]] std::vector<FluidState<float>> states_of(int dimension) const {
        std::vector<FluidState<float>> some;
        std::copy_if(states.begin(), states.end(), std::back_inserter(some),
                     [&](const auto& state) { return state.dimension == dimension; });
        return some;
    }

    [[nodiscard]] std::vector<Path> files_in_3d() const {
        std::vector<Path> some;
        for (std::size_t k = 0; k < files.size(); ++k)
            if (states[k].dimension == 3)
                some.push_back(files[k]);
        return some;
    }

    /// The largest state of each of the three largest scenes.
    [[nodiscard]] std::vector<Path> large_files_in_3d() const {
        std::map<std::string, std::size_t> of_scene; // index of its largest state
        for (std::size_t k = 0; k < files.size(); ++k)
            if (states[k].dimension == 3) {
                auto& largest = of_scene.emplace(states[k].scene, k).first->second;
                largest = states[k].size() >= states[largest].size() ? k : largest;
            }
        std::vector<std::size_t> largest;
        std::transform(of_scene.begin(), of_scene.end(), std::back_inserter(largest),
                       [](const auto& one) { return one.second; });
        std::sort(largest.begin(), largest.end(), [&](std::size_t a, std::size_t b) {
            return states[a].size() > states[b].size();
        });
        largest.resize(std::min<std::size_t>(largest.size(), 3));
        std::vector<Path> some;
        std::transform(largest.begin(), largest.end(), std::back_inserter(some),
                       [&](std::size_t k) { return files[k]; });
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
        number_rows(table);
        Plot missed{table.name + "_missed.svg", table.title + ": what they miss", "time",
                    "false_negatives", "group"};
        Plot let_through{table.name + "_let_through.svg", table.title + ": what they let through",
                         "time", "false_positive_rate", "group"};
        missed.label = let_through.label = "number";
        bench.add(std::move(table), {missed, let_through});
    }
}

void add_features(Bench& bench, const std::vector<FluidState<float>>& states,
                  double label_threshold, const std::string& name) {
    FeaturePairOptions options;
    options.label_threshold = label_threshold;
    options.threads = bench.threads;
    options.timing = bench.command.timing;
    Table table = feature_pairs(states, options);
    table.name = name;
    table.title +=
        fmt::format(", surface where more than {} % is uncovered", 100 * label_threshold);
    number_rows(table);
    Plot plot{table.name + ".svg", table.title, "time", "false_positive_rate", "kind"};
    plot.label = "number";
    bench.add(std::move(table), {plot});
}

/// For the surface itself, and for the threshold that the shipped line is trained with.
void bench_features(Bench& bench) {
    for (const int dimension : {3, 2}) {
        const auto states = bench.states_of(dimension);
        if (states.empty())
            continue;
        add_features(bench, states, 0, fmt::format("features_{}d", dimension));
        add_features(bench, states, 0.02, fmt::format("features_{}d_2_percent", dimension));
    }
}

void bench_coverage(Bench& bench) {
    EstimatorOptions options;
    options.snapshots = bench.files_in_3d();
    options.threads = bench.threads;
    options.timing.repetitions = bench.command.timing.repetitions;
    Table table = coverage_estimators(options);
    mark_best(table, {"time", "lost", "normal", "curvature"}, "case");
    std::vector<Plot> plots;
    for (const char* error : {"lambda", "normal", "curvature"}) {
        Plot plot{fmt::format("{}_{}.svg", table.name, error), table.title, "time", error,
                  "estimator"};
        plot.panel = "case";
        plot.joined = true;
        plots.push_back(plot);
    }
    bench.add(std::move(table), plots);
}

void bench_line(Bench& bench) {
    LineShiftOptions options;
    for (const Path& sample : sample_snapshots())
        if (sample.stem() == "droplet_iisph_04")
            options.double_droplet = sample;
    options.published_model = bench.models / "splishsplash_d12.json";
    options.threads = bench.threads;
    options.timing = bench.command.timing;
    Table table = line_shift(options);
    mark_best(table, {"time", "false_negatives"}, "state");
    std::vector<Plot> plots;
    for (const char* figure : {"candidates", "false_negatives", "time"}) {
        Plot plot{fmt::format("{}_{}.svg", table.name, figure), table.title, "d", figure, "line"};
        plot.panel = "state";
        plot.joined = true;
        plot.logarithmic_x = false;
        plot.logarithmic_y = plot.y == "false_negatives";
        plots.push_back(plot);
    }
    bench.add(std::move(table), plots);
}

void bench_steps(Bench& bench) {
    TensionStepOptions options;
    options.snapshots = bench.large_files_in_3d();
    options.threads = bench.threads;
    options.timing = bench.command.timing;
    Table table = tension_steps(options);
    mark_best(table, {"time", "angle", "local_scatter", "inside"}, "state");
    number_rows(table, "state");
    Plot plot{table.name + ".svg", table.title, "time", "angle", "group"};
    plot.label = "number";
    plot.panel = "state";
    bench.add(std::move(table), {plot});
}

struct NamedTable {
    const char* name;
    const char* what;
    void (*make)(Bench&);
};

constexpr NamedTable known_tables[] = {
    {"detectors", "surface detectors of this project and of others", bench_detectors},
    {"features", "lines in the plane of any two features", bench_features},
    {"coverage", "uncovered part, normal and curvature by samples", bench_coverage},
    {"line", "what shifting the line does", bench_line},
    {"steps", "whole surface-tension steps", bench_steps},
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
        inputs.push_back(
            {{"name", state.name}, {"scene", state.scene}, {"particles", state.size()}});
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

/// What the figures belong to, for whoever reads the tables.
std::string about(const Bench& bench) {
    const auto of = machine();
    std::size_t particles = 0;
    for (const auto& state : bench.states)
        particles += state.size();
    return fmt::format("{}, {} cores ({}); {}, {}; labels with {}; medians of {} runs and their "
                       "quartiles, of 3 runs where one is long; {} states, {} particles\n",
                       of["processor"].get<std::string>(), of["cores"].get<int>(),
                       of["caches"].get<std::string>(), of["compiler"].get<std::string>(),
                       of["build"].get<std::string>(), of["vectors_of_labels"].get<std::string>(),
                       bench.command.timing.repetitions, bench.states.size(), particles);
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
                command.inputs.empty() ? sample_snapshots() : command.inputs,
                {},
                {}};
    for (const Path& file : bench.files)
        bench.states.push_back(read_fluid_state<float>(file));
    const std::string machine_text = about(bench);
    if (!command.quiet)
        fmt::print("{}", machine_text);
    write_whole(command.folder / "machine.md", machine_text);
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
                 "machine: tables as DIR/*.md, plots as DIR/*.svg, and all figures in "
                 "DIR/speed_against_error.json");
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
        ->allow_extra_args(false)
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
