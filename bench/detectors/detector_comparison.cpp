#include "detector_comparison.hpp"

#include <meniscus/classifier/training_set/error_counts.hpp>

#include <deque>
#include <map>

namespace meniscus {
namespace {

struct Errors {
    ErrorCounts all;
    double false_positive_rate = 0; ///< percent, mean over scenes
};

/// A detector on all states, made ready.
struct Run {
    const std::vector<FluidState<float>>* states;
    std::vector<Detection> detections;
    std::vector<std::vector<std::uint8_t>> surface; ///< of each state

    Run(const Detector<float>& detector, const std::vector<FluidState<float>>& on, int threads)
        : states(&on), surface(on.size()) {
        for (const auto& state : on)
            detections.push_back(detector.prepare(state, threads));
    }

    void operator()() {
        for (std::size_t s = 0; s < detections.size(); ++s)
            detections[s](surface[s]);
    }

    [[nodiscard]] Errors errors() const {
        Errors errors;
        std::map<std::string, ErrorCounts> of_scene;
        for (std::size_t s = 0; s < states->size(); ++s) {
            const auto& state = (*states)[s];
            for (std::size_t i = 0; i < state.size(); ++i)
                of_scene[state.scene].add(state.uncovered_fraction[i], 0, surface[s][i] != 0);
        }
        for (const auto& [scene, counts] : of_scene) {
            errors.all.add(counts);
            errors.false_positive_rate +=
                100 * false_positive_rate(counts) / static_cast<double>(of_scene.size());
        }
        return errors;
    }
};

/// A detector's places among what is timed, and its errors.
struct Row {
    std::size_t serial;
    std::optional<std::size_t> parallel;
    Errors errors;
};

Table empty_table(int dimension, int threads) {
    const std::string name = std::to_string(dimension) + "d";
    const std::string parallel =
        threads > 1 ? std::to_string(threads) + " threads" : "more threads: not measured";
    return {"detectors_" + name,
            "Surface detectors in " + std::to_string(dimension) + "D",
            {{"detector", "detector"},
             {"group", "group"},
             {"false_negatives", "false negatives", 9},
             {"false_negatives_plain", "of them over 2 % uncovered", 9},
             {"missed_area", "missed area, %", 2},
             {"false_positive_rate", "false positives, %"},
             {"time", "ns a particle, 1 thread"},
             {"time_parallel", "ns a particle, " + parallel},
             {"source", "source"}},
            {}};
}

} // namespace

Table compare_detectors(const std::vector<FluidState<float>>& states,
                        const std::vector<Detector<float>>& all, int threads,
                        const TimingOptions& timing) {
    std::size_t particles = 0;
    for (const auto& state : states)
        particles += state.size();
    std::deque<Run> runs; // which do not move
    std::vector<Timed> timed;
    const auto add = [&](const Detector<float>& detector, int number) {
        Run& run = runs.emplace_back(detector, states, number);
        timed.push_back({[&run] { run(); }, detector.is_slow});
        return timed.size() - 1;
    };
    std::vector<Row> rows;
    for (const auto& detector : all) {
        Row row{add(detector, 1), std::nullopt, {}};
        runs.back()();
        row.errors = runs.back().errors();
        if (threads > 1 && detector.is_parallel)
            row.parallel = add(detector, threads);
        rows.push_back(row);
    }
    const auto times = measure(timed, timing);
    Table table = empty_table(states[0].dimension, threads);
    for (std::size_t d = 0; d < all.size(); ++d) {
        const auto& [serial, parallel, errors] = rows[d];
        Cell parallel_time;
        if (parallel)
            parallel_time = per_particle(times[*parallel], 1e-9, particles);
        table.rows.push_back(
            {all[d].name, all[d].group, static_cast<double>(errors.all.false_negatives),
             static_cast<double>(errors.all.bands.back().missed),
             100 * missed_area_fraction(errors.all), errors.false_positive_rate,
             per_particle(times[serial], 1e-9, particles), parallel_time, all[d].source});
    }
    mark_best(table, {"time", "false_negatives", "false_positive_rate"});
    return table;
}

} // namespace meniscus
