// H5Part: a group /Step#N for each state with an array for each quantity; x, y and z are the
// positions. States are in the order of N.
#include "detail/frames.hpp"
#include "detail/hdf5_formats.hpp"

#include <meniscus/data/text/text.hpp>

#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <string_view>

namespace meniscus {
namespace {

constexpr std::string_view step = "Step#";

/// The names of the steps, by their numbers.
std::map<std::uint64_t, std::string> steps_in(const Hdf5Source& source) {
    std::map<std::uint64_t, std::string> steps;
    for (const std::string& name : names_in(source, "/")) {
        std::uint64_t number = 0;
        if (name.rfind(step, 0) == 0 &&
            read_number(std::string_view(name).substr(step.size()), number) == std::errc())
            steps.emplace(number, name);
    }
    return steps;
}

bool holds_h5part(const Hdf5Source& source) {
    const auto steps = steps_in(source);
    return !steps.empty() && exists(source, "/" + steps.rbegin()->second + "/x");
}

std::vector<double> read_column(const Hdf5Source& source, const std::string& path,
                                std::size_t particles) {
    const Dataset dataset = open_dataset(source, path);
    if (dataset.dimensions != Dimensions{particles})
        fail(source, path, std::to_string(particles) + " values", shown(dataset.dimensions));
    return as_doubles({path, 1, read_numbers(source, dataset)});
}

void read_positions(const Hdf5Source& source, const std::string& group, Snapshot& snapshot) {
    const Dataset x = open_dataset(source, group + "/x");
    snapshot.positions.resize(value_count(x));
    if (std::holds_alternative<std::vector<float>>(empty_values(source, x)))
        snapshot.position_precision = Precision::float32;
    for (const std::size_t axis : {0, 1, 2}) {
        const std::string path = group + "/" + std::string(1, "xyz"[axis]);
        if (axis == 2 && !exists(source, path)) {
            snapshot.dimension_is_stated = true;
            continue;
        }
        const std::vector<double> values = read_column(source, path, snapshot.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            snapshot.positions[i][axis] = values[i];
    }
    snapshot.dimension = snapshot.dimension_is_stated ? 2 : dimension_of(snapshot.positions);
}

Snapshot h5part_snapshot(const Hdf5Source& source, const ReadChoices& choices) {
    const auto steps = steps_in(source);
    const std::uint64_t frame = frame_to_read(choices, steps.size());
    const std::string group =
        "/" + std::next(steps.begin(), static_cast<std::ptrdiff_t>(frame))->second;
    Snapshot snapshot;
    read_positions(source, group, snapshot);
    for (const std::string& name : array_names_in(source, group)) {
        if (name == "x" || name == "y" || name == "z")
            continue;
        const Dataset dataset = open_dataset(source, group + "/" + name);
        if (dataset.dimensions == Dimensions{snapshot.size()})
            snapshot.point_data.push_back({name, 1, read_numbers(source, dataset)});
    }
    const auto time = number_attribute<double>(source, group.c_str(), "time", 1);
    if (!time.empty() && std::isfinite(time[0]))
        snapshot.time = time[0];
    note_frame(snapshot, choices, frame, steps.size(), group.substr(1));
    return snapshot;
}

} // namespace

Hdf5Format h5part_format() {
    return {"H5Part", holds_h5part, h5part_snapshot, true};
}

} // namespace meniscus
