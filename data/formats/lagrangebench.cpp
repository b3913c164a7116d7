// LagrangeBench's trajectories: a group 00000, 00001, ... for each, in it `position` (states x
// particles x 2 or 3) and `particle_type` (0 fluid, 1 and 2 walls, 3 rigid bodies, -1 padding). Of
// several trajectories the states are counted through. The spacing and the periodic box stand in a
// file beside it, metadata.json.
#include "detail/frames.hpp"
#include "detail/hdf5_formats.hpp"

#include "detail/number_blocks.hpp"
#include "detail/particle_roles.hpp"
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace meniscus {
namespace {

using Json = nlohmann::json;

/// The groups of the trajectories, in their order.
std::vector<std::string> trajectories(const Hdf5Source& source) {
    std::vector<std::string> groups;
    for (const std::string& name : names_in(source, "/"))
        if (!name.empty() && name.find_first_not_of("0123456789") == std::string::npos)
            groups.push_back("/" + name);
    return groups;
}

bool holds_lagrangebench(const Hdf5Source& source) {
    const std::vector<std::string> groups = trajectories(source);
    return !groups.empty() && exists(source, groups.back() + "/position") &&
           exists(source, groups.back() + "/particle_type");
}

Dataset open_positions(const Hdf5Source& source, const std::string& group) {
    Dataset positions = open_dataset(source, group + "/position");
    const Dimensions& found = positions.dimensions;
    if (found.size() != 3 || found[0] == 0 || found[2] < 2 || found[2] > 3)
        fail(source, positions.path, "states x particles x 2 or 3 coordinates", shown(found));
    return positions;
}

void read_types(const Hdf5Source& source, const std::string& group, Snapshot& snapshot) {
    const Dataset types = open_dataset(source, group + "/particle_type");
    if (types.dimensions != Dimensions{snapshot.size()})
        fail(source, types.path, std::to_string(snapshot.size()) + " values",
             shown(types.dimensions));
    snapshot.point_data.push_back({"particle_type", 1, read_numbers(source, types)});
}

std::string periodic_words(const Json& metadata) {
    const auto bounds = metadata.find("bounds");
    const auto periodic = metadata.find("periodic_boundary_conditions");
    if (bounds == metadata.end() || periodic == metadata.end() || !bounds->is_array() ||
        !periodic->is_array())
        return {};
    std::string words;
    for (std::size_t axis = 0; axis < std::min({bounds->size(), periodic->size(), std::size_t{3}});
         ++axis) {
        const Json& sides = (*bounds)[axis];
        if ((*periodic)[axis] == true && sides.is_array() && sides.size() == 2 &&
            sides[0].is_number() && sides[1].is_number() && sides[0] < sides[1])
            words += (words.empty() ? "" : ",") + std::string(1, "xyz"[axis]) + "=" +
                     number_text(sides[0].get<double>()) + ":" +
                     number_text(sides[1].get<double>());
    }
    return words;
}

/// What metadata.json says, as far as it can be read.
void take_metadata(const Hdf5Source& source, Snapshot& snapshot) {
    const Json metadata = Json::parse(source.metadata, nullptr, false);
    if (!metadata.is_object()) {
        snapshot.notes.push_back("no metadata.json beside the file, which would state the spacing "
                                 "and the periodic box");
        return;
    }
    const auto spacing = metadata.find("dx");
    if (spacing != metadata.end() && spacing->is_number() && spacing->get<double>() > 0)
        snapshot.particle_spacing = spacing->get<double>();
    if (const std::string words = periodic_words(metadata); !words.empty())
        snapshot.provenance["periodic"] = words;
}

Snapshot lagrangebench_snapshot(const Hdf5Source& source, const ReadChoices& choices) {
    const std::vector<std::string> groups = trajectories(source);
    std::vector<std::uint64_t> ends; // of each trajectory, counted through
    for (const std::string& group : groups)
        ends.push_back((ends.empty() ? 0 : ends.back()) +
                       open_positions(source, group).dimensions[0]);
    const std::uint64_t frame = frame_to_read(choices, ends.back());
    const auto place =
        static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), frame) - ends.begin());
    const std::uint64_t state = frame - (place == 0 ? 0 : ends[place - 1]);

    const Dataset positions = open_positions(source, groups[place]);
    Snapshot snapshot;
    set_positions(snapshot, read_row(source, positions, state), positions.dimensions[2]);
    read_types(source, groups[place], snapshot);
    take_metadata(source, snapshot);
    note_frame(snapshot, choices, frame, ends.back(),
               "state " + std::to_string(state) + " of trajectory " + groups[place].substr(1));
    if (!choices.choose_particles() && !choices.is_boundary) {
        ReadChoices roles;
        roles.walls = {"particle_type=1", "particle_type=2", "particle_type=3"};
        roles.ignored = {"particle_type=-1"};
        choose_particles(snapshot, roles);
    }
    return snapshot;
}

} // namespace

Hdf5Format lagrangebench_format() {
    return {"LagrangeBench", holds_lagrangebench, lagrangebench_snapshot, true};
}

} // namespace meniscus
