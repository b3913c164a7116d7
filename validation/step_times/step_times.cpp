// Milliseconds a step of surface tension and of all, and false positives of the line: the 2020
// paper's table 2 (its steps by table 1), and how its advantage depends on the length of steps.
#include "framework/measures.hpp"
#include "framework/run_tables.hpp"
#include "framework/scene_runs.hpp"
#include "studies.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>

#include <algorithm>
#include <fmt/format.h>

namespace meniscus {
namespace {

/// Shares of the particles, %: what the line lets through although it is covered, and the surface.
/// Means over the frames but the first.
void add_shares(const SceneRun& done, Json& figures) {
    std::vector<double> false_positives;
    std::vector<double> surface;
    for (std::size_t frame = 1; frame < done.frames.size(); ++frame) {
        const Snapshot snapshot = read_vtkhdf(done.frames[frame]);
        const std::vector<double> classes = scalar_values(snapshot, "surface_class");
        const auto share = [&](double of_class) {
            return 100.0 *
                   static_cast<double>(std::count(classes.begin(), classes.end(), of_class)) /
                   static_cast<double>(classes.size());
        };
        false_positives.push_back(share(1));
        surface.push_back(share(2));
    }
    figures["false positives, %"] = mean_and_deviation(false_positives).mean;
    figures["surface, %"] = mean_and_deviation(surface).mean;
}

Json measure(const StudyRun& run, const Workplace& place) {
    const SceneRun done = run_to_end(scene_of(run), place);
    Json figures = {{"particles", done.log.at("particles").front()}};
    if (!done.failure.empty()) {
        figures["failure"] = done.failure;
        return figures;
    }
    const StepSums& sums = done.result.profile.sums;
    const double step = sums.time / static_cast<double>(sums.steps);
    const TensionOptions& tension = done.scene.surface_tension;
    figures["mean step, ms"] = 1000 * step;
    figures["surface tension, ms"] = milliseconds_a_step(done.result, &StageTimes::surface_tension);
    figures["total, ms"] = milliseconds_a_step(done.result);
    figures["total for a second, s"] = seconds_a_second(done.result);
    figures["pressure iterations"] =
        static_cast<double>(sums.pressure_iterations) / static_cast<double>(sums.steps);
    if (tension.model == "meniscus") {
        figures["samples"] =
            tension.sampling_density > 0
                ? std::max<double>(tension.min_samples, tension.sampling_density * step)
                : static_cast<double>(tension.surface.samples);
        add_shares(done, figures);
    }
    return figures;
}

/// Of the run with the same labels but for the model.
const Json* rival_of(const Json& result, const Json& run, const std::string& model) {
    Json labels = run.at("labels");
    labels["model"] = model;
    for (const Json& other : result.at("runs"))
        if (other.at("labels") == labels)
            return &other;
    return nullptr;
}

constexpr const char* figures_of_steps =
    "particles {:.0f} | mean step, ms {:.2f} | samples {:.0f} | surface tension, ms {:.2f} | "
    "total, "
    "ms {:.2f} | pressure iterations {:.1f} | false positives, % {:.2f} | surface, % {:.1f}";

/// What a row's model takes over Becker's, here and published.
Table beside_the_paper(const Json& result, const Json& reference) {
    Table table = table_of("step_times_ratios",
                           "scene | solver | model | surface tension over Becker's {:.2f} | "
                           "published {:.2f} | total over Becker's {:.2f} | published {:.2f}");
    for (const Json& run : result.at("runs")) {
        const std::string model = label_of(run, "model");
        const Json* becker = rival_of(result, run, "Becker 2007");
        if (model == "Becker 2007" || becker == nullptr || !figure_of(run, "total, ms") ||
            !figure_of(*becker, "total, ms"))
            continue;
        std::vector<Cell> row = {label_of(run, "scene"), label_of(run, "solver"), model};
        for (const char* what : {"surface tension", "total"}) {
            const std::string figure = fmt::format("{}, ms", what);
            row.emplace_back(*figure_of(run, figure) / *figure_of(*becker, figure));
            const auto key = [&](const std::string& of) {
                return fmt::format("{}, {}, {}: {}", label_of(run, "scene"),
                                   label_of(run, "solver"), of, figure);
            };
            const std::string of = model.rfind("ours", 0) == 0 ? "ours" : model;
            std::optional<double> ratio;
            if (reference.at("numbers").contains(key(of)))
                ratio = published(reference, key(of)) / published(reference, key("Becker 2007"));
            row.emplace_back(ratio);
        }
        table.add(row);
    }
    return table;
}

/// The published rates of false positives, and the mean over this study's runs of the scene.
Table false_positives(const Json& result, const Json& reference) {
    Table table = table_of("step_times_false_positives",
                           "scene | false positives, % {:.3f} | published, % {:.3f}");
    for (const char* scene : {"droplet", "crown", "dam break"}) {
        std::vector<double> shares;
        for (const Json& run : result.at("runs"))
            if (const auto share = figure_of(run, "false positives, %");
                share && label_of(run, "scene") == scene)
                shares.push_back(*share);
        if (!shares.empty())
            table.add({scene, mean_and_deviation(shares).mean,
                       published(reference, fmt::format("{}: false positives, %", scene))});
    }
    return table;
}

std::vector<Table> tables(const Json& result, const Json& reference) {
    return {table_of_runs("step_times", result, "scene | solver | model", figures_of_steps),
            beside_the_paper(result, reference), false_positives(result, reference)};
}

/// Whether the fastest of ours is faster than Becker 2007 in whole steps, for each length.
Table advantage(const Json& result) {
    Table table = table_of("step_lengths_advantage",
                           "step | fastest of ours | surface tension over Becker's {:.2f} | total "
                           "over Becker's {:.2f}");
    std::vector<std::string> steps;
    for (const Json& run : result.at("runs"))
        if (std::find(steps.begin(), steps.end(), label_of(run, "step")) == steps.end())
            steps.push_back(label_of(run, "step"));
    for (const std::string& step : steps) {
        const Json* fastest = nullptr;
        for (const Json& run : result.at("runs"))
            if (label_of(run, "step") == step && label_of(run, "model").rfind("ours", 0) == 0 &&
                figure_of(run, "total, ms") &&
                (fastest == nullptr ||
                 *figure_of(run, "total, ms") < *figure_of(*fastest, "total, ms")))
                fastest = &run;
        const Json* becker =
            fastest == nullptr ? nullptr : rival_of(result, *fastest, "Becker 2007");
        if (becker == nullptr || !figure_of(*becker, "total, ms"))
            continue;
        const auto over = [&](const char* figure) {
            return *figure_of(*fastest, figure) / *figure_of(*becker, figure);
        };
        table.add(
            {step, label_of(*fastest, "model"), over("surface tension, ms"), over("total, ms")});
    }
    return table;
}

std::vector<Table> tables_of_lengths(const Json& result, const Json& /*reference*/) {
    return {table_of_runs("step_lengths", result, "step | model", figures_of_steps),
            advantage(result)};
}

} // namespace

Study step_times_study() {
    return {"step_times", "milliseconds a step and false positives: the 2020 paper's table 2",
            measure, tables};
}

Study step_lengths_study() {
    return {"step_lengths", "what surface tension costs in short and in long steps", measure,
            tables_of_lengths};
}

} // namespace meniscus
