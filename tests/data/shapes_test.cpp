#include <meniscus/data/clouds/shapes.hpp>

#include "expected_errors.hpp"

#include <meniscus/data/text/errors.hpp>

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace meniscus {
namespace {

using Vector3 = std::array<double, 3>;

Vector3 moved(Vector3 place, double length, const Vector3& direction) {
    for (int axis = 0; axis < 3; ++axis)
        place[axis] += length * direction[axis];
    return place;
}

double distance(const Vector3& a, const Vector3& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double dot(const Vector3& a, const Vector3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// One of each, all of about the same size.
std::vector<Shape> all_shapes() {
    std::vector<Shape> shapes{circle(1.3),
                              sphere(0.9),
                              ellipsoid({0.7, 1.5, 1.1}),
                              ellipsoid({1, 1, 0.4}),
                              torus(1.2, 0.4),
                              cylinder(0.8, 2.5),
                              cube(1.7),
                              cube(1.7, 2),
                              plane(2),
                              plane(2, 2),
                              paraboloid(0.4, 0.3, 2),
                              paraboloid(-0.5, 0.2, 2),
                              paraboloid(0.3, -0.4, 2)};
    for (std::size_t k = 0, count = shapes.size(); k < count; ++k)
        shapes.push_back(outside(shapes[k]));
    return shapes;
}

std::vector<Vector3> random_places(const Shape& shape, double reach, int count, unsigned seed) {
    std::mt19937 generator(seed);
    const Box box = shape.box_around(reach);
    std::vector<Vector3> places(count);
    for (Vector3& place : places)
        for (int axis = 0; axis < shape.dimension; ++axis)
            place[axis] =
                std::uniform_real_distribution<double>(box.low[axis], box.high[axis])(generator);
    return places;
}

/// Points of the surface away from edges.
std::vector<SurfacePoint> random_surface_points(const Shape& shape, int count, unsigned seed) {
    std::vector<SurfacePoint> points;
    for (const Vector3& place : random_places(shape, 0.2, count, seed)) {
        SurfacePoint point =
            nearest_surface_point(shape, nearest_surface_point(shape, place).position);
        if (point.edge_distance > 1e-3)
            points.push_back(point);
    }
    return points;
}

std::string label(const Shape& shape) {
    return shape.name + (shape.side == Side::inside ? ", inside" : ", outside") + ", " +
           std::to_string(shape.dimension) + "D";
}

TEST(Shapes, NearestPointLiesOnTheSurfaceAlongItsNormal) {
    for (const Shape& shape : all_shapes())
        for (const Vector3& place : random_places(shape, 0.5, 500, 1)) {
            const SurfacePoint point = nearest_surface_point(shape, place);
            EXPECT_NEAR(std::sqrt(dot(point.normal, point.normal)), 1, 1e-14);
            EXPECT_NEAR(std::fabs(point.signed_distance), distance(place, point.position), 1e-12);
            EXPECT_EQ(point.signed_distance < 0, in_fluid(shape, place)) << label(shape);
            if (shape.name != "cube") { // from outside, its edges are nearest to much
                EXPECT_LT(
                    distance(moved(point.position, point.signed_distance, point.normal), place),
                    1e-9)
                    << label(shape);
            }
            if (nearest_surface_point(shape, point.position).edge_distance > 1e-3) {
                EXPECT_FALSE(in_fluid(shape, moved(point.position, 1e-7, point.normal)));
                EXPECT_TRUE(in_fluid(shape, moved(point.position, -1e-7, point.normal)))
                    << label(shape);
            }
        }
}

TEST(Shapes, NoOtherPointIsNearer) {
    for (const Shape& shape : all_shapes()) {
        const auto others = random_surface_points(shape, 500, 2);
        ASSERT_FALSE(others.empty());
        for (const Vector3& place : random_places(shape, 0.5, 100, 3)) {
            const double nearest = std::fabs(nearest_surface_point(shape, place).signed_distance);
            for (const SurfacePoint& other : others)
                ASSERT_GE(distance(place, other.position), nearest - 1e-9) << label(shape);
        }
    }
}

TEST(Shapes, CurvatureIsTheDivergenceOfTheNormals) {
    constexpr double step = 1e-4;
    for (const Shape& shape : all_shapes())
        for (const SurfacePoint& point : random_surface_points(shape, 200, 4)) {
            double divergence = 0;
            for (int axis = 0; axis < shape.dimension; ++axis) {
                Vector3 along{};
                along[axis] = 1;
                const auto ahead = nearest_surface_point(shape, moved(point.position, step, along));
                const auto back = nearest_surface_point(shape, moved(point.position, -step, along));
                divergence += (ahead.normal[axis] - back.normal[axis]) / (2 * step);
            }
            EXPECT_NEAR(divergence / (shape.dimension - 1), point.mean_curvature, 1e-5)
                << label(shape);
        }
}

TEST(Shapes, CurvatureWhereItIsKnown) {
    const auto curvature = [](const Shape& shape, const Vector3& place) {
        return nearest_surface_point(shape, place).mean_curvature;
    };
    // Relative to a support radius of 20, as in the papers.
    const Shape benchmark = ellipsoid({100, 200, 400});
    EXPECT_NEAR(20 * curvature(benchmark, {100, 0, 0}), 0.03125, 1e-15);
    EXPECT_NEAR(20 * curvature(benchmark, {0, 200, 0}), 0.2125, 1e-15);
    EXPECT_NEAR(20 * curvature(benchmark, {0, 0, 400}), 0.5, 1e-15);
    EXPECT_NEAR(20 * curvature(outside(benchmark), {0, 0, 399}), -0.5, 1e-12);
    EXPECT_NEAR(curvature(torus(3, 1), {4.1, 0, 0}), (1 + 1.0 / 4) / 2, 1e-14);
    EXPECT_NEAR(curvature(torus(3, 1), {0, 1.9, 0}), (1 - 1.0 / 2) / 2, 1e-14);
    EXPECT_NEAR(curvature(paraboloid(0.7, 0.2, 5), {0, 0, 0.1}), 0.7 - 0.2, 1e-14);
    EXPECT_NEAR(curvature(outside(paraboloid(0.7, 0.2, 5)), {0, 0, -0.1}), 0.2 - 0.7, 1e-14);
    EXPECT_NEAR(curvature(circle(4), {1, 1, 0}), 1.0 / 4, 1e-15);
    EXPECT_NEAR(curvature(outside(sphere(4)), {5, 1, 0}), -1.0 / 4, 1e-15);
    EXPECT_NEAR(curvature(cylinder(4, 9), {3, 1, 2}), 1.0 / 8, 1e-15);
    EXPECT_EQ(curvature(cube(4), {1, 0, 0}), 0);
}

TEST(Shapes, PlacesThatAreEquallyNearToManyPoints) {
    const auto depth = [](const Shape& shape, const Vector3& place) {
        const SurfacePoint point = nearest_surface_point(shape, place);
        EXPECT_NEAR(std::sqrt(dot(point.normal, point.normal)), 1, 1e-14) << shape.name;
        return -point.signed_distance;
    };
    EXPECT_NEAR(depth(sphere(2), {0, 0, 0}), 2, 1e-14);
    EXPECT_NEAR(depth(circle(2), {0, 0, 0}), 2, 1e-14);
    EXPECT_NEAR(depth(ellipsoid({1, 2, 3}), {0, 0, 0}), 1, 1e-11);
    EXPECT_NEAR(depth(ellipsoid({2, 2, 2}), {0, 0, 0}), 2, 1e-11);
    // From the long axis of a spheroid, inside of its focus: the nearest points make a ring.
    EXPECT_NEAR(depth(ellipsoid({1, 1, 2}), {0, 0, 0.3}), std::sqrt(1 - 0.09 / 3), 1e-11);
    EXPECT_NEAR(depth(torus(3, 1), {3, 0, 0}), 1, 1e-14);
    EXPECT_NEAR(depth(torus(3, 1), {0, 0, 0}), -2, 1e-14);
    EXPECT_NEAR(depth(cylinder(2, 5), {0, 0, 1}), 2, 1e-14);
    EXPECT_NEAR(depth(cube(2), {0, 0, 0}), 1, 1e-14);
    // Above the focus of z = x^2 / 2 - y^2 / 4, which is 1 above the origin.
    EXPECT_NEAR(depth(paraboloid(0.5, 0.25, 4), {0, 0, 3}), std::sqrt(5.0), 1e-5);
    EXPECT_NEAR(depth(paraboloid(0.5, 0.25, 4), {1e-9, 0, 3}), std::sqrt(5.0), 1e-7);
}

TEST(Shapes, DistanceToTheEdgesOfACube) {
    const auto edge_distance = [](const Shape& shape, const Vector3& place) {
        return nearest_surface_point(shape, place).edge_distance;
    };
    EXPECT_NEAR(edge_distance(cube(2), {1, 0, 0}), 1, 1e-15);
    EXPECT_NEAR(edge_distance(cube(2), {1, 0.5, 0.2}), 0.5, 1e-15);
    EXPECT_NEAR(edge_distance(cube(2), {0, 0, 0}), std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(edge_distance(cube(2), {4, 5, 3}), std::sqrt(9 + 16 + 4.0), 1e-14); // to a corner
    EXPECT_NEAR(edge_distance(cube(2, 2), {0, 0, 0}), std::sqrt(2.0), 1e-15);
}

TEST(Shapes, RefusesLengthsThatAreNone) {
    for (const double length : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        EXPECT_THROW(circle(length), InputError) << length;
        EXPECT_THROW(sphere(length), InputError) << length;
        EXPECT_THROW(ellipsoid({1, length, 1}), InputError) << length;
        EXPECT_THROW(torus(2, length), InputError) << length;
        EXPECT_THROW(torus(length, 1), InputError) << length;
        EXPECT_THROW(cylinder(length, 1), InputError) << length;
        EXPECT_THROW(cylinder(1, length), InputError) << length;
        EXPECT_THROW(cube(length), InputError) << length;
        EXPECT_THROW(plane(length), InputError) << length;
        EXPECT_THROW(paraboloid(1, 1, length), InputError) << length;
    }
    expect_mentions(error_of<InputError>([] { sphere(-2); }),
                    {"sphere radius", "positive", "-2.0"});
    expect_mentions(error_of<InputError>([] { torus(1, 1.5); }), {"ring radius", "1.5", "1.0"});
    expect_mentions(error_of<InputError>([] { paraboloid(1, std::nan(""), 1); }),
                    {"finite", "nan"});
    expect_mentions(error_of<InputError>([] { cube(1, 4); }), {"cube", "2 or 3", "4"});
}

} // namespace
} // namespace meniscus
