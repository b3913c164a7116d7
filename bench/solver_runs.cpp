// How the pressure solvers do on whole runs, in Markdown.
//   runs        dam break and double droplet with each solver and our surface tension
//   dam_front   the front of the 2D dam break beside Martin and Moyce 1952
//   iterations  pressure iterations with surface tension on all particles and on those at the
//               surface alone
// Usage: solver_runs TABLE SCENES    SCENES: the folder configs/scenes
#include "simulation_runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace meniscus {
namespace {

using Folder = std::filesystem::path;

struct NamedSolver {
    const char* name;
    PressureSolverKind kind;
};

constexpr std::array<NamedSolver, 4> solvers = {{{"WCSPH", PressureSolverKind::wcsph},
                                                 {"PCISPH", PressureSolverKind::pcisph},
                                                 {"IISPH", PressureSolverKind::iisph},
                                                 {"DFSPH", PressureSolverKind::dfsph}}};

/// The scene with another solver: WCSPH with a sound ten times as fast as the fluid may become.
Scene with_solver(Scene scene, PressureSolverKind kind, double largest_speed) {
    scene.pressure.solver = kind;
    if (kind == PressureSolverKind::wcsph) {
        scene.pressure.sound_speed = 10 * largest_speed;
        scene.time_step.fixed.reset();
        scene.time_step.largest = 1e-3;
    }
    return scene;
}

void print_run(const char* scene, const char* solver, const RunSummary& run, double energy) {
    if (!run.failure.empty()) {
        fmt::print("| {} | {} | {} |\n", scene, solver, run.failure);
        return;
    }
    fmt::print("| {} | {} | {} | {:.2f} | {:.1f} | {:.1f} | {:.3f} | {:.3f} | {} | {:.2f} | "
               "{:.0e} | {:.2f} |\n",
               scene, solver, run.steps, run.time_step * 1000, run.divergence_iterations,
               run.pressure_iterations, run.mean_density_error * 100,
               run.largest_density_error * 100, run.unconverged, run.energy_rise / energy * 100,
               run.largest_momentum, total_seconds(run.seconds) * 1000);
}

void print_runs(const Folder& scenes) {
    fmt::print("| scene | solver | steps | mean step, ms | divergence iterations | pressure "
               "iterations | mean density error, % | largest, % | unconverged steps | largest rise "
               "of energy, % | largest net momentum | ms a step |\n"
               "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    const Scene dam = read_scene(scenes / "dam_break.json", "");
    Scene droplet = read_scene(scenes / "double_droplet.json", "");
    droplet.precision = Precision::float64;
    for (const NamedSolver& solver : solvers) {
        const RunSummary run = run_scene(with_solver(dam, solver.kind, 6));
        print_run("dam break", solver.name, run, run.largest_kinetic);
    }
    for (const NamedSolver& solver : solvers) {
        const RunSummary run = run_scene(with_solver(droplet, solver.kind, 2));
        print_run("double droplet", solver.name, run, run.first_energy);
    }
}

/// Front of the column of water with n^2 = 2 and a = 2.25 inches: T = t sqrt(2 g / a), Z = x / a
/// (Martin and Moyce 1952, figure 3, as read off for PySPH's examples).
constexpr std::array<std::pair<double, double>, 5> measured_front = {
    {{0.832, 1.217}, {1.219, 1.474}, {1.997, 2.292}, {2.547, 2.995}, {3.345, 4.134}}};

void print_dam_front(const Folder& scenes) {
    fmt::print("| T | measured Z | {} particles | off, % | {} particles | off, % |\n"
               "|---|---|---|---|---|---|\n",
               1250, 20000);
    std::vector<std::vector<double>> fronts;
    for (const char* variant : {"", "paper"}) {
        Scene scene = read_scene(scenes / "dam_break_2d.json", variant);
        const double to_time = std::sqrt(1 / (2 * 9.81)); // a = 1 m
        scene.duration = measured_front.back().first * to_time + 1e-3;
        std::vector<double> front;
        run_scene(scene, [&](const Simulation& simulation, const StepReport&) {
            if (front.size() == measured_front.size() ||
                simulation.time() < measured_front[front.size()].first * to_time)
                return;
            double farthest = 0;
            for (const Place& place : simulation.state().positions)
                farthest = std::max(farthest, place[0]);
            front.push_back(farthest + scene.particle_spacing / 2);
        });
        fronts.push_back(front);
    }
    for (std::size_t row = 0; row < measured_front.size(); ++row) {
        fmt::print("| {} | {}", measured_front[row].first, measured_front[row].second);
        for (const auto& front : fronts)
            fmt::print(" | {:.3f} | {:+.1f}", front.at(row),
                       100 * (front.at(row) / measured_front[row].second - 1));
        fmt::print(" |\n");
    }
}

struct NamedModel {
    const char* name;
    TensionModel kind;
    double coefficient;
};

void print_iterations(const Folder& scenes) {
    fmt::print("| scene | solver | surface tension | pressure iterations | divergence iterations | "
               "on the surface alone: pressure | divergence |\n|---|---|---|---|---|---|---|\n");
    const std::array<NamedModel, 5> models = {{{"Becker 2007", TensionModel::becker_2007, 1},
                                               {"Huber 2015", TensionModel::huber_2015, 1},
                                               {"Akinci 2013", TensionModel::akinci_2013, 1},
                                               {"He 2014", TensionModel::he_2014, 1},
                                               {"ours", TensionModel::meniscus, 0}}};
    for (const char* name : {"dam_break", "double_droplet"})
        for (const NamedSolver& solver : {solvers[1], solvers[2], solvers[3]})
            for (const NamedModel& model : models) {
                Scene scene = with_solver(read_scene(scenes / (std::string(name) + ".json"), ""),
                                          solver.kind, 6);
                scene.duration = 1;
                scene.surface_tension.model = model.kind;
                if (model.kind != TensionModel::meniscus)
                    scene.surface_tension.coefficient = model.coefficient;
                const RunSummary all = run_scene(scene);
                fmt::print("| {} | {} | {} | {:.1f} | {:.1f}", name, solver.name, model.name,
                           all.pressure_iterations, all.divergence_iterations);
                scene.surface_tension.restrict_to_surface = true;
                if (model.kind == TensionModel::meniscus) {
                    fmt::print(" | | |\n");
                    continue;
                }
                const RunSummary surface = run_scene(scene);
                fmt::print(" | {:.1f} | {:.1f} |\n", surface.pressure_iterations,
                           surface.divergence_iterations);
            }
}

void print_table(const std::string& table, const Folder& scenes) {
    if (table == "runs")
        print_runs(scenes);
    else if (table == "dam_front")
        print_dam_front(scenes);
    else if (table == "iterations")
        print_iterations(scenes);
    else
        throw std::runtime_error("no table " + table);
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        if (argument_count != 3)
            throw std::runtime_error("usage: solver_runs runs|dam_front|iterations SCENES");
        meniscus::print_table(arguments[1], arguments[2]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "solver_runs: %s\n", error.what());
        return 2;
    }
    return 0;
}
