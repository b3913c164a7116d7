// The tables of `meniscus bench`: this project's methods beside those of others, with their plots.
#include "coverage/coverage_estimators.hpp"
#include "detectors/detector_comparison.hpp"
#include "features/feature_pairs.hpp"
#include "support/tables.hpp"
#include "tension/tension_steps.hpp"
#include "training/line_shift.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace meniscus {
namespace {

using Path = std::filesystem::path;

std::vector<FluidState<float>> states_of(const TableInput& input, int dimension) {
    std::vector<FluidState<float>> some;
    std::copy_if(input.states.begin(), input.states.end(), std::back_inserter(some),
                 [&](const auto& state) { return state.dimension == dimension; });
    return some;
}

std::vector<Path> files_in_3d(const TableInput& input) {
    std::vector<Path> some;
    for (std::size_t k = 0; k < input.files.size(); ++k)
        if (input.states[k].dimension == 3)
            some.push_back(input.files[k]);
    return some;
}

/// The largest state of each of the three largest scenes.
std::vector<Path> large_files_in_3d(const TableInput& input) {
    const auto& states = input.states;
    std::map<std::string, std::size_t> of_scene; // index of its largest state
    for (std::size_t k = 0; k < states.size(); ++k)
        if (states[k].dimension == 3) {
            auto& max = of_scene.emplace(states[k].scene, k).first->second;
            max = states[k].size() >= states[max].size() ? k : max;
        }
    std::vector<std::size_t> max;
    for (const auto& [scene, state] : of_scene)
        max.push_back(state);
    std::sort(max.begin(), max.end(),
              [&](std::size_t a, std::size_t b) { return states[a].size() > states[b].size(); });
    std::vector<Path> some;
    for (std::size_t k = 0; k < std::min<std::size_t>(max.size(), 3); ++k)
        some.push_back(input.files[max[k]]);
    return some;
}

/// A plot of one column over another for each of `figures`, with a panel a case.
void add_joined_plots(const char* x, const std::vector<std::string>& figures, const char* series,
                      const char* panel, bool logarithmic, Table& table) {
    for (const std::string& figure : figures) {
        Plot plot{table.name + "_" + figure + ".svg", table.title, x, figure, series};
        plot.panel = panel;
        plot.joined = true;
        plot.logarithmic_x = logarithmic;
        plot.logarithmic_y = logarithmic || figure == "false_negatives";
        table.plots.push_back(plot);
    }
}

Tables detector_tables(const TableInput& input) {
    Tables tables;
    for (const int dimension : {3, 2}) {
        const auto states = states_of(input, dimension);
        if (states.empty())
            continue;
        Table table = compare_detectors(states, detectors<float>(dimension, input.models),
                                        input.threads, input.timing);
        table.plots = {{table.name + "_missed.svg", table.title + ": what they miss", "time",
                        "false_negatives", "group", "detector"},
                       {table.name + "_false_positives.svg", table.title + ": false positives",
                        "time", "false_positive_rate", "group", "detector"}};
        tables.push_back(std::move(table));
    }
    return tables;
}

/// For the surface itself, and for the threshold that the shipped line is trained with.
Tables feature_tables(const TableInput& input) {
    Tables tables;
    for (const int dimension : {3, 2}) {
        const auto states = states_of(input, dimension);
        for (const double threshold : {0.0, 0.02}) {
            if (states.empty())
                continue;
            Table table = feature_pairs(states, {threshold, input.threads, input.timing});
            table.name =
                fmt::format("features_{}d{}", dimension, threshold > 0 ? "_2_percent" : "");
            table.title +=
                fmt::format(", surface where more than {} % is uncovered", 100 * threshold);
            table.plots = {{table.name + ".svg", table.title, "time", "false_positive_rate", "kind",
                            "features"}};
            tables.push_back(std::move(table));
        }
    }
    return tables;
}

Tables coverage_tables(const TableInput& input) {
    EstimatorOptions options;
    options.snapshots = files_in_3d(input);
    options.threads = input.threads;
    options.timing.repetitions = input.timing.repetitions;
    Table table = coverage_estimators(options);
    mark_best(table, {"time", "lost", "normal", "curvature"}, "case");
    add_joined_plots("time", {"lambda", "normal", "curvature"}, "estimator", "case", true, table);
    return {table};
}

Tables line_tables(const TableInput& input) {
    LineShiftOptions options;
    for (const Path& sample : input.samples)
        if (sample.stem() == "droplet_iisph_04")
            options.double_droplet = sample;
    options.published_model = input.models / "splishsplash_d12.json";
    options.threads = input.threads;
    options.timing = input.timing;
    Table table = line_shift(options);
    mark_best(table, {"time", "false_negatives"}, "state");
    add_joined_plots("d", {"candidates", "false_negatives", "time"}, "line", "state", false, table);
    return {table};
}

Tables step_tables(const TableInput& input) {
    TensionStepOptions options;
    options.snapshots = large_files_in_3d(input);
    options.threads = input.threads;
    options.timing = input.timing;
    Table table = tension_steps(options);
    mark_best(table, {"time", "angle", "local_scatter", "inside"}, "state");
    table.plots = {{table.name + ".svg", table.title, "time", "angle", "group", "model", "state"}};
    return {table};
}

} // namespace

const std::vector<TableKind>& compared_tables() {
    static const char* const snapshots = "[SNAPSHOT...]";
    static const std::vector<TableKind> kinds = {
        {"detectors", snapshots, 0, "surface detectors of this project and of others",
         detector_tables, true},
        {"features", snapshots, 0, "lines in the plane of any two features", feature_tables, true},
        {"coverage", snapshots, 0, "uncovered part, normal and curvature by samples",
         coverage_tables, true},
        {"line", snapshots, 0, "what shifting the line does", line_tables, true},
        {"steps", snapshots, 0, "whole surface-tension steps", step_tables, true},
    };
    return kinds;
}

} // namespace meniscus
