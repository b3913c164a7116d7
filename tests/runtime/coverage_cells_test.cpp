#include "random_caps.hpp"

#include <gtest/gtest.h>

namespace meniscus {
namespace {

Vector3 cell_direction(std::size_t k) {
    return {test_cells().x[k], test_cells().y[k], test_cells().z[k]};
}

/// The circle through three directions, as its middle and the cosine of its radius; the farthest
/// point from all directions is the middle of such a circle.
struct Circle {
    Vector3 middle;
    double cosine;

    Circle(const Vector3& a, const Vector3& b, const Vector3& c)
        : middle(cross(difference(b, a), difference(c, a))) {
        middle = scaled(1 / std::sqrt(dot(middle, middle)), middle);
        cosine = dot(middle, a);
    }
};

bool is_empty(const Vector3& middle, double cosine) {
    for (std::size_t k = 0; k < CoverageCells::count; ++k)
        if (dot(middle, cell_direction(k)) > cosine + 1e-6)
            return false;
    return true;
}

TEST(CoverageCells, CoveringRadiusIsThatOfTheDirections) {
    double farthest = 0;
    const double nothing_to_learn = std::cos(0.2);
    for (std::size_t a = 0; a < CoverageCells::count; ++a)
        for (std::size_t b = a + 1; b < CoverageCells::count; ++b)
            for (std::size_t c = b + 1; c < CoverageCells::count; ++c) {
                const Circle circle(cell_direction(a), cell_direction(b), cell_direction(c));
                for (const double side : {1.0, -1.0})
                    if (side * circle.cosine < nothing_to_learn &&
                        is_empty(scaled(side, circle.middle), side * circle.cosine))
                        farthest = std::max(farthest, std::acos(side * circle.cosine));
            }
    EXPECT_LT(farthest, CoverageCells::covering_radius);
    EXPECT_GT(farthest, CoverageCells::covering_radius - 0.001);
}

TEST(CoverageCells, WhatTheySettleIsSo) {
    std::mt19937_64 generator(1);
    ExactCoverage coverage;
    int settled_count = 0;
    constexpr int trials = 20000;
    for (int trial = 0; trial < trials; ++trial) {
        fill_caps<3>(coverage, random_neighborhood(generator, 3));
        const Settled settled = settle(test_cells(), coverage.caps, coverage.tests, true);
        // All caps near: what the arcs say without the help of cells.
        coverage.tests.is_near.assign(coverage.caps.size(), 1);
        if (coverage.caps.size() == 0)
            continue;
        const UncoveredPart alone = exact_coverage::part_by_boundary(coverage);
        if (settled == Settled::covered) {
            ASSERT_LE(alone.fraction, 1e-12) << trial;
        }
        if (settled == Settled::uncovered) {
            ASSERT_GT(alone.fraction, zero_uncovered_fraction) << trial;
        }
        settled_count += settled != Settled::undecided ? 1 : 0;
        const UncoveredPart part = uncovered_part<3>(test_cells(), coverage);
        ASSERT_NEAR(part.fraction, alone.fraction, 1e-12) << trial;
        const Vector3 off = difference(part.moment, alone.moment);
        ASSERT_LE(dot(off, off), 1e-24) << trial;
    }
    EXPECT_GT(settled_count, trials * 6 / 10);
}

TEST(CoverageCells, OneOpenDirectionIsEnoughAndTheSearchEndsThere) {
    ExactCoverage coverage;
    fill_caps<3>(coverage, {{0.5, 0, 0}});
    EXPECT_EQ(settle(test_cells(), coverage.caps, coverage.tests, false), Settled::uncovered);
    fill_caps<3>(coverage, {});
    EXPECT_EQ(settle(test_cells(), coverage.caps, coverage.tests, true), Settled::uncovered);
}

} // namespace
} // namespace meniscus
