#include <meniscus/sph/pressure/lattice_waves.hpp>

#include <gtest/gtest.h>

namespace meniscus {
namespace {

template <int Dimension>
float share_at(double ratio) {
    Fluid<float, Dimension> fluid;
    fluid.spacing = 1 / ratio;
    return stable_share(fluid);
}

/// The largest ratios |S|^2 / sum |grad W|^2 of the cubic spline, from sums written anew in another
/// language: 2.82, 7.47, 20.4 in three dimensions at 2, 3 and 4.2 spacings, 2.15, 3.78, 7.37 in
/// two.
TEST(LatticeWaves, IterationsSlowDownWhereMoreNeighborsCouple) {
    EXPECT_EQ(share_at<3>(2), 1.0F);
    EXPECT_NEAR(share_at<3>(3), 3 / 7.47, 0.004);
    EXPECT_NEAR(share_at<3>(4.2), 3 / 20.4, 0.002);
    EXPECT_EQ(share_at<2>(2), 1.0F);
    EXPECT_NEAR(share_at<2>(3), 3 / 3.776, 0.008);
    EXPECT_NEAR(share_at<2>(4.2), 3 / 7.375, 0.004);
}

} // namespace
} // namespace meniscus
