// The accuracy tables of docs/accuracy.md, in Markdown, from labelled snapshots:
//   training      each objective trained on all files: the line and its errors, in double and float
//   unseen        leave one scene out: each scene judged by a line that never saw it
//   published     SPlisHSPlasH's line with the constants d that its authors name
//   sweep         neyman-pearson against an exhaustive sweep over slopes
//   own-line      what a line fitted to one state alone would reach there, and its bulk
//   sources       lines trained on SAMPLES, on OWN states and on both, on each of these and on
//   AUDITED lines         models as they are: what each misses and lets through, run by run
// Usage: accuracy_tables TABLE LABELLED...
//        accuracy_tables sources SAMPLES... -- OWN... -- AUDITED...
//        accuracy_tables lines MODEL... -- LABELLED...
//        accuracy_tables readme SAMPLES... -- OWN...
#include <meniscus/classifier/audit.hpp>
#include <meniscus/classifier/torch_plugin.hpp>
#include <meniscus/classifier/trainer.hpp>
#include <meniscus/data/snapshot_files.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>

namespace meniscus {
namespace {

constexpr double thresholds[] = {0, 0.005, 0.02};
constexpr const char* relative_objective = "neyman-pearson, relative counts";

/// A labelled file with what the audit needs of it, read once.
struct File {
    Snapshot snapshot;
    LabelledState state;
};

std::vector<LabelledState> states_of(const std::vector<File>& files, const std::string& left_out) {
    std::vector<LabelledState> states;
    for (const File& file : files)
        if (file.state.scene != left_out)
            states.push_back(file.state);
    return states;
}

std::vector<std::string> scenes_of(const std::vector<File>& files) {
    std::vector<std::string> scenes;
    for (const File& file : files)
        if (std::find(scenes.begin(), scenes.end(), file.state.scene) == scenes.end())
            scenes.push_back(file.state.scene);
    return scenes;
}

std::vector<std::string> objectives() {
    std::vector<std::string> names = {relative_objective, "neyman-pearson"};
    if (has_torch_trainer())
        names.insert(names.end(), {"logistic", "network"});
    return names;
}

Model train_with(std::vector<LabelledState> states, const std::string& objective,
                 double threshold) {
    TrainingOptions options;
    options.objective = objective;
    if (objective == relative_objective) {
        options.objective = "neyman-pearson";
        for (LabelledState& state : states)
            make_relative(state);
    }
    options.label_threshold = threshold;
    return train(states, options);
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

/// Mean over scenes of the rate of false positives.
double mean_rate(const std::vector<File>& files, const Model& model, double threshold) {
    double sum = 0;
    const auto scenes = scenes_of(files);
    for (const std::string& scene : scenes) {
        sum += 100 * false_positive_rate(audit_scene(files, model, threshold, scene));
    }
    return sum / static_cast<double>(scenes.size());
}

void print_training(const std::vector<File>& files) {
    fmt::print("| label threshold | objective | k | d | false negatives (double / float) | false "
               "positives (double / float) | of all particles, mean over scenes |\n"
               "|---|---|---|---|---|---|---|\n");
    const auto states = states_of(files, "");
    for (const double threshold : thresholds)
        for (const std::string& objective : objectives()) {
            const Model model = train_with(states, objective, threshold);
            const AuditRow row = audit_scene(files, model, threshold, "");
            fmt::print("| {} | {} | {:.2f} | {:.2f} | {} / {} | {} / {} | {:.2f} % |\n", threshold,
                       objective, model.line.k, model.line.d, row.false_negatives,
                       row.false_negatives_float, row.false_positives, row.false_positives_float,
                       mean_rate(files, model, threshold));
        }
}

/// "missed (of surface), let through of all".
std::string cell(const AuditRow& row) {
    return fmt::format("{} ({:.3f} %), {:.2f} %", row.false_negatives,
                       100 * false_negative_rate(row), 100 * false_positive_rate(row));
}

void print_scene_columns(const std::string& first, const std::vector<std::string>& scenes,
                         const std::string& last) {
    std::string rule = "|---|---|";
    fmt::print("| label threshold | {} |", first);
    for (const std::string& scene : scenes) {
        fmt::print(" {} |", scene);
        rule += "---|";
    }
    fmt::print(" {} |\n{}---|\n", last, rule);
}

/// Trained on all scenes but one.
AuditRow unseen_row(const std::vector<File>& files, const std::string& objective, double threshold,
                    const std::string& scene) {
    return audit_scene(files, train_with(states_of(files, scene), objective, threshold), threshold,
                       scene);
}

void print_unseen(const std::vector<File>& files) {
    const auto scenes = scenes_of(files);
    print_scene_columns("objective", scenes, "missed area, worst scene");
    for (const double threshold : thresholds)
        for (const std::string& objective : objectives()) {
            fmt::print("| {} | {} |", threshold, objective);
            double worst_area = 0;
            for (const std::string& scene : scenes) {
                const AuditRow row = unseen_row(files, objective, threshold, scene);
                worst_area = std::max(worst_area, 100 * missed_area_fraction(row));
                fmt::print(" {} |", cell(row));
            }
            fmt::print(" {:.4f} % |\n", worst_area);
        }
}

Model published_model(double d) {
    Model model;
    model.objective = "published";
    model.line = {74.688796680497925, d};
    return model;
}

void print_published(const std::vector<File>& files) {
    const auto scenes = scenes_of(files);
    print_scene_columns("d", scenes, "missed area, worst scene");
    for (const double threshold : {0.0, 0.02})
        for (const double d : {12.0, 13.0, 28.0, 35.0}) {
            fmt::print("| {} | {} |", threshold, d);
            double worst_area = 0;
            for (const std::string& scene : scenes) {
                const AuditRow row = audit_scene(files, published_model(d), threshold, scene);
                worst_area = std::max(worst_area, 100 * missed_area_fraction(row));
                fmt::print(" {} |", cell(row));
            }
            fmt::print(" {:.4f} % |\n", worst_area);
        }
}

void print_sweep(const std::vector<File>& files) {
    constexpr double step = 0.05;
    fmt::print("Slopes from 0 to 1000 in steps of {}, each with the smallest d that leaves no "
               "false negative:\n\n"
               "| label threshold | best of the sweep: k | its rate | neyman-pearson: k | its rate "
               "| ratio |\n|---|---|---|---|---|---|\n",
               step);
    const auto states = states_of(files, "");
    const auto rate_of = [&](const Line& line, double threshold) {
        return mean_false_positive_rate(count_errors(states, line, threshold));
    };
    for (const double threshold : thresholds) {
        double best = 1;
        double best_k = 0;
        for (int n = 0; n <= 20000; ++n) {
            const double rate = rate_of(shift_line(states, threshold, n * step), threshold);
            if (rate < best) {
                best = rate;
                best_k = n * step;
            }
        }
        const Line line = train_with(states, "neyman-pearson", threshold).line;
        const double rate = rate_of(line, threshold);
        fmt::print("| {} | {:.2f} | {:.5f} | {:.2f} | {:.5f} | {:.4f} |\n", threshold, best_k, best,
                   line.k, rate, rate / best);
    }
}

void print_own_line(const std::vector<File>& files) {
    constexpr double threshold = 0.02;
    const Model common = train_with(states_of(files, ""), "neyman-pearson", threshold);
    fmt::print("| state | bulk neighbor count | common line (k = {:.1f}, d = {:.2f}) | same k, own "
               "d | own line | its k | its d |\n|---|---|---|---|---|---|---|\n",
               common.line.k, common.line.d);
    for (const File& file : files) {
        const std::vector<LabelledState> own = {file.state};
        const auto rate_of = [&](const Line& line) {
            return 100 * mean_false_positive_rate(count_errors(own, line, threshold));
        };
        const Line line = train_with(own, "neyman-pearson", threshold).line;
        fmt::print("| {} | {} | {:.2f} % | {:.2f} % | {:.2f} % | {:.1f} | {:.2f} |\n",
                   file.state.file, bulk_neighbor_count(file.state).value_or(0),
                   rate_of(common.line), rate_of(shift_line(own, threshold, common.line.k)),
                   rate_of(line), line.k, line.d);
    }
}

using States = std::vector<LabelledState>;

States relative(States states) {
    for (LabelledState& state : states)
        make_relative(state);
    return states;
}

States read_states(const std::vector<std::string>& files) {
    States states;
    for (const std::string& file : files)
        states.push_back(read_labelled_state(file, ""));
    return states;
}

States joined(States states, const States& more) {
    states.insert(states.end(), more.begin(), more.end());
    return states;
}

States of_scene(const States& states, const std::string& scene) {
    States found;
    std::copy_if(states.begin(), states.end(), std::back_inserter(found),
                 [&](const LabelledState& state) { return state.scene == scene; });
    return found;
}

States without(const States& states, const std::string& scene) {
    States rest;
    std::copy_if(states.begin(), states.end(), std::back_inserter(rest),
                 [&](const LabelledState& state) { return state.scene != scene; });
    return rest;
}

SceneErrors sum_of(const std::vector<SceneErrors>& scenes) {
    SceneErrors sum;
    for (const SceneErrors& scene : scenes) {
        sum.particles += scene.particles;
        sum.surface_particles += scene.surface_particles;
        sum.false_negatives += scene.false_negatives;
        sum.false_positives += scene.false_positives;
    }
    return sum;
}

double share(std::size_t part, std::size_t whole) {
    return 100 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string cell(const SceneErrors& errors) {
    return fmt::format("{} of {}, {:.2f} %", errors.false_negatives, errors.surface_particles,
                       share(errors.false_positives, errors.particles));
}

/// Errors on states of a line that saw the training states but for the scene that it is judged on.
SceneErrors unseen_errors(const States& training, const States& judged, double threshold) {
    TrainingOptions options;
    options.label_threshold = threshold;
    std::vector<SceneErrors> all;
    for (const std::string& scene : group_by_scene(judged).names) {
        const Line line = train(without(training, scene), options).line;
        all.push_back(sum_of(count_errors(of_scene(judged, scene), line, threshold)));
    }
    return sum_of(all);
}

void print_sources_rows(const std::array<States, 3>& groups, double threshold,
                        const std::string& counts) {
    const auto& [samples, own, audited] = groups;
    const States both = joined(samples, own);
    const std::pair<const char*, const States&> trainings[] = {
        {"samples", samples}, {"own states", own}, {"both", both}};
    for (const auto& [name, training] : trainings) {
        TrainingOptions options;
        options.label_threshold = threshold;
        const Line line = train(training, options).line;
        fmt::print("| {}{} | {} | {:.1f} | {:.2f} |", threshold, counts, name, line.k, line.d);
        for (const States& judged : groups)
            fmt::print(" {} |", cell(unseen_errors(training, judged, threshold)));
        fmt::print("\n");
    }
}

void print_sources(const std::vector<std::vector<std::string>>& files) {
    if (files.size() != 3)
        throw std::runtime_error("usage: accuracy_tables sources SAMPLES... -- OWN... -- "
                                 "AUDITED...");
    std::array<States, 3> groups;
    std::array<States, 3> scaled;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        groups[g] = read_states(files[g]);
        scaled[g] = relative(groups[g]);
    }
    fmt::print("| label threshold | trained on | k | d | samples | own states | own, papers' sizes "
               "|\n|---|---|---|---|---|---|---|\n");
    print_sources_rows(groups, 0.02, "");
    print_sources_rows(groups, 0, "");
    print_sources_rows(scaled, 0.02, ", relative counts");
}

void print_lines(const std::vector<std::vector<std::string>>& files) {
    if (files.size() != 2)
        throw std::runtime_error("usage: accuracy_tables lines MODEL... -- LABELLED...");
    std::vector<Model> models;
    fmt::print("| run | particles |");
    std::string rule = "|---|---|";
    for (const std::string& file : files[0]) {
        models.push_back(read_model(file));
        fmt::print(" {} | candidates for each surface particle |",
                   std::filesystem::path(file).stem().string());
        rule += "---|---|";
    }
    fmt::print("\n{}\n", rule);
    const States states = read_states(files[1]);
    for (const std::string& run : group_by_scene(states).names) {
        const States of_run = of_scene(states, run);
        std::string cells;
        std::size_t particles = 0;
        for (const Model& model : models) {
            const States& counted = model.reference_neighbor_count > 0 ? relative(of_run) : of_run;
            const SceneErrors sum =
                sum_of(count_errors(counted, model.line, model.label_threshold));
            const auto candidates =
                sum.surface_particles - sum.false_negatives + sum.false_positives;
            cells += fmt::format(" {} | {:.1f} |", cell(sum),
                                 share(candidates, sum.surface_particles) / 100);
            particles = sum.particles;
        }
        fmt::print("| {} | {} |{}\n", run, particles, cells);
    }
}

void print_readme(const std::vector<std::vector<std::string>>& files) {
    if (files.size() != 2)
        throw std::runtime_error("usage: accuracy_tables readme SAMPLES... -- OWN...");
    constexpr double threshold = 0.02;
    const States samples = read_states(files[0]);
    const States both = joined(samples, read_states(files[1]));
    fmt::print("| scene | particles | our line: missed of surface, let through of all | our "
               "relative line | published line, d = 28 |\n|---|---|---|---|---|\n");
    for (const std::string& scene : group_by_scene(samples).names) {
        const States judged = of_scene(samples, scene);
        const SceneErrors plain = unseen_errors(both, judged, threshold);
        const auto published = count_errors(judged, published_model(28).line, threshold);
        fmt::print("| {} | {} | {} | {} | {} |\n", scene, plain.particles, cell(plain),
                   cell(unseen_errors(relative(samples), relative(judged), threshold)),
                   cell(sum_of(published)));
    }
}

/// Arguments from the second on, cut at "--".
std::vector<std::vector<std::string>> groups_of(int argument_count, char** arguments) {
    std::vector<std::vector<std::string>> groups(1);
    for (int a = 2; a < argument_count; ++a)
        if (arguments[a] == std::string("--"))
            groups.emplace_back();
        else
            groups.back().emplace_back(arguments[a]);
    return groups;
}

int run(int argument_count, char** arguments) {
    const std::map<std::string, void (*)(const std::vector<std::vector<std::string>>&)> of_groups =
        {{"sources", print_sources}, {"lines", print_lines}, {"readme", print_readme}};
    if (argument_count > 1 && of_groups.count(arguments[1]) != 0) {
        of_groups.at(arguments[1])(groups_of(argument_count, arguments));
        return 0;
    }
    const std::map<std::string, void (*)(const std::vector<File>&)> tables = {
        {"training", print_training},
        {"unseen", print_unseen},
        {"published", print_published},
        {"sweep", print_sweep},
        {"own-line", print_own_line}};
    if (argument_count < 3 || tables.count(arguments[1]) == 0)
        throw std::runtime_error("usage: accuracy_tables training|unseen|published|sweep|own-line|"
                                 "readme|sources|lines LABELLED...");
    std::vector<File> files;
    for (int a = 2; a < argument_count; ++a) {
        File file;
        file.snapshot = read_snapshot(arguments[a]);
        file.state = labelled_state(file.snapshot, arguments[a]);
        files.push_back(std::move(file));
    }
    tables.at(arguments[1])(files);
    return 0;
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        return meniscus::run(argument_count, arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "accuracy_tables: %s\n", error.what());
        return 1;
    }
}
