#include "feature_pairs.hpp"

#include "particle_features.hpp"

#include <meniscus/classifier/objectives/neyman_pearson.hpp>
#include <meniscus/classifier/objectives/scene_errors.hpp>
#include <meniscus/classifier/objectives/shift.hpp>

#include <algorithm>
#include <exception>
#include <functional>
#include <limits>
#include <map>

namespace meniscus {
namespace {

/// What decides: true where a particle of features x and y is taken for surface.
using Rule = std::function<bool(double x, double y)>;
/// Learns a rule from states at a label threshold.
using Trainer = Rule (*)(const std::vector<LabelledState>&, double);

Rule rule_of(const Line& line) {
    return [line](double x, double y) { return predicts_surface(line, x, y); };
}

Rule line(const std::vector<LabelledState>& states, double label_threshold) {
    return rule_of(min_false_positives(states, label_threshold));
}

/// A line of slope 0, on either side.
Rule threshold(const std::vector<LabelledState>& states, double label_threshold) {
    const auto line_at = [&](bool above) { return shift_line(states, label_threshold, 0, above); };
    const auto rate_of = [&](const Line& line) {
        return mean_false_positive_rate(count_errors(states, line, label_threshold));
    };
    const Line below = line_at(false);
    const Line above = line_at(true);
    return rule_of(rate_of(below) <= rate_of(above) ? below : above);
}

/// For each count (y) the smallest offset (x) of a surface particle.
std::map<double, double> min_offsets(const std::vector<LabelledState>& states,
                                     double label_threshold) {
    std::map<double, double> offsets;
    for (const LabelledState& state : states)
        for (std::size_t i = 0; i < state.size(); ++i)
            if (state.uncovered_fraction[i] > label_threshold && !state.is_alone(i)) {
                const auto [entry, is_new] = offsets.try_emplace(state.y(i), state.x(i));
                entry->second = std::min(entry->second, state.x(i));
            }
    return offsets;
}

/// Counts of which no surface particle was seen are taken for interior.
Rule table_of_counts(const std::vector<LabelledState>& states, double label_threshold) {
    return [offsets = min_offsets(states, label_threshold)](double x, double y) {
        const auto entry = offsets.find(y);
        return entry != offsets.end() && x >= entry->second;
    };
}

/// An offset that is surface at a count is surface at every smaller count.
Rule falling_table_of_counts(const std::vector<LabelledState>& states, double label_threshold) {
    auto offsets = min_offsets(states, label_threshold);
    double min = std::numeric_limits<double>::infinity();
    for (auto entry = offsets.rbegin(); entry != offsets.rend(); ++entry)
        entry->second = min = std::min(min, entry->second);
    return [offsets = std::move(offsets)](double x, double y) {
        const auto entry = offsets.lower_bound(y);
        return entry != offsets.end() && x >= entry->second;
    };
}

/// Something to be trained and judged.
struct Candidate {
    FeaturePair features;
    std::string kind;
    std::string name;
    Trainer train;
};

std::vector<Candidate> candidates() {
    std::vector<Candidate> all;
    const auto name = [](std::size_t feature) { return std::string(feature_list[feature].name); };
    for (std::size_t a = 0; a < feature_count; ++a)
        for (std::size_t b = a + 1; b < feature_count; ++b)
            all.push_back({{a, b}, "line", name(a) + ", " + name(b), line});
    for (std::size_t a = 0; a < feature_count; ++a)
        all.push_back({{a, a}, "threshold", name(a), threshold});
    all.push_back({{}, "table", "offset for each count", table_of_counts});
    all.push_back({{}, "table", "offset for each count, falling", falling_table_of_counts});
    return all;
}

std::vector<double> in_double(const std::vector<float>& values) {
    return {values.begin(), values.end()};
}

/// The states with the features of a candidate.
std::vector<LabelledState> states_for(const FeaturePair& features,
                                      const std::vector<FluidState<float>>& states,
                                      const std::vector<FeatureArrays>& arrays) {
    std::vector<LabelledState> labelled(states.size());
    for (std::size_t s = 0; s < states.size(); ++s) {
        LabelledState& state = labelled[s];
        state.scene = states[s].scene;
        state.features = features;
        state.first = in_double(arrays[s][features.first]);
        state.second = in_double(arrays[s][features.second]);
        state.neighbor_count = in_double(arrays[s][FeaturePair{}.second]);
        state.uncovered_fraction = states[s].uncovered_fraction;
    }
    return labelled;
}

/// The states of a scene, or all others.
std::vector<LabelledState> select(const std::vector<LabelledState>& states,
                                  const std::string& scene, bool of_scene) {
    std::vector<LabelledState> some;
    for (const LabelledState& state : states)
        if ((state.scene == scene) == of_scene)
            some.push_back(state);
    return some;
}

ErrorCounts judge(const std::vector<LabelledState>& states, const Rule& rule,
                  double label_threshold) {
    ErrorCounts counts;
    for (const LabelledState& state : states)
        for (std::size_t i = 0; i < state.size(); ++i)
            counts.add(state.uncovered_fraction[i], label_threshold,
                       state.is_alone(i) || rule(state.x(i), state.y(i)));
    return counts;
}

/// Rates are in percent, means over scenes.
struct Errors {
    double false_positive_rate = 0;
    double left_out_false_negatives = 0;
    double left_out_miss_rate = 0;
    double left_out_false_positive_rate = 0;
};

Errors errors_of(const std::vector<LabelledState>& states, const Candidate& candidate,
                 double label_threshold) {
    Errors errors;
    const auto scenes = group_by_scene(states).names;
    const double share = 100 / static_cast<double>(scenes.size());
    const Rule rule = candidate.train(states, label_threshold);
    for (const std::string& scene : scenes) {
        const auto judged = select(states, scene, true);
        errors.false_positive_rate +=
            share * false_positive_rate(judge(judged, rule, label_threshold));
        if (scenes.size() == 1)
            continue;
        const Rule other = candidate.train(select(states, scene, false), label_threshold);
        const ErrorCounts left_out = judge(judged, other, label_threshold);
        errors.left_out_false_negatives += static_cast<double>(left_out.false_negatives);
        errors.left_out_miss_rate += share * false_negative_rate(left_out);
        errors.left_out_false_positive_rate += share * false_positive_rate(left_out);
    }
    return errors;
}

/// Errors of all candidates, on several threads.
std::vector<Errors> errors_of_all(const std::vector<FluidState<float>>& states,
                                  const std::vector<Candidate>& all,
                                  const FeaturePairOptions& options) {
    std::vector<FeatureArrays> arrays;
    for (const auto& state : states)
        arrays.push_back(all_features(state));
    std::vector<Errors> errors(all.size());
    // Candidates take seconds each, a chunk of a loop over particles would hold all of them.
    std::exception_ptr thrown;
#pragma omp parallel for schedule(dynamic) num_threads(options.threads)
    for (std::size_t c = 0; c < all.size(); ++c)
        try {
            errors[c] = errors_of(states_for(all[c].features, states, arrays), all[c],
                                  options.label_threshold);
        } catch (...) {
#pragma omp critical(meniscus_thrown)
            thrown = std::current_exception();
        }
    if (thrown)
        std::rethrow_exception(thrown);
    return errors;
}

/// Times of the passes that find a candidate's features, in the order of the candidates.
std::vector<RepeatedTime> times_of(const std::vector<FluidState<float>>& states,
                                   const std::vector<Candidate>& all,
                                   const TimingOptions& options) {
    std::vector<FeatureArrays> features(states.size());
    double particles = 0;
    for (const auto& state : states)
        particles += static_cast<double>(state.size());
    std::vector<Timed> timed;
    timed.reserve(all.size());
    for (const Candidate& candidate : all)
        timed.push_back({[&states, &features, pair = candidate.features] {
            for (std::size_t s = 0; s < states.size(); ++s)
                find_features(states[s], pair, features[s]);
        }});
    auto times = measure(timed, options);
    const double scale = 1e9 / particles;
    for (RepeatedTime& time : times)
        time = {time.median * scale, time.lower * scale, time.upper * scale};
    return times;
}

Table empty_table(int dimension) {
    const std::string name = std::to_string(dimension) + "d";
    return {"feature_pairs_" + name,
            "Features to draw a line in, " + std::to_string(dimension) + "D",
            {{"features", "features"},
             {"kind", "kind"},
             {"false_positive_rate", "false positives, %"},
             {"left_out_false_negatives", "missed in left-out scenes", 9},
             {"left_out_miss_rate", "of their surface, %", 2},
             {"left_out_false_positive_rate", "false positives there, %"},
             {"time", "ns a particle"}},
            {}};
}

} // namespace

Table feature_pairs(const std::vector<FluidState<float>>& states,
                    const FeaturePairOptions& options) {
    const auto all = candidates();
    const auto errors = errors_of_all(states, all, options);
    const auto times = times_of(states, all, options.timing);
    Table table = empty_table(states.front().dimension);
    const bool has_left_out = std::any_of(states.begin(), states.end(), [&](const auto& state) {
        return state.scene != states.front().scene;
    });
    for (std::size_t c = 0; c < all.size(); ++c) {
        const auto left_out = [&](double figure) { return has_left_out ? Cell(figure) : Cell(); };
        table.rows.push_back({all[c].name, all[c].kind, errors[c].false_positive_rate,
                              left_out(errors[c].left_out_false_negatives),
                              left_out(errors[c].left_out_miss_rate),
                              left_out(errors[c].left_out_false_positive_rate),
                              all[c].kind == "table" ? Cell() : Cell(times[c])});
    }
    mark_best(table, {"false_positive_rate", "left_out_false_negatives", "time"});
    return table;
}

} // namespace meniscus
