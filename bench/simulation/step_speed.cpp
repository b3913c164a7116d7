// Time of whole steps, as the simulation takes it of its stages: dam break and double droplet of
// SPlisHSPlasH's size, and a dam break of 10^5 to 4 10^6 particles with two iterations of each
// solve.
#include "support/tables.hpp"
#include "watched_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace meniscus {
namespace {

/// The run of median time out of several.
RunSummary median_run(const Scene& scene, int threads, int repetitions) {
    std::vector<RunSummary> runs;
    for (int r = 0; r < repetitions; ++r)
        runs.push_back(watch_run(scene, {}, threads));
    const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
    std::nth_element(runs.begin(), middle, runs.end(), [](const auto& a, const auto& b) {
        return total_seconds(a.seconds) < total_seconds(b.seconds);
    });
    return *middle;
}

Tables stages(const TableInput& input) {
    Table table = table_of(
        "stages",
        "scene | particles | threads | steps | iterations | sort {:.2f} | neighbors {:.2f} | "
        "density {:.2f} | divergence {:.2f} | surface tension {:.2f} | viscosity {:.2f} | pressure "
        "{:.2f} | motion {:.2f} | ms a step {:.1f} | ns a particle {:.0f}");
    std::vector<int> thread_counts = {1};
    if (input.threads > 1)
        thread_counts.push_back(input.threads);
    for (const auto& [file, duration] : // s
         {std::pair{"dam_break.json", 0.4}, std::pair{"double_droplet.json", 0.6}})
        for (const int threads : thread_counts) {
            Scene scene = read_scene(input.scenes / file, "splishsplash");
            scene.duration = duration;
            const RunSummary run = median_run(scene, threads, 5);
            table.add({scene.name, run.particles, threads, run.steps,
                       fmt::format("{:.1f} + {:.1f}", run.divergence_iterations,
                                   run.pressure_iterations)});
            for (const auto stage : all_stages)
                table.rows.back().emplace_back(run.seconds.*stage * 1000);
            const double seconds = total_seconds(run.seconds);
            table.rows.back().emplace_back(seconds * 1000);
            table.rows.back().emplace_back(seconds * 1e9 / static_cast<double>(run.particles));
        }
    return {table};
}

/// The dam break with its lattice and walls refined to about so many particles.
Scene dam_of(const std::filesystem::path& scenes, double particles) {
    Scene scene = read_scene(scenes / "dam_break.json", "splishsplash");
    auto& lattice = std::get<LatticeShape>(scene.fluid.at(0).shape);
    const double before =
        static_cast<double>(lattice.count[0]) * lattice.count[1] * lattice.count[2];
    const double finer = std::cbrt(particles / before);
    scene.particle_spacing /= finer;
    scene.support_radius /= finer;
    for (int& count : lattice.count)
        count = static_cast<int>(std::lround(count * finer));
    scene.pressure.min_iterations = scene.pressure.max_iterations = 2;
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

Tables scaling(const TableInput& input) {
    Table table =
        table_of("scaling", "particles | surface, % {:.1f} | neighbors {:.0f} | density {:.0f} | "
                            "divergence {:.0f} | surface tension {:.0f} | pressure {:.0f} | rest "
                            "{:.0f} | ns a particle and step {:.0f} | over the first {:.2f}");
    double first = 0;
    for (const double wanted : {1e5, 3e5, 1e6, 2e6, 4e6}) {
        const RunSummary run = timed_steps(dam_of(input.scenes, wanted), input.threads);
        const auto particles = static_cast<double>(run.particles);
        const StageTimes& s = run.seconds;
        const double all = total_seconds(s) * 1e9 / particles;
        first = first > 0 ? first : all;
        table.add({run.particles, 100 * run.surface_particles / particles});
        for (const double stage : {s.neighbors, s.density, s.divergence, s.surface_tension,
                                   s.pressure, s.sort + s.viscosity + s.motion})
            table.rows.back().emplace_back(stage * 1e9 / particles);
        table.rows.back().emplace_back(all);
        table.rows.back().emplace_back(all / first);
    }
    return {table};
}

} // namespace

TableGroup step_speed_tables() {
    return {"Simulation",
            {{"stages", "", 0, "time of a step, stage by stage", stages},
             {"scaling", "", 0, "the same for up to four million particles", scaling}}};
}

} // namespace meniscus
