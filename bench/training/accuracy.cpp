// How accurate lines are, on labelled snapshots: what each misses of the surface (false negatives)
// and what of the interior it passes (false positives).
#include "support/tables.hpp"

#include <meniscus/classifier/audit/audit.hpp>
#include <meniscus/classifier/objectives/neyman_pearson.hpp>
#include <meniscus/classifier/objectives/scene_errors.hpp>
#include <meniscus/classifier/objectives/shift.hpp>
#include <meniscus/classifier/objectives/trainer.hpp>
#include <meniscus/classifier/torch/torch_plugin.hpp>
#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/feature_names.hpp>
#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>

namespace meniscus {
namespace {

using Path = std::filesystem::path;
using States = std::vector<LabelledState>;

constexpr double thresholds[] = {0, 0.005, 0.02};
constexpr double shipped_threshold = 0.02;
constexpr const char* two_lines = "neyman-pearson, two lines";

/// Of the second line that ships.
FeaturePair second_features() {
    return feature_pair({"mass_offset", "direction_eigenvalue"});
}

/// Of files and of the files in folders.
States read_states(const std::vector<Path>& paths, const FeaturePair& features = {}) {
    States states;
    for (const Path& path : paths) {
        std::vector<Path> files = {path};
        if (std::filesystem::is_directory(path)) {
            files.assign(std::filesystem::directory_iterator(path), {});
            std::sort(files.begin(), files.end());
        }
        for (const Path& file : files)
            states.push_back(read_labelled_state(file, "", features));
    }
    return states;
}

States joined(States states, const States& more) {
    states.insert(states.end(), more.begin(), more.end());
    return states;
}

/// Those of a scene, or all others.
States of_scene(const States& states, const std::string& scene, bool wanted = true) {
    States found;
    std::copy_if(states.begin(), states.end(), std::back_inserter(found),
                 [&](const LabelledState& state) { return (state.scene == scene) == wanted; });
    return found;
}

double percent(std::size_t part, std::size_t whole) {
    return 100 * static_cast<double>(part) / static_cast<double>(whole);
}

std::vector<std::string> compared_objectives() {
    std::vector<std::string> names = {two_lines, "neyman-pearson"};
    if (has_torch_trainer())
        names.insert(names.end(), {"logistic", "network"});
    return names;
}

Model train_with(const States& states, const std::string& objective, double threshold) {
    TrainingOptions options;
    options.label_threshold = threshold;
    options.objective = objective;
    return train(states, options);
}

/// The same with a second line.
Model train_two_lines(const States& first, const States& second, double threshold) {
    Model model = train_with(first, "neyman-pearson", threshold);
    add_second_line(model, first, second);
    return model;
}

Line exact_line(const States& states, double threshold) {
    return train_with(states, "neyman-pearson", threshold).line;
}

// --- by the audit, in double and in float ---

/// A labelled file with what the audit needs of it, read once.
struct File {
    Snapshot snapshot;
    LabelledState state;
    LabelledState second; ///< with second_features()
};

std::vector<File> read_files(const TableInput& input) {
    std::vector<File> files;
    for (const Path& file : input.files) {
        files.emplace_back();
        files.back().snapshot = read_snapshot(file);
        files.back().state = labelled_state(files.back().snapshot, file);
        files.back().second = labelled_state(files.back().snapshot, file, second_features());
    }
    return files;
}

States states_of(const std::vector<File>& files) {
    States states;
    for (const File& file : files)
        states.push_back(file.state);
    return states;
}

Model train_with(const std::vector<File>& files, const std::string& objective, double threshold) {
    if (objective != two_lines)
        return train_with(states_of(files), objective, threshold);
    States second;
    for (const File& file : files)
        second.push_back(file.second);
    return train_two_lines(states_of(files), second, threshold);
}

/// The audit of one scene; of all where it is empty.
AuditRow audit_scene(const std::vector<File>& files, const Model& model, double threshold,
                     const std::string& scene) {
    AuditRow sum;
    for (const File& file : files)
        if (scene.empty() || file.state.scene == scene)
            add_row(audit_state(model, file.snapshot, file.state, threshold), sum);
    return sum;
}

/// Mean over scenes of the rate of false positives, in percent.
double mean_rate(const std::vector<File>& files, const Model& model, double threshold) {
    double sum = 0;
    const auto scenes = group_by_scene(states_of(files)).names;
    for (const std::string& scene : scenes)
        sum += 100 * false_positive_rate(audit_scene(files, model, threshold, scene));
    return sum / static_cast<double>(scenes.size());
}

Tables training(const TableInput& input) {
    Table table =
        table_of("training", "label threshold | objective | k {:.2f} | d {:.2f} | false negatives "
                             "(double / float) {:.0f} | false positives (double / float) {:.0f} | "
                             "of all particles, mean over scenes {:.2f} %");
    const auto files = read_files(input);
    for (const double threshold : thresholds)
        for (const std::string& objective : compared_objectives()) {
            const Model model = train_with(files, objective, threshold);
            const AuditRow row = audit_scene(files, model, threshold, "");
            const auto both = [](std::size_t in_double, std::size_t in_float) {
                return Figures{static_cast<double>(in_double), static_cast<double>(in_float)};
            };
            table.add({threshold, objective, model.line.k, model.line.d,
                       both(row.false_negatives, row.false_negatives_float),
                       both(row.false_positives, row.false_positives_float),
                       mean_rate(files, model, threshold)});
        }
    return {table};
}

/// A column a scene: missed (of the surface), false positives of all particles.
Table scene_table(const char* name, const char* second, const std::vector<std::string>& scenes) {
    std::string columns = std::string("label threshold | ") + second;
    for (const std::string& scene : scenes)
        columns += " | " + scene;
    return table_of(name, columns + " | missed area, worst scene {:.4f} %");
}

template <class ModelFor>
void add_scene_row(const std::vector<File>& files, const std::vector<std::string>& scenes,
                   double threshold, const Cell& name, const ModelFor& model_for, Table& table) {
    std::vector<Cell> row = {threshold, name};
    double worst_area = 0;
    for (const std::string& scene : scenes) {
        const AuditRow found = audit_scene(files, model_for(scene), threshold, scene);
        worst_area = std::max(worst_area, 100 * missed_area_fraction(found));
        row.emplace_back(fmt::format("{} ({:.3f} %), {:.2f} %", found.false_negatives,
                                     100 * false_negative_rate(found),
                                     100 * false_positive_rate(found)));
    }
    row.emplace_back(worst_area);
    table.add(row);
}

/// Trained on all scenes but one.
Tables unseen(const TableInput& input) {
    const auto files = read_files(input);
    const auto scenes = group_by_scene(states_of(files)).names;
    Table table = scene_table("unseen", "objective", scenes);
    for (const double threshold : thresholds)
        for (const std::string& objective : compared_objectives())
            add_scene_row(
                files, scenes, threshold, objective,
                [&](const std::string& scene) {
                    std::vector<File> others;
                    std::copy_if(files.begin(), files.end(), std::back_inserter(others),
                                 [&](const File& file) { return file.state.scene != scene; });
                    return train_with(others, objective, threshold);
                },
                table);
    return {table};
}

Model published_model(double d) {
    Model model;
    model.objective = "published";
    model.line = {74.688796680497925, d};
    return model;
}

Tables published(const TableInput& input) {
    const auto files = read_files(input);
    const auto scenes = group_by_scene(states_of(files)).names;
    Table table = scene_table("published", "d", scenes);
    for (const double threshold : {0.0, 0.02})
        for (const double d : {12.0, 13.0, 28.0, 35.0})
            add_scene_row(
                files, scenes, threshold, d, [&](const std::string&) { return published_model(d); },
                table);
    return {table};
}

// --- by counting ---

/// Mean over the scenes, from 0 to 1.
double rate_of(const States& states, const Line& line, double threshold) {
    return mean_false_positive_rate(count_errors(states, line, threshold));
}

Tables sweep(const TableInput& input) {
    constexpr double step = 0.05;
    Table table =
        table_of("sweep", "label threshold | best of the sweep: k {:.2f} | its rate {:.5f} | "
                          "neyman-pearson: k {:.2f} | its rate {:.5f} | ratio {:.4f}");
    table.before =
        fmt::format("Slopes from 0 to 1000 in steps of {}, each with the smallest d that "
                    "leaves no false negative:\n\n",
                    step);
    const auto states = read_states(input.files);
    for (const double threshold : thresholds) {
        double best = 1;
        double best_k = 0;
        for (int n = 0; n <= 20000; ++n) {
            const double rate = rate_of(states, shift_line(states, threshold, n * step), threshold);
            if (rate < best) {
                best = rate;
                best_k = n * step;
            }
        }
        const Line line = exact_line(states, threshold);
        const double rate = rate_of(states, line, threshold);
        table.add({threshold, best_k, best, line.k, rate, rate / best});
    }
    return {table};
}

Tables own_line(const TableInput& input) {
    const States states = read_states(input.files);
    const Line common = exact_line(states, shipped_threshold);
    Table table = table_of(
        "own-line",
        fmt::format("state | bulk neighbor count | common line (k = {:.1f}, d = {:.2f}) {{:.2f}} % "
                    "| same k, own d {{:.2f}} % | own line {{:.2f}} % | its k {{:.1f}} | its d "
                    "{{:.2f}}",
                    common.k, common.d));
    for (const LabelledState& state : states) {
        const States own = {state};
        const Line line = exact_line(own, shipped_threshold);
        std::vector<Cell> row = {state.file, bulk_neighbor_count(state).value_or(0)};
        for (const Line& tried : {common, shift_line(own, shipped_threshold, common.k), line})
            row.emplace_back(100 * rate_of(own, tried, shipped_threshold));
        row.insert(row.end(), {line.k, line.d});
        table.add(row);
    }
    return {table};
}

SceneErrors sum_of(const std::vector<SceneErrors>& scenes) {
    SceneErrors sum;
    for (const SceneErrors& scene : scenes)
        sum.add(scene);
    return sum;
}

Cell cell(const ErrorCounts& errors) {
    return fmt::format("{} of {}, {:.2f} %", errors.false_negatives, errors.surface_particles,
                       percent(errors.false_positives, errors.particles));
}

/// Errors on states of a line that saw the training states but for the scene that it is judged on.
SceneErrors unseen_errors(const States& training, const States& judged, double threshold) {
    std::vector<SceneErrors> all;
    for (const std::string& scene : group_by_scene(judged).names) {
        const Line line = exact_line(of_scene(training, scene, false), threshold);
        all.push_back(sum_of(count_errors(of_scene(judged, scene), line, threshold)));
    }
    return sum_of(all);
}

using Sources = std::array<States, 3>;

void add_sources(const Sources& groups, double threshold, const char* counts, Table& table) {
    const States both = joined(groups[0], groups[1]);
    const std::pair<const char*, const States&> trainings[] = {
        {"samples", groups[0]}, {"own states", groups[1]}, {"both", both}};
    for (const auto& [name, states] : trainings) {
        const Line line = exact_line(states, threshold);
        std::vector<Cell> row = {fmt::format("{}{}", threshold, counts), name, line.k, line.d};
        for (const States& judged : groups)
            row.push_back(cell(unseen_errors(states, judged, threshold)));
        table.add(row);
    }
}

/// From three folders.
Tables sources(const TableInput& input) {
    Sources groups;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        groups[g] = read_states({input.files.at(g)});
    }
    Table table = table_of("sources", "label threshold | trained on | k {:.1f} | d {:.2f} | "
                                      "samples | own states | own, papers' sizes");
    add_sources(groups, 0.02, "", table);
    add_sources(groups, 0, "", table);
    return {table};
}

/// Models as they are, run by run: files that end in .json are models, others states.
Tables lines(const TableInput& input) {
    const auto first_state =
        std::find_if(input.files.begin(), input.files.end(),
                     [](const Path& file) { return file.extension() != ".json"; });
    std::vector<Model> models;
    std::string columns = "run | particles";
    for (auto file = input.files.begin(); file != first_state; ++file) {
        models.push_back(read_model(*file));
        columns += " | " + file->stem().string() + " | candidates for each surface particle {:.1f}";
    }
    Table table = table_of("lines", columns);
    const std::vector<Path> states(first_state, input.files.end());
    std::vector<std::vector<AuditRow>> runs;
    for (const Model& model : models)
        runs.push_back(audit(model, states, {model.label_threshold, "", 0}).scenes);
    for (std::size_t run = 0; run < runs.front().size(); ++run) {
        std::vector<Cell> row = {runs.front()[run].scene, runs.front()[run].particles};
        for (const auto& of_model : runs) {
            const AuditRow& sum = of_model[run];
            const auto candidates =
                sum.surface_particles - sum.false_negatives + sum.false_positives;
            row.push_back(cell(sum));
            row.emplace_back(percent(candidates, sum.surface_particles) / 100);
        }
        table.add(row);
    }
    return {table};
}

/// The published line takes counts as they are.
SceneErrors published_errors(const Model& published, States judged) {
    for (LabelledState& state : judged)
        state.count_scale = 1;
    return sum_of(count_errors(judged, published.line, shipped_threshold));
}

/// Errors on a scene of two lines that saw all other training states.
SceneErrors unseen_errors_of_both(const std::array<States, 2>& training,
                                  const std::array<States, 2>& judged, const std::string& scene) {
    const Model model = train_two_lines(of_scene(training[0], scene, false),
                                        of_scene(training[1], scene, false), shipped_threshold);
    return sum_of(
        count_errors_of_both(model, of_scene(judged[0], scene), of_scene(judged[1], scene)));
}

/// From two folders.
Tables readme(const TableInput& input) {
    std::array<States, 2> samples, both;
    for (const std::size_t line : {0U, 1U}) {
        const FeaturePair features = line == 0 ? FeaturePair{} : second_features();
        samples[line] = read_states({input.files.at(0)}, features);
        both[line] = joined(samples[line], read_states({input.files.at(1)}, features));
    }
    Table table =
        table_of("readme", "scene | particles | our two lines: false negatives of surface, false "
                           "positives of all | our first line alone | published line, d = 28");
    Model published = published_model(28);
    for (const std::string& scene : group_by_scene(samples[0]).names) {
        const States judged = of_scene(samples[0], scene);
        const SceneErrors two = unseen_errors_of_both(both, samples, scene);
        table.add({scene, two.particles, cell(two),
                   cell(unseen_errors(both[0], judged, shipped_threshold)),
                   cell(published_errors(published, judged))});
    }
    return {table};
}

/// The line of the logistic fit as it is: a model file without the shift.
Tables plain_line(const TableInput& input) {
    const States states = read_states(input.files);
    TrainingOptions options;
    options.objective = "logistic";
    options.label_threshold = 0; // as published
    Model model = train(states, options);
    model.line = fit_with_torch(options.objective, states, options.label_threshold, options.seed);
    model.objective = "logistic, not shifted";
    model.d_margin = 0;
    const auto errors = sum_of(count_errors(states, model.line, options.label_threshold));
    model.false_negatives = errors.false_negatives;
    model.false_positives = errors.false_positives;
    return {text_alone(model_to_json(model))};
}

} // namespace

TableGroup accuracy_tables() {
    const char* const labelled = "LABELLED...";
    return {
        "Lines",
        {{"training", labelled, 1, "each objective trained on all files, and its errors", training},
         {"unseen", labelled, 1, "each scene judged by a line that never saw it", unseen},
         {"published", labelled, 1, "SPlisHSPlasH's line with its authors' constants d", published},
         {"sweep", labelled, 1, "neyman-pearson against a sweep over slopes", sweep},
         {"own-line", labelled, 1, "what a line for one state alone would reach", own_line},
         {"sources", "SAMPLES OWN AUDITED (folders)", 3,
          "lines trained on samples, on own states and on both", sources},
         {"lines", "MODEL... LABELLED...", 2, "errors of models as they are, run by run", lines},
         {"readme", "SAMPLES OWN (folders)", 2, "lines on scenes that they never saw", readme},
         {"plain-line", labelled, 1, "a model file: the logistic fit before its shift",
          plain_line}}};
}

} // namespace meniscus
