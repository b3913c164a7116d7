// Which files a scene is made from: they must outlive its run.
#pragma once

#include "scene.hpp"

#include <filesystem>
#include <vector>

namespace meniscus {

/// The files that a scene names besides its own: snapshots, meshes and the model.
std::vector<std::filesystem::path> files_read_by(const Scene& scene);

} // namespace meniscus
