// Changes of a scene from the command line, where another solver or surface-tension model takes the
// place of the one that the file has: what the file says for that one alone has no meaning any
// more.
#pragma once

#include "scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meniscus {

/// read_scene(), and in `left_out` a sentence for each key of the file that goes with the method
/// which the changes have replaced, and that they do not name themselves. Throws InputError as
/// read_scene does, where the file's coefficient of surface tension is in the unit of another model
/// and the changes give none, and where a method needs a key that neither has.
Scene read_changed_scene(const std::filesystem::path& file, const std::string& variant,
                         const std::vector<std::string>& changes,
                         std::vector<std::string>& left_out);

} // namespace meniscus
