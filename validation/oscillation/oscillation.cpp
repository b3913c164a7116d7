// Drops that swing in a mode, beside Lamb's period and damping: omega^2 = n (n - 1) (n + 2) sigma /
// (rho R^3), in 2D n (n^2 - 1) sigma / (rho R^3); a little viscosity takes exp(-(n - 1) (2 n + 1)
// nu t / R^2), in 2D exp(-2 n (n - 1) nu t / R^2).
#include "framework/drops_at_rest.hpp"
#include "framework/measures.hpp"
#include "framework/run_tables.hpp"
#include "framework/spread.hpp"
#include "studies.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/runtime/math/angles.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace meniscus {
namespace {

double lamb_period(const Scene& scene, int mode, double radius) {
    const int stiffness =
        scene.dimension == 3 ? mode * (mode - 1) * (mode + 2) : mode * (mode * mode - 1);
    return 2 * pi *
           std::sqrt(scene.rest_density * std::pow(radius, 3) /
                     (stiffness * scene.surface_tension.coefficient));
}

double lamb_damping(const Scene& scene, int mode, double radius) {
    const int factor = scene.dimension == 3 ? (mode - 1) * (2 * mode + 1) : 2 * mode * (mode - 1);
    return factor * scene.viscosity.kinematic / (radius * radius);
}

/// The scene's ball stretched in the mode, as a snapshot in the place's folder; three periods.
Scene swinging(Scene scene, int mode, double amplitude, const Workplace& place) {
    const SceneParticles ball = fill_scene(scene);
    const double radius = volume_radius(scene, ball.positions.size());
    Snapshot first;
    first.dimension = scene.dimension;
    first.positions = in_mode(ball.positions, mode, amplitude, radius, scene.dimension);
    first.support_radius = scene.support_radius;
    first.particle_spacing = scene.particle_spacing;
    SnapshotShape shape;
    shape.file = place.folder / "first.vtkhdf";
    write_vtkhdf(first, shape.file);
    scene.fluid = {{shape, {}}};
    const double period = lamb_period(scene, mode, radius);
    scene.duration = 3 * period;
    scene.frame_interval = period / 24;
    return scene;
}

Json measure(const StudyRun& run, const Workplace& place) {
    const int mode = static_cast<int>(run.numbers.at("mode"));
    const SceneRun done =
        run_to_end(swinging(scene_of(run), mode, run.numbers.at("amplitude"), place), place);
    const Scene& scene = done.scene;
    const auto particles = static_cast<std::size_t>(done.log.at("particles").front());
    const double radius = volume_radius(scene, particles);
    const double period = lamb_period(scene, mode, radius);
    Json figures = {{"particles", particles}, {"Lamb's period, s", period}};
    if (!done.failure.empty()) {
        figures["failure"] = done.failure;
        return figures;
    }
    std::vector<double> moments;
    for (const auto& frame : done.frames)
        moments.push_back(mode_moment(read_vtkhdf(frame).positions, mode, scene.dimension));
    const Swing swing = swing_of(done.log.at("time"), moments);
    if (swing.period == 0) {
        figures["failure"] = "no whole period";
        return figures;
    }
    figures["period, s"] = swing.period;
    figures["period off, %"] = 100 * (swing.period / period - 1);
    figures["left a period later"] = swing.left;
    figures["left by viscosity alone"] = std::exp(-lamb_damping(scene, mode, radius) * period);
    return figures;
}

/// A row for each drop and swing: how far the periods of its runs are off, and how many ended.
Table table_of_swings(const Json& result) {
    Table table = table_of("oscillation_swings",
                           "drop | swing | runs that came to their end | period off, % {:+.1f} | "
                           "left a period later {:.2f} | left by viscosity alone {:.2f}");
    for (const Seeds& runs : by_seeds(result, {"drop", "swing"})) {
        const auto range = [&](const char* figure) -> Cell {
            const std::vector<double> values = runs.values(figure);
            if (values.empty())
                return {};
            const auto [least, most] = std::minmax_element(values.begin(), values.end());
            return Figures{*least, *most};
        };
        table.add({runs.labels[0], runs.labels[1],
                   fmt::format("{} of {}", runs.values("period, s").size(), runs.runs.size()),
                   range("period off, %"), range("left a period later"),
                   range("left by viscosity alone")});
    }
    table.before = "Least / most of the runs of a swing.\n\n";
    return table;
}

std::vector<Table> tables(const Json& result, const Json& reference) {
    return {table_of_runs("oscillation", result, "drop | solver | steps | swing",
                          "particles {:.0f} | Lamb's period, s {:.3f} | period, s {:.3f} | period "
                          "off, % {:+.1f} | left a period later {:.2f} | left by viscosity alone "
                          "{:.2f}"),
            table_of_swings(result), table_of_sources(reference)};
}

} // namespace

Study oscillation_study() {
    return {"oscillation", "drops that swing in modes 2 to 4, beside Lamb's period and damping",
            measure, tables};
}

} // namespace meniscus
