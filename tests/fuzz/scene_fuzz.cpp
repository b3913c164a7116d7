#include "fuzz_file.hpp"

#include <meniscus/sph/scene/scene.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return meniscus::run_reader(data, size, [](const std::filesystem::path& file) {
        const std::vector<std::string> variants = meniscus::scene_variants(file);
        const meniscus::Scene scene =
            meniscus::read_scene(file, variants.empty() ? "" : variants.front());
        meniscus::require(scene.particle_spacing > 0 && !scene.fluid.empty(),
                          "a scene has fluid and a spacing");
        return meniscus::Snapshot{};
    });
}
