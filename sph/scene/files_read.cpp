#include "files_read.hpp"

namespace meniscus {

std::vector<std::filesystem::path> files_read_by(const Scene& scene) {
    std::vector<std::filesystem::path> files;
    for (const FluidBody& body : scene.fluid)
        if (const auto* snapshot = std::get_if<SnapshotShape>(&body.shape))
            files.push_back(snapshot->file);
    for (const Wall& wall : scene.walls)
        if (const auto* mesh = std::get_if<MeshShape>(&wall.shape))
            files.push_back(mesh->file);
    if (!scene.surface_tension.model_file.empty())
        files.push_back(scene.surface_tension.model_file);
    return files;
}

} // namespace meniscus
