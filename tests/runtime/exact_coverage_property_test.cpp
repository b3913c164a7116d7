// What must hold for any neighborhood, tried on tens of thousands of random ones.
#include "random_caps.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace meniscus {
namespace {

constexpr int trials = 20000;
/// Rounding moves lambda by no more.
constexpr double band = 1e-9;

class ExactCoverageProperty : public testing::TestWithParam<int> {
protected:
    std::mt19937_64 generator{2020};

    [[nodiscard]] UncoveredPart part_of(const Displacements& neighbors) const {
        return GetParam() == 2 ? uncovered<2>(neighbors) : uncovered<3>(neighbors);
    }
};

TEST_P(ExactCoverageProperty, LambdaLiesBetweenZeroAndOne) {
    for (int trial = 0; trial < trials; ++trial) {
        const UncoveredPart part = part_of(random_neighborhood(generator, GetParam()));
        ASSERT_GE(part.fraction, 0) << trial;
        ASSERT_LE(part.fraction, 1) << trial;
        // No more than if all of it lay in one direction.
        ASSERT_LE(dot(part.moment, part.moment), std::pow(part.fraction, 2) + band) << trial;
    }
}

TEST_P(ExactCoverageProperty, AFurtherCovererNeverUncovers) {
    for (int trial = 0; trial < trials / 20; ++trial) {
        const Displacements all = random_neighborhood(generator, GetParam());
        Displacements some;
        double before = 1;
        for (const Vector3& x : all) {
            some.push_back(x);
            const double after = part_of(some).fraction;
            ASSERT_LE(after, before + band) << trial << ", neighbor " << some.size();
            before = after;
        }
    }
}

TEST_P(ExactCoverageProperty, RotationTurnsTheMomentAndNothingElse) {
    for (int trial = 0; trial < trials; ++trial) {
        const Displacements neighbors = random_neighborhood(generator, GetParam());
        const Vector3 axis = GetParam() == 2 ? Vector3{0, 0, 1} : random_direction(generator, 3);
        const Vector3 aside = random_direction(generator, 2);
        const Frame flat(axis);
        const Vector3 first = sum(scaled(aside[0], flat.first), scaled(aside[1], flat.second));
        const Vector3 second = cross(axis, first);
        const auto turned = [&](const Vector3& x) {
            return sum(scaled(x[0], first), sum(scaled(x[1], second), scaled(x[2], axis)));
        };
        Displacements others;
        for (const Vector3& x : neighbors)
            others.push_back(turned(x));
        const UncoveredPart part = part_of(neighbors);
        const UncoveredPart other = part_of(others);
        ASSERT_NEAR(other.fraction, part.fraction, band) << trial;
        const Vector3 off = difference(other.moment, turned(part.moment));
        ASSERT_LE(dot(off, off), band * band) << trial;
    }
}

TEST_P(ExactCoverageProperty, OrderChangesNothing) {
    for (int trial = 0; trial < trials; ++trial) {
        Displacements neighbors = random_neighborhood(generator, GetParam());
        const UncoveredPart part = part_of(neighbors);
        std::shuffle(neighbors.begin(), neighbors.end(), generator);
        ASSERT_NEAR(part_of(neighbors).fraction, part.fraction, band) << trial;
    }
}

TEST_P(ExactCoverageProperty, ScaleChangesNothing) {
    ExactCoverage coverage;
    std::uniform_real_distribution<double> exponent(-9, 9);
    for (int trial = 0; trial < trials; ++trial) {
        const Displacements neighbors = random_neighborhood(generator, GetParam());
        const double h = std::pow(10, exponent(generator));
        coverage.caps.clear();
        for (const Vector3& x : neighbors)
            if (GetParam() == 2)
                add_cap<2>(coverage.caps, scaled(h, x), h, test_radius_ratio * h);
            else
                add_cap<3>(coverage.caps, scaled(h, x), h, test_radius_ratio * h);
        const double fraction = (GetParam() == 2 ? uncovered_part<2>(test_cells(), coverage)
                                                 : uncovered_part<3>(test_cells(), coverage))
                                    .fraction;
        ASSERT_NEAR(fraction, part_of(neighbors).fraction, band) << trial;
    }
}

/// Neighbors in bunches whose members all but coincide, where cuts of circles are ill conditioned.
TEST_P(ExactCoverageProperty, BunchesCoverWhatOneOfThemCovers) {
    std::uniform_int_distribution<int> members(1, 4);
    for (const double spread : {0.0, 1e-16, 1e-14, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8}) {
        for (int trial = 0; trial < trials / 20; ++trial) {
            const Displacements neighbors = random_neighborhood(generator, GetParam());
            Displacements bunches;
            for (const Vector3& x : neighbors)
                for (int n = members(generator); n > 0; --n)
                    bunches.push_back(
                        sum(x, scaled(spread, random_direction(generator, GetParam()))));
            // A bunch reaches farther by its spread.
            ASSERT_NEAR(part_of(bunches).fraction, part_of(neighbors).fraction, band + 10 * spread)
                << "spread " << spread << ", trial " << trial;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, ExactCoverageProperty, testing::Values(2, 3),
                         [](const auto& info) { return std::to_string(info.param) + "D"; });

} // namespace
} // namespace meniscus
