// The scenes that ship and how many particles they have, in Markdown. Usage: scene_table
// SCENE.json...
#include <meniscus/sph/scene.hpp>

#include <cstdio>
#include <exception>
#include <fmt/format.h>

namespace meniscus {
namespace {

std::string step_text(const TimeStepOptions& options) {
    if (options.fixed)
        return fmt::format("{:g}", *options.fixed * 1000);
    return fmt::format("{:g} to {:g}", options.smallest * 1000, options.largest * 1000);
}

void print_row(const std::filesystem::path& file, const std::string& variant) {
    const Scene scene = read_scene(file, variant);
    const SceneParticles particles = fill_scene(scene);
    fmt::print("| {} | {} | {:g} | {} | {} | {} | {:g} |\n", variant.empty() ? scene.name : "",
               variant, scene.particle_spacing, particles.positions.size(), particles.walls.size(),
               step_text(scene.time_step), scene.surface_tension.coefficient);
}

void print_table(int argument_count, char** arguments) {
    fmt::print("| scene | variant | spacing, m | fluid | walls | time step, ms | sigma, N/m |\n"
               "|---|---|---|---|---|---|---|\n");
    for (int a = 1; a < argument_count; ++a) {
        print_row(arguments[a], "");
        for (const std::string& variant : scene_variants(arguments[a]))
            print_row(arguments[a], variant);
    }
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        meniscus::print_table(argument_count, arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "scene_table: %s\n", error.what());
        return 2;
    }
    return 0;
}
