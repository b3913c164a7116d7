#include "trainer.hpp"

#include "neyman_pearson.hpp"
#include "objectives.hpp"
#include "scene_errors.hpp"
#include "shift.hpp"

#include <meniscus/data/particles/feature_names.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>

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

std::string file_names(const std::vector<LabelledState>& states) {
    const std::string first = states.front().file;
    return states.size() == 1 ? first
                              : first + " and " + std::to_string(states.size() - 1) + " more files";
}

void check_classes(const Campaign& campaign, const std::vector<LabelledState>& states,
                   double label_threshold) {
    std::size_t particles = 0;
    std::size_t surface = 0;
    for (const StateHead& head : campaign.heads) {
        particles += head.particles;
        surface += head.surface;
    }
    if (surface != 0 && surface != particles)
        return;
    const std::string threshold = number_text(label_threshold);
    if (surface == 0)
        throw InputError(file_names(states) + ": no surface particle to train on among " +
                         std::to_string(particles) + " (uncovered fraction above " + threshold +
                         "); give other files or a lower --label-threshold");
    throw InputError(file_names(states) + ": no interior particle to train on among " +
                     std::to_string(particles) + " (uncovered fraction at most " + threshold +
                     "); give other files or a higher --label-threshold");
}

/// `states`: without particles.
void check_training(const Campaign& campaign, const std::vector<LabelledState>& states,
                    const TrainingOptions& options) {
    if (states.empty())
        throw InputError("no labelled file to train on; give at least one");
    if (!objective_named(options.objective).any_features && !is_of_paper(states.front().features))
        throw InputError("objective '" + options.objective + "' fits lines of the features " +
                         names_of(FeaturePair{}) + ", not of " + names_of(states.front().features) +
                         "; train with --objective neyman-pearson");
    check_label_threshold(options.label_threshold);
    for (const LabelledState& state : states)
        if (!state.support_radius)
            throw InputError(state.file + ": its particles have support radii of their own, and "
                                          "lines are trained on states of one radius; leave it "
                                          "out, or label it with --support-radius");
    check_same_kind(states);
    if (options.keep_k) {
        if (names_of(options.keep_k->features) != names_of(states.front().features))
            throw InputError("the line to keep is of the features " +
                             names_of(options.keep_k->features) + ", the states have " +
                             names_of(states.front().features) + "; give --features " +
                             names_of(options.keep_k->features));
        check_dimension(*options.keep_k, states.front().dimension, states.front().file);
        check_radius_ratio(*options.keep_k, states.front().radius_ratio, states.front().file);
        for (const LabelledState& state : states)
            check_boundary_weight(*options.keep_k, state.boundary_weight, state.file);
        if (options.keep_k->reference_spacing_ratio != reference_spacing_ratio)
            throw InputError("the line to keep takes counts as they are, and lines are trained on "
                             "counts at a support radius of " +
                             number_text(reference_spacing_ratio) +
                             " spacings; keep one that was trained so");
    }
    check_classes(campaign, states, options.label_threshold);
}

Line trained_line(const Campaign& campaign, const TrainingOptions& options) {
    if (options.keep_k)
        return shift_line(campaign, options.label_threshold, options.keep_k->line.k,
                          options.keep_k->line.above);
    const Objective& objective = objective_named(options.objective);
    if (objective.fit_campaign != nullptr)
        return objective.fit_campaign(campaign, options.label_threshold);
    if (campaign.in_memory == nullptr)
        throw InputError("objective '" + options.objective +
                         "' needs all files in the memory of one process; train with --objective "
                         "neyman-pearson, or without --memory and mpirun");
    return objective.fit(*campaign.in_memory, options.label_threshold, options.seed);
}

void set_errors(Model& model, const std::vector<SceneErrors>& scenes) {
    model.false_negatives = model.false_positives = 0;
    for (const SceneErrors& scene : scenes) {
        model.false_negatives += scene.false_negatives;
        model.false_positives += scene.false_positives;
    }
}

void describe_training_set(const Campaign& campaign, Model& model) {
    for (const StateHead& head : campaign.heads) {
        const LabelledState& state = head.state;
        model.training_files.push_back(
            {state.file, state.hash, state.scene, head.particles, head.surface});
        widen(model.spacing_ratio, state.spacing_ratio);
        widen(model.bulk_neighbor_count, head.bulk_neighbor_count);
    }
    set_errors(model, count_errors(campaign, model.line, model.label_threshold));
}

/// Notes which particles of a state the model's line lets through.
void mark_candidates(const Model& model, const LabelledState& first, LabelledState& second) {
    if (first.uncovered_fraction != second.uncovered_fraction)
        throw InputError(first.file + " and " + second.file +
                         " are not the same state, so a second line cannot follow the first");
    second.candidate.resize(first.size());
    for (std::size_t i = 0; i < first.size(); ++i)
        second.candidate[i] = static_cast<std::uint8_t>(
            first.is_alone(i) || predicts_surface(model.line, first.x(i), first.y(i)));
}

/// The same for all, which must be the same ones.
void mark_candidates(const Model& model, const std::vector<LabelledState>& first,
                     std::vector<LabelledState>& second) {
    if (first.size() != second.size())
        throw InputError("the second line has " + std::to_string(second.size()) +
                         " states, the first " + std::to_string(first.size()));
    for (std::size_t s = 0; s < first.size(); ++s)
        mark_candidates(model, first[s], second[s]);
}

} // namespace

Model train(const Campaign& campaign, const TrainingOptions& options) {
    const auto states = campaign.states();
    check_training(campaign, states, options);
    Model model;
    model.line = trained_line(campaign, options);
    model.features = states.front().features;
    model.dimension = states.front().dimension;
    model.radius_ratio = states.front().radius_ratio;
    model.boundary_weight = common_boundary_weight(states);
    model.reference_spacing_ratio = reference_spacing_ratio;
    model.label_threshold = options.label_threshold;
    model.objective = options.keep_k ? "keep-k" : options.objective;
    model.d_margin = d_margin(model.line.k, model.features);
    describe_training_set(campaign, model);
    return model;
}

Model train(const std::vector<LabelledState>& states, const TrainingOptions& options) {
    return train(campaign_of(states, options.label_threshold), options);
}

std::vector<SceneErrors> add_second_line(Model& model, const std::vector<LabelledState>& first,
                                         std::vector<LabelledState> second) {
    if (!is_of_paper(model.features))
        throw InputError("a second line follows a first one of " + names_of(FeaturePair{}) +
                         "; leave --features out");
    mark_candidates(model, first, second);
    SecondModelLine line;
    line.features = second.front().features;
    line.line = min_false_positives(second, model.label_threshold);
    line.d_margin = d_margin(line.line.k, line.features);
    model.second = line;
    const auto errors = count_errors(second, line.line, model.label_threshold);
    set_errors(model, errors);
    return errors;
}

std::vector<SceneErrors> count_errors_of_both(const Model& model,
                                              const std::vector<LabelledState>& first,
                                              std::vector<LabelledState> second) {
    mark_candidates(model, first, second);
    return count_errors(second, model.second.value().line, model.label_threshold);
}

} // namespace meniscus
