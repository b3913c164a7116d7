#include <meniscus/sph/scene/scene.hpp>

#include "data/test_folder.hpp"
#include "runtime/option_values.hpp"

#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/text/errors.hpp>

#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace meniscus {
namespace {

using Change = std::function<void(Json&)>;

const char* smallest_scene = R"({
  "name": "small", "particle_spacing": 0.1, "duration": 2, "frame_interval": 0.5,
  "fluid": [{"box": {"low": [0, 0, 0], "high": [0.4, 0.4, 0.4]}}],
  "pressure": {"solver": "dfsph"}
})";

const char* full_scene = R"({
  "name": "full-2", "dimension": 3, "precision": "double", "particle_spacing": 0.1,
  "support_radius": 0.25, "rest_density": 900, "volume_share": 0.8, "duration": 2,
  "frame_interval": 0.5,
  "fluid": [
    {"lattice": {"first": [1, 2, 3], "count": [4, 5, 6]}, "velocity": [0, -1, 0.5]},
    {"box": {"low": [5, 0, 0], "high": [5.4, 0.4, 0.4]}},
    {"ball": {"center": [10, 0, 0], "radius": 0.5}},
    {"ball": {"center": [12, 0, 0], "half_axes": [0.5, 0.4, 0.3]}},
    {"snapshot": {"file": "drop.vtkhdf", "translation": [0, 20, 0]}}
  ],
  "walls": [
    {"box": {"low": [-5, -5, -5], "high": [20, 20, 20], "open": ["+z", "-x"]}},
    {"ball": {"center": [0, 0, 0], "radius": 0.3}},
    {"mesh": {"file": "glass.obj", "scale": 2, "translation": [1, 0, 0]}}
  ],
  "gravity": [0, -9.81, 0], "domain": {"low": [-50, -50, -50], "high": [50, 50, 50]},
  "kernel": "mueller",
  "pressure": {"solver": "iisph", "density_error": 0.01, "min_iterations": 3,
               "max_iterations": 50, "clip_negative": false, "relaxation": 0.4,
               "accelerate": false},
  "viscosity": {"kinematic": 0.02, "density_correction": true, "xsph": 0.1},
  "surface_tension": {"model": "meniscus", "coefficient": 3, "samples": 64, "verification": "exact",
                      "balance_momentum": false, "contact_friction": 0.5, "ripple_damping": 0.25, "k": 74.7, "d": 28, "paper": true},
  "time_step": {"courant_factor": 0.5, "min": 0.0001, "max": 0.002},
  "variants": {
    "large": {"particle_spacing": 0.05, "pressure": {"density_error": 0.001}},
    "still": {"gravity": null, "surface_tension": null}
  }
})";

const char* flat_scene = R"({
  "name": "flat", "dimension": 2, "particle_spacing": 0.1, "duration": 2, "frame_interval": 0.5,
  "fluid": [{"lattice": {"first": [1, 2], "count": [4, 5]}, "velocity": [1, 2]},
            {"ball": {"center": [5, 0, 0], "half_axes": [1, 2]}}],
  "walls": [{"box": {"low": [-1, -1], "high": [9, 9], "open": ["+y"]}}],
  "gravity": [0, -9.81], "pressure": {"solver": "wcsph", "sound_speed": 88}
})";

class SceneFile : public TestFolder {
protected:
    Scene scene(const std::string& text, const std::string& variant = "") const {
        return read_scene(write("some.json", text), variant);
    }

    /// The error from a scene after a change.
    std::string error(const char* text, const Change& change,
                      const std::string& variant = "") const {
        Json json = Json::parse(text);
        change(json);
        std::string message = error_of<InputError>([&] { scene(json.dump(), variant); });
        EXPECT_NE(message.find("some.json"), std::string::npos) << message;
        return message;
    }

    /// The error where the value at a place of the full scene is another.
    std::string error_with(const std::string& place, const Json& value) const {
        return error(full_scene, [&](Json& json) { json[Json::json_pointer(place)] = value; });
    }
};

TEST_F(SceneFile, LeavesOutWhatIsNotNamed) {
    const Scene read = scene(smallest_scene);
    EXPECT_EQ(read.name, "small");
    EXPECT_EQ(read.variant, "");
    EXPECT_EQ(read.dimension, 3);
    EXPECT_EQ(read.precision, Precision::float32);
    EXPECT_EQ(read.support_radius, 0.2);
    EXPECT_EQ(read.rest_density, 1000);
    EXPECT_EQ(read.volume_share, 1);
    EXPECT_TRUE(read.walls.empty());
    EXPECT_EQ(read.gravity, Place{});
    EXPECT_FALSE(read.domain);
    EXPECT_EQ(read.kernel, KernelKind::cubic_spline);
    EXPECT_EQ(read.pressure.density_error, 0.0005);
    EXPECT_EQ(read.viscosity.kinematic, 0);
    EXPECT_EQ(read.viscosity.xsph, 0);
    EXPECT_EQ(read.surface_tension.model, "none");
    EXPECT_FALSE(read.time_step.fixed);
}

TEST_F(SceneFile, ReadsEveryValue) {
    const Scene read = scene(full_scene);
    EXPECT_EQ(read.name, "full-2");
    EXPECT_EQ(read.precision, Precision::float64);
    EXPECT_EQ(read.particle_spacing, 0.1);
    EXPECT_EQ(read.support_radius, 0.25);
    EXPECT_EQ(read.rest_density, 900);
    EXPECT_EQ(read.volume_share, 0.8);
    EXPECT_EQ(read.duration, 2);
    EXPECT_EQ(read.frame_interval, 0.5);
    EXPECT_EQ(read.gravity, (Place{0, -9.81, 0}));
    EXPECT_EQ((*read.domain)[1], (Place{50, 50, 50}));
    EXPECT_EQ(read.kernel, KernelKind::mueller);
    EXPECT_EQ(read.pressure.solver, "iisph");
    EXPECT_EQ(read.pressure.density_error, 0.01);
    EXPECT_EQ(read.pressure.min_iterations, 3);
    EXPECT_EQ(read.pressure.max_iterations, 50);
    EXPECT_FALSE(read.pressure.clip_negative);
    EXPECT_EQ(read.pressure.relaxation, 0.4);
    EXPECT_FALSE(read.pressure.accelerate);
    EXPECT_EQ(read.viscosity.kinematic, 0.02);
    EXPECT_TRUE(read.viscosity.density_correction);
    EXPECT_EQ(read.viscosity.xsph, 0.1);
    EXPECT_EQ(read.surface_tension.model, "meniscus");
    EXPECT_EQ(read.surface_tension.coefficient, 3);
    EXPECT_FALSE(read.surface_tension.balance_momentum);
    EXPECT_EQ(read.surface_tension.contact_friction, 0.5);
    EXPECT_EQ(read.surface_tension.ripple_damping, 0.25);
    EXPECT_EQ(read.surface_tension.surface.samples, 64U);
    EXPECT_EQ(read.surface_tension.surface.verification, Verification::exact);
    EXPECT_EQ(read.surface_tension.surface.k, 74.7);
    EXPECT_EQ(read.surface_tension.surface.d, 28);
    EXPECT_EQ(read.surface_tension.surface.force, ForceForm::paper); // the paper's choice
    EXPECT_EQ(read.time_step.courant_factor, 0.5);
    EXPECT_EQ(read.time_step.min, 0.0001);
    EXPECT_EQ(read.time_step.max, 0.002);
}

TEST_F(SceneFile, ReadsEveryShape) {
    const Scene read = scene(full_scene);
    ASSERT_EQ(read.fluid.size(), 5U);
    const auto& lattice = std::get<LatticeShape>(read.fluid[0].shape);
    EXPECT_EQ(lattice.first, (Place{1, 2, 3}));
    EXPECT_EQ(lattice.count, (std::array<int, 3>{4, 5, 6}));
    EXPECT_EQ(read.fluid[0].velocity, (Place{0, -1, 0.5}));
    EXPECT_EQ(std::get<BoxShape>(read.fluid[1].shape).high, (Place{5.4, 0.4, 0.4}));
    EXPECT_EQ(std::get<SphereShape>(read.fluid[2].shape).half_axes, (Place{0.5, 0.5, 0.5}));
    EXPECT_EQ(std::get<SphereShape>(read.fluid[3].shape).half_axes, (Place{0.5, 0.4, 0.3}));
    const auto& snapshot = std::get<SnapshotShape>(read.fluid[4].shape);
    EXPECT_EQ(snapshot.file, folder / "drop.vtkhdf");
    EXPECT_EQ(snapshot.translation, (Place{0, 20, 0}));
    ASSERT_EQ(read.walls.size(), 3U);
    EXPECT_EQ(std::get<BoxShape>(read.walls[0].shape).open, (std::vector<std::string>{"-x", "+z"}));
    EXPECT_EQ(std::get<SphereShape>(read.walls[1].shape).half_axes, (Place{0.3, 0.3, 0.3}));
    const auto& mesh = std::get<MeshShape>(read.walls[2].shape);
    EXPECT_EQ(mesh.file, folder / "glass.obj");
    EXPECT_EQ(mesh.scale, 2);
    EXPECT_EQ(mesh.translation, (Place{1, 0, 0}));
}

TEST_F(SceneFile, PlacesInThePlaneHaveTwoNumbersOrThree) {
    const Scene read = scene(flat_scene);
    EXPECT_EQ(std::get<LatticeShape>(read.fluid[0].shape).first, (Place{1, 2, 0}));
    EXPECT_EQ(std::get<LatticeShape>(read.fluid[0].shape).count, (std::array<int, 3>{4, 5, 1}));
    EXPECT_EQ(read.fluid[0].velocity, (Place{1, 2, 0}));
    EXPECT_EQ(std::get<SphereShape>(read.fluid[1].shape).half_axes, (Place{1, 2, 0}));
    EXPECT_EQ(read.gravity, (Place{0, -9.81, 0}));
    EXPECT_EQ(read.pressure.sound_speed, 88);
    expect_mentions(error(flat_scene,
                          [](Json& json) {
                              json["gravity"] = {0, 0, -1};
                          }),
                    {"'gravity'", "two numbers"});
    expect_mentions(error(flat_scene,
                          [](Json& json) {
                              json["fluid"][0]["lattice"]["count"] = {1, 1, 2};
                          }),
                    {"'fluid[0].lattice.count'"});
    expect_mentions(error(flat_scene, [](Json& json) { json["walls"][0]["box"]["open"] = {"+z"}; }),
                    {"'walls[0].box.open'", "-x, +x, -y, +y, found"});
    expect_mentions(error(flat_scene,
                          [](Json& json) {
                              json["walls"][0] = {{"mesh", {{"file", "a"}}}};
                          }),
                    {"'walls[0].mesh'", "three dimensions"});
}

TEST_F(SceneFile, VariantsAreMergedIn) {
    EXPECT_EQ(scene_variants(write("some.json", full_scene)),
              (std::vector<std::string>{"large", "still"}));
    EXPECT_TRUE(scene_variants(write("some.json", smallest_scene)).empty());
    const Scene large = scene(full_scene, "large");
    EXPECT_EQ(large.variant, "large");
    EXPECT_EQ(large.particle_spacing, 0.05);
    EXPECT_EQ(large.pressure.density_error, 0.001);
    EXPECT_EQ(large.pressure.relaxation, 0.4);
    const Scene still = scene(full_scene, "still");
    EXPECT_EQ(still.gravity, Place{});
    EXPECT_EQ(still.surface_tension.model, "none");
    EXPECT_EQ(still.particle_spacing, 0.1);
}

TEST_F(SceneFile, NamesTheVariantsThatThereAre) {
    const auto nothing = [](Json&) {};
    expect_mentions(error(full_scene, nothing, "larg"),
                    {"'larg'", "did you mean 'large'", "still"});
    expect_mentions(error(smallest_scene, nothing, "paper"), {"'paper'", "has none"});
    expect_mentions(error(
                        full_scene, [](Json& j) { j["variants"]["large"]["gravty"] = 1; }, "large"),
                    {"variant 'large'", "'gravty'", "did you mean 'gravity'"});
    for (const char* key : {"name", "dimension", "variants"})
        expect_mentions(error(full_scene, [&](Json& j) { j["variants"]["large"][key] = 2; }),
                        {"variants.large", key});
    expect_mentions(error_with("/variants/large", 3), {"'variants.large'", "object"});
}

TEST_F(SceneFile, NamesTheNearestSpellingOfEachWrongKey) {
    const std::vector<std::array<const char*, 3>> wrong{
        {"/gavity", "'gavity'", "'gravity'"},
        {"/viscocity", "'viscocity'", "'viscosity'"},
        {"/fluid/0/lattise", "'fluid[0].lattise'", "'lattice'"},
        {"/fluid/0/lattice/cuont", "'fluid[0].lattice.cuont'", "'count'"},
        {"/fluid/1/box/open", "'fluid[1].box.open'", "'low'"},
        {"/fluid/2/ball/centre", "'fluid[2].ball.centre'", "'center'"},
        {"/fluid/4/snapshot/files", "'fluid[4].snapshot.files'", "'file'"},
        {"/walls/0/boxes", "'walls[0].boxes'", "'box'"},
        {"/walls/0/box/opened", "'walls[0].box.opened'", "'open'"},
        {"/walls/2/mesh/scales", "'walls[2].mesh.scales'", "'scale'"},
        {"/domain/hihg", "'domain.hihg'", "'high'"},
        {"/pressure/solvr", "'pressure.solvr'", "'solver'"},
        {"/viscosity/cinematic", "'viscosity.cinematic'", "'kinematic'"},
        {"/surface_tension/coeficient", "'surface_tension.coeficient'", "'coefficient'"},
        {"/time_step/fixd", "'time_step.fixd'", "'fixed'"}};
    for (const auto& [place, named, nearest] : wrong)
        expect_mentions(error_with(place, 1), {named, nearest, "did you mean", "Keys here: "});
}

TEST_F(SceneFile, NamesWhatIsOutOfRange) {
    const double huge = 1e300;
    const std::vector<std::pair<const char*, std::vector<Json>>> wrong{
        {"/name", {"", "a/b", "two words", std::string(101, 'a'), 1}},
        {"/dimension", {1, 4, 2.5, "3"}},
        {"/precision", {"half", 32}},
        {"/particle_spacing", {0, -1, huge, nullptr, "0.1"}},
        {"/support_radius", {0, 0.1, 0.7, -1}},
        {"/rest_density", {0, -1, huge}},
        {"/volume_share", {0, 0.05, 2.1}},
        {"/duration", {0, -1, huge}},
        {"/frame_interval", {0, -1, 2.1}},
        {"/fluid", {1, Json::array()}},
        {"/fluid/0/velocity",
         {1, {1, 2}, {1, 2, 3, 4}, {1, 2, "3"}, {1, 2, huge}, {1, 2, nullptr}}},
        {"/fluid/0/lattice/first", {1, {1, 2}, {1, 2, huge}}},
        {"/fluid/0/lattice/count", {1, {1, 2}, {1, 2, 0}, {1, 2, 2.5}, {1, 2, -3}, {1, 2, 1e6}}},
        {"/fluid/1/box/high", {{4, 1, 1}, {5, 1, 1}, 1}},
        {"/fluid/2/ball/radius", {0, -1, huge}},
        {"/fluid/3/ball/half_axes", {{1, 1, 0}, {1, -1, 1}, {1, 1}}},
        {"/fluid/4/snapshot/file", {"", 1, std::string("a\0b", 3)}},
        {"/walls", {1}},
        {"/walls/0/box/open", {{"x"}, {"+x", "+x"}, {1}, {"-x", "+x", "-y", "+y", "-z", "+z"}}},
        {"/walls/2/mesh/scale", {0, -1, huge}},
        {"/walls/0/contact_angle", {0, 9, 171, "90"}},
        {"/surface_tension/contact_friction", {-1, 2.5, "1"}},
        {"/surface_tension/ripple_damping", {-1, 1.5, "1"}},
        {"/leaving", {"go", 1}},
        {"/domain/high", {{-60, 1, 1}}},
        {"/kernel", {"cubic", 1}},
        {"/log", {"forces", {"force"}, {"forces", "forces"}, 1}},
        {"/pressure/solver", {"sph", 1}},
        {"/pressure/density_error", {0, -1, 0.6}},
        {"/pressure/min_iterations", {-1, 51, 2.5}},
        {"/pressure/max_iterations", {0, 1e9}},
        {"/pressure/clip_negative", {1, "yes"}},
        {"/pressure/relaxation", {0, 1.1}},
        {"/pressure/accelerate", {1}},
        {"/viscosity/kinematic", {-1, huge}},
        {"/viscosity/density_correction", {1}},
        {"/viscosity/xsph", {-0.1, 1.1}},
        {"/surface_tension/model", {"none", "akinci", 1}},
        {"/surface_tension/coefficient", {-1, huge}},
        {"/surface_tension/samples", {3, 1e9, 10.5, "64"}},
        {"/surface_tension/seed", {-1, 0.5, 1e20, true}},
        {"/surface_tension/k", {huge, "1"}},
        {"/surface_tension/verification", {true, "verify"}},
        {"/surface_tension/paper", {1}},
        {"/time_step/courant_factor", {0, 11}},
        {"/time_step/smallest", {0, 0.003}},
        {"/time_step/largest", {0, 2}}};
    for (const auto& [place, values] : wrong)
        for (const Json& value : values) {
            const std::string key = Json::json_pointer(place).back();
            expect_mentions(error_with(place, value), {key.c_str()});
        }
}

TEST_F(SceneFile, NamesEachMissingKey) {
    for (const char* key :
         {"name", "particle_spacing", "duration", "frame_interval", "fluid", "pressure"})
        expect_mentions(error(smallest_scene, [&](Json& json) { json.erase(key); }),
                        {key, "missing"});
    const std::vector<std::pair<const char*, const char*>> inner{
        {"/pressure", "solver"},
        {"/surface_tension", "model"},
        {"/surface_tension", "coefficient"},
        {"/fluid/0/lattice", "first"},
        {"/fluid/1/box", "low"},
        {"/fluid/2/ball", "center"},
        {"/fluid/4/snapshot", "file"},
        {"/walls/2/mesh", "file"},
        {"/domain", "low"}};
    for (const auto& [place, key] : inner)
        expect_mentions(error(full_scene,
                              [place = place, key = key](Json& json) {
                                  json[Json::json_pointer(place)].erase(key);
                              }),
                        {key, "missing"});
}

TEST_F(SceneFile, NamesKeysThatContradictEachOther) {
    expect_mentions(error_with("/time_step/fixed", 0.001), {"'time_step.courant_factor'", "fixed"});
    expect_mentions(error_with("/pressure/sound_speed", 88), {"'pressure.sound_speed'", "iisph"});
    expect_mentions(error_with("/pressure/divergence_error", 0.1),
                    {"'pressure.divergence_error'", "iisph"});
    expect_mentions(error_with("/pressure/solver", "pcisph"), {"'pressure.relaxation'", "pcisph"});
    expect_mentions(error_with("/pressure", {{"solver", "wcsph"}}), {"sound_speed", "missing"});
    expect_mentions(error_with("/pressure",
                               {{"solver", "wcsph"}, {"sound_speed", 88}, {"density_error", 0.01}}),
                    {"'pressure.density_error'", "wcsph"});
    expect_mentions(error_with("/surface_tension/model", "akinci_2013"),
                    {"'surface_tension.balance_momentum'", "meniscus alone"});
    expect_mentions(error_with("/surface_tension/coverage", "exact"),
                    {"'surface_tension.samples'", "coverage exact"});
    expect_mentions(error_with("/surface_tension/verify", false),
                    {"'surface_tension.verify'", "now named 'verification'"});
    expect_mentions(error_with("/surface_tension/restrict_to_surface", true),
                    {"'surface_tension.restrict_to_surface'"});
    expect_mentions(error(full_scene, [](Json& json) { json["surface_tension"].erase("d"); }),
                    {"'surface_tension.d'", "both"});
    expect_mentions(error_with("/viscosity/kinematic", 0), {"'viscosity.density_correction'"});
    expect_mentions(error_with("/fluid/2/ball/half_axes", {1, 1, 1}), {"'fluid[2].ball.radius'"});
    expect_mentions(error_with("/fluid/1/ball", Json::object()), {"'fluid[1].ball'", "'box'"});
    expect_mentions(error(full_scene, [](Json& json) { json["fluid"][1].erase("box"); }),
                    {"'fluid[1].lattice'", "another shape"});
}

TEST_F(SceneFile, RefusesWhatIsNoScene) {
    for (const char* text : {"", "{", "[]", "3", "null", "{\"name\": 1e999}", "\xff\xfe"})
        expect_mentions(error_of<InputError>([&] { scene(text); }), {"some.json"});
    expect_mentions(error_of<InputError>([&] { read_scene(folder / "none.json", ""); }),
                    {"none.json", "scene"});
    expect_mentions(error_of<InputError>([&] { read_scene(folder, ""); }), {"cannot be read"});
}

TEST_F(SceneFile, TextTellsScenesApartAndNothingElse) {
    write("glass.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("drop.vtkhdf", "any bytes");
    const std::string text = scene_text(scene(full_scene));
    EXPECT_EQ(text, scene_text(scene(full_scene)));
    EXPECT_EQ(text.find(folder.string()), std::string::npos) << text;

    Json reordered = Json::parse(full_scene);
    const Json pressure = reordered["pressure"];
    reordered.erase("pressure");
    reordered["pressure"] = pressure;
    reordered["walls"][0]["box"]["open"] = {"-x", "+z"};
    reordered["gravity"] = {-0.0, -9.81, 0.0};
    reordered.erase("variants");
    reordered["dimension"] = 3.0;
    EXPECT_EQ(text, scene_text(scene(reordered.dump())));

    write("glass.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_NE(text, scene_text(scene(full_scene)));
}

TEST_F(SceneFile, SamplesFollowTheTimeStepWhereADensityStandsInTheirPlace) {
    Json json = Json::parse(smallest_scene);
    json["surface_tension"] = {
        {"model", "meniscus"}, {"coefficient", 1}, {"sampling_density", 10000}, {"min_samples", 8}};
    const Scene read = scene(json.dump());
    EXPECT_EQ(read.surface_tension.sampling_density, 10000);
    EXPECT_EQ(read.surface_tension.min_samples, 8);
    EXPECT_NE(scene_text(read).find("\"sampling_density\":10000"), std::string::npos);
    const auto error_in = [&](const char* key, const Json& value) {
        return error(json.dump().c_str(),
                     [&](Json& changed) { changed["surface_tension"][key] = value; });
    };
    expect_mentions(error_in("samples", 64), {"'surface_tension.samples'", "sampling_density"});
    expect_mentions(error_in("sampling_density", 0), {"'surface_tension.min_samples'"});
    expect_mentions(error_in("coverage", "exact"), {"'surface_tension.sampling_density'", "exact"});
    expect_mentions(error_in("min_samples", 3), {"'surface_tension.min_samples'"});
}

TEST_F(SceneFile, AirPressesMoreAtWallsAndNotWithThePapersChoices) {
    const auto pressure_of = [&](const Change& change) {
        Json json = Json::parse(full_scene);
        change(json);
        return scene(json.dump()).surface_tension.surface.ambient_pressure;
    };
    EXPECT_EQ(pressure_of([](Json&) {}), 0);
    const auto own = [](Json& json) { json["surface_tension"].erase("paper"); };
    EXPECT_EQ(pressure_of(own), default_ambient_pressure(true));
    EXPECT_EQ(pressure_of([&](Json& json) {
                  own(json);
                  json.erase("walls");
              }),
              default_ambient_pressure(false));
    EXPECT_EQ(pressure_of([](Json& json) { json["surface_tension"]["ambient_pressure"] = 0.25; }),
              0.25);
}

TEST_F(SceneFile, SaysWhatTheLogHas) {
    Json json = Json::parse(smallest_scene);
    const std::string plain = scene_text(scene(json.dump()));
    json["log"] = {"bodies"};
    const Scene read = scene(json.dump());
    EXPECT_TRUE(read.log.bodies);
    EXPECT_FALSE(read.log.forces);
    EXPECT_NE(scene_text(read), plain);
}

TEST_F(SceneFile, TextChangesWithEveryValue) {
    write("glass.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("drop.vtkhdf", "any bytes");
    const std::string text = scene_text(scene(full_scene));
    Json flat = Json::parse(full_scene);
    flat.erase("variants");
    const Json values = flat.flatten();
    for (const auto& [place, value] : values.items()) {
        if (place == "/dimension" || place.find("/file") != std::string::npos ||
            place == "/pressure/solver" || place == "/surface_tension/model")
            continue;
        Json changed = flat;
        Json& entry = changed[Json::json_pointer(place)];
        if (value.is_boolean())
            entry = !value.get<bool>();
        else if (value.is_number_integer())
            entry = value.get<int>() + (place.find("/low/") != std::string::npos ? -1 : 1);
        else if (value.is_number())
            entry = value.get<double>() * 0.99;
        else if (place == "/name")
            entry = "other";
        else if (place == "/precision")
            entry = "single";
        else if (place == "/kernel")
            entry = "cubic_spline";
        else if (place == "/surface_tension/verification")
            entry = "drop";
        else
            entry = "-y"; // open sides
        EXPECT_NE(text, scene_text(scene(changed.dump()))) << place;
    }
}

/// The full scene with the options of the paper or the project, and one of its own.
template <class Value>
std::string with_option(bool paper, const SurfaceOption<Value>& option, Value value) {
    Json json = Json::parse(full_scene);
    Json& section = json["surface_tension"];
    section = {{"model", "meniscus"}, {"coefficient", 3}, {"paper", paper}, {"k", 40}, {"d", 18}};
    if constexpr (std::is_enum_v<Value>)
        section[option.name] = option.range.words[static_cast<int>(value)];
    else
        section[option.name] = value;
    return json.dump();
}

TEST_F(SceneFile, HasTheOptionsOfTheTable) {
    write("glass.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("drop.vtkhdf", "any bytes");
    std::set<std::string> texts;
    std::size_t scenes = 0;
    for (const bool paper : {false, true})
        for_each_surface_option([&](const auto& option) {
            auto expected = paper ? paper_options() : SurfaceTensionOptions{};
            set_line(expected, {40, 18});
            if (!paper)
                expected.ambient_pressure =
                    default_ambient_pressure(true); // the full scene has walls
            set_other(option, expected);
            const std::string text = with_option(paper, option, expected.*option.member);
            if (option.name == std::string("surface_tension") ||
                option.name == std::string("spacing_ratio")) { // from coefficient and spacing
                expect_mentions(error_of<InputError>([&] { scene(text); }), {option.name});
                return;
            }
            const Scene read = scene(text);
            for_each_surface_option([&](const auto& other) {
                EXPECT_EQ(read.surface_tension.surface.*other.member, expected.*other.member)
                    << option.name << ' ' << other.name;
            });
            texts.insert(scene_text(read));
            ++scenes;
        });
    EXPECT_EQ(texts.size(), scenes);
    EXPECT_GT(scenes, 25U);
}

TEST_F(SceneFile, NamesTheRangeOfEachOption) {
    for_each_surface_option([&](const auto& option) {
        if (option.name == std::string("surface_tension") ||
            option.name == std::string("spacing_ratio"))
            return;
        for (const auto value : values_out_of_range(option)) {
            if constexpr (std::is_enum_v<std::decay_t<decltype(value)>>)
                continue; // other words are refused above
            else {
                const std::string message =
                    error_of<InputError>([&] { scene(with_option(false, option, value)); });
                expect_mentions(message, {option.name, option.range.text});
            }
        }
    });
}

TEST_F(SceneFile, RandomlyChangedTextIsReadOrRefused) {
    std::mt19937 generator(6);
    const std::string letters = "{}[]\",:0123456789.-e ntfalsue\\\n";
    int read = 0;
    for (int k = 0; k < 500; ++k) {
        std::string text = full_scene;
        for (int change = 0; change < 1 + k % 4; ++change)
            text[generator() % text.size()] = letters[generator() % letters.size()];
        try {
            scene(text, k % 2 == 0 ? "large" : "");
            ++read;
        } catch (const InputError&) {
        }
    }
    EXPECT_GT(read, 5);
    EXPECT_LT(read, 480);
}

} // namespace
} // namespace meniscus
