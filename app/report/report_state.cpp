#include "report_state.hpp"

#include <meniscus/app/features/model_features.hpp>
#include <meniscus/data/packing/bytes.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus {
namespace {

using Json = nlohmann::ordered_json;
using Point = std::array<double, 3>;

/// Compressed, as text.
template <class Number>
std::string packed(const std::vector<Number>& numbers) {
    return base64(
        deflated({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)}));
}

struct Box {
    Point low;
    Point high;
};

Box box_of(const Positions& positions) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Box box{{far, far, far}, {-far, -far, -far}};
    for (const Point& position : positions)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box.low[axis] = std::min(box.low[axis], position[axis]);
            box.high[axis] = std::max(box.high[axis], position[axis]);
        }
    return box;
}

/// One scale for all axes; all x, then all y, then all z, which compresses better.
std::vector<std::uint16_t> rounded(const Positions& positions, const Point& low, double step) {
    std::vector<std::uint16_t> numbers;
    numbers.reserve(positions.size() * 3);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const Point& position : positions)
            numbers.push_back(
                static_cast<std::uint16_t>(std::lround((position[axis] - low[axis]) / step)));
    return numbers;
}

/// Values of the particles that the file calls valid.
template <class Value>
std::vector<Value> of_valid(const std::vector<Value>& values,
                            const std::vector<std::size_t>& valid) {
    std::vector<Value> chosen;
    chosen.reserve(valid.size());
    for (const std::size_t i : valid)
        chosen.push_back(values[i]);
    return chosen;
}

std::vector<float> as_floats(const std::vector<double>& values) {
    return {values.begin(), values.end()};
}

/// Point data of any number of components, in float.
std::vector<float> floats_of_valid(const PointArray& array, const std::vector<std::size_t>& valid) {
    const std::vector<double> values = as_doubles(array);
    const auto components = static_cast<std::size_t>(array.components);
    std::vector<float> chosen;
    for (const std::size_t i : valid)
        for (std::size_t c = 0; c < components; ++c)
            chosen.push_back(static_cast<float>(values[i * components + c]));
    return chosen;
}

Json plane_json(const FeaturePair& pair, const Line& line) {
    const FeatureRow& x = feature_list[pair.first];
    const FeatureRow& y = feature_list[pair.second];
    return {{"features", {x.name, y.name}},
            {"meanings", {x.meaning, y.meaning}},
            {"k", line.k},
            {"d", line.d},
            {"above", line.above}};
}

void add_positions(const Snapshot& snapshot, const std::vector<std::size_t>& valid,
                   const Positions& boundary, Json& json) {
    const Positions fluid = of_valid(snapshot.positions, valid);
    Positions all = fluid;
    all.insert(all.end(), boundary.begin(), boundary.end());
    const Box box = all.empty() ? Box{{}, {}} : box_of(all);
    double extent = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        extent = std::max(extent, box.high[axis] - box.low[axis]);
    const double step = extent > 0 ? extent / 65535 : 1;
    json["low"] = box.low;
    json["step"] = step;
    json["arrays"]["position"] = packed(rounded(fluid, box.low, step));
    if (!boundary.empty())
        json["arrays"]["boundary"] = packed(rounded(boundary, box.low, step));
}

/// What later steps may have stored, and what tells particles apart.
void add_optional_arrays(const Snapshot& snapshot, const std::vector<std::size_t>& valid,
                         Json& json) {
    const std::pair<const char*, const char*> stored[] = {
        {"runtime_normal", "normal"}, {"runtime_curvature", "curvature"}, {"phase", "phase"}};
    for (const auto& [name, ours] : stored)
        if (const PointArray* array = find_array(snapshot, name))
            json["arrays"][ours] = packed(floats_of_valid(*array, valid));
    const SupportRadii radii = support_radii(snapshot);
    json["support_radius"] = radii.max;
    if (radii.vary())
        json["arrays"]["support_radius"] = packed(as_floats(of_valid(radii.each, valid)));
    if (valid.size() != snapshot.size())
        json["arrays"]["index"] = packed(std::vector<std::uint32_t>(valid.begin(), valid.end()));
}

} // namespace

Json planes_json(const Model& model) {
    Json planes = Json::array();
    planes.push_back(plane_json(model.features, model.line));
    if (model.second)
        planes.push_back(plane_json(model.second->features, model.second->line));
    return planes;
}

Positions nearby_boundary(const Snapshot& snapshot) {
    Positions fluid;
    for (const std::size_t i : places_of_valid(snapshot))
        fluid.push_back(snapshot.positions[i]);
    const Box box = box_of(fluid);
    const double margin = 2 * support_radii(snapshot).max;
    Positions nearby;
    for (const Point& position : snapshot.boundary) {
        bool is_near = true;
        for (std::size_t axis = 0; axis < 3; ++axis)
            is_near = is_near && position[axis] >= box.low[axis] - margin &&
                      position[axis] <= box.high[axis] + margin;
        if (is_near)
            nearby.push_back(position);
    }
    return nearby;
}

Json state_json(const Snapshot& snapshot, const LabelledState& state, const Positions& boundary,
                const Model& model, const AuditOptions& options) {
    const auto valid = places_of_valid(snapshot);
    Json json = {{"file", state.file},
                 {"scene", state.scene},
                 {"dimension", state.dimension},
                 {"time", snapshot.time ? Json(*snapshot.time) : Json(nullptr)},
                 {"count", valid.size()},
                 {"boundary_count", boundary.size()},
                 {"radius_ratio", state.radius_ratio},
                 {"provenance", snapshot.provenance}};
    json["scales"].push_back(feature_scales(model.features, state, model));
    if (model.second)
        json["scales"].push_back(feature_scales(model.second->features, state, model));
    json["arrays"] = Json::object();
    add_positions(snapshot, valid, boundary, json);
    for (const auto& [feature, values] : feature_values(snapshot, state, model, options.threads))
        json["arrays"][feature_list[feature].name] = packed(of_valid(values, valid));
    std::vector<std::uint8_t> surface;
    for (const double lambda : state.uncovered_fraction)
        surface.push_back(lambda > options.label_threshold.value_or(0) ? 1 : 0);
    json["arrays"]["surface"] = packed(surface);
    json["arrays"]["uncovered_fraction"] = packed(as_floats(state.uncovered_fraction));
    add_optional_arrays(snapshot, valid, json);
    return json;
}

} // namespace meniscus
