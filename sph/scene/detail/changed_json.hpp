// Changes of the command line in the JSON of a scene, before it is read.
#pragma once

#include <meniscus/data/json/json_reader.hpp>

#include <string>
#include <vector>

namespace meniscus {

/// The JSON with changes such as "pressure.solver=iisph". Where one names another solver or
/// surface-tension model, keys that go with the one before are taken out, but for those that a
/// change names; `left_out` gets a sentence for each. Throws as read_changed_scene does
/// (scene_changes.hpp).
Json changed_json(Json json, const std::vector<std::string>& changes,
                  std::vector<std::string>& left_out);

} // namespace meniscus
