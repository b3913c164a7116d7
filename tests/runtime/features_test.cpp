#include <meniscus/runtime/features/features.hpp>

#include <gtest/gtest.h>
#include <vector>

namespace meniscus {
namespace {

template <class Real>
class Features : public testing::Test {};
using RealTypes = testing::Types<float, double>;
TYPED_TEST_SUITE(Features, RealTypes);

TYPED_TEST(Features, CenterOfMassOfTwoNeighbors) {
    using Real = TypeParam;
    const auto range = neighbor_range<Real>(2, 0.8);
    FeatureSum<Real, 3> sum;
    sum.add(std::array<Real, 3>{1, 0, 0}, Real(1), Real(3), range);
    sum.add(std::array<Real, 3>{0, 1, 0}, Real(1), Real(4), range);
    EXPECT_EQ(sum.count, 2);
    EXPECT_FLOAT_EQ(static_cast<float>(sum.mass), 7);
    // |(3, 4, 0)| / (2 * 7)
    EXPECT_FLOAT_EQ(static_cast<float>(mass_offset(sum, Real(2))), 5.0F / 14.0F);
}

/// The masses of water at h = 1 nm: in float the square of the sum would be 0.
TYPED_TEST(Features, MassesWhoseProductsVanishOrOverflowCancelOut) {
    using Real = TypeParam;
    const auto range = neighbor_range<Real>(2, 0.8);
    constexpr int max = std::numeric_limits<Real>::max_exponent;
    for (const int exponent : {max / 2 + 4, -max / 2 - 4, max - 3}) {
        const Real unit = std::ldexp(Real(1), exponent);
        FeatureSum<Real, 3> sum;
        sum.add(std::array<Real, 3>{1, 0, 0}, Real(1), 3 * unit, range);
        sum.add(std::array<Real, 3>{0, 1, 0}, Real(1), 4 * unit, range);
        EXPECT_FLOAT_EQ(static_cast<float>(mass_offset(sum, Real(2))), 5.0F / 14.0F);
    }
}

TYPED_TEST(Features, NeighborsOutsideTheRangeCountInNeitherFeature) {
    using Real = TypeParam;
    const Real h = Real(0.5);
    const auto range = neighbor_range<Real>(h, 0.8);
    for (const Real distance : {Real(0), Real(0.05), Real(0.1), h, Real(0.6)}) {
        FeatureSum<Real, 2> sum;
        sum.add(std::array<Real, 2>{distance, 0}, distance * distance, Real(1), range);
        EXPECT_EQ(sum.count, 0) << distance;
        EXPECT_EQ(sum.moment[0], Real(0));
        EXPECT_EQ(mass_offset(sum, h), Real(0));
    }
    for (const Real distance : {Real(0.101), Real(0.25), Real(0.4999)}) {
        FeatureSum<Real, 2> sum;
        sum.add(std::array<Real, 2>{0, -distance}, distance * distance, Real(1), range);
        EXPECT_EQ(sum.count, 1) << distance;
    }
}

TEST(NeighborBand, HoldsPairsAtTheSupportRadiusOutWhateverTheRounding) {
    // Lattice neighbors two spacings apart in float, moved about: all stand at h, none counts.
    const auto range = neighbor_range<float>(0.08, 0.8);
    for (int place = 0; place < 160; ++place) {
        const float first = 0.04F * static_cast<float>(place);
        const float second = 0.04F * static_cast<float>(place + 2);
        FeatureSum<float, 3> sum;
        sum.add(std::array<float, 3>{second - first, 0, 0}, (second - first) * (second - first),
                1.0F, range);
        EXPECT_EQ(sum.count, 0) << place;
    }
}

TEST(CsrNeighborhood, DeliversDisplacementsWithStrideAndMass) {
    const std::vector<float> positions{0, 0, 0, 99, 1, 2, 3, 99};
    const std::vector<float> masses{5, 7};
    const std::vector<int> offsets{0, 1, 1};
    const std::vector<int> neighbors{1};
    const CsrNeighborhood<float, 3, 4, int, int> view{positions.data(), masses.data(),
                                                      offsets.data(), neighbors.data()};
    int visits = 0;
    view(0, [&](std::size_t j, const auto& displacement, float mass) {
        ++visits;
        EXPECT_EQ(j, 1U);
        EXPECT_EQ(displacement, (std::array<float, 3>{1, 2, 3}));
        EXPECT_EQ(mass, 7);
    });
    view(1, [&](std::size_t, const auto&, float) { ++visits; });
    EXPECT_EQ(visits, 1);
}

} // namespace
} // namespace meniscus
