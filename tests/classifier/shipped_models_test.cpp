// The headers in runtime/coefficients/ are what the models in configs/models/ export to.
#include <meniscus/classifier/export/header_export.hpp>
#include <meniscus/classifier/model/model.hpp>
#include <meniscus/runtime/coefficients/surface_2d_wide.hpp>
#include <meniscus/runtime/coefficients/surface_3d.hpp>
#include <meniscus/runtime/coefficients/surface_3d_relative.hpp>
#include <meniscus/runtime/coefficients/surface_3d_strict.hpp>
#include <meniscus/runtime/coefficients/surface_3d_wide.hpp>
#include <meniscus/runtime/features/shipped_surface_line.hpp>
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
    EXPECT_EQ(coefficient_header(shipped("surface_3d"), "Surface3D"), runtime_header("surface_3d"));
    EXPECT_EQ(coefficient_header(shipped("surface_3d_strict"), "Surface3DStrict"),
              runtime_header("surface_3d_strict"));
    EXPECT_EQ(coefficient_header(shipped("surface_3d_relative"), "Surface3DRelative"),
              runtime_header("surface_3d_relative"));
    EXPECT_EQ(coefficient_header(shipped("surface_3d_wide"), "Surface3DWide"),
              runtime_header("surface_3d_wide"));
    EXPECT_EQ(coefficient_header(shipped("surface_2d"), "Surface2D"), runtime_header("surface_2d"));
    EXPECT_EQ(coefficient_header(shipped("surface_2d_wide"), "Surface2DWide"),
              runtime_header("surface_2d_wide"));
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
    EXPECT_EQ(Surface3DRelative::reference_neighbor_count, 40);
    EXPECT_EQ(Surface2D::dimension, 2);
    EXPECT_EQ(Surface3DWide::min_spacing_ratio, 2.5);
}

template <int Dimension>
void expect_line_of(const std::string& name) {
    const Line line = shipped(name).line;
    for (const auto& options : {SurfaceTensionOptions{}, paper_options()}) {
        EXPECT_EQ(completed(options, Dimension).k, line.k);
        EXPECT_EQ(completed(options, Dimension).d, line.d);
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
