#include "snapshot.hpp"

#include "generic_names.hpp"
#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace meniscus {

namespace {

std::size_t value_count(const PointArray& array) {
    return std::visit([](const auto& values) { return values.size(); }, array.values);
}

bool is_finite(const std::array<double, 3>& position) {
    return std::all_of(position.begin(), position.end(), [](double x) { return std::isfinite(x); });
}

} // namespace

const PointArray* find_array(const Snapshot& snapshot, std::string_view name) {
    const auto found = std::find_if(snapshot.point_data.begin(), snapshot.point_data.end(),
                                    [&](const PointArray& array) { return array.name == name; });
    return found == snapshot.point_data.end() ? nullptr : &*found;
}

void set_array(Snapshot& snapshot, PointArray array) {
    if (array.components < 1 ||
        value_count(array) != snapshot.size() * static_cast<std::size_t>(array.components)) {
        throw std::invalid_argument("point data '" + array.name + "': expected " +
                                    std::to_string(array.components) + " values for each of " +
                                    std::to_string(snapshot.size()) + " particles, found " +
                                    std::to_string(value_count(array)) + " values");
    }
    const auto same =
        std::find_if(snapshot.point_data.begin(), snapshot.point_data.end(),
                     [&](const PointArray& other) { return other.name == array.name; });
    if (same == snapshot.point_data.end())
        snapshot.point_data.push_back(std::move(array));
    else
        *same = std::move(array);
}

const PointArray& scalar_array(const Snapshot& snapshot, std::string_view name) {
    const PointArray* array = find_array(snapshot, name);
    if (array == nullptr) {
        throw InputError("point data '" + std::string(name) +
                         "': expected one value a particle, found no such array");
    }
    if (array->components != 1) {
        throw InputError("point data '" + std::string(name) +
                         "': expected one value a particle, found " +
                         std::to_string(array->components));
    }
    return *array;
}

std::vector<double> scalar_values(const Snapshot& snapshot, std::string_view name) {
    return as_doubles(scalar_array(snapshot, name));
}

std::vector<double> as_doubles(const PointArray& array) {
    return std::visit(
        [](const auto& values) { return std::vector<double>(values.begin(), values.end()); },
        array.values);
}

std::vector<std::uint8_t> finite_positions(const Snapshot& snapshot) {
    std::vector<std::uint8_t> finite(snapshot.size());
    std::transform(snapshot.positions.begin(), snapshot.positions.end(), finite.begin(), is_finite);
    return finite;
}

int dimension_of(const Positions& positions) {
    const auto first = std::find_if(positions.begin(), positions.end(), is_finite);
    if (first == positions.end())
        return 3;
    std::size_t same_plane = 0;
    for (auto position = first; position != positions.end(); ++position) {
        if (!is_finite(*position))
            continue;
        if ((*position)[2] != (*first)[2])
            return 3;
        ++same_plane;
    }
    return same_plane >= 2 ? 2 : 3;
}

std::string scene_of(const Snapshot& snapshot, const std::filesystem::path& file) {
    if (!snapshot.scene.empty())
        return snapshot.scene;
    // A frame number stands apart: "dam_0014" is frame 14 of "dam", "breakwater2020" is a name.
    const std::string stem = telling_stem(file);
    const std::size_t last_letter = stem.find_last_not_of("0123456789");
    const bool framed = last_letter != std::string::npos && last_letter + 1 < stem.size() &&
                        std::string_view("_-.").find(stem[last_letter]) != std::string_view::npos;
    return framed && last_letter > 0 ? stem.substr(0, last_letter) : stem;
}

} // namespace meniscus
