#include "fuzz_file.hpp"

#include <meniscus/data/particles/boundary_sampling.hpp>

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return meniscus::run_reader(data, size, [](const std::filesystem::path& file) {
        const meniscus::TriangleMesh mesh = meniscus::read_obj(file);
        meniscus::require(!mesh.triangles.empty(), "what is read has triangles");
        for (const auto& triangle : mesh.triangles)
            for (const std::uint32_t vertex : triangle)
                meniscus::require(vertex < mesh.vertices.size(), "triangles have their vertices");
        for (const auto& vertex : mesh.vertices)
            for (const double coordinate : vertex)
                meniscus::require(std::isfinite(coordinate), "vertices are finite");
        return meniscus::Snapshot{};
    });
}
