// Time of whole steps, in Markdown.
//   stages   dam break and double droplet of SPlisHSPlasH's size, stage by stage
//   scaling  a dam break of 10^5 to 4 10^6 particles with two iterations of each solve
// Usage: step_speed TABLE SCENES    SCENES: the folder configs/scenes
#include "simulation_runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <omp.h>
#include <stdexcept>
#include <string>
#include <vector>

namespace meniscus {
namespace {

using Folder = std::filesystem::path;

/// The run of median time out of several.
RunSummary median_run(const Scene& scene, int threads, int repetitions) {
    std::vector<RunSummary> runs;
    for (int r = 0; r < repetitions; ++r)
        runs.push_back(run_scene(scene, {}, threads));
    const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
    std::nth_element(runs.begin(), middle, runs.end(), [](const auto& a, const auto& b) {
        return total_seconds(a.seconds) < total_seconds(b.seconds);
    });
    return *middle;
}

std::vector<int> thread_counts() {
    return omp_get_max_threads() > 1 ? std::vector<int>{1, omp_get_max_threads()}
                                     : std::vector<int>{1};
}

void print_stages(const Folder& scenes) {
    fmt::print("| scene | particles | threads | steps | iterations | sort | neighbors | density | "
               "divergence | surface tension | viscosity | pressure | motion | ms a step | ns a "
               "particle |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    struct Case {
        const char* file;
        double duration; ///< s
    };
    for (const auto& [file, duration] :
         {Case{"dam_break.json", 0.4}, Case{"double_droplet.json", 0.6}})
        for (const int threads : thread_counts()) {
            Scene scene = read_scene(scenes / file, "splishsplash");
            scene.duration = duration;
            const RunSummary run = median_run(scene, threads, 5);
            const StageTimes& s = run.seconds;
            fmt::print("| {} | {} | {} | {} | {:.1f} + {:.1f}", scene.name, run.particles, threads,
                       run.steps, run.divergence_iterations, run.pressure_iterations);
            for (const double stage : {s.sort, s.neighbors, s.density, s.divergence,
                                       s.surface_tension, s.viscosity, s.pressure, s.motion})
                fmt::print(" | {:.2f}", stage * 1000);
            fmt::print(" | {:.1f} | {:.0f} |\n", total_seconds(s) * 1000,
                       total_seconds(s) * 1e9 / static_cast<double>(run.particles));
        }
}

/// The dam break with its lattice and walls refined to about so many particles.
Scene dam_of(const Folder& scenes, double particles) {
    Scene scene = read_scene(scenes / "dam_break.json", "splishsplash");
    auto& lattice = std::get<LatticeShape>(scene.fluid.at(0).shape);
    const double before =
        static_cast<double>(lattice.count[0]) * lattice.count[1] * lattice.count[2];
    const double finer = std::cbrt(particles / before);
    scene.particle_spacing /= finer;
    scene.support_radius /= finer;
    for (int& count : lattice.count)
        count = static_cast<int>(std::lround(count * finer));
    scene.pressure.least_iterations = scene.pressure.most_iterations = 2;
    return scene;
}

/// Ten steps after five to warm up, from the first state on.
RunSummary timed_steps(const Scene& scene, int threads) {
    constexpr int warm_up = 5;
    constexpr int timed = 10;
    const SceneParticles particles = fill_scene(scene);
    const auto simulation = simulate(scene, particles, threads);
    for (int step = 0; step < warm_up; ++step)
        simulation->step(scene.duration);
    std::vector<StepReport> reports;
    for (int step = 0; step < timed; ++step)
        reports.push_back(simulation->step(scene.duration));
    std::nth_element(reports.begin(), reports.begin() + timed / 2, reports.end(),
                     [](const StepReport& a, const StepReport& b) {
                         return total_seconds(a.seconds) < total_seconds(b.seconds);
                     });
    RunSummary run;
    run.particles = particles.positions.size();
    run.seconds = reports[timed / 2].seconds;
    run.surface_particles = static_cast<double>(reports[timed / 2].surface_particles);
    return run;
}

void print_scaling(const Folder& scenes) {
    fmt::print("| particles | surface, % | neighbors | density | divergence | surface tension | "
               "pressure | rest | ns a particle and step | over the first |\n"
               "|---|---|---|---|---|---|---|---|---|---|\n");
    double first = 0;
    for (const double wanted : {1e5, 3e5, 1e6, 2e6, 4e6}) {
        const RunSummary run = timed_steps(dam_of(scenes, wanted), omp_get_max_threads());
        const auto particles = static_cast<double>(run.particles);
        const StageTimes& s = run.seconds;
        const double all = total_seconds(s) * 1e9 / particles;
        first = first > 0 ? first : all;
        fmt::print("| {} | {:.1f}", run.particles, 100 * run.surface_particles / particles);
        for (const double stage : {s.neighbors, s.density, s.divergence, s.surface_tension,
                                   s.pressure, s.sort + s.viscosity + s.motion})
            fmt::print(" | {:.0f}", stage * 1e9 / particles);
        fmt::print(" | {:.0f} | {:.2f} |\n", all, all / first);
    }
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        const std::string table = argument_count == 3 ? arguments[1] : "";
        if (table == "stages")
            meniscus::print_stages(arguments[2]);
        else if (table == "scaling")
            meniscus::print_scaling(arguments[2]);
        else
            throw std::runtime_error("usage: step_speed stages|scaling SCENES");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "step_speed: %s\n", error.what());
        return 2;
    }
    return 0;
}
