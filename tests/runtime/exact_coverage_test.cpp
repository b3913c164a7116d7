// Exact coverage against formulas: cases whose uncovered part is known, degenerate ones above all.
#include "random_caps.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

constexpr double exact = 1e-12;

/// Distance at which a neighbor covers a cap of that angular radius, the closer of the two.
double distance_of_cap(double angle, double radius_ratio = test_radius_ratio) {
    const double cosine = std::cos(angle);
    return cosine - std::sqrt(cosine * cosine - 1 + radius_ratio * radius_ratio);
}

/// Part of the sphere that a cap covers.
double cap_fraction(double angle) {
    return (1 - std::cos(angle)) / 2;
}

/// Part of the sphere that two caps share whose middles are `apart` and whose edges cut
/// (Tovchigrechko and Vakser 2001, How common is the funnel-like energy landscape...).
double shared_fraction(double one, double other, double apart) {
    const auto corner = [](double across, double a, double b) {
        return std::acos((std::cos(across) - std::cos(a) * std::cos(b)) /
                         (std::sin(a) * std::sin(b)));
    };
    return (pi - corner(apart, one, other) - corner(other, apart, one) * std::cos(one) -
            corner(one, apart, other) * std::cos(other)) /
           (2 * pi);
}

Vector3 at_angle(double angle, double distance) {
    return {distance * std::cos(angle), distance * std::sin(angle), 0};
}

Displacements six_around(double distance) {
    return {{distance, 0, 0},  {-distance, 0, 0}, {0, distance, 0},
            {0, -distance, 0}, {0, 0, distance},  {0, 0, -distance}};
}

/// Neighbors on the simple cubic lattice, with h = `spacings` spacings, kept by keep(x, y, z).
template <class Keep>
Displacements lattice(double spacings, Keep&& keep) {
    Displacements neighbors;
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y)
            for (int z = -3; z <= 3; ++z) {
                const Vector3 place{x / spacings, y / spacings, z / spacings};
                const double square = dot(place, place);
                if (square > 0 && square < 1 - 1e-9 && keep(x, y, z))
                    neighbors.push_back(place);
            }
    return neighbors;
}

TEST(ExactCoverage, NoNeighborCoversNothing) {
    const UncoveredPart part = uncovered({});
    EXPECT_EQ(part.fraction, 1);
    EXPECT_EQ(part.moment, (Vector3{0, 0, 0}));
    EXPECT_EQ(uncovered<2>({}).fraction, 1);
}

TEST(ExactCoverage, OneNeighborCoversItsCap) {
    for (const double distance : {0.2001, 0.21, 0.4, 0.6, 0.9, 1.0}) {
        const double cosine = (distance * distance + 1 - 0.64) / (2 * distance);
        for (const Vector3 direction :
             {Vector3{1, 0, 0}, Vector3{0, 0, -1}, Vector3{0.48, -0.6, 0.64}}) {
            const UncoveredPart part = uncovered({scaled(distance, direction)});
            EXPECT_NEAR(part.fraction, (1 + cosine) / 2, exact);
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(part.moment[axis], -(1 - cosine * cosine) / 4 * direction[axis], exact);
        }
        const UncoveredPart part = uncovered<2>({{0, distance, 0}});
        EXPECT_NEAR(part.fraction, 1 - std::acos(cosine) / pi, exact);
        EXPECT_NEAR(part.moment[0], 0, exact);
        EXPECT_NEAR(part.moment[1], -std::sqrt(1 - cosine * cosine) / pi, exact);
    }
}

TEST(ExactCoverage, NeighborsThatCoverNothing) {
    const double nan = std::nan("");
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(
        uncovered({{0, 0, 0}, {0.1, 0, 0}, {0, 0.2 - 1e-12, 0}, {0, 0, 1.8 + 1e-12}}).fraction, 1);
    EXPECT_EQ(uncovered({{nan, 0, 0}, {infinity, 0, 0}, {0, -infinity, nan}}).fraction, 1);
}

TEST(ExactCoverage, CoincidentNeighborsCoverOnce) {
    const UncoveredPart once = uncovered({{0.3, 0.4, 0.2}, {-0.5, 0, 0.1}});
    Displacements many;
    for (int n = 0; n < 500; ++n) {
        many.push_back({0.3, 0.4, 0.2});
        many.push_back({-0.5, 0, 0.1});
    }
    const UncoveredPart part = uncovered(many);
    EXPECT_NEAR(part.fraction, once.fraction, exact);
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(part.moment[axis], once.moment[axis], exact);
    EXPECT_NEAR(uncovered<2>({{0.3, 0.4, 0}, {0.3, 0.4, 0}}).fraction,
                uncovered<2>({{0.3, 0.4, 0}}).fraction, exact);
}

TEST(ExactCoverage, OfTwoCapsInOneDirectionTheLargerCounts) {
    // Distances d and (1 - rho^2) / d cover the same cap.
    for (const auto& [near, far] : {std::pair{0.5, 0.72}, {0.4, 0.9}, {0.6, 0.6}})
        EXPECT_NEAR(uncovered({{0, near, 0}, {0, far, 0}}).fraction,
                    uncovered({{0, far, 0}}).fraction, exact);
    EXPECT_NEAR(uncovered({{0, 0.6, 0}, {0, 0.3, 0}, {0, 0.95, 0}}).fraction,
                uncovered({{0, 0.6, 0}}).fraction, exact);
}

TEST(ExactCoverage, TwoCapsApartTouchingAndOverlapping) {
    for (const auto& [one, other] : {std::pair{0.3, 0.3}, {0.9, 0.9}, {0.2, 0.8}, {0.05, 0.5}}) {
        for (const double apart :
             {one + other + 0.3, one + other + 1e-9, one + other, one + other - 1e-9,
              0.9 * (one + other), 1.01 * (other - one), other - one + 1e-9, other - one}) {
            if (apart < 1e-6) // the formula cannot tell
                continue;
            const UncoveredPart part = uncovered({at_angle(0.2, distance_of_cap(one)),
                                                  at_angle(0.2 + apart, distance_of_cap(other))});
            double shared = 0;
            if (apart <= other - one)
                shared = cap_fraction(one);
            else if (apart < one + other)
                shared = shared_fraction(one, other, apart);
            // The formula itself loses half the digits where caps touch.
            EXPECT_NEAR(part.fraction, 1 - cap_fraction(one) - cap_fraction(other) + shared, 1e-8)
                << one << " " << other << " " << apart;
        }
    }
}

TEST(ExactCoverage, SixCapsThatTouch) {
    // Caps of 45 degrees around the axes touch their neighbors in twelve points.
    const double fraction = uncovered(six_around(distance_of_cap(pi / 4))).fraction;
    EXPECT_NEAR(fraction, 1 - 6 * cap_fraction(pi / 4), 1e-9);
}

TEST(ExactCoverage, SixCapsThroughEightPointsCoverAll) {
    // The edges of the six caps meet at the corners of a cube, three at a time.
    const double angle = std::acos(1 / std::sqrt(3.0));
    const auto fraction = [&](double by) {
        return uncovered(six_around(distance_of_cap(angle + by, 0.9)), 0.9).fraction;
    };
    EXPECT_LE(fraction(0), zero_uncovered_fraction);
    EXPECT_EQ(fraction(1e-4), 0);
    // Beyond, eight triangles open. Each corner of a triangle lies where two edges cut.
    const double open = fraction(-1e-3);
    EXPECT_GT(open, 1e-7);
    EXPECT_LT(open, 1e-5);
    EXPECT_NEAR(fraction(-2e-3) / open, 4, 0.02);
}

TEST(ExactCoverage, FullLatticesAreCovered) {
    const auto all = [](int, int, int) { return true; };
    for (const double spacings : {2.0, 2.2, 2.5, 3.0})
        EXPECT_EQ(uncovered(lattice(spacings, all)).fraction, 0) << spacings;
}

TEST(ExactCoverage, FlatSurfaceOfALattice) {
    for (const double spacings : {2.0, 2.5, 3.0}) {
        const UncoveredPart part =
            uncovered(lattice(spacings, [](int, int, int z) { return z <= 0; }));
        EXPECT_GT(part.fraction, 0.05);
        EXPECT_LT(part.fraction, 0.5);
        EXPECT_NEAR(part.moment[0], 0, 1e-9);
        EXPECT_NEAR(part.moment[1], 0, 1e-9);
        EXPECT_GT(part.moment[2], 0.01);
        // A layer below is covered.
        EXPECT_EQ(uncovered(lattice(spacings, [](int, int, int z) { return z <= 1; })).fraction, 0);
    }
}

TEST(ExactCoverage, LatticesDoNotDependOnTheirRotation) {
    std::mt19937_64 generator(5);
    const auto half = lattice(2.5, [](int x, int y, int z) { return x + y + z <= 0; });
    const double fraction = uncovered(half).fraction;
    for (int trial = 0; trial < 200; ++trial) {
        const Vector3 axis = random_direction(generator, 3);
        const Frame frame(axis);
        Displacements turned;
        for (const Vector3& x : half)
            turned.push_back(sum(scaled(x[0], frame.first),
                                 sum(scaled(x[1], frame.second), scaled(x[2], axis))));
        EXPECT_NEAR(uncovered(turned).fraction, fraction, zero_uncovered_fraction);
    }
}

TEST(ExactCoverage, PinholesAreFound) {
    // Rings of caps around the x axis cover all but a hole around +x.
    const double angle = 0.9;
    for (const double hole : {0.3, 0.1, 0.01, 1e-3}) {
        Displacements rings;
        for (int ring = 0; ring < 8; ++ring)
            for (int n = 0; n < 40; ++n) {
                const double away = std::min(angle + hole + 0.3 * ring, pi);
                const double around = n * 2 * pi / 40;
                rings.push_back(scaled(distance_of_cap(angle),
                                       {std::cos(away), std::sin(away) * std::cos(around),
                                        std::sin(away) * std::sin(around)}));
            }
        const UncoveredPart part = uncovered(rings);
        // A regular polygon of 40 arcs that touch the hole's circle from outside.
        EXPECT_GT(part.fraction, cap_fraction(hole));
        EXPECT_LT(part.fraction, 1.02 * cap_fraction(hole));
        EXPECT_GT(part.moment[0], 0.95 * part.fraction);
        rings.push_back({distance_of_cap(angle), 0, 0});
        EXPECT_EQ(uncovered(rings).fraction, 0);
    }
}

TEST(ExactCoverage, CircleCoveredByArcs) {
    // Half-angle of 0.9 at four places leaves four gaps of pi / 2 - 1.8 < 0: covered.
    const double wide = distance_of_cap(0.9);
    const double narrow = distance_of_cap(0.5);
    Displacements four;
    for (int n = 0; n < 4; ++n)
        four.push_back(at_angle(n * pi / 2, wide));
    EXPECT_EQ(uncovered<2>(four).fraction, 0);
    for (Vector3& x : four)
        x = scaled(narrow / wide, x);
    EXPECT_NEAR(uncovered<2>(four).fraction, 1 - 4 / (2 * pi), exact);
    // Arcs that touch end to end, all around.
    Displacements touching;
    for (int n = 0; n < 6; ++n)
        touching.push_back(at_angle(n * pi / 3, distance_of_cap(pi / 6)));
    EXPECT_LE(uncovered<2>(touching).fraction, zero_uncovered_fraction);
}

TEST(ExactCoverage, MoreThanAThousandNeighbors) {
    std::mt19937_64 generator(3);
    Displacements below;
    while (below.size() < 1500) {
        const Vector3 x = scaled(0.95, random_direction(generator, 3));
        if (x[2] < -0.2)
            below.push_back(x);
    }
    const UncoveredPart part = uncovered(below);
    EXPECT_GT(part.fraction, 0.15);
    EXPECT_LT(part.fraction, 0.4);
    EXPECT_NEAR(part.moment[0] / part.moment[2], 0, 0.05);
}

TEST(ExactCoverage, FloatDisplacementsAndOtherUnits) {
    ExactCoverage coverage;
    for (const double h : {1e-9, 1.0, 1e9}) {
        coverage.caps.clear();
        const std::array<float, 3> x{static_cast<float>(0.5 * h), 0, 0};
        add_cap<3>(coverage.caps, x, h, 0.8 * h);
        EXPECT_NEAR(uncovered_part<3>(test_cells(), coverage).fraction, (1 + 0.61) / 2, 1e-6);
    }
}

} // namespace
} // namespace meniscus
