// The scenes that ship and how many particles they have.
#include "support/tables.hpp"

#include <meniscus/sph/scene/scene.hpp>

#include <fmt/format.h>

namespace meniscus {
namespace {

std::string step_text(const TimeStepOptions& options) {
    if (options.fixed)
        return fmt::format("{:g}", *options.fixed * 1000);
    return fmt::format("{:g} to {:g}", options.min * 1000, options.max * 1000);
}

Tables scenes(const TableInput& input) {
    Table table = table_of(
        "scenes",
        "scene | variant | spacing, m {:g} | fluid | walls | time step, ms | sigma, N/m {:g}");
    for (const auto& file : input.files) {
        std::vector<std::string> variants = scene_variants(file);
        variants.insert(variants.begin(), "");
        for (const std::string& variant : variants) {
            const Scene scene = read_scene(file, variant);
            const SceneParticles particles = fill_scene(scene);
            table.add({variant.empty() ? scene.name : "", variant, scene.particle_spacing,
                       particles.positions.size(), particles.walls.size(),
                       step_text(scene.time_step), scene.surface_tension.coefficient});
        }
    }
    return {table};
}

} // namespace

TableGroup scene_tables() {
    return {"Simulation",
            {{"scenes", "SCENE...", 1, "scenes, their variants and particles", scenes}}};
}

} // namespace meniscus
