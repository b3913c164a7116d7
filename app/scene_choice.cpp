#include "scene_choice.hpp"

#include "shipped_files.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/spelling.hpp>
#include <meniscus/sph/scene/scene_changes.hpp>

#include <algorithm>
#include <fmt/format.h>

namespace meniscus {

std::vector<std::string> shipped_scene_names() {
    std::vector<std::string> names;
    try {
        for (const auto& entry : std::filesystem::directory_iterator(shipped_scenes()))
            if (entry.path().extension() == ".json")
                names.push_back(entry.path().stem().string());
    } catch (const InputError&) { // not installed
    }
    std::sort(names.begin(), names.end());
    return names;
}

Path scene_file(const Path& file_or_name) {
    if (std::filesystem::exists(file_or_name) || file_or_name != file_or_name.filename())
        return file_or_name;
    const std::vector<std::string> names = shipped_scene_names();
    const std::string name = file_or_name.stem().string();
    if (std::find(names.begin(), names.end(), name) != names.end())
        return shipped_scenes() / (name + ".json");
    const std::string nearest = likely_spelling(name, names);
    throw InputError(fmt::format(
        "{}: there is no such file, and no scene of that name ships{}; those that do: {}",
        file_or_name.string(), nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest),
        fmt::join(names, ", ")));
}

Scene chosen_scene(const Path& file_or_name, const std::string& variant,
                   const std::vector<std::string>& changes, bool quiet) {
    std::vector<std::string> left_out;
    const Path file = scene_file(file_or_name);
    const Scene scene = read_changed_scene(file, variant, changes, left_out);
    for (const std::string& sentence : left_out)
        if (!quiet)
            print_text(fmt::format("scene '{}': {}\n", scene.name, printable(sentence)));
    return scene;
}

} // namespace meniscus
