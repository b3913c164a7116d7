#include <meniscus/data/particles/boundary_sampling.hpp>

#include "test_folder.hpp"

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <set>

namespace meniscus {
namespace {

using Place = std::array<double, 3>;

double distance(const Place& a, const Place& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double min_distance(const Positions& places, double reach) {
    const NeighborGrid grid(places, reach);
    double min = reach;
    FoundNeighbors found;
    for (std::size_t at = 0; at < grid.size(); ++at) {
        grid.find(at, found);
        for (const Place& displacement : found.displacements)
            min = std::min(min, distance(displacement, {}));
    }
    return min;
}

/// The largest distance of one of the places from the samples nearest to it; at most `reach`.
double max_hole(const Positions& samples, const Positions& places, double reach) {
    const NeighborGrid grid(samples, reach);
    double max = 0;
    FoundNeighbors found;
    for (const Place& place : places) {
        grid.find_around(place, reach, found);
        double nearest = reach;
        for (const Place& displacement : found.displacements)
            nearest = std::min(nearest, distance(displacement, {}));
        max = std::max(max, nearest);
    }
    return max;
}

Positions random_places_on(const TriangleMesh& mesh, int each, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> share(0, 1);
    Positions places;
    for (const auto& [a, b, c] : mesh.triangles)
        for (int k = 0; k < each; ++k) {
            double u = share(generator);
            double v = share(generator);
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            Place place{};
            for (int axis = 0; axis < 3; ++axis)
                place[axis] = (1 - u - v) * mesh.vertices[a][axis] + u * mesh.vertices[b][axis] +
                              v * mesh.vertices[c][axis];
            places.push_back(place);
        }
    return places;
}

void expect_well_sampled(const TriangleMesh& mesh, double spacing, int places_each) {
    const Positions samples = sample_mesh(mesh, spacing);
    EXPECT_GE(min_distance(samples, spacing), 0.75 * spacing);
    EXPECT_LT(max_hole(samples, random_places_on(mesh, places_each, 1), 2 * spacing), spacing);
    EXPECT_EQ(samples, sample_mesh(mesh, spacing));
}

TriangleMesh random_triangles(int count, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    TriangleMesh mesh;
    for (int t = 0; t < count; ++t) {
        for (int corner = 0; corner < 3; ++corner)
            mesh.vertices.push_back(
                {coordinate(generator), coordinate(generator), coordinate(generator)});
        const auto first = static_cast<std::uint32_t>(3 * t);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

TEST(BoundarySampling, BoxHasEachPointOnceOnItsSides) {
    const BoxSides box{{-0.5, 0, 1}, {0.5, 0.7, 1.31}, {}};
    const Positions points = sample_box(box, 0.1, 3);
    // 10, 7 and 4 (0.31 needs four) parts: all points of the grid but the inner ones.
    EXPECT_EQ(points.size(), 11U * 8 * 5 - 9U * 6 * 3);
    EXPECT_EQ(std::set<Place>(points.begin(), points.end()).size(), points.size());
    for (const Place& point : points) {
        bool on_side = false;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(point[axis], box.low[axis]);
            EXPECT_LE(point[axis], box.high[axis]);
            on_side = on_side || point[axis] == box.low[axis] || point[axis] == box.high[axis];
        }
        EXPECT_TRUE(on_side);
    }
    EXPECT_NEAR(min_distance(points, 0.1), 0.31 / 4, 1e-12);
}

TEST(BoundarySampling, BoxLeavesOpenSidesOut) {
    for (int side = 0; side < 6; ++side) {
        BoxSides box{{0, 0, 0}, {1, 1, 1}, {}};
        box.open[side] = true;
        const Positions points = sample_box(box, 0.25, 3);
        EXPECT_EQ(points.size(), 5U * 5 * 5 - 3U * 3 * 3 - 3U * 3); // but its inner points
        std::size_t on_open_side = 0;
        for (const Place& point : points)
            on_open_side += point[side / 2] == side % 2;
        EXPECT_EQ(on_open_side, 16U); // edges, which belong to other sides
    }
    BoxSides floor{{0, 0, 0}, {1, 1, 1}, {true, true, false, true, true, true}};
    EXPECT_EQ(sample_box(floor, 0.25, 3).size(), 25U);
}

TEST(BoundarySampling, RectangleLiesInThePlane) {
    const BoxSides box{{0, 0, 0}, {1, 0.5, 0}, {false, false, false, true, false, false}};
    const Positions points = sample_box(box, 0.1, 2);
    EXPECT_EQ(points.size(), 11U + 2 * 5);
    for (const Place& point : points)
        EXPECT_EQ(point[2], 0);
}

TEST(BoundarySampling, BoxRefusesWhatItCannotSample) {
    const auto error = [](const Place& low, const Place& high, double spacing) {
        return error_of<InputError>([&] { sample_box({low, high, {}}, spacing, 3); });
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    expect_mentions(error({0, 0, 0}, {1, 0.04, 1}, 0.1), {"half a spacing", "0.04"});
    expect_mentions(error({0, 0, 0}, {1, -1, 1}, 0.1), {"half a spacing"});
    expect_mentions(error({0, 0, 0}, {1, nan, 1}, 0.1), {"nan"});
    expect_mentions(error({0, 0, 0}, {1, inf, 1}, 0.1), {"inf"});
    expect_mentions(error({0, 0, 0}, {1e9, 1e9, 1e9}, 0.1), {"wall particles"});
    for (const double spacing : {0.0, -1.0, nan, inf})
        expect_mentions(error({0, 0, 0}, {1, 1, 1}, spacing), {"spacing"});
}

TEST(BoundarySampling, EllipsoidHasNoHolesAndLiesOnItself) {
    const double spacing = 0.1;
    const Place center{1, -2, 0.5};
    std::mt19937 generator(2);
    std::normal_distribution<double> normal;
    for (const Place& axes :
         {Place{1, 1, 1}, Place{0.5, 1.2, 0.8}, Place{0.05, 1, 0.3}, Place{0.05, 0.05, 0.05}}) {
        const Positions samples = sample_ellipsoid(center, axes, spacing, 3);
        for (const Place& sample : samples)
            EXPECT_NEAR(
                distance({(sample[0] - center[0]) / axes[0], (sample[1] - center[1]) / axes[1],
                          (sample[2] - center[2]) / axes[2]},
                         {}),
                1, 1e-12);
        Positions places;
        for (int k = 0; k < 20000; ++k) {
            const Place p{normal(generator), normal(generator), normal(generator)};
            const double length = distance(p, {});
            places.push_back({center[0] + axes[0] * p[0] / length,
                              center[1] + axes[1] * p[1] / length,
                              center[2] + axes[2] * p[2] / length});
        }
        EXPECT_LT(max_hole(samples, places, 3 * spacing), spacing);
        EXPECT_GE(min_distance(samples, spacing), 0.75 * spacing * (1 - 1e-12));
    }
}

TEST(BoundarySampling, CircleIsEven) {
    const Positions samples = sample_ellipsoid({3, 4, 0}, {1, 1, 0}, 0.1, 2);
    EXPECT_EQ(samples.size(), 63U); // 2 pi / 0.1, rounded up
    const double chord = 2 * std::sin(M_PI / 63);
    for (std::size_t k = 0; k < samples.size(); ++k) {
        EXPECT_NEAR(distance(samples[k], samples[(k + 1) % samples.size()]), chord, 1e-5);
        EXPECT_NEAR(distance(samples[k], {3, 4, 0}), 1, 1e-12);
        EXPECT_EQ(samples[k][2], 0);
    }
}

TEST(BoundarySampling, EllipseHasNoHolesNorClusters) {
    for (const Place& axes : {Place{2, 0.5, 0}, Place{2, 0.05, 0}, Place{0.05, 0.05, 0}}) {
        const Positions samples = sample_ellipsoid({}, axes, 0.1, 2);
        EXPECT_GE(min_distance(samples, 0.1), 0.05 * (1 - 1e-12));
        Positions places;
        for (int k = 0; k < 5000; ++k)
            places.push_back({axes[0] * std::cos(k), axes[1] * std::sin(k), 0});
        EXPECT_LT(max_hole(samples, places, 0.3), 0.1);
        for (const Place& sample : samples)
            EXPECT_NEAR(std::hypot(sample[0] / axes[0], sample[1] / axes[1]), 1, 1e-12);
    }
}

TEST(BoundarySampling, EllipsoidRefusesWhatItCannotSample) {
    const auto error = [](const Place& center, const Place& axes) {
        return error_of<InputError>([&] { sample_ellipsoid(center, axes, 0.1, 3); });
    };
    expect_mentions(error({}, {1, 0.04, 1}), {"half axes", "0.04"});
    expect_mentions(error({}, {1, 1, 1000}), {"half axes", "1000"});
    expect_mentions(error({}, {1, 1, std::nan("")}), {"half axes", "nan"});
    expect_mentions(error({0, std::nan(""), 0}, {1, 1, 1}), {"center", "nan"});
}

TEST(BoundarySampling, MeshHasNoHolesNorClusters) {
    for (const double spacing : {0.03, 0.2, 1.0})
        expect_well_sampled(random_triangles(20, 3), spacing, 3000);
}

TEST(BoundarySampling, MeshOfSliversAndOfFineTrianglesHasNoHolesNorClusters) {
    TriangleMesh slivers = random_triangles(10, 4);
    for (std::size_t v = 0; v < slivers.vertices.size(); v += 3) { // nearly, then wholly flat
        slivers.vertices[v + 2] = slivers.vertices[v];
        slivers.vertices[v + 2][0] += v % 2 == 0 ? 1e-9 : 0.0;
    }
    expect_well_sampled(slivers, 0.05, 3000);
    TriangleMesh fine;
    for (std::uint32_t i = 0; i < 50; ++i)
        for (std::uint32_t j = 0; j < 50; ++j)
            fine.vertices.push_back({0.01 * i, 0.01 * j, 0.02 * std::sin(0.2 * i)});
    for (std::uint32_t i = 0; i + 1 < 50; ++i)
        for (std::uint32_t j = 0; j + 1 < 50; ++j) {
            fine.triangles.push_back({50 * i + j, 50 * i + j + 1, 50 * i + j + 50});
            fine.triangles.push_back({50 * i + j + 51, 50 * i + j + 1, 50 * i + j + 50});
        }
    expect_well_sampled(fine, 0.1, 20);
}

TEST(BoundarySampling, SamplesOfAFlatMeshLieInIt) {
    const TriangleMesh mesh{{{0, 0, 1}, {1, 0, 2}, {0, 1, 3}}, {{0, 1, 2}}};
    const Positions samples = sample_mesh(mesh, 0.1);
    EXPECT_GT(samples.size(), 50U);
    for (const Place& p : samples) {
        EXPECT_NEAR(p[2], 1 + p[0] + 2 * p[1], 1e-12);
        EXPECT_GE(p[0], -1e-12);
        EXPECT_GE(p[1], -1e-12);
        EXPECT_LE(p[0] + p[1], 1 + 1e-12);
    }
}

TEST(BoundarySampling, MeshRefusesWhatItCannotSample) {
    const auto error = [](const TriangleMesh& mesh) {
        return error_of<InputError>([&] { sample_mesh(mesh, 0.1); });
    };
    expect_mentions(error({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}}),
                    {"triangle 1", "vertex 4"});
    expect_mentions(error({{{0, 0, 0}, {1, std::nan(""), 0}, {0, 1, 0}}, {{0, 1, 2}}}),
                    {"vertex 2", "not finite"});
    expect_mentions(error({{{0, 0, 0}, {1e6, 0, 0}, {0, 1e6, 0}}, {{0, 1, 2}}}),
                    {"wall particles", "scale"});
}

class ObjFile : public TestFolder {
protected:
    std::string error(const std::string& text) const {
        std::string message = error_of<InputError>([&] { read_obj(write("some.obj", text)); });
        EXPECT_NE(message.find("some.obj"), std::string::npos) << message;
        return message;
    }
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
};

TEST_F(ObjFile, ReadsAllFormsOfCorners) {
    const std::vector<std::array<std::uint32_t, 3>> expected{{0, 1, 2}, {0, 2, 3}};
    for (const char* face : {"f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1//7 2//7 3//7 4//7",
                             "f 1/2/3 2/2/3 3/2/3 4/2/3", "f -4 -3 -2 -1", "  f\t1 2  3 4 \r"}) {
        const TriangleMesh mesh =
            read_obj(write("some.obj", "# comment\n" + square + "vn 0 0 1\n" + face));
        EXPECT_EQ(mesh.vertices.size(), 4U);
        EXPECT_EQ(mesh.triangles, expected) << face;
    }
}

TEST_F(ObjFile, ReadsFacesBeforeTheirVertices) {
    EXPECT_EQ(read_obj(write("some.obj", "f 1 2 3\n" + square)).triangles.size(), 1U);
}

TEST_F(ObjFile, NamesTheLineOfWhatIsWrong) {
    expect_mentions(error("v 0 0 0\nv 0 nan 0\n"), {"line 2", "'nan'"});
    expect_mentions(error("v 0 0 1e999\n"), {"line 1", "'1e999'"});
    expect_mentions(error("v 0 0 zero\n"), {"line 1", "'zero'"});
    expect_mentions(error("v 0 0\n"), {"line 1", "found 2"});
    expect_mentions(error(square + "f 1 2\n"), {"line 5", "three corners", "found 2"});
    expect_mentions(error(square + "f 1 2 5\n"), {"line 5", "vertex 5", "there are 4"});
    expect_mentions(error(square + "\nf -1 -2 -5\n"), {"line 6", "there are 4"});
    expect_mentions(error(square + "f 0 1 2\n"), {"line 5", "'0'"});
    expect_mentions(error(square + "f 1 2 3x\n"), {"line 5", "'3x'"});
    expect_mentions(error(square + "f 1 2 99999999999999999999\n"), {"line 5"});
    expect_mentions(error(square + "f 1 2 -9223372036854775808\n"), {"line 5"});
}

TEST_F(ObjFile, RefusesFilesWithoutFaces) {
    expect_mentions(error(""), {"no face"});
    expect_mentions(error(square), {"no face"});
    expect_mentions(error(std::string(5000, '\0')), {"no face"});
    expect_mentions(error_of<InputError>([&] { read_obj(folder / "missing.obj"); }),
                    {"missing.obj", "cannot be read"});
    expect_mentions(error_of<InputError>([&] { read_obj(folder); }), {"cannot be read"});
    expect_mentions(error_of<InputError>([&] { read_obj("/dev/zero"); }), {"cannot be read"});
}

TEST_F(ObjFile, RandomTextIsReadOrRefused) {
    std::mt19937 generator(5);
    const std::string letters = "vf/ -0123459.e\n\n#nai\r\t";
    int read = 0;
    for (int k = 0; k < 500; ++k) {
        std::string text = square + "f 1 2 3\nf 1/1 3//2 -1\n";
        for (int change = 0; change < 1 + k % 5; ++change)
            text[generator() % text.size()] = letters[generator() % letters.size()];
        try {
            sample_mesh(read_obj(write("some.obj", text)), 0.3);
            ++read;
        } catch (const InputError&) {
        }
    }
    EXPECT_GT(read, 20);
    EXPECT_LT(read, 480);
}

} // namespace
} // namespace meniscus
