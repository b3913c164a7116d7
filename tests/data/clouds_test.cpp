#include <meniscus/data/clouds/clouds.hpp>

#include "expected_errors.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/runtime/math/angles.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace meniscus {
namespace {

constexpr Arrangement arrangements[] = {Arrangement::random, Arrangement::lattice,
                                        Arrangement::relaxed};

/// Of spacing 1.
CloudOptions options_of(Arrangement arrangement, double support_radius = 2) {
    CloudOptions options;
    options.spacing = 1;
    options.support_radius = support_radius;
    options.arrangement = arrangement;
    options.seed = 7;
    return options;
}

double mean_of(const std::vector<double>& values) {
    double total = 0;
    for (const double value : values)
        total += value;
    return total / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values) {
    const double mean = mean_of(values);
    double total = 0;
    for (const double value : values)
        total += (value - mean) * (value - mean);
    return std::sqrt(total / static_cast<double>(values.size()));
}

/// The neighbors of particles with full neighborhoods.
std::vector<double> counts_inside(const Cloud& cloud) {
    const NeighborLists lists = find_neighbors(cloud.positions, cloud.support_radius);
    std::vector<double> counts;
    for (std::size_t i = 0; i < cloud.size(); ++i)
        if (cloud.trusted[i] != 0 && cloud.depth[i] > 1.5 * cloud.support_radius)
            counts.push_back(static_cast<double>(lists.offsets[i + 1] - lists.offsets[i]));
    return counts;
}

struct Filled {
    Shape shape;
    double volume; ///< of what is filled with layers of 6
};

std::vector<Filled> filled_shapes() {
    const double r = 12;
    const double ball = 4 * pi / 3;
    return {{circle(40), pi * 40 * 40},
            {outside(circle(40)), pi * (46 * 46 - 40 * 40)},
            {sphere(r), ball * r * r * r},
            {outside(sphere(r)), ball * (18 * 18 * 18 - r * r * r)},
            {ellipsoid({8, 10, 20}), ball * 8 * 10 * 20},
            {torus(14, 6.5), 2 * pi * pi * 14 * 6.5 * 6.5},
            {cylinder(8, 40), pi * 8 * 8 * 40},
            {outside(cylinder(8, 40)), pi * (14 * 14 - 8 * 8) * 40},
            {cube(20), 20 * 20 * 20},
            {cube(60, 2), 60 * 60},
            {plane(30), 30 * 30 * 6},
            {outside(plane(300, 2)), 300 * 6}};
}

CloudOptions with_layer_of_6(const Shape& shape, CloudOptions options) {
    if (shape.side == Side::outside || !shape.bounded)
        options.thickness = 6;
    return options;
}

void expect_known_surface(const Cloud& cloud, const Shape& shape) {
    ASSERT_EQ(cloud.normal.size(), cloud.size());
    ASSERT_EQ(cloud.mean_curvature.size(), cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const SurfacePoint point = nearest_surface_point(shape, cloud.positions[i]);
        ASSERT_TRUE(in_fluid(shape, cloud.positions[i])) << shape.name;
        ASSERT_GE(cloud.depth[i], 0);
        ASSERT_EQ(cloud.depth[i], -point.signed_distance);
        ASSERT_EQ(cloud.normal[i], point.normal);
        ASSERT_EQ(cloud.mean_curvature[i], point.mean_curvature);
    }
}

TEST(Clouds, FillTheirVolumeAndKnowTheirSurface) {
    for (const Filled& filled : filled_shapes())
        for (const Arrangement arrangement : arrangements) {
            CloudOptions options = with_layer_of_6(filled.shape, options_of(arrangement));
            options.jitter = 0.3;
            const Cloud cloud = fill(filled.shape, options);
            const double tolerance = arrangement == Arrangement::random
                                         ? 4 * std::sqrt(filled.volume)
                                         : 0.02 * filled.volume;
            EXPECT_NEAR(static_cast<double>(cloud.size()), filled.volume, tolerance)
                << filled.shape.name << " " << static_cast<int>(arrangement);
            expect_known_surface(cloud, filled.shape);
        }
}

TEST(Clouds, TrustedParticlesSeeNoCut) {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    for (const Shape& shape :
         {outside(sphere(8)), plane(20), outside(plane(40, 2)), cylinder(6, 20),
          outside(torus(12, 4)), paraboloid(0.03, 0.02, 24), outside(paraboloid(0.03, 0.02, 24))}) {
        const CloudOptions options = options_of(Arrangement::random);
        const double thickness = 4 * options.support_radius;
        const double reach = 2 * options.support_radius;
        const Cloud cloud = fill(shape, options);
        std::size_t trusted = 0;
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            trusted += cloud.trusted[i];
            for (int look = 0; look < 30 && cloud.trusted[i] != 0; ++look) {
                std::array<double, 3> place = cloud.positions[i];
                std::array<double, 3> step{};
                for (int axis = 0; axis < shape.dimension; ++axis)
                    step[axis] = reach * coordinate(generator);
                if (std::hypot(step[0], step[1], step[2]) >= reach)
                    continue;
                for (int axis = 0; axis < 3; ++axis)
                    place[axis] += step[axis];
                if (!in_fluid(shape, place))
                    continue;
                if (!(shape.bounded && shape.side == Side::inside)) {
                    ASSERT_LT(-nearest_surface_point(shape, place).signed_distance, thickness)
                        << shape.name;
                }
                for (int axis = 0; axis < 3; ++axis)
                    ASSERT_TRUE(place[axis] >= shape.patch.low[axis] &&
                                place[axis] <= shape.patch.high[axis])
                        << shape.name;
            }
        }
        EXPECT_GT(trusted, cloud.size() / 50) << shape.name;
        EXPECT_LT(trusted, cloud.size()) << shape.name;
    }
}

TEST(Clouds, AllOfADropIsTrusted) {
    for (const Shape& shape : {sphere(8), ellipsoid({6, 7, 8}), torus(12, 5), circle(20)})
        for (const std::uint8_t trusted : fill(shape, options_of(Arrangement::lattice)).trusted)
            ASSERT_EQ(trusted, 1) << shape.name;
}

TEST(Clouds, EdgesOfACubeAreNotTrusted) {
    const Cloud cloud = fill(cube(24), options_of(Arrangement::lattice));
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        std::array<double, 3> from_face{};
        for (int axis = 0; axis < 3; ++axis)
            from_face[axis] = 12 - std::fabs(cloud.positions[i][axis]);
        std::sort(from_face.begin(), from_face.end());
        EXPECT_EQ(cloud.trusted[i] != 0, std::hypot(from_face[0], from_face[1]) >= 4);
    }
}

TEST(Clouds, MeanNumberOfNeighborsInside) {
    for (const int dimension : {2, 3})
        for (const Arrangement arrangement : arrangements) {
            const double wanted = dimension == 2 ? 20.5 : 40.5;
            const double h = support_radius_in_spacings(wanted, dimension, arrangement);
            const Shape shape = dimension == 2 ? circle(80) : sphere(16);
            // A lattice has a stepwise number of neighbors; shaken they are on average what they
            // should be.
            CloudOptions options = options_of(arrangement, h);
            options.jitter = arrangement == Arrangement::lattice ? 0.5 : 0;
            EXPECT_NEAR(mean_of(counts_inside(fill(shape, options))), wanted, 0.04 * wanted)
                << dimension << " " << static_cast<int>(arrangement);
        }
    EXPECT_NEAR(support_radius_in_spacings(4 * pi / 3 * 8 - 1, 3, Arrangement::lattice), 2, 1e-14);
    EXPECT_NEAR(support_radius_in_spacings(pi * 4, 2, Arrangement::random), 2, 1e-14);
    EXPECT_NEAR(support_radius_in_spacings(0.1, 3, Arrangement::random), std::cbrt(0.3 / 4 / pi),
                1e-15);
}

TEST(Clouds, RandomParticlesAreIndependent) {
    // The number of those in a ball varies as Poisson's does.
    const auto counts = counts_inside(fill(sphere(16), options_of(Arrangement::random)));
    EXPECT_NEAR(deviation_of(counts), std::sqrt(mean_of(counts)), 0.5);
}

TEST(Clouds, LatticeIsOneHoweverItIsTurned) {
    const Cloud cloud = fill(sphere(10), options_of(Arrangement::lattice, 1.2));
    for (const double count : counts_inside(cloud))
        ASSERT_EQ(count, 6);
    CloudOptions other = options_of(Arrangement::lattice, 1.2);
    other.seed = 8;
    EXPECT_NE(fill(sphere(10), other).positions, cloud.positions);
}

/// Particles by number of neighbors and distance of the nearest (in h): the outermost, whose
/// neighbors' center of mass is more than 0.2 h away, and those that have none of them for
/// neighbor.
struct Layers {
    std::vector<double> outer_count, outer_nearest, inner_count, inner_nearest;
};

Layers layers_of(const Positions& positions, double h) {
    const NeighborLists lists = find_neighbors(positions, h);
    std::vector<double> nearest(positions.size(), 1);
    std::vector<std::uint8_t> outer(positions.size());
    const auto visit_neighbors = [&](std::size_t i, auto&& visit) {
        for (std::size_t k = lists.offsets[i]; k < lists.offsets[i + 1]; ++k)
            visit(lists.neighbors[k]);
    };
    for (std::size_t i = 0; i < positions.size(); ++i) {
        std::array<double, 3> total{};
        visit_neighbors(i, [&](std::uint32_t j) {
            std::array<double, 3> displacement{};
            for (int axis = 0; axis < 3; ++axis) {
                displacement[axis] = (positions[j][axis] - positions[i][axis]) / h;
                total[axis] += displacement[axis];
            }
            nearest[i] =
                std::min(nearest[i], std::hypot(displacement[0], displacement[1], displacement[2]));
        });
        const auto count = static_cast<double>(lists.offsets[i + 1] - lists.offsets[i]);
        outer[i] = std::hypot(total[0], total[1], total[2]) > 0.2 * count;
    }
    Layers layers;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        bool inner = outer[i] == 0;
        visit_neighbors(i, [&](std::uint32_t j) { inner = inner && outer[j] == 0; });
        const auto count = static_cast<double>(lists.offsets[i + 1] - lists.offsets[i]);
        if (outer[i] != 0) {
            layers.outer_count.push_back(count);
            layers.outer_nearest.push_back(nearest[i]);
        } else if (inner) {
            layers.inner_count.push_back(count);
            layers.inner_nearest.push_back(nearest[i]);
        }
    }
    return layers;
}

Layers layers_of_sample(const std::string& name) {
    const Snapshot droplet = read_snapshot(MENISCUS_SAMPLES + ("/" + name + ".vtkhdf"));
    return layers_of(droplet.positions, *droplet.support_radius);
}

TEST(Clouds, RelaxedParticlesAreThoseOfADroplet) {
    const Cloud cloud = fill(sphere(13), options_of(Arrangement::relaxed, 2.15));
    const Layers relaxed = layers_of(cloud.positions, cloud.support_radius);
    for (const char* name : {"cube_iisph_05", "droplet_iisph_14"}) {
        const Layers solved = layers_of_sample(name);
        EXPECT_NEAR(mean_of(relaxed.outer_count), mean_of(solved.outer_count), 1.5) << name;
        EXPECT_NEAR(mean_of(relaxed.outer_nearest), mean_of(solved.outer_nearest), 0.04) << name;
        EXPECT_NEAR(mean_of(relaxed.inner_count), mean_of(solved.inner_count), 1.5) << name;
    }
    // Only this one has nothing left of the lattice that it began with.
    EXPECT_NEAR(deviation_of(relaxed.inner_count),
                deviation_of(layers_of_sample("droplet_iisph_14").inner_count), 0.3);
}

TEST(Clouds, JitterBringsTheNearestAsCloseAsInADroplet) {
    const auto nearest_inside = [](double jitter) {
        CloudOptions options = options_of(Arrangement::relaxed, 2.15);
        options.jitter = jitter;
        return mean_of(layers_of(fill(sphere(13), options).positions, 2.15).inner_nearest);
    };
    EXPECT_NEAR(2.15 * nearest_inside(0), 0.95, 0.01);
    for (const char* name : {"cube_iisph_05", "droplet_iisph_14"}) {
        const double solved = mean_of(layers_of_sample(name).inner_nearest);
        EXPECT_GT(nearest_inside(0.1), solved) << name;
        EXPECT_LT(nearest_inside(0.3), solved) << name;
    }
}

TEST(Clouds, RelaxedParticlesAreEvenlySpread) {
    for (const Shape& shape : {sphere(13), ellipsoid({8, 10, 20}), outside(sphere(10)),
                               torus(14, 6), plane(30), circle(50)}) {
        const Cloud cloud = fill(shape, options_of(Arrangement::relaxed));
        const auto counts = counts_inside(cloud);
        EXPECT_LT(deviation_of(counts), 0.4 * std::sqrt(mean_of(counts))) << shape.name;
        std::vector<double> outermost;
        for (const double depth : cloud.depth) {
            EXPECT_GE(depth, 0.25 - 1e-9) << shape.name;
            if (depth < 0.8)
                outermost.push_back(depth);
        }
        EXPECT_NEAR(mean_of(outermost), 0.5, 0.1) << shape.name;
        EXPECT_LT(deviation_of(outermost), 0.12) << shape.name;
    }
}

TEST(Clouds, ShareOnTheSurfaceIsSpreadEvenlyOverIt) {
    CloudOptions options = options_of(Arrangement::random);
    options.surface_share = 0.3;
    const double ring = 20;
    const double tube = 8;
    const Cloud cloud = fill(torus(ring, tube), options);
    double on_surface = 0;
    double far_side = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
        if (cloud.depth[i] < 1e-9) {
            ++on_surface;
            far_side += std::hypot(cloud.positions[i][0], cloud.positions[i][1]) > ring ? 1 : 0;
        }
    EXPECT_NEAR(on_surface, 0.3 * static_cast<double>(cloud.size()), 1);
    EXPECT_NEAR(far_side / on_surface, 0.5 + tube / (pi * ring), 2 / std::sqrt(on_surface));
}

TEST(Clouds, SameForASeedOnAnyNumberOfThreads) {
    for (const Arrangement arrangement : arrangements) {
        CloudOptions options = options_of(arrangement);
        options.threads = 1;
        const Cloud one = fill(ellipsoid({6, 8, 10}), options);
        options.threads = 5;
        const Cloud many = fill(ellipsoid({6, 8, 10}), options);
        EXPECT_EQ(one.positions, many.positions);
        EXPECT_EQ(one.normal, many.normal);
        options.seed = 8;
        EXPECT_NE(one.positions, fill(ellipsoid({6, 8, 10}), options).positions);
    }
}

TEST(Clouds, NeighborhoodOfOnePlace) {
    const double h = 20;
    const double spacing = h / support_radius_in_spacings(1000, 3, Arrangement::random);
    const Shape drop = ellipsoid({100, 200, 400});
    for (const Shape& shape : {drop, outside(drop)})
        for (const std::array<double, 3>& tip :
             {std::array<double, 3>{100, 0, 0}, {0, 200, 0}, {0, 0, -400}}) {
            std::vector<double> counts;
            for (std::uint64_t seed = 0; seed < 50; ++seed) {
                const Positions positions = random_neighborhood(shape, tip, h, spacing, seed);
                ASSERT_EQ(positions[0], tip);
                for (std::size_t i = 1; i < positions.size(); ++i) {
                    ASSERT_TRUE(in_fluid(shape, positions[i]));
                    ASSERT_LT(std::hypot(positions[i][0] - tip[0], positions[i][1] - tip[1],
                                         positions[i][2] - tip[2]),
                              h);
                }
                counts.push_back(static_cast<double>(positions.size() - 1));
            }
            // The fluid's part of a small ball around a point of its surface: 1/2 - 3/16 h H.
            const double curvature = nearest_surface_point(shape, tip).mean_curvature;
            EXPECT_NEAR(mean_of(counts), 1000 * (0.5 - 3.0 / 16 * h * curvature), 15);
            EXPECT_GT(deviation_of(counts), 10);
        }
    EXPECT_EQ(random_neighborhood(drop, {0, 0, 400}, h, spacing, 5),
              random_neighborhood(drop, {0, 0, 400}, h, spacing, 5));
}

std::string refusal(const Shape& shape, const std::function<void(CloudOptions&)>& change) {
    CloudOptions options = options_of(Arrangement::random);
    change(options);
    return error_of<InputError>([&] { fill(shape, options); });
}

TEST(Clouds, RefusesOptionsThatMakeNoCloud) {
    const Shape shape = sphere(5);
    for (const double value : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        EXPECT_NE(refusal(shape, [&](auto& o) { o.spacing = value; }).find("spacing"),
                  std::string::npos);
        EXPECT_NE(refusal(shape, [&](auto& o) { o.support_radius = value; }).find("support radius"),
                  std::string::npos);
        EXPECT_NE(refusal(shape, [&](auto& o) { o.thickness = value; }).find("thickness"),
                  std::string::npos);
        EXPECT_THROW(random_neighborhood(shape, {5, 0, 0}, value, 1, 0), InputError);
        EXPECT_THROW(random_neighborhood(shape, {5, 0, 0}, 1, value, 0), InputError);
        EXPECT_THROW(support_radius_in_spacings(value, 3, Arrangement::random), InputError);
    }
    for (const double value : {-0.1, 1.0, std::nan("")}) {
        EXPECT_NE(refusal(shape, [&](auto& o) { o.jitter = value; }).find("jitter"),
                  std::string::npos);
        EXPECT_NE(refusal(shape, [&](auto& o) { o.surface_share = value; }).find("share"),
                  std::string::npos);
    }
    expect_mentions(refusal(shape, [](auto& o) { o.spacing = 1e-3; }), {"sphere", "5e8", "0.001"});
    expect_mentions(refusal(shape, [](auto& o) { o.spacing = 1e-200; }), {"sphere", "5e8"});
    // Many, however thin: would take years to look through.
    expect_mentions(error_of<InputError>([] {
                        CloudOptions options = options_of(Arrangement::lattice);
                        options.thickness = 1e-6;
                        fill(plane(1e12, 2), options);
                    }),
                    {"plane", "5e8"});
    expect_mentions(refusal(shape, [](auto& o) { o.spacing = 11; }), {"sphere", "10.0", "11.0"});
    expect_mentions(refusal(shape,
                            [](auto& o) {
                                o.arrangement = Arrangement::lattice;
                                o.surface_share = 0.1;
                            }),
                    {"surface", "random"});
    EXPECT_THROW(random_neighborhood(shape, {5, 0, std::nan("")}, 1, 1, 0), InputError);
    EXPECT_THROW(random_neighborhood(shape, {5, 0, 0}, 1, 1e-4, 0), InputError);
    EXPECT_THROW(support_radius_in_spacings(30, 4, Arrangement::random), InputError);
}

} // namespace
} // namespace meniscus
