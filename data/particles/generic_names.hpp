// Names of files that say nothing of their scene, such as SPlisHSPlasH's ParticleData_Fluid_12.vtk
// in a folder Dam/vtk: the folder does.
#pragma once

#include <filesystem>
#include <string>

namespace meniscus {

/// The file's stem, or where that is generic the name of the folder that is not, with the frame
/// number: "Dam_12".
std::string telling_stem(const std::filesystem::path& file);

} // namespace meniscus
