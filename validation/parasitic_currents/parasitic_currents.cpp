// Speeds that stay in a drop at rest, over the Laplace number La = 2 sigma R rho / mu^2: surface
// tension and pressure that do not balance exactly drive them.
#include "framework/drops_at_rest.hpp"
#include "framework/measures.hpp"
#include "framework/run_tables.hpp"
#include "studies.hpp"

#include <cmath>

namespace meniscus {
namespace {

constexpr double radius = 0.5; // m, of the scenes

/// The scene with the viscosity of the run's Laplace number.
Scene scene_at(const StudyRun& run) {
    Scene scene = scene_of(run);
    scene.viscosity.kinematic = std::sqrt(2 * scene.surface_tension.coefficient * radius /
                                          (scene.rest_density * run.numbers.at("laplace_number")));
    return scene;
}

Json measure(const StudyRun& run, const Workplace& place) {
    const SceneRun done = run_to_end(scene_at(run), place);
    const Scene& scene = done.scene;
    Json figures = {{"particles", done.log.at("particles").front()}};
    if (!done.failure.empty()) {
        figures["failure"] = done.failure;
        return figures;
    }
    const double sigma = scene.surface_tension.coefficient;
    const double viscosity = scene.rest_density * scene.viscosity.kinematic;
    const double from = last_fifth(scene);
    const double max = mean_and_deviation(values_from(done.log, "max_speed", from)).mean;
    const double mean = mean_and_deviation(values_from(done.log, "mean_speed", from)).mean;
    figures["largest speed, mu u / sigma"] = viscosity * max / sigma;
    figures["mean speed, mu u / sigma"] = viscosity * mean / sigma;
    figures["largest speed of the capillary one, %"] = 100 * max / capillary_speed(scene, radius);
    figures["mean speed of the capillary one, %"] = 100 * mean / capillary_speed(scene, radius);
    return figures;
}

std::vector<Table> tables(const Json& result, const Json& reference) {
    Table runs = table_of_runs("parasitic_currents", result, "drop | model | Laplace number",
                               "largest speed, mu u / sigma {:.5f} | mean speed, mu u / sigma "
                               "{:.5f} | largest speed of the capillary one, % {:.2f} | mean speed "
                               "of the capillary one, % {:.2f}");
    runs.columns.push_back({"below", "largest below the published one"});
    const double usual = published(reference, "largest speed, mu u / sigma");
    for (std::size_t n = 0; n < runs.rows.size(); ++n) {
        const auto speed = figure_of(result.at("runs")[n], "largest speed, mu u / sigma");
        runs.rows[n].emplace_back(speed ? (*speed < usual ? "yes" : "**no**") : "");
    }
    return {runs, table_of_sources(reference)};
}

} // namespace

Study parasitic_currents_study() {
    return {"parasitic_currents", "speeds that stay in a drop at rest, over the Laplace number",
            measure, tables};
}

} // namespace meniscus
