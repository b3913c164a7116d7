#include "data/test_folder.hpp"

#include <meniscus/classifier/curvature/curvature_model.hpp>
#include <meniscus/classifier/export/header_export.hpp>
#include <meniscus/classifier/torch/torch_plugin.hpp>
#include <meniscus/data/text/errors.hpp>

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace meniscus {
namespace {

using Json = nlohmann::ordered_json;

CurvatureModel example() {
    CurvatureModel model;
    model.map = {3, {-0.01, 1.06, -0.22, 0.125}, -0.5, 0.75};
    model.clouds = "filled";
    model.fade = 0.03;
    model.tau = 0.5;
    model.normal_passes = 1;
    model.spacing_ratio = {1.8, 2.7};
    model.bias_penalty = 100;
    model.min_curvature = 0.1;
    model.seed = 7;
    model.cloud_count = 12;
    model.particles = 3456;
    model.residuals = {{"sphere", "relaxed", 0.2, 400, 0.2, 0.001, 0.003, 0.01},
                       {"sphere", "lattice", 0.4, 400, 0.4, -0.02, 0.03, 0.02},
                       {"torus", "relaxed", 0.5, 400, 0.25, 0.01, 0.01, 0.02}};
    return model;
}

TEST(CurvatureModelFile, ReadsBackWhatWasWritten) {
    const std::string text = curvature_model_to_json(example());
    const CurvatureModel model = curvature_model_from_json(text, "curvature.json");
    EXPECT_EQ(curvature_model_to_json(model), text);
    EXPECT_EQ(model.map.coefficients[2], -0.22);
    EXPECT_EQ(model.residuals.size(), 3U);
    EXPECT_EQ(model.file, "curvature.json");
}

std::string error_with(const std::string& place, const Json& value) {
    Json json = Json::parse(curvature_model_to_json(example()));
    json[Json::json_pointer(place)] = value;
    return error_of<InputError>([&] { curvature_model_from_json(json.dump(), "curvature.json"); });
}

TEST(CurvatureModelFile, RefusesWhatIsNotPlausible) {
    expect_mentions(error_with("/format", "meniscus model"),
                    {"curvature.json", "is a model, not a curvature model"});
    expect_mentions(error_with("/format_version", 9), {"curvature.json", "'format_version'"});
    expect_mentions(error_with("/dimension", 1), {"'dimension'", "2 to 3"});
    expect_mentions(error_with("/radius_ratio", -0.8), {"'radius_ratio'", "-0.8"});
    expect_mentions(error_with("/coefficients/turning", "one"), {"'coefficients.turning'"});
    expect_mentions(error_with("/coefficients/turning", 1e9), {"'coefficients.turning'"});
    expect_mentions(error_with("/coefficients/cubic", 1), {"coefficients.cubic"});
    expect_mentions(error_with("/turning/min", 2), {"'turning'", "min"});
    expect_mentions(error_with("/turning", nullptr), {"'turning'"});
    expect_mentions(error_with("/spacing_ratio", nullptr), {"'spacing_ratio'"});
    expect_mentions(error_with("/averaged", "yes"), {"'averaged'", "true or false"});
    expect_mentions(error_with("/clouds", "thin"), {"'clouds'"});
    expect_mentions(error_with("/residuals/0/deviation", -1), {"'residuals[0].deviation'"});
}

TEST(CurvatureModelFile, EveryKeyIsNeeded) {
    const Json json = Json::parse(curvature_model_to_json(example()));
    for (const auto& item : json.items()) {
        Json without = json;
        without.erase(item.key());
        expect_mentions(error_of<InputError>(
                            [&] { curvature_model_from_json(without.dump(), "curvature.json"); }),
                        {"curvature.json", item.key().c_str(), "missing"});
    }
}

TEST(CurvatureModelFile, RefusesAnotherDimension) {
    check_dimension(example(), 3, "flat.vtkhdf");
    expect_mentions(error_of<InputError>([] { check_dimension(example(), 2, "flat.vtkhdf"); }),
                    {"3D", "flat.vtkhdf", "2D"});
}

using CurvatureHeader = TestFolder;

TEST_F(CurvatureHeader, CompilesAloneAndHoldsTheModel) {
    const auto file = write("map.hpp", coefficient_header(example(), "Map"));
    const auto check = write("check.cpp", "#include \"map.hpp\"\n#include \"map.hpp\"\n"
                                          "using meniscus::Map;\n"
                                          "static_assert(Map::dimension == 3);\n"
                                          "static_assert(Map::coefficients[0] == -0.01);\n"
                                          "static_assert(Map::coefficients[3] == 0.125);\n"
                                          "static_assert(Map::min == -0.5);\n"
                                          "static_assert(Map::max == 0.75);\n"
                                          "static_assert(Map::averaged);\n"
                                          "static_assert(Map::radius_ratio == 0.8);\n"
                                          "static_assert(Map::normal_passes == 1);\n"
                                          "static_assert(Map::max_spacing_ratio == 2.7);\n");
    for (const auto& source : {file, check})
        EXPECT_EQ(std::system((std::string(MENISCUS_CXX_COMPILER) +
                               " -std=c++17 -Wall -Wextra -Werror -fsyntax-only -x c++ '" +
                               source.string() + "'")
                                  .c_str()),
                  0);
}

TEST_F(CurvatureHeader, RefusesNamesAndNumbersThatAreNone) {
    for (const char* name : {"", "coefficients", "min", "int", "a-b"})
        expect_mentions(error_of<InputError>([&] { coefficient_header(example(), name); }), {name});
    CurvatureModel model = example();
    model.map.coefficients[1] = std::numeric_limits<double>::quiet_NaN();
    expect_mentions(error_of<InputError>([&] { coefficient_header(model, "Map"); }), {"finite"});
}

TEST(CurvatureResiduals, AreToldByShape) {
    const auto lines = residual_lines(example());
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0], "sphere, h/R 0.2 to 0.4: off by at most 0.03, +- 0.016");
    EXPECT_EQ(lines[1], "torus, h/R 0.5: off by at most 0.01, +- 0.02");
}

#if MENISCUS_TRAINER

/// Groups whose truth is 0.02 + 1.1 turning - 0.3 square, with errors of turning that cancel out.
std::vector<CurvatureGroup> known_groups(double noise) {
    std::vector<CurvatureGroup> groups;
    for (const double curvature : {-0.5, -0.2, 0.1, 0.3, 0.6})
        for (const double spread : {0.0, 0.2}) {
            CurvatureGroup group;
            group.shape = "sphere";
            group.size = std::fabs(curvature);
            group.spacing_ratio = 2;
            group.clouds = 1;
            const double square = curvature * curvature + spread;
            for (const double sign : {-1.0, 1.0, -0.5, 0.5})
                group.samples.push_back({curvature + sign * noise, square, 0,
                                         0.02 + 1.1 * curvature - 0.3 * square, 1});
            groups.push_back(group);
        }
    return groups;
}

Calibration known_calibration(double bias_penalty) {
    Calibration calibration;
    calibration.has_term = {true, true, true, false};
    calibration.bias_penalty = bias_penalty;
    calibration.min_curvature = 0.1;
    return calibration;
}

TEST(CurvatureTrainer, FindsTheCoefficientsThatAreThere) {
    const CurvatureModel model = fit_curvature_model(known_groups(0), known_calibration(1));
    EXPECT_NEAR(model.map.coefficients[0], 0.02, 1e-6);
    EXPECT_NEAR(model.map.coefficients[1], 1.1, 1e-5);
    EXPECT_NEAR(model.map.coefficients[2], -0.3, 1e-6);
    EXPECT_EQ(model.map.coefficients[3], 0);
    EXPECT_NEAR(model.map.min, -0.5, 1e-6);
    EXPECT_NEAR(model.map.max, 0.6, 1e-6);
    EXPECT_EQ(model.particles, 40U);
    EXPECT_EQ(model.cloud_count, 10U);
}

TEST(CurvatureTrainer, BiasPenaltyKeepsNoiseFromShrinkingTheSlope) {
    const auto slope = [](double penalty) {
        return fit_curvature_model(known_groups(0.4), known_calibration(penalty))
            .map.coefficients[1];
    };
    EXPECT_LT(slope(1), 0.9);
    EXPECT_NEAR(slope(1e4), 1.1, 0.01);
}

TEST(CurvatureTrainer, ReportsWhatIsLeft) {
    const CurvatureModel model = fit_curvature_model(known_groups(0.1), known_calibration(1e6));
    ASSERT_EQ(model.residuals.size(), 5U); // the two spreads of each size in one row
    for (const CurvatureResidual& row : model.residuals) {
        EXPECT_EQ(row.particles, 8U);
        EXPECT_NEAR(row.bias, 0, 1e-3);
        EXPECT_NEAR(row.deviation, 1.1 * 0.1 * std::sqrt(0.625), 1e-3);
    }
}

TEST(CurvatureTrainer, RefusesToFitNothing) {
    expect_mentions(error_of<InputError>([] { fit_curvature_model({}, known_calibration(1)); }),
                    {"no cloud"});
}

#else

TEST(CurvatureTrainer, WithoutTorchItSaysSo) {
    expect_mentions(
        error_of<FailureError>([] { calibrate(Calibration(), [](std::size_t, std::size_t) {}); }),
        {"calibrate", "libtorch"});
}

#endif

} // namespace
} // namespace meniscus
