// A scene as canonical JSON.
#include "detail/scene_names.hpp"
#include "methods.hpp"

#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/runtime/surface/option_table.hpp>

namespace meniscus {
namespace {

template <class Value>
Json json_of(const SurfaceOption<Value>& option, const SurfaceTensionOptions& options) {
    const Value value = options.*option.member;
    if constexpr (std::is_enum_v<Value>)
        return option.range.words[static_cast<std::size_t>(value)];
    else
        return value; // null where it is NaN
}

Json json_of(const Place& place) {
    return {place[0] + 0.0, place[1] + 0.0, place[2] + 0.0}; // -0 is 0
}

Json json_of(const LatticeShape& shape) {
    return {{"lattice", {{"first", json_of(shape.first)}, {"count", shape.count}}}};
}

Json json_of(const BoxShape& shape) {
    return {{"box",
             {{"low", json_of(shape.low)}, {"high", json_of(shape.high)}, {"open", shape.open}}}};
}

Json json_of(const SphereShape& shape) {
    return {{"ball", {{"center", json_of(shape.center)}, {"half_axes", json_of(shape.half_axes)}}}};
}

Json json_of(const MeshShape& shape) {
    return {{"mesh",
             {{"sha256", file_hash(shape.file)},
              {"scale", shape.scale},
              {"translation", json_of(shape.translation)}}}};
}

Json json_of(const SnapshotShape& shape) {
    return {{"snapshot",
             {{"sha256", file_hash(shape.file)}, {"translation", json_of(shape.translation)}}}};
}

template <class Shapes>
Json json_of_any(const Shapes& shapes) {
    return std::visit([](const auto& shape) { return json_of(shape); }, shapes);
}

Json json_of(const PressureOptions& options) {
    Json json;
    json["solver"] = options.solver;
    for (const PressureKey& key : pressure_keys)
        std::visit([&](auto option) { json[key.name] = options.*option; }, key.option);
    return json;
}

template <class Value>
Json json_of(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json json_of(const SecondLine& line) {
    return {{"features", {feature_list[line.x].name, feature_list[line.y].name}},
            {"k", line.k},
            {"d", line.d},
            {"above", line.above}};
}

Json json_of(const TensionOptions& options) {
    Json json = {{"model", options.model},
                 {"coefficient", options.coefficient},
                 {"restrict_to_surface", options.restrict_to_surface},
                 {"adhesion", options.adhesion},
                 {"balance_momentum", options.balance_momentum},
                 {"contact_friction", options.contact_friction},
                 {"ripple_damping", options.ripple_damping},
                 {"sampling_density", options.sampling_density},
                 {"min_samples", options.min_samples}};
    for_each_surface_option([&](const auto& option) {
        if (!comes_with_scene(option.name))
            json[option.name] = json_of(option, options.surface);
    });
    if (options.surface.second_line.is_there)
        json["second_line"] = json_of(options.surface.second_line);
    return json;
}

Json json_of(const ViscosityOptions& options) {
    return {{"kinematic", options.kinematic},
            {"density_correction", options.density_correction},
            {"xsph", options.xsph}};
}

Json json_of(const TimeStepOptions& options) {
    return {{"fixed", json_of(options.fixed)},
            {"courant_factor", options.courant_factor},
            {"min", options.min},
            {"max", options.max}};
}

void add_shapes(const Scene& scene, Json& json) {
    json["fluid"] = Json::array();
    for (const FluidBody& body : scene.fluid) {
        json["fluid"].push_back(json_of_any(body.shape));
        json["fluid"].back()["velocity"] = json_of(body.velocity);
    }
    json["walls"] = Json::array();
    for (const Wall& wall : scene.walls) {
        json["walls"].push_back(json_of_any(wall.shape));
        json["walls"].back()["contact_angle"] = json_of(wall.contact_angle);
    }
    json["domain"] = nullptr;
    if (scene.domain)
        json["domain"] = {{"low", json_of((*scene.domain)[0])},
                          {"high", json_of((*scene.domain)[1])}};
}

} // namespace

std::string scene_text(const Scene& scene) {
    Json json;
    json["name"] = scene.name;
    json["variant"] = scene.variant;
    json["dimension"] = scene.dimension;
    json["precision"] = precision_names[scene.precision == Precision::float32 ? 0 : 1];
    json["particle_spacing"] = scene.particle_spacing;
    json["support_radius"] = scene.support_radius;
    json["rest_density"] = scene.rest_density;
    json["volume_share"] = scene.volume_share;
    json["duration"] = scene.duration;
    json["frame_interval"] = scene.frame_interval;
    add_shapes(scene, json);
    json["leaving"] = name_of(scene.leaving, leaving_names);
    json["gravity"] = json_of(scene.gravity);
    json["kernel"] = name_of(scene.kernel, kernel_names);
    json["pressure"] = json_of(scene.pressure);
    json["viscosity"] = json_of(scene.viscosity);
    json["surface_tension"] = json_of(scene.surface_tension);
    json["time_step"] = json_of(scene.time_step);
    json["log"] = {{log_names[0], scene.log.forces}, {log_names[1], scene.log.bodies}};
    return json.dump();
}

} // namespace meniscus
