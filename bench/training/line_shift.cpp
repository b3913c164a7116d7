#include "line_shift.hpp"

#include "support/known_state.hpp"
#include "support/loops.hpp"

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/classifier/training_set/error_counts.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <memory>
#include <set>

namespace meniscus {
namespace {

using Tension = SurfaceTension<float, 3>;

/// How a solver's particles stand, beside relaxed ones.
constexpr double paraboloid_jitter = 0.2;

struct ShiftedState {
    FluidState<float> state;
    std::vector<std::uint8_t> counted; ///< 0 where a cut of the cloud is near
};

struct Slope {
    std::string name;
    SurfaceLine<double> line; ///< with the d that it came with
};

ShiftedState paraboloid_state(double width) {
    constexpr double curvature = 0.25; // of both kinds, at its middle
    auto known =
        known_state<float>("hyperbolic paraboloid", paraboloid(curvature / 2, curvature / 2, width),
                           known_cloud(paraboloid_jitter));
    return {std::move(known.state), std::move(known.cloud.trusted)};
}

ShiftedState droplet_state(const std::filesystem::path& file) {
    auto state = read_fluid_state_in_3d<float>(file);
    state.name = "double droplet";
    const std::size_t size = state.size();
    return {std::move(state), std::vector<std::uint8_t>(size, 1)};
}

std::vector<Slope> slopes(const std::filesystem::path& published_model,
                          const FluidState<float>& state) {
    const Model model = read_model(published_model);
    check_features_of_paper(model, "a shifted line");
    if (model.dimension != 3)
        throw InputError(published_model.string() + ": is in 2D; the published line is in 3D");
    return {{"published slope", {model.line.k, model.line.d}},
            {"own slope", shipped_first_line(3, double{state.support_radius} / state.spacing)}};
}

/// Candidates, false negatives, wide ones, false positives and missed area in percent.
std::vector<Cell> errors_of(const ShiftedState& shifted, const SurfaceLine<float>& line) {
    const FluidState<float>& state = shifted.state;
    SurfaceParticles<float, 3> list;
    find_candidates<float, 3>(state.view<3>(), state.size(),
                              UniformRadius<float>{state.support_radius}, line, 0.8, SerialLoop{},
                              list);
    ErrorCounts counts;
    for (std::size_t i = 0; i < state.size(); ++i)
        if (shifted.counted[i] != 0)
            counts.add(state.uncovered_fraction[i], 0, list.slot_of[i] >= 0);
    const std::size_t candidates =
        counts.surface_particles - counts.false_negatives + counts.false_positives;
    return {static_cast<double>(candidates), static_cast<double>(counts.false_negatives),
            static_cast<double>(counts.bands.back().missed),
            static_cast<double>(counts.false_positives), 100 * missed_area_fraction(counts)};
}

/// Classification, and the whole step after another line.
Timed timed_classification(const FluidState<float>& state, const SurfaceLine<float>& line,
                           int threads) {
    const auto list = std::make_shared<SurfaceParticles<float, 3>>();
    return {[&state, line, threads, list] {
        with_loop(threads, [&](const auto& loop) {
            find_candidates<float, 3>(state.view<3>(), state.size(),
                                      UniformRadius<float>{state.support_radius}, line, 0.8, loop,
                                      *list);
        });
    }};
}

Timed timed_step(const FluidState<float>& state, const SurfaceLine<double>& line, int threads) {
    SurfaceTensionOptions options;
    set_line(options, line);
    const auto tension = std::make_shared<Tension>(options);
    return {[&state, threads, tension] {
        with_loop(threads, [&](const auto& loop) {
            tension->step(state.view<3>(), state.size(), UniformRadius<float>{state.support_radius},
                          loop);
        });
    }};
}

void add_rows(const ShiftedState& shifted, const Slope& slope, const LineShiftOptions& options,
              Table& table) {
    const FluidState<float>& state = shifted.state;
    std::vector<std::vector<Cell>> rows;
    std::vector<Timed> timed;
    std::set<double> constants(options.d.begin(), options.d.end());
    constants.insert(slope.line.d);
    for (const double d : constants) {
        const double k = slope.line.k;
        const SurfaceLine<float> line{static_cast<float>(k), static_cast<float>(d)};
        rows.push_back({state.name, slope.name, k, d});
        for (const Cell& error : errors_of(shifted, line))
            rows.back().push_back(error);
        for (const int threads : {1, options.threads}) {
            timed.push_back(timed_classification(state, line, threads));
            timed.push_back(timed_step(state, {k, d}, threads));
        }
    }
    const auto times = measure(timed, options.timing);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (std::size_t k = 0; k < 4; ++k)
            rows[row].emplace_back(per_particle(times[4 * row + k], 1e-9, state.size()));
        table.rows.push_back(rows[row]);
    }
}

} // namespace

Table line_shift(const LineShiftOptions& options) {
    const std::string on_threads = " on " + std::to_string(options.threads) + " threads";
    Table table{"line_shift",
                "The line's constant d",
                {{"state", "state"},
                 {"line", "line"},
                 {"k", "k"},
                 {"d", "d"},
                 {"candidates", "candidates", 6},
                 {"false_negatives", "false negatives", 6},
                 {"false_negatives_plain", "more than 2 % uncovered", 6},
                 {"false_positives", "false positives", 6},
                 {"missed_area", "missed area, %"},
                 {"time_classify", "classification, ns a particle"},
                 {"time", "step, ns a particle"},
                 {"time_classify_parallel", "classification" + on_threads},
                 {"time_parallel", "step" + on_threads}},
                {}};
    for (const ShiftedState& shifted :
         {paraboloid_state(options.paraboloid_width), droplet_state(options.double_droplet)})
        for (const Slope& slope : slopes(options.published_model, shifted.state))
            add_rows(shifted, slope, options, table);
    return table;
}

} // namespace meniscus
