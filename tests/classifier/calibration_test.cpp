#include <meniscus/classifier/curvature/calibration.hpp>
#include <meniscus/data/clouds/shapes.hpp>
#include <meniscus/data/text/errors.hpp>

#include <data/expected_errors.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace meniscus {
namespace {

using Json = nlohmann::ordered_json;

Json example() {
    return {
        {"format", "meniscus calibration"},
        {"format_version", 1},
        {"dimension", 3},
        {"radius_ratio", 0.8},
        {"fade", 0.03},
        {"tau", 0.5},
        {"normal_passes", 1},
        {"averaged", true},
        {"terms", {"constant", "turning"}},
        {"bias_penalty", 100},
        {"min_curvature", 0.1},
        {"samples", {0, 128}},
        {"seed", 1},
        {"clouds",
         {{"kind", "filled"},
          {"spacing_ratios", {2.0}},
          {"arrangements", {{{"kind", "lattice"}, {"jitter", 0.1}}}},
          {"particles", 100}}},
        {"shapes",
         {{{"kind", "torus"}, {"proportions", {2, 1}}, {"sizes", {0.4}}, {"sides", {"outside"}}}}}};
}

Json dense_example() {
    Json json = example();
    json["clouds"] = {{"kind", "dense"}, {"neighbors", 200}, {"candidates", 50}, {"repeats", 5}};
    json["shapes"][0]["places"] = {3, 0, 0};
    return json;
}

Calibration read(const Json& json) {
    return calibration_from_json(json.dump(), "clouds.json");
}

/// The example with the value at a JSON pointer replaced must be refused with that text.
void expect_refused(const std::string& place, const Json& value, const std::string& mention,
                    Json json = example()) {
    json[Json::json_pointer(place)] = value;
    expect_mentions(error_of<InputError>([&] { read(json); }), {"clouds.json", mention.c_str()});
}

TEST(CalibrationFile, IsReadAsItStands) {
    const Calibration calibration = read(example());
    EXPECT_EQ(calibration.dimension, 3);
    EXPECT_EQ(calibration.has_term, (std::vector<bool>{true, true, false, false}));
    EXPECT_EQ(calibration.samples, (std::vector<int>{0, 128}));
    EXPECT_FALSE(calibration.is_dense);
    ASSERT_EQ(calibration.filled.arrangements.size(), 1U);
    EXPECT_EQ(calibration.filled.arrangements[0].kind, Arrangement::lattice);
    EXPECT_EQ(calibration.filled.arrangements[0].jitter, 0.1);
    ASSERT_EQ(calibration.shapes.size(), 1U);
    EXPECT_EQ(calibration.shapes[0].sides[0], Side::outside);
    EXPECT_TRUE(read(dense_example()).is_dense);
    EXPECT_EQ(read(dense_example()).shapes[0].places[0][0], 3);
}

TEST(CalibrationFile, ThoseOfTheProjectAreRead) {
    for (const char* name : {"solver_like_3d", "solver_like_2d", "dense_3d"})
        EXPECT_FALSE(read_calibration(std::string(MENISCUS_CALIBRATIONS) + "/" + name + ".json")
                         .shapes.empty());
}

TEST(CalibrationFile, EveryKeyIsNeeded) {
    const Json json = example();
    for (const auto& item : json.items()) {
        Json without = json;
        without.erase(item.key());
        expect_mentions(error_of<InputError>([&] { read(without); }),
                        {"clouds.json", item.key().c_str()});
    }
}

TEST(CalibrationFile, RefusesWhatIsNotPlausible) {
    expect_refused("/format", "meniscus model", "is a model, not a calibration");
    expect_refused("/format_version", 2, "format_version");
    expect_refused("/dimension", 4, "dimension");
    expect_refused("/radius_ratio", -0.8, "radius_ratio");
    expect_refused("/radius_ratio", 1, "radius_ratio");
    expect_refused("/tau", 1.5, "tau");
    expect_refused("/normal_passes", 0.5, "normal_passes");
    expect_refused("/averaged", 1, "averaged");
    expect_refused("/terms", {"cubic"}, "terms");
    expect_refused("/terms", Json::array(), "terms");
    expect_refused("/samples", {3}, "samples");
    expect_refused("/samples", {128.5}, "samples");
    expect_refused("/min_curvature", 0, "min_curvature");
    expect_refused("/clouds", "filled", "clouds");
    expect_refused("/clouds/kind", "sparse", "clouds.kind");
    expect_refused("/clouds/spacing_ratios", {0.5}, "clouds.spacing_ratios");
    expect_refused("/clouds/spacing_ratios", Json::array(), "clouds.spacing_ratios");
    expect_refused("/clouds/arrangements/0/kind", "hexagonal", "clouds.arrangements[0].kind");
    expect_refused("/clouds/arrangements/0/jitter", 1, "clouds.arrangements[0].jitter");
    expect_refused("/clouds/particles", 1e9, "clouds.particles");
    expect_refused("/shapes", Json::array(), "shapes");
    expect_refused("/shapes/0/kind", "circle", "shapes[0].kind");
    expect_refused("/shapes/0/kind", "sphere", "shapes[0].proportions");
    expect_refused("/shapes/0/proportions", {2}, "shapes[0].proportions");
    expect_refused("/shapes/0/proportions", {1, 2}, "ring radius");
    expect_refused("/shapes/0/sizes", {-0.1}, "shapes[0].sizes");
    expect_refused("/shapes/0/sizes", {0}, "shapes[0].sizes");
    expect_refused("/shapes/0/sides", {"top"}, "shapes[0].sides");
    expect_refused("/shapes/0/places", {1, 0, 0}, "shapes[0].places");
    expect_refused("/shapes/0/places", {1, 0}, "shapes[0].places", dense_example());
    expect_refused("/clouds/repeats", 0, "clouds.repeats", dense_example());
    expect_refused("/spelling", 1, "spelling");
    expect_refused("/shapes/0/radius", 1, "radius");
}

TEST(CalibrationFile, RefusesWhatIsNoJson) {
    const auto error_of_text = [](const std::string& text) {
        return error_of<InputError>([&] { calibration_from_json(text, "clouds.json"); });
    };
    expect_mentions(error_of_text("{\"format\": "), {"clouds.json", "not a calibration"});
    expect_mentions(error_of_text("[]"), {"clouds.json", "object"});
    expect_mentions(error_of<InputError>([] { read_calibration("/nowhere/clouds.json"); }),
                    {"/nowhere/clouds.json", "solver_like_3d"});
}

TEST(CalibrationShapes, HaveTheCurvatureOfTheirSize) {
    const auto curvature = [](const CalibrationShape& shape, double size, Side side,
                              const std::array<double, 3>& place, int dimension = 3) {
        return nearest_surface_point(shape_of(shape, size, side, dimension), place).mean_curvature;
    };
    EXPECT_NEAR(curvature({"sphere", {}, {}, {}, {}}, 0.3, Side::inside, {9, 0, 0}), 0.3, 1e-12);
    EXPECT_NEAR(curvature({"sphere", {}, {}, {}, {}}, 0.3, Side::outside, {9, 0, 0}), -0.3, 1e-12);
    EXPECT_NEAR(curvature({"cylinder", {}, {}, {}, {}}, 0.3, Side::inside, {9, 0, 0}), 0.15, 1e-12);
    EXPECT_NEAR(curvature({"circle", {}, {}, {}, {}}, 0.3, Side::inside, {9, 0, 0}, 2), 0.3, 1e-12);
    EXPECT_NEAR(curvature({"paraboloid", {0.5, -0.5}, {}, {}, {}}, 0.3, Side::inside, {0, 0, 1}),
                0.3, 1e-12);
    EXPECT_NEAR(curvature({"ellipsoid", {1, 1, 1}, {}, {}, {}}, 0.3, Side::inside, {9, 0, 0}), 0.3,
                1e-12);
    EXPECT_NEAR(curvature({"torus", {3, 1}, {}, {}, {}}, 0.3, Side::inside, {99, 0, 0}),
                0.3 * (1 + 0.25) / 2, 1e-12);
}

} // namespace
} // namespace meniscus
