#include "comparison/feature_pairs.hpp"

#include "comparison/half_plane.hpp"
#include "comparison/particle_features.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <map>

namespace meniscus {
namespace {

/// One entry a particle of all states together.
struct Particles {
    std::vector<FeatureArrays> features; ///< one a state
    std::vector<std::size_t> scene_of;   ///< one a state
    std::vector<std::string> scenes;
    std::vector<std::int64_t>
        weight; ///< of a particle, one a scene: the same for each scene in all
};

Particles particles_of(const std::vector<FluidState<float>>& states) {
    Particles all;
    std::vector<double> sizes;
    for (const auto& state : states) {
        const auto found = std::find(all.scenes.begin(), all.scenes.end(), state.scene);
        all.scene_of.push_back(static_cast<std::size_t>(found - all.scenes.begin()));
        if (found == all.scenes.end()) {
            all.scenes.push_back(state.scene);
            sizes.push_back(0);
        }
        sizes[all.scene_of.back()] += static_cast<double>(state.size());
        all.features.push_back(all_features(state));
    }
    // In units so small that a weight is whole: then sums are the same in every order.
    const double of_scene = std::ldexp(1.0, 62) / static_cast<double>(sizes.size());
    for (const double size : sizes)
        all.weight.push_back(std::llround(of_scene / size));
    return all;
}

/// What decides: true where a particle of these two features is taken for surface.
using Rule = std::function<bool(const PlanePoint&)>;
/// Learns a rule.
using Trainer = std::function<Rule(const LabelledPoints&)>;

Rule line(const LabelledPoints& particles) {
    const HalfPlane half = tightest_half_plane(particles);
    return [half](const PlanePoint& point) { return half.contains(point); };
}

Rule threshold(const LabelledPoints& particles) {
    const HalfPlane half = tightest_threshold(particles);
    return [half](const PlanePoint& point) { return half.contains(point); };
}

/// For each count (y) the smallest offset (x) of a surface particle.
std::map<double, double> smallest_offsets(const LabelledPoints& particles) {
    std::map<double, double> offsets;
    for (std::size_t i = 0; i < particles.points.size(); ++i)
        if (particles.surface[i] != 0) {
            const auto [entry, is_new] =
                offsets.try_emplace(particles.points[i].y, particles.points[i].x);
            entry->second = std::min(entry->second, particles.points[i].x);
        }
    return offsets;
}

/// Counts of which no surface particle was seen are taken for interior.
Rule table_of_counts(const LabelledPoints& particles) {
    return [offsets = smallest_offsets(particles)](const PlanePoint& point) {
        const auto entry = offsets.find(point.y);
        return entry != offsets.end() && point.x >= entry->second;
    };
}

/// An offset that is surface at a count is surface at every smaller count.
Rule falling_table_of_counts(const LabelledPoints& particles) {
    auto offsets = smallest_offsets(particles);
    double least = std::numeric_limits<double>::infinity();
    for (auto entry = offsets.rbegin(); entry != offsets.rend(); ++entry)
        entry->second = least = std::min(least, entry->second);
    return [offsets = std::move(offsets)](const PlanePoint& point) {
        const auto entry = offsets.lower_bound(point.y);
        return entry != offsets.end() && point.x >= entry->second;
    };
}

/// Something to be trained and judged.
struct Candidate {
    Feature a;
    Feature b;
    std::string kind;
    std::string name;
    Trainer train;
};

std::vector<Candidate> candidates() {
    std::vector<Candidate> all;
    for (std::size_t a = 0; a < feature_count; ++a)
        for (std::size_t b = a + 1; b < feature_count; ++b) {
            const auto first = static_cast<Feature>(a);
            const auto second = static_cast<Feature>(b);
            all.push_back({first, second, "line",
                           std::string(feature_name(first)) + ", " + feature_name(second), line});
        }
    for (std::size_t a = 0; a < feature_count; ++a) {
        const auto one = static_cast<Feature>(a);
        all.push_back({one, one, "threshold", feature_name(one), threshold});
    }
    all.push_back(
        {Feature::offset, Feature::count, "table", "offset for each count", table_of_counts});
    all.push_back({Feature::offset, Feature::count, "table", "offset for each count, falling",
                   falling_table_of_counts});
    return all;
}

/// The states with what a candidate needs of them.
struct View {
    const std::vector<FluidState<float>>& states;
    const Particles& particles;
    double label_threshold;

    [[nodiscard]] bool is_surface(std::size_t state, std::size_t i) const {
        return states[state].uncovered_fraction[i] > label_threshold;
    }

    /// Without a counted neighbor: surface, whatever the rule.
    [[nodiscard]] bool is_alone(std::size_t state, std::size_t i) const {
        return feature(state, Feature::count)[i] == 0;
    }

    [[nodiscard]] PlanePoint point(const Candidate& candidate, std::size_t state,
                                   std::size_t i) const {
        return {static_cast<double>(feature(state, candidate.a)[i]),
                static_cast<double>(feature(state, candidate.b)[i])};
    }

    /// All particles but those of a scene; a scene that there is not leaves none out.
    [[nodiscard]] LabelledPoints points_without(const Candidate& candidate,
                                                std::size_t scene) const {
        LabelledPoints points;
        for (std::size_t s = 0; s < states.size(); ++s)
            if (particles.scene_of[s] != scene)
                for (std::size_t i = 0; i < states[s].size(); ++i)
                    if (!is_alone(s, i))
                        points.add(point(candidate, s, i), is_surface(s, i),
                                   particles.weight[particles.scene_of[s]]);
        return points;
    }

private:
    [[nodiscard]] const std::vector<float>& feature(std::size_t state, Feature feature) const {
        return particles.features[state][static_cast<std::size_t>(feature)];
    }
};

struct SceneCounts {
    double particles = 0;
    double surface = 0;
    double false_negatives = 0;
    double false_positives = 0;
};

SceneCounts judge(const View& view, const Candidate& candidate, const Rule& rule,
                  std::size_t scene) {
    SceneCounts counts;
    for (std::size_t s = 0; s < view.states.size(); ++s) {
        if (view.particles.scene_of[s] != scene)
            continue;
        counts.particles += static_cast<double>(view.states[s].size());
        for (std::size_t i = 0; i < view.states[s].size(); ++i) {
            const bool says = view.is_alone(s, i) || rule(view.point(candidate, s, i));
            const bool is = view.is_surface(s, i);
            counts.surface += is ? 1 : 0;
            counts.false_negatives += is && !says ? 1 : 0;
            counts.false_positives += !is && says ? 1 : 0;
        }
    }
    return counts;
}

/// Rates are in percent, means over scenes.
struct Errors {
    double false_positive_rate = 0;
    double left_out_false_negatives = 0;
    double left_out_miss_rate = 0;
    double left_out_false_positive_rate = 0;
};

Errors errors_of(const View& view, const Candidate& candidate) {
    Errors errors;
    const std::size_t scenes = view.particles.scenes.size();
    const double share = 100 / static_cast<double>(scenes);
    const Rule rule = candidate.train(view.points_without(candidate, scenes));
    for (std::size_t scene = 0; scene < scenes; ++scene) {
        const SceneCounts counts = judge(view, candidate, rule, scene);
        errors.false_positive_rate += share * counts.false_positives / counts.particles;
        if (scenes == 1)
            continue;
        const Rule other = candidate.train(view.points_without(candidate, scene));
        const SceneCounts left_out = judge(view, candidate, other, scene);
        errors.left_out_false_negatives += left_out.false_negatives;
        errors.left_out_miss_rate +=
            share * left_out.false_negatives / std::max(1.0, left_out.surface);
        errors.left_out_false_positive_rate +=
            share * left_out.false_positives / left_out.particles;
    }
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
        timed.push_back({[&states, &features, a = candidate.a, b = candidate.b] {
            for (std::size_t s = 0; s < states.size(); ++s)
                find_features(states[s], a, b, features[s]);
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
    const Particles particles = particles_of(states);
    const View view{states, particles, options.label_threshold};
    const auto all = candidates();
    std::vector<Errors> errors(all.size());
    // Candidates take seconds each, a chunk of a loop over particles would hold all of them.
    std::exception_ptr thrown;
#pragma omp parallel for schedule(dynamic) num_threads(options.threads)
    for (std::size_t c = 0; c < all.size(); ++c)
        try {
            errors[c] = errors_of(view, all[c]);
        } catch (...) {
#pragma omp critical(meniscus_thrown)
            thrown = std::current_exception();
        }
    if (thrown)
        std::rethrow_exception(thrown);
    const auto times = times_of(states, all, options.timing);
    Table table = empty_table(states.front().dimension);
    const bool has_left_out = particles.scenes.size() > 1;
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
