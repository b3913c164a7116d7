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
               "{:.0e} |\n",
               scene, solver, run.steps, run.time_step * 1000, run.divergence_iterations,
               run.pressure_iterations, run.mean_density_error * 100,
               run.largest_density_error * 100, run.unconverged, run.energy_rise / energy * 100,
               run.largest_momentum);
}

void print_runs(const Folder& scenes) {
    fmt::print("| scene | solver | steps | mean step, ms | divergence iterations | pressure "
               "iterations | mean density error, % | largest, % | unconverged steps | largest rise "
               "of energy, % | largest net momentum |\n"
               "|---|---|---|---|---|---|---|---|---|---|---|\n");
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
    run_scene(scene, [&](const Simulation& simulation, const StepReport&) {
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

void print_dam_front(const Folder& scenes) {
    const Scene coarse = read_scene(scenes / "dam_break_2d.json", "");
    const Scene fine = read_scene(scenes / "dam_break_2d.json", "paper");
    fmt::print("| T | measured Z | MPS | off, % | {} particles | off, % | {} particles | off, % "
               "|\n|---|---|---|---|---|---|---|---|\n",
               fill_scene(coarse).positions.size(), fill_scene(fine).positions.size());
    const std::array<std::vector<double>, 2> fronts = {simulated_front(coarse),
                                                       simulated_front(fine)};
    for (std::size_t row = 0; row + 1 < measured_front().size(); ++row) { // then comes the wall
        const auto& [time, measured] = measured_front()[row];
        const double mps = front_at(front_by_mps(), time);
        fmt::print("| {} | {} | {:.3f} | {:+.1f}", time, measured, mps, 100 * (mps / measured - 1));
        for (const auto& front : fronts)
            fmt::print(" | {:.3f} | {:+.1f}", front.at(row), 100 * (front.at(row) / measured - 1));
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
