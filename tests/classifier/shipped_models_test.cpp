// The headers in runtime/ are what the models in configs/models/ export to.
#include <meniscus/classifier/header_export.hpp>
#include <meniscus/classifier/model.hpp>
#include <meniscus/runtime/relative_surface_coefficients.hpp>
#include <meniscus/runtime/shipped_curvature_map.hpp>
#include <meniscus/runtime/shipped_surface_line.hpp>
#include <meniscus/runtime/strict_surface_coefficients.hpp>
#include <meniscus/runtime/surface_coefficients.hpp>
#include <meniscus/runtime/surface_tension.hpp>
#include <meniscus/runtime/wide_surface_coefficients.hpp>
#include <meniscus/runtime/wide_surface_coefficients_2d.hpp>

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
    std::ifstream stream(std::string(MENISCUS_RUNTIME) + "/" + name + ".hpp", std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ShippedModels, HeadersAreExportedFromThem) {
    EXPECT_EQ(coefficient_header(shipped("surface_3d"), "SurfaceCoefficients"),
              runtime_header("surface_coefficients"));
    EXPECT_EQ(coefficient_header(shipped("surface_3d_strict"), "StrictSurfaceCoefficients"),
              runtime_header("strict_surface_coefficients"));
    EXPECT_EQ(coefficient_header(shipped("surface_3d_relative"), "RelativeSurfaceCoefficients"),
              runtime_header("relative_surface_coefficients"));
    EXPECT_EQ(coefficient_header(shipped("surface_3d_wide"), "WideSurfaceCoefficients"),
              runtime_header("wide_surface_coefficients"));
    EXPECT_EQ(coefficient_header(shipped("surface_2d"), "SurfaceCoefficients2D"),
              runtime_header("surface_coefficients_2d"));
    EXPECT_EQ(coefficient_header(shipped("surface_2d_wide"), "WideSurfaceCoefficients2D"),
              runtime_header("wide_surface_coefficients_2d"));
}

CurvatureModel shipped_curvature(const std::string& name) {
    return read_curvature_model(std::string(MENISCUS_MODELS) + "/" + name + ".json");
}

TEST(ShippedModels, CurvatureHeadersAreExportedFromThem) {
    EXPECT_EQ(coefficient_header(shipped_curvature("curvature_3d"), "CurvatureCoefficients"),
              runtime_header("curvature_coefficients"));
    EXPECT_EQ(coefficient_header(shipped_curvature("curvature_2d"), "CurvatureCoefficients2D"),
              runtime_header("curvature_coefficients_2d"));
}

TEST(ShippedModels, CurvatureMapsSayWhatTheModelsSay) {
    for (const int dimension : {2, 3}) {
        const CurvatureModel model =
            shipped_curvature("curvature_" + std::to_string(dimension) + "d");
        const CurvatureMap map = shipped_curvature_map(dimension);
        EXPECT_EQ(map.dimension, dimension);
        for (int term = 0; term < CurvatureMap::terms; ++term)
            EXPECT_EQ(map.coefficients[term], model.map.coefficients[term]);
        EXPECT_EQ(map.least, model.map.least);
        EXPECT_EQ(map.largest, model.map.largest);
        EXPECT_TRUE(map.averaged);
    }
}

TEST(ShippedModels, HeadersSayWhatTheModelsSay) {
    EXPECT_EQ(shipped("surface_3d").line.k, SurfaceCoefficients::k);
    EXPECT_EQ(shipped("surface_3d").line.d, SurfaceCoefficients::d);
    EXPECT_EQ(StrictSurfaceCoefficients::label_threshold, 0);
    EXPECT_EQ(RelativeSurfaceCoefficients::reference_neighbor_count, 40);
    EXPECT_EQ(SurfaceCoefficients2D::dimension, 2);
    EXPECT_EQ(WideSurfaceCoefficients::spacing_ratio_min, 2.5);
}

template <int Dimension>
void expect_line_of(const std::string& name) {
    const Line line = shipped(name).line;
    for (const auto& options : {shipped_options<Dimension>(), paper_options<Dimension>()}) {
        EXPECT_EQ(options.k, line.k);
        EXPECT_EQ(options.d, line.d);
    }
}

TEST(ShippedModels, TheRuntimeTakesTheOneOfItsDimension) {
    expect_line_of<2>("surface_2d");
    expect_line_of<3>("surface_3d");
}

TEST(ShippedModels, MissNothingThatTheyWereTrainedOn) {
    for (const char* name : {"surface_3d", "surface_3d_strict", "surface_3d_relative",
                             "surface_3d_wide", "surface_2d", "surface_2d_wide"})
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
