// The headers in runtime/coefficients/ are what the models in configs/models/ export to.
#include <meniscus/classifier/export/header_export.hpp>
#include <meniscus/classifier/model/model.hpp>
#include <meniscus/runtime/coefficients/surface_2d_wide.hpp>
#include <meniscus/runtime/coefficients/surface_3d.hpp>
#include <meniscus/runtime/coefficients/surface_3d_strict.hpp>
#include <meniscus/runtime/coefficients/surface_3d_wide.hpp>
#include <meniscus/runtime/surface/shipped_curvature_map.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>

namespace meniscus {
namespace {

Model shipped(const std::string& name) {
    return read_model(std::string(MENISCUS_MODELS) + "/" + name + ".json");
}

std::string runtime_header(const std::string& name) {
    std::ifstream stream(std::string(MENISCUS_RUNTIME) + "/coefficients/" + name + ".hpp",
                         std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ShippedModels, HeadersAreExportedFromThem) {
    EXPECT_EQ(coefficient_header(shipped("surface_3d_strict"), "Surface3DStrict"),
              runtime_header("surface_3d_strict"));
    for (const std::string dimension : {"2", "3"})
        for (const auto& [file, name] :
             {std::pair{"", ""}, {"_wide", "Wide"}, {"_widest", "Widest"}}) {
            const std::string model = "surface_" + dimension + "d" + file;
            EXPECT_EQ(coefficient_header(shipped(model), "Surface" + dimension + "D" + name),
                      runtime_header(model));
        }
}

CurvatureModel shipped_curvature(const std::string& name) {
    return read_curvature_model(std::string(MENISCUS_MODELS) + "/" + name + ".json");
}

TEST(ShippedModels, CurvatureHeadersAreExportedFromThem) {
    EXPECT_EQ(coefficient_header(shipped_curvature("curvature_3d"), "Curvature3D"),
              runtime_header("curvature_3d"));
    EXPECT_EQ(coefficient_header(shipped_curvature("curvature_2d"), "Curvature2D"),
              runtime_header("curvature_2d"));
}

TEST(ShippedModels, CurvatureMapsSayWhatTheModelsSay) {
    for (const int dimension : {2, 3}) {
        const CurvatureModel model =
            shipped_curvature("curvature_" + std::to_string(dimension) + "d");
        const CurvatureMap map = shipped_curvature_map(dimension);
        EXPECT_EQ(map.dimension, dimension);
        for (int term = 0; term < CurvatureMap::terms; ++term)
            EXPECT_EQ(map.coefficients[term], model.map.coefficients[term]);
        EXPECT_EQ(map.min, model.map.min);
        EXPECT_EQ(map.max, model.map.max);
        EXPECT_TRUE(map.averaged);
    }
}

TEST(ShippedModels, HeadersSayWhatTheModelsSay) {
    EXPECT_EQ(shipped("surface_3d").line.k, Surface3D::k);
    EXPECT_EQ(shipped("surface_3d").line.d, Surface3D::d);
    EXPECT_EQ(Surface3DStrict::label_threshold, 0);
    EXPECT_EQ(Surface2D::dimension, 2);
    EXPECT_NEAR(Surface3DWide::min_spacing_ratio, 2.5, 1e-9);
}

/// The options of the runtime at so many spacings, made of a header and of a model.
template <int Dimension>
void expect_classifier_of(const std::string& name, double spacing_ratio) {
    for (SurfaceTensionOptions options : {SurfaceTensionOptions{}, paper_options()}) {
        options.spacing_ratio = spacing_ratio;
        const SurfaceTensionOptions found = completed(options, Dimension);
        set_classifier(options, shipped(name));
        EXPECT_NEAR(found.k, options.k, 1e-9 * options.k) << name;
        EXPECT_NEAR(found.d, options.d, 1e-9 * options.d);
        EXPECT_EQ(found.boundary_weight, options.boundary_weight);
        EXPECT_TRUE(found.second_line.is_there);
        EXPECT_EQ(found.second_line.x, options.second_line.x);
        EXPECT_EQ(found.second_line.y, options.second_line.y);
        EXPECT_NEAR(found.second_line.k, options.second_line.k, 1e-9 * options.second_line.k);
        EXPECT_NEAR(found.second_line.d, options.second_line.d, 1e-9 * options.second_line.d);
    }
}

TEST(ShippedModels, TheRuntimeTakesTheOneOfItsDimensionAndRatio) {
    expect_classifier_of<2>("surface_2d", 2.1);
    expect_classifier_of<3>("surface_3d", 2);
    expect_classifier_of<3>("surface_3d", 2.154);
    expect_classifier_of<3>("surface_3d_wide", 2.6);
    expect_classifier_of<2>("surface_2d_widest", 3.46);
    expect_classifier_of<3>("surface_3d_widest", 4.2);
    for (const int dimension : {2, 3}) {
        SurfaceTensionOptions options;
        options.spacing_ratio = 1.5; // as at 2, which lets more through
        EXPECT_NEAR(completed(options, dimension).d, completed({}, dimension).d, 1e-9);
        options.spacing_ratio = 5.5;
        EXPECT_THROW(completed(options, dimension), std::invalid_argument);
        options.k = options.d = 20; // of one's own
        EXPECT_NO_THROW(completed(options, dimension));
    }
}

TEST(ShippedModels, MissNothingThatTheyWereTrainedOn) {
    for (const char* name :
         {"surface_3d", "surface_3d_strict", "surface_3d_wide", "surface_3d_widest", "surface_2d",
          "surface_2d_wide", "surface_2d_widest"})
        EXPECT_EQ(shipped(name).false_negatives, 0U) << name;
}

TEST(ShippedModels, PublishedLinesAreModelsLikeAnyOther) {
    for (const int d : {12, 13, 28, 35}) {
        const Model model = shipped("splishsplash_d" + std::to_string(d));
        EXPECT_NEAR(model.line.k, 74.6888, 1e-4);
        EXPECT_EQ(model.line.d, d);
    }
}

} // namespace
} // namespace meniscus
