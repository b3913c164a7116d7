// The pressure in a drop at rest, read from the particles' pressures, beside Young and Laplace's
// (D - 1) sigma / R.
#include "framework/drops_at_rest.hpp"
#include "framework/measures.hpp"
#include "framework/run_tables.hpp"
#include "studies.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

Json measure(const StudyRun& run, const Workplace& place) {
    const SceneRun done = run_to_end(scene_of(run), place);
    const Scene& scene = done.scene;
    const auto particles = static_cast<std::size_t>(done.log.at("particles").front());
    Json figures = {{"particles", particles}, {"spacing", scene.particle_spacing}};
    if (!done.failure.empty()) {
        figures["failure"] = done.failure;
        return figures;
    }
    const double radius = volume_radius(scene, particles);
    const double exact = (scene.dimension - 1) * scene.surface_tension.coefficient / radius;
    std::vector<double> means;
    std::vector<double> scatters;
    for (std::size_t frame = 0; frame < done.frames.size(); ++frame) {
        if (done.log.at("time")[frame] < last_fifth(scene))
            continue;
        const Snapshot snapshot = read_vtkhdf(done.frames[frame]);
        const auto pressure =
            inside(snapshot.positions, scalar_values(snapshot, "pressure"), radius / 2);
        means.push_back(pressure.mean);
        scatters.push_back(pressure.deviation / pressure.mean);
    }
    const auto pressure = mean_and_deviation(means);
    const auto speeds = mean_and_deviation(values_from(done.log, "mean_speed", last_fifth(scene)));
    figures["pressure over Young-Laplace"] = pressure.mean / exact;
    figures["change over time, %"] = 100 * pressure.deviation / pressure.mean;
    figures["scatter in the drop, %"] = 100 * mean_and_deviation(scatters).mean;
    figures["mean speed of the capillary one, %"] =
        100 * speeds.mean / capillary_speed(scene, radius);
    return figures;
}

/// One row for each drop and solver: the slope of the error over the spacing.
Table table_of_orders(const Json& result) {
    Table table = table_of("pressure_jump_order",
                           "drop | solver | resolutions | largest error, % {:.2f} | error at the "
                           "finest, % {:.2f} | order of convergence {:.2f}");
    std::vector<std::pair<std::string, std::string>> kinds;
    for (const Json& run : result.at("runs")) {
        const std::pair kind{label_of(run, "drop"), label_of(run, "solver")};
        if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
            kinds.push_back(kind);
    }
    for (const auto& [drop, solver] : kinds) {
        std::vector<double> spacings;
        std::vector<double> errors;
        for (const Json& run : result.at("runs")) {
            const auto ratio = figure_of(run, "pressure over Young-Laplace");
            if (label_of(run, "drop") != drop || label_of(run, "solver") != solver || !ratio)
                continue;
            spacings.push_back(*figure_of(run, "spacing"));
            errors.push_back(std::abs(*ratio - 1));
        }
        if (errors.size() < 2)
            continue;
        table.add({drop, solver, errors.size(),
                   100 * *std::max_element(errors.begin(), errors.end()), 100 * errors.back(),
                   convergence_order(spacings, errors)});
    }
    return table;
}

std::vector<Table> tables(const Json& result, const Json& /*reference*/) {
    Table runs = table_of_runs("pressure_jump", result, "drop | solver | resolution",
                               "particles {:.0f} | pressure over Young-Laplace {:.4f} | change "
                               "over time, % {:.2f} | scatter in the drop, % {:.2f} | mean speed "
                               "of the capillary one, % {:.2f}");
    return {runs, table_of_orders(result)};
}

} // namespace

Study pressure_jump_study() {
    return {"pressure_jump", "pressure in a drop at rest beside Young and Laplace's", measure,
            tables};
}

} // namespace meniscus
