// How the pressure solvers do on whole runs: dam break and double droplet with each solver and our
// surface tension, the front of the 2D dam break beside Martin and Moyce 1952, and pressure
// iterations with surface tension on all particles and on those at the surface alone.
#include "solvers.hpp"
#include "support/tables.hpp"
#include "watched_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace meniscus {
namespace {

/// The scene with another solver: WCSPH with a sound ten times as fast as the fluid may become.
Scene with_solver(Scene scene, std::string_view kind, double max_speed) {
    scene.pressure.solver = kind;
    if (kind == "wcsph") {
        scene.pressure.sound_speed = 10 * max_speed;
        scene.time_step.fixed.reset();
        scene.time_step.max = 1e-3;
    }
    return scene;
}

std::vector<Cell> row_of(const char* scene, const char* solver, const RunSummary& run,
                         double energy) {
    if (!run.failure.empty())
        return {scene, solver, run.failure};
    return {scene,
            solver,
            run.steps,
            run.time_step * 1000,
            run.divergence_iterations,
            run.pressure_iterations,
            run.mean_density_error * 100,
            run.max_density_error * 100,
            run.unconverged,
            run.energy_rise / energy * 100,
            run.max_momentum};
}

Tables runs(const TableInput& input) {
    Table table = table_of(
        "solver-runs",
        "scene | solver | steps | mean step, ms {:.2f} | divergence iterations {:.1f} | pressure "
        "iterations {:.1f} | mean density error, % {:.3f} | largest, % {:.3f} | unconverged steps "
        "| largest rise of energy, % {:.2f} | largest net momentum {:.0e}");
    const Scene dam = read_scene(input.scenes / "dam_break.json", "");
    Scene droplet = read_scene(input.scenes / "double_droplet.json", "");
    droplet.precision = Precision::float64;
    for (const NamedSolver& solver : all_solvers) {
        const RunSummary run = watch_run(with_solver(dam, solver.kind, 6));
        table.add(row_of("dam break", solver.name, run, run.max_kinetic));
    }
    for (const NamedSolver& solver : all_solvers) {
        const RunSummary run = watch_run(with_solver(droplet, solver.kind, 2));
        table.add(row_of("double droplet", solver.name, run, run.first_energy));
    }
    return {table};
}

using Front = std::vector<std::pair<double, double>>;

// Columns twice as high as wide (a): T = t sqrt(2 g / a), Z = x / a, as read off for PySPH's
// examples from the papers' figures.
/// Water, a = 2.25 inches (Martin and Moyce 1952, figure 3).
const Front& measured_front() {
    static const Front front = {
        {0.832, 1.217}, {1.219, 1.474}, {1.997, 2.292}, {2.547, 2.995}, {3.345, 4.134}};
    return front;
}

/// Calculated by another particle method, MPS (Koshizuka and Oka 1996).
const Front& front_by_mps() {
    static const Front front = {{0.778, 1.351}, {0.958, 1.512}, {1.095, 1.637},
                                {1.226, 1.771}, {1.858, 2.480}, {2.043, 2.707},
                                {2.451, 3.251}, {2.604, 3.481}, {2.943, 3.997}};
    return front;
}

/// Between the two nearest times; NaN beyond the last.
double front_at(const Front& front, double time) {
    for (std::size_t n = 1; n < front.size(); ++n)
        if (time <= front[n].first) {
            const auto& [t0, z0] = front[n - 1];
            const auto& [t1, z1] = front[n];
            return z0 + (z1 - z0) * (time - t0) / (t1 - t0);
        }
    return std::nan("");
}

/// The farthest particle of the 2D dam break at the measured times.
std::vector<double> simulated_front(Scene scene) {
    const double to_seconds = 1 / std::sqrt(2 * 9.81); // a = 1 m
    scene.duration = measured_front().back().first * to_seconds + 1e-3;
    std::vector<double> front;
    watch_run(scene, [&](const Simulation& simulation, const StepReport&) {
        if (front.size() == measured_front().size() ||
            simulation.time() < measured_front()[front.size()].first * to_seconds)
            return;
        double farthest = 0;
        for (const Place& place : simulation.state().positions)
            farthest = std::max(farthest, place[0]);
        front.push_back(farthest + scene.particle_spacing / 2);
    });
    return front;
}

Tables dam_front(const TableInput& input) {
    const Scene coarse = read_scene(input.scenes / "dam_break_2d.json", "");
    const Scene fine = read_scene(input.scenes / "dam_break_2d.json", "paper");
    std::string columns = "T {} | measured Z {} | MPS {:.3f} | off, % {:+.1f}";
    for (const Scene* scene : {&coarse, &fine})
        columns += fmt::format(" | {} particles {{:.3f}} | off, % {{:+.1f}}",
                               fill_scene(*scene).positions.size());
    Table table = table_of("dam-front", columns);
    const std::array<std::vector<double>, 2> fronts = {simulated_front(coarse),
                                                       simulated_front(fine)};
    for (std::size_t row = 0; row + 1 < measured_front().size(); ++row) { // then comes the wall
        const auto& [time, measured] = measured_front()[row];
        table.add({time, measured});
        for (const double front :
             {front_at(front_by_mps(), time), fronts[0].at(row), fronts[1].at(row)}) {
            table.rows.back().emplace_back(front);
            table.rows.back().emplace_back(100 * (front / measured - 1));
        }
    }
    return {table};
}

struct NamedModel {
    const char* name;
    std::string_view kind;
    double coefficient;
};

Tables iterations(const TableInput& input) {
    Table table =
        table_of("iterations",
                 "scene | solver | surface tension | pressure iterations {:.1f} | divergence "
                 "iterations {:.1f} | on the surface alone: pressure {:.1f} | divergence {:.1f}");
    constexpr NamedModel models[] = {{"Becker 2007", "becker_2007", 1},
                                     {"Huber 2015", "huber_2015", 1},
                                     {"Akinci 2013", "akinci_2013", 1},
                                     {"He 2014", "he_2014", 1},
                                     {"ours", "meniscus", 0}};
    for (const char* name : {"dam_break", "double_droplet"})
        for (const NamedSolver& solver : {all_solvers[1], all_solvers[2], all_solvers[3]})
            for (const NamedModel& model : models) {
                const auto file = input.scenes / (std::string(name) + ".json");
                Scene scene = with_solver(read_scene(file, ""), solver.kind, 6);
                const bool is_ours = model.kind == "meniscus";
                scene.duration = 1;
                scene.surface_tension.model = model.kind;
                if (!is_ours)
                    scene.surface_tension.coefficient = model.coefficient;
                const RunSummary all = watch_run(scene);
                std::vector<Cell> row = {name,
                                         solver.name,
                                         model.name,
                                         all.pressure_iterations,
                                         all.divergence_iterations,
                                         "",
                                         ""};
                scene.surface_tension.restrict_to_surface = true;
                if (!is_ours) {
                    const RunSummary surface = watch_run(scene);
                    row[5] = surface.pressure_iterations;
                    row[6] = surface.divergence_iterations;
                }
                table.add(row);
            }
    return {table};
}

} // namespace

TableGroup solver_tables() {
    return {"Simulation",
            {{"solver-runs", "", 0, "whole runs with each pressure solver", runs},
             {"dam-front", "", 0, "the front of a dam break, measured and simulated", dam_front},
             {"iterations", "", 0, "with surface tension on all and on the surface alone",
              iterations}}};
}

} // namespace meniscus
