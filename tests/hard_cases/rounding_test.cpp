// No label outside the rounding band changes, whatever arithmetic this program was built with.
#include "rounding_fluids.hpp"

#include <gtest/gtest.h>

namespace meniscus::test {
namespace {

template <class Real>
class RoundingBandOf : public testing::Test {
protected:
    LabelChanges changes;

    void add(const HardCase& fluid) { add_changes<Real>(fluid, changes); }

    void expect_all_inside() const {
        EXPECT_GT(changes.particles, 0U);
        EXPECT_EQ(changes.outside, 0U)
            << changes.by_coverage << " labels changed by coverage, lambda up to "
            << changes.farthest_lambda << ", neighbors up to " << changes.farthest_distance
            << " h from a limit; " << changes.by_line << " by the line, up to "
            << changes.farthest_from_line << " neighbors from it";
        // lambda itself is off by no more, but where circles all but coincide.
        EXPECT_LE(changes.max_lambda_error, sizeof(Real) == 4 ? 1e-5 : 1e-7);
    }
};

using RealTypes = testing::Types<float, double>;
TYPED_TEST_SUITE(RoundingBandOf, RealTypes);

TYPED_TEST(RoundingBandOf, HardCases) {
    for_hard_cases([this](const HardCase& fluid) { this->add(fluid); });
    this->expect_all_inside();
}

TYPED_TEST(RoundingBandOf, RandomNeighborhoods) {
    for_random_fluids(1000, [this](const HardCase& fluid) { this->add(fluid); });
    this->expect_all_inside();
}

TYPED_TEST(RoundingBandOf, Samples) {
    for_samples(MENISCUS_SAMPLES, 9000, [this](const HardCase& fluid) { this->add(fluid); });
    this->expect_all_inside();
}

} // namespace
} // namespace meniscus::test
