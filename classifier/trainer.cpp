#include "trainer.hpp"

#include "neyman_pearson.hpp"
#include "torch_plugin.hpp"

#include <meniscus/data/errors.hpp>
#include <meniscus/data/text.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus {
namespace {

void widen(std::optional<Range>& range, std::optional<double> value) {
    if (!value)
        return;
    if (!range)
        range = Range{*value, *value};
    range->min = std::min(range->min, *value);
    range->max = std::max(range->max, *value);
}

std::string names_of(const std::vector<LabelledState>& states) {
    const std::string first = states.front().file;
    return states.size() == 1 ? first
                              : first + " and " + std::to_string(states.size() - 1) + " more files";
}

std::size_t surface_particles(const LabelledState& state, double label_threshold) {
    return static_cast<std::size_t>(
        std::count_if(state.uncovered_fraction.begin(), state.uncovered_fraction.end(),
                      [&](double lambda) { return lambda > label_threshold; }));
}

void check_classes(const std::vector<LabelledState>& states, double label_threshold) {
    std::size_t particles = 0;
    std::size_t surface = 0;
    for (const LabelledState& state : states) {
        particles += state.size();
        surface += surface_particles(state, label_threshold);
    }
    if (surface != 0 && surface != particles)
        return;
    const std::string threshold = number_text(label_threshold);
    if (surface == 0)
        throw InputError(names_of(states) + ": no surface particle to train on among " +
                         std::to_string(particles) + " (uncovered fraction above " + threshold +
                         "); give other files or a lower --label-threshold");
    throw InputError(names_of(states) + ": no interior particle to train on among " +
                     std::to_string(particles) + " (uncovered fraction at most " + threshold +
                     "); give other files or a higher --label-threshold");
}

void check_training(const std::vector<LabelledState>& states, const TrainingOptions& options) {
    if (states.empty())
        throw InputError("no labelled file to train on; give at least one");
    const auto& names = training_objectives();
    if (std::find(names.begin(), names.end(), options.objective) == names.end())
        throw InputError("'" + options.objective +
                         "' is no objective; expected neyman-pearson, logistic or network");
    check_label_threshold(options.label_threshold);
    for (const LabelledState& state : states)
        if (!state.support_radius)
            throw InputError(state.file + ": its particles have support radii of their own, and "
                                          "lines are trained on states of one radius; leave it "
                                          "out, or label it with --support-radius");
    check_same_kind(states);
    if (options.keep_k) {
        check_dimension(*options.keep_k, states.front().dimension, states.front().file);
        check_radius_ratio(*options.keep_k, states.front().radius_ratio, states.front().file);
        check_boundary_rule(*options.keep_k, states.front().boundary_counts, states.front().file);
        if ((options.keep_k->reference_neighbor_count > 0) != states.front().relative)
            throw InputError("one of the line to keep and the states has relative counts, the "
                             "other has not");
    }
    check_classes(states, options.label_threshold);
}

Line trained_line(const std::vector<LabelledState>& states, const TrainingOptions& options) {
    const double threshold = options.label_threshold;
    if (options.keep_k)
        return shift_line(states, threshold, options.keep_k->line.k);
    if (options.objective == "neyman-pearson")
        return fewest_false_positives(states, threshold);
    return shift_line(states, threshold,
                      fit_with_torch(options.objective, states, threshold, options.seed).k);
}

void describe_training_set(const std::vector<LabelledState>& states, Model& model) {
    for (const LabelledState& state : states) {
        model.training_files.push_back({state.file, state.hash, state.scene, state.size(),
                                        surface_particles(state, model.label_threshold)});
        widen(model.spacing_ratio, spacing_ratio(state));
        widen(model.bulk_neighbor_count, bulk_neighbor_count(state));
    }
    for (const SceneErrors& scene : count_errors(states, model.line, model.label_threshold)) {
        model.false_negatives += scene.false_negatives;
        model.false_positives += scene.false_positives;
    }
}

} // namespace

const std::vector<std::string>& training_objectives() {
    static const std::vector<std::string> names = {"neyman-pearson", "logistic", "network"};
    return names;
}

Model train(const std::vector<LabelledState>& states, const TrainingOptions& options) {
    check_training(states, options);
    Model model;
    model.line = trained_line(states, options);
    model.dimension = states.front().dimension;
    model.radius_ratio = states.front().radius_ratio;
    model.boundary_counts = states.front().boundary_counts;
    model.reference_neighbor_count = states.front().relative ? reference_neighbor_count : 0;
    model.label_threshold = options.label_threshold;
    model.objective = options.keep_k ? "keep-k" : options.objective;
    model.d_margin = d_margin(model.line.k);
    describe_training_set(states, model);
    return model;
}

double d_margin(double k) {
    return margin_per_slope * std::abs(k) + margin_without_slope;
}

double smallest_d(const std::vector<LabelledState>& states, double label_threshold, double k) {
    if (!std::isfinite(k))
        throw InputError("the slope k of a line must be finite, found " + number_text(k));
    double d = -std::numeric_limits<double>::infinity();
    for (const LabelledState& state : states)
        for (std::size_t i = 0; i < state.size(); ++i)
            if (state.uncovered_fraction[i] > label_threshold && state.neighbor_count[i] != 0)
                d = std::max(d, state.scaled_count(i) - k * state.mass_offset[i]);
    if (std::isinf(d))
        throw InputError("no surface particle has neighbors (uncovered fraction above " +
                         number_text(label_threshold) +
                         "), so nothing holds the line; give other files");
    return d + d_margin(k);
}

Line shift_line(const std::vector<LabelledState>& states, double label_threshold, double k) {
    return {k, smallest_d(states, label_threshold, k)};
}

std::vector<SceneErrors> count_errors(const std::vector<LabelledState>& states, const Line& line,
                                      double label_threshold) {
    const SceneGroups groups = group_by_scene(states);
    std::vector<SceneErrors> scenes(groups.names.size());
    for (std::size_t s = 0; s < states.size(); ++s) {
        const LabelledState& state = states[s];
        SceneErrors& scene = scenes[groups.of_state[s]];
        scene.scene = state.scene;
        scene.particles += state.size();
        for (std::size_t i = 0; i < state.size(); ++i) {
            const bool surface = state.uncovered_fraction[i] > label_threshold;
            const bool predicted =
                predicts_surface(line, state.mass_offset[i], state.scaled_count(i));
            scene.surface_particles += static_cast<std::size_t>(surface);
            scene.false_negatives += static_cast<std::size_t>(surface && !predicted);
            scene.false_positives += static_cast<std::size_t>(!surface && predicted);
        }
    }
    return scenes;
}

double mean_false_positive_rate(const std::vector<SceneErrors>& scenes) {
    double sum = 0;
    std::size_t counted = 0;
    for (const SceneErrors& scene : scenes) {
        if (scene.particles == 0)
            continue;
        sum += static_cast<double>(scene.false_positives) / static_cast<double>(scene.particles);
        ++counted;
    }
    return counted == 0 ? 0 : sum / static_cast<double>(counted);
}

} // namespace meniscus
