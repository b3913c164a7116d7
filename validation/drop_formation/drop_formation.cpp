// A cube that becomes a drop, as Huber et al. (2015) test it: their models and ours, each with the
// coefficients of the paper and every solver.
#include "drop_findings.hpp"
#include "framework/measures.hpp"
#include "framework/run_tables.hpp"
#include "framework/scene_runs.hpp"
#include "simulation/watched_run.hpp"
#include "studies.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>

#include <fmt/format.h>

namespace meniscus {
namespace {

constexpr double round_limit = 3; // %, of the radius of the outermost particles

/// Standard deviation over mean of the radius of the outermost particles, %, of each frame.
std::vector<double> deviations_of(const SceneRun& done) {
    std::vector<double> deviations;
    for (const auto& frame : done.frames) {
        SimulationState state;
        state.positions = read_vtkhdf(frame).positions;
        const DropletShape shape = droplet_shape(state, done.scene.support_radius);
        deviations.push_back(100 * shape.deviation / shape.radius);
    }
    return deviations;
}

void add_forces(const SceneRun& done, Json& figures) {
    for (const auto& [column, name] :
         {std::pair{"tension_force", "tension"}, std::pair{"pressure_force", "pressure"}}) {
        // The first frame has no steps behind it.
        const auto force = mean_and_deviation(values_from(done.log, column, 1e-9));
        figures[fmt::format("{} force, N", name)] = force.mean;
        figures[fmt::format("{} force over time, deviation, N", name)] = force.deviation;
    }
}

void add_times(const SceneRun& done, Json& figures) {
    const RunResult& result = done.result;
    figures["surface tension, s"] = seconds_a_second(result, &StageTimes::surface_tension);
    figures["pressure, s"] = seconds_a_second(result, &StageTimes::pressure) +
                             seconds_a_second(result, &StageTimes::divergence);
    figures["all, s"] = seconds_a_second(result);
}

Json measure(const StudyRun& run, const Workplace& place) {
    const SceneRun done = run_to_end(scene_of(run), place);
    Json figures = {{"coefficient", run.numbers.at("coefficient")},
                    {"particles", done.log.at("particles").front()}};
    if (!done.failure.empty()) {
        figures["failure"] = done.failure;
        return figures;
    }
    place.draw(done.frames.back());
    const std::vector<double>& times = done.log.at("time");
    const std::vector<double>& speeds = done.log.at("mean_speed");
    const double end = 0.8 * done.scene.duration;
    const std::vector<double> deviations = deviations_of(done);
    figures["mean speed, m/s"] = mean_and_deviation(speeds).mean;
    figures["speed at the end, m/s"] =
        mean_and_deviation(values_from(done.log, "mean_speed", end)).mean;
    add_forces(done, figures);
    const std::size_t tail = deviations.size() - deviations.size() / 5;
    figures["off a sphere at the end, %"] =
        mean_and_deviation(
            {deviations.begin() + static_cast<std::ptrdiff_t>(tail), deviations.end()})
            .mean;
    const auto round = stays_below(times, deviations, round_limit);
    figures["round after, s"] = round ? Json(*round) : Json("not reached");
    figures["maxima of the speed"] = local_maxima(speeds, 0.05);
    figures["aspect at the end"] = done.log.at("largest_aspect").back();
    figures["pairs closer than half a spacing, %"] =
        100 *
        share_closer(read_vtkhdf(done.frames.back()).positions, done.scene.particle_spacing / 2);
    add_times(done, figures);
    figures["time"] = times;
    figures["speed"] = speeds;
    return figures;
}

/// The speeds over time with IISPH, at the largest coefficient of each model.
std::vector<Table> plots(const Json& result) {
    Table table = table_of("drop_formation_speed", "time, s | mean speed, m/s | model");
    for (const Json& run : result.at("runs")) {
        if (label_of(run, "solver") != "IISPH" || !is_largest_coefficient(result, run) ||
            !run.at("figures").contains("speed"))
            continue;
        const Json& figures = run.at("figures");
        for (std::size_t n = 0; n < figures.at("time").size(); ++n)
            table.add({figures["time"][n].get<double>(), figures["speed"][n].get<double>(),
                       label_of(run, "force")});
    }
    Plot plot{"drop_formation_speed.svg", "Mean speed of the particles, IISPH", "time, s",
              "mean speed, m/s", "model"};
    plot.logarithmic_x = plot.logarithmic_y = false;
    plot.joined = true;
    table.plots = {plot};
    return {table};
}

std::vector<Table> tables(const Json& result, const Json& reference) {
    return {table_of_models(result), table_of_ends(result), table_of_times(result, reference),
            table_of_drop_findings(result, reference)};
}

} // namespace

Study drop_formation_study() {
    return {"drop_formation", "a cube becomes a drop: Huber's models and ours with all solvers",
            measure, tables, plots};
}

} // namespace meniscus
