// Which scene `meniscus simulate` runs: a file, or one that ships, by its name.
#pragma once

#include "command_line.hpp"

#include <meniscus/sph/scene/scene.hpp>

#include <string>
#include <vector>

namespace meniscus {

/// Names of the scenes that ship, in alphabetical order; none where they are missing.
std::vector<std::string> shipped_scene_names();

/// The file of that name or, where there is none, the scene that ships under the name. Throws
/// InputError, with the nearest and all names, where there is neither.
Path scene_file(const Path& file_or_name);

/// Reads the scene with its changes, and says on standard output, unless `quiet`, which keys of the
/// file they leave without a meaning. Throws as scene_file and read_changed_scene do.
Scene chosen_scene(const Path& file_or_name, const std::string& variant,
                   const std::vector<std::string>& changes, bool quiet);

} // namespace meniscus
