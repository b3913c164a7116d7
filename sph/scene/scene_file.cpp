#include "detail/changed_json.hpp"
#include "detail/read_values.hpp"
#include "detail/scene_names.hpp"
#include "methods.hpp"
#include "scene_changes.hpp"

#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/surface/option_table.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

// Beyond what anybody simulates: what lies outside is a slip of the pen or of the unit.
constexpr double min = 1e-9;
constexpr double max = 1e9;
constexpr double max_spacing_ratio = 6; // h over spacing; 1 leaves no neighbors
constexpr int max_lattice = 100000;

const std::vector<std::string> side_names{"-x", "+x", "-y", "+y", "-z", "+z"};
const std::vector<std::string> fluid_shapes{"lattice", "box", "ball", "snapshot"};
const std::vector<std::string> wall_shapes{"box", "ball", "mesh"};

/// What the shapes of a scene have in common.
struct Frame {
    int dimension = 3;
    std::filesystem::path folder; ///< that file names are relative to
};

/// Three numbers; in two dimensions two, or a third that is `flat`.
Place read_place(const JsonReader& reader, const char* key, const Frame& frame, double min,
                 double flat = 0) {
    std::vector<double> numbers = reader.numbers(key, -max, max);
    if (frame.dimension == 2 && numbers.size() == 2)
        numbers.push_back(flat);
    if (numbers.size() != 3 || (frame.dimension == 2 && numbers[2] != flat))
        reader.refuse(key, frame.dimension == 3 ? "a list of three numbers"
                                                : "a list of two numbers, in two dimensions");
    for (int axis = 0; axis < frame.dimension; ++axis)
        if (numbers[axis] < min)
            reader.refuse(key, "a list of numbers from " + number_text(min) + " on");
    return {numbers[0], numbers[1], numbers[2]};
}

void take_place(const JsonReader& reader, const char* key, const Frame& frame, Place& place) {
    if (reader.has(key))
        place = read_place(reader, key, frame, -max);
}

std::array<Place, 2> read_corners(const JsonReader& reader, const Frame& frame) {
    const std::array<Place, 2> corners{read_place(reader, "low", frame, -max),
                                       read_place(reader, "high", frame, -max)};
    for (int axis = 0; axis < frame.dimension; ++axis)
        if (corners[0][axis] >= corners[1][axis])
            reader.refuse("high", "above 'low' along every axis");
    return corners;
}

std::filesystem::path read_file_name(const JsonReader& reader, const Frame& frame) {
    const std::string name = reader.text("file");
    if (name.empty() || name.find('\0') != std::string::npos)
        reader.refuse("file", "the name of a file, relative to the scene's file");
    return frame.folder / name;
}

LatticeShape read_lattice(const JsonReader& reader, const Frame& frame) {
    reader.expect_only({"first", "count"});
    LatticeShape lattice;
    lattice.first = read_place(reader, "first", frame, -max);
    const Place count = read_place(reader, "count", frame, 1, 1);
    for (int axis = 0; axis < 3; ++axis) {
        if (count[axis] > max_lattice || count[axis] != std::floor(count[axis]))
            reader.refuse("count",
                          "a list of whole numbers from 1 to " + std::to_string(max_lattice));
        lattice.count[axis] = static_cast<int>(count[axis]);
    }
    return lattice;
}

std::vector<std::string> read_open_sides(const JsonReader& reader, const Frame& frame) {
    if (!reader.has("open"))
        return {};
    std::vector<std::string> valid = side_names;
    valid.resize(frame.dimension == 3 ? 6 : 4);
    const std::vector<std::string> found = reader.texts("open");
    std::vector<std::string> open; // in the order of sides
    std::copy_if(valid.begin(), valid.end(), std::back_inserter(open), [&](const auto& side) {
        return std::find(found.begin(), found.end(), side) != found.end();
    });
    if (open.size() != found.size() || open.size() == valid.size())
        reader.refuse("open", "a list of sides, each one once and not all, of -x, +x, -y, +y" +
                                  std::string(frame.dimension == 3 ? ", -z, +z" : ""));
    return open;
}

BoxShape read_box(const JsonReader& reader, const Frame& frame, bool wall) {
    reader.expect_only(wall ? std::vector<std::string>{"low", "high", "open"}
                            : std::vector<std::string>{"low", "high"});
    const auto [low, high] = read_corners(reader, frame);
    return {low, high, read_open_sides(reader, frame)};
}

SphereShape read_ball(const JsonReader& reader, const Frame& frame) {
    reader.expect_only({"center", "radius", "half_axes"});
    if (reader.has("radius") == reader.has("half_axes"))
        reader.refuse("radius", "there or 'half_axes' instead, one of the two");
    SphereShape ball;
    ball.center = read_place(reader, "center", frame, -max);
    if (reader.has("half_axes")) {
        ball.half_axes = read_place(reader, "half_axes", frame, min);
        return ball;
    }
    for (int axis = 0; axis < frame.dimension; ++axis)
        ball.half_axes[axis] = reader.number("radius", min, max);
    return ball;
}

MeshShape read_mesh(const JsonReader& reader, const Frame& frame) {
    reader.expect_only({"file", "scale", "translation"});
    MeshShape mesh;
    mesh.file = read_file_name(reader, frame);
    take(reader, "scale", min, max, mesh.scale);
    take_place(reader, "translation", frame, mesh.translation);
    return mesh;
}

SnapshotShape read_snapshot_shape(const JsonReader& reader, const Frame& frame) {
    reader.expect_only({"file", "translation"});
    SnapshotShape snapshot;
    snapshot.file = read_file_name(reader, frame);
    take_place(reader, "translation", frame, snapshot.translation);
    return snapshot;
}

/// The one of the shapes that an entry of a list names.
std::string only_shape(const JsonReader& reader, const std::vector<std::string>& shapes) {
    std::vector<std::string> named;
    std::copy_if(shapes.begin(), shapes.end(), std::back_inserter(named),
                 [&](const auto& shape) { return reader.has(shape.c_str()); });
    if (named.empty())
        reader.refuse(shapes[0].c_str(), "there, or another shape");
    if (named.size() > 1)
        reader.refuse(named[1].c_str(), "an entry of its own, '" + named[0] + "' being the shape");
    return named[0];
}

FluidBody read_body(const JsonReader& reader, const Frame& frame) {
    reader.expect_only({"lattice", "box", "ball", "snapshot", "velocity"});
    FluidBody body;
    take_place(reader, "velocity", frame, body.velocity);
    const std::string shape = only_shape(reader, fluid_shapes);
    const JsonReader at = reader.object_at(shape.c_str());
    if (shape == "lattice")
        body.shape = read_lattice(at, frame);
    else if (shape == "box")
        body.shape = read_box(at, frame, false);
    else if (shape == "ball")
        body.shape = read_ball(at, frame);
    else
        body.shape = read_snapshot_shape(at, frame);
    return body;
}

WallShape read_wall_shape(const JsonReader& reader, const Frame& frame) {
    const std::string shape = only_shape(reader, wall_shapes);
    const JsonReader at = reader.object_at(shape.c_str());
    if (shape == "box")
        return read_box(at, frame, true);
    if (shape == "ball")
        return read_ball(at, frame);
    if (frame.dimension == 2)
        reader.refuse("mesh", "in a scene of three dimensions; take boxes and balls");
    return read_mesh(at, frame);
}

Wall read_wall(const JsonReader& reader, const Frame& frame) {
    std::vector<std::string> keys = wall_shapes;
    keys.emplace_back("contact_angle");
    reader.expect_only(keys);
    Wall wall = read_wall_shape(reader, frame);
    const OptionRange& range = option_ranges::contact_angle;
    if (reader.has("contact_angle"))
        wall.contact_angle = reader.number("contact_angle", range.min, range.max);
    return wall;
}

/// The rows' names.
template <class Row>
std::vector<std::string> names_of(const std::vector<Row>& rows) {
    std::vector<std::string> names;
    names.reserve(rows.size());
    for (const Row& row : rows)
        names.emplace_back(row.name);
    return names;
}

void read_option(const JsonReader& reader, const PressureKey& key, PressureOptions& options) {
    if (const auto* number = std::get_if<double PressureOptions::*>(&key.option))
        options.*(*number) = reader.number(key.name, key.min, key.max);
    else if (const auto* whole = std::get_if<int PressureOptions::*>(&key.option))
        options.*(*whole) =
            reader.whole_number(key.name, static_cast<int>(key.min), static_cast<int>(key.max));
    else
        options.*std::get<bool PressureOptions::*>(key.option) = reader.truth(key.name);
}

PressureOptions read_pressure(const JsonReader& reader) {
    std::vector<std::string> keys{"solver"};
    for (const PressureKey& key : pressure_keys)
        keys.emplace_back(key.name);
    reader.expect_only(keys);
    const auto& solver = pressure_solvers()[reader.choice("solver", names_of(pressure_solvers()))];
    PressureOptions options;
    options.solver = solver.name;
    for (const PressureKey& key : pressure_keys)
        if (!reads_key(solver, key.name))
            refuse_with(reader, key.name, "it has no meaning for solver " + options.solver);
        else if (reader.has(key.name) || !has_default(key))
            read_option(reader, key, options);
    if (options.min_iterations > options.max_iterations)
        reader.refuse("min_iterations", "at most 'max_iterations', which is " +
                                            std::to_string(options.max_iterations));
    return options;
}

ViscosityOptions read_viscosity(const JsonReader& reader) {
    reader.expect_only({"kinematic", "density_correction", "xsph"});
    ViscosityOptions options;
    take(reader, "kinematic", 0, max, options.kinematic);
    take(reader, "density_correction", options.density_correction);
    take(reader, "xsph", 0, 1, options.xsph);
    if (options.density_correction && options.kinematic == 0)
        reader.refuse("density_correction", "false where 'kinematic' is 0, which it corrects");
    return options;
}

/// Refuses keys that other models alone read.
void refuse_keys_of_others(const JsonReader& reader, const TensionModelRow& model) {
    for (const TensionModelRow& other : tension_models())
        for (const std::string& key : other.keys)
            if (&other != &model)
                refuse_with(reader, key.c_str(),
                            "it is for model " + std::string(other.name) + " alone");
}

TensionOptions read_tension(const JsonReader& reader, bool has_walls) {
    std::vector<std::string> keys{"model", "coefficient", "restrict_to_surface"};
    for (const TensionModelRow& model : tension_models())
        keys.insert(keys.end(), model.keys.begin(), model.keys.end());
    reader.expect_only(keys);
    const TensionModelRow& model =
        tension_models()[reader.choice("model", names_of(tension_models()))];
    TensionOptions options;
    options.model = model.name;
    options.coefficient = reader.number("coefficient", 0, max);
    options.surface.ambient_pressure = default_ambient_pressure(has_walls);
    refuse_keys_of_others(reader, model);
    if (model.read != nullptr)
        model.read(reader, options);
    if (model.finds_surface)
        refuse_with(reader, "restrict_to_surface", "model " + options.model + " always does");
    else
        take(reader, "restrict_to_surface", options.restrict_to_surface);
    return options;
}

TimeStepOptions default_time_step(double spacing) {
    TimeStepOptions options;
    options.max = default_max_time_step(spacing);
    options.min = std::min(options.min, options.max);
    return options;
}

TimeStepOptions read_time_step(const JsonReader& reader, double spacing) {
    reader.expect_only({"fixed", "courant_factor", "min", "max"});
    TimeStepOptions options = default_time_step(spacing);
    if (reader.has("fixed")) {
        for (const char* key : {"courant_factor", "min", "max"})
            refuse_with(reader, key, "'fixed' already says how long steps are");
        options.fixed = reader.number("fixed", min, 1);
        return options;
    }
    take(reader, "courant_factor", 0.001, 10, options.courant_factor);
    take(reader, "min", min, 1, options.min);
    take(reader, "max", min, 1, options.max);
    if (options.min > options.max)
        reader.refuse(reader.has("min") ? "min" : "max",
                      "such that 'min' (" + number_text(options.min) + ") is at most 'max' (" +
                          number_text(options.max) + ")");
    return options;
}

std::string read_name(const JsonReader& reader) {
    std::string name = reader.text("name");
    const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-';
    });
    if (!plain || name.empty() || name.size() > 100)
        reader.refuse("name", "1 to 100 letters, digits, '_' and '-', since files are named so");
    return name;
}

void read_numbers(const JsonReader& reader, Scene& scene) {
    scene.particle_spacing = reader.number("particle_spacing", 1e-6, 1e6);
    scene.support_radius = 2 * scene.particle_spacing;
    take(reader, "support_radius", 1.01 * scene.particle_spacing,
         max_spacing_ratio * scene.particle_spacing, scene.support_radius);
    take(reader, "rest_density", 1e-6, 1e6, scene.rest_density);
    take(reader, "volume_share", 0.1, 2, scene.volume_share);
    scene.duration = reader.number("duration", min, max);
    scene.frame_interval = reader.number("frame_interval", min, scene.duration);
}

LogOptions read_log(const JsonReader& reader) {
    LogOptions options;
    for (const std::string& name : reader.texts("log")) {
        bool* const wanted = name == log_names[0]   ? &options.forces
                             : name == log_names[1] ? &options.bodies
                                                    : nullptr;
        if (wanted == nullptr || *wanted)
            reader.refuse("log", "a list of 'forces' and 'bodies', each at most once");
        *wanted = true;
    }
    return options;
}

void read_shapes(const JsonReader& reader, const Frame& frame, Scene& scene) {
    for (const JsonReader& entry : reader.objects("fluid"))
        scene.fluid.push_back(read_body(entry, frame));
    if (scene.fluid.empty())
        reader.refuse("fluid", "a list with at least one body");
    if (reader.has("walls"))
        for (const JsonReader& entry : reader.objects("walls"))
            scene.walls.push_back(read_wall(entry, frame));
    if (reader.has("domain")) {
        const JsonReader domain = reader.object_at("domain");
        domain.expect_only({"low", "high"});
        scene.domain = read_corners(domain, frame);
    }
}

Scene scene_from(const JsonReader& reader, const std::filesystem::path& folder) {
    reader.expect_only(
        {"name",         "dimension",    "precision",       "particle_spacing", "support_radius",
         "rest_density", "volume_share", "duration",        "frame_interval",   "fluid",
         "walls",        "gravity",      "domain",          "leaving",          "kernel",
         "pressure",     "viscosity",    "surface_tension", "time_step",        "variants",
         "log"});
    Scene scene;
    scene.name = read_name(reader);
    take(reader, "dimension", 2, 3, scene.dimension);
    if (reader.has("precision"))
        scene.precision = reader.choice("precision", precision_names) == 0 ? Precision::float32
                                                                           : Precision::float64;
    read_numbers(reader, scene);
    const Frame frame{scene.dimension, folder};
    read_shapes(reader, frame, scene);
    if (reader.has("leaving"))
        scene.leaving = static_cast<Leaving>(reader.choice("leaving", leaving_names));
    take_place(reader, "gravity", frame, scene.gravity);
    if (reader.has("kernel"))
        scene.kernel = static_cast<KernelKind>(reader.choice("kernel", kernel_names));
    scene.pressure = read_pressure(reader.object_at("pressure"));
    if (reader.has("viscosity"))
        scene.viscosity = read_viscosity(reader.object_at("viscosity"));
    if (reader.has("surface_tension"))
        scene.surface_tension =
            read_tension(reader.object_at("surface_tension"), !scene.walls.empty());
    scene.time_step = reader.has("time_step")
                          ? read_time_step(reader.object_at("time_step"), scene.particle_spacing)
                          : default_time_step(scene.particle_spacing);
    if (reader.has("log"))
        scene.log = read_log(reader);
    return scene;
}

Json read_scene_json(const std::filesystem::path& file) {
    return parse_json(text_of_file(file, "a scene (JSON)"), file.string(), "a scene");
}

std::vector<std::string> variant_names(const Json& json, const std::filesystem::path& file) {
    std::vector<std::string> names;
    const JsonReader reader(json, file.string(), "");
    if (!reader.has("variants"))
        return names;
    const JsonReader variants = reader.object_at("variants");
    for (const auto& [name, patch] : reader.value("variants").items()) {
        const JsonReader changes = variants.object_at(name.c_str());
        for (const char* key : {"name", "dimension", "variants"})
            refuse_with(changes, key, "variants of a scene have that in common");
        names.push_back(name);
    }
    return names;
}

/// The scene's JSON with the variant's changes merged in (RFC 7396).
Json merged(const Json& json, const std::filesystem::path& file, const std::string& variant) {
    const std::vector<std::string> names = variant_names(json, file);
    if (variant.empty())
        return json;
    if (std::find(names.begin(), names.end(), variant) == names.end()) {
        std::string known;
        for (const std::string& name : names)
            known += (known.empty() ? "" : ", ") + name;
        throw InputError(file.string() + ": there is no variant " + quoted_text(variant) +
                         (names.empty() ? "; it has none"
                                        : "; did you mean '" + nearest_spelling(variant, names) +
                                              "'? It has: " + known));
    }
    Json scene = json;
    scene.merge_patch(json["variants"][variant]);
    return scene;
}

} // namespace

Scene read_scene(const std::filesystem::path& file, const std::string& variant,
                 const std::vector<std::string>& changes) {
    std::vector<std::string> left_out;
    return read_changed_scene(file, variant, changes, left_out);
}

Scene read_changed_scene(const std::filesystem::path& file, const std::string& variant,
                         const std::vector<std::string>& changes,
                         std::vector<std::string>& left_out) {
    const Json json = changed_json(merged(read_scene_json(file), file, variant), changes, left_out);
    const std::string shown_file =
        file.string() + (variant.empty() ? "" : ", variant '" + variant + "'");
    Scene scene = scene_from(JsonReader(json, shown_file, ""), file.parent_path());
    scene.variant = variant;
    std::filesystem::path& model = scene.surface_tension.model_file;
    if (!model.empty())
        model = file.parent_path() / model;
    return scene;
}

std::vector<std::string> scene_variants(const std::filesystem::path& file) {
    return variant_names(read_scene_json(file), file);
}

} // namespace meniscus
