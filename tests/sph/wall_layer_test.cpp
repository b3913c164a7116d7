#include <meniscus/sph/fluid/pair_sums.hpp>

#include "sample_fluids.hpp"

namespace meniscus {
namespace {

template <class SettingType>
class WallLayer : public testing::Test {
public:
    using Real = typename SettingType::Real;
    static constexpr int dimension = SettingType::dimension;
    using Sample = SampleFluid<Real, dimension>;

    /// What a flat wall adds to the density of a particle so many spacings away, by the plain sum
    /// over its lattice.
    static double layer_density(const FlatWall<Real>& wall, double spacing, double height) {
        const int reach = static_cast<int>(1 / spacing) + 1;
        const Lanes<Real> heights = all_lanes<Lanes<Real>>(static_cast<Real>(spacing * height));
        const double share =
            static_cast<double>(share_of(wall.share, heights, all_lanes<Lanes<Real>>(1)).value[0]);
        const PlainKernel kernel{KernelKind::cubic_spline, dimension, 1};
        double sum = 0;
        for (int x = -reach; x <= reach; ++x)
            for (int y = dimension == 3 ? -reach : 0; y <= (dimension == 3 ? reach : 0); ++y)
                sum += kernel.value(
                    spacing * std::hypot(static_cast<double>(x), static_cast<double>(y), height));
        return static_cast<double>(wall.volume) * share * sum;
    }

    /// What all layers behind a flat wall would add at rest, the first one `first` spacings away.
    static double density_behind(double spacing, double first) {
        FlatWall<Real> one;
        one.volume = static_cast<Real>(std::pow(spacing, dimension));
        double sum = 0;
        for (double layer = first; layer * spacing < 1; ++layer)
            sum += layer_density(one, spacing, layer);
        return sum;
    }
};
TYPED_TEST_SUITE(WallLayer, Settings);

TYPED_TEST(WallLayer, SlopeOfTheShareIsItsDerivative) {
    using Real = typename TypeParam::Real;
    using V = Lanes<Real>;
    WallShare<Real> share;
    share.inverse_spacing = Real(2);
    share.steepness = Real(3.4);
    share.far = Real(0.2);
    const Real step = std::is_same_v<Real, float> ? Real(1e-2) : Real(1e-5);
    for (int number = 0; number < 36; ++number)
        for (const Real flat : {Real(0), Real(0.4), Real(1)}) {
            const Real height = Real(0.05) + Real(0.0237) * static_cast<Real>(number);
            const V flats = all_lanes<V>(flat);
            const auto at = [&](Real where) {
                return share_of(share, all_lanes<V>(where), flats).value[0];
            };
            const Real slope = share_of(share, all_lanes<V>(height), flats).slope[0];
            const Real difference = (at(height + step) - at(height - step)) / (2 * step);
            EXPECT_NEAR(slope, difference, 20 * step) << "at " << height << ", flat " << flat;
        }
    EXPECT_EQ(share_of(share, all_lanes<V>(Real(0.5)), all_lanes<V>(Real(1))).value[0], Real(1));
}

TYPED_TEST(WallLayer, GradientIsThatOfTheDensity) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    PlainFluid plain = lattice_ball(dimension, KernelKind::cubic_spline, 1, 0.3);
    RandomNumbers random(3);
    for (int n = 0; n < 60; ++n) {
        Place wall = product_of(1.5, random.vector(dimension));
        wall[1] = -0.6;
        plain.walls.push_back(wall);
        plain.wall_volumes.push_back(std::pow(plain.spacing, dimension));
    }
    typename TestFixture::Sample sample(plain);
    auto& fluid = sample.fluid;
    fluid.wall_share.inverse_spacing = static_cast<Real>(1 / plain.spacing);
    fluid.wall_share.steepness = Real(3.4);
    fluid.wall_share.far = Real(0.3);
    for (auto& normal : fluid.wall_normal) {
        Place direction = random.vector(dimension);
        const double length = length_of(direction);
        normal = {static_cast<Real>(direction[0] / length),
                  static_cast<Real>(direction[1] / length),
                  static_cast<Real>(direction[2] / length), static_cast<Real>(std::abs(random()))};
    }
    const Real step = std::is_same_v<Real, float> ? Real(4e-3) : Real(1e-5);
    const CubicSpline<Real, dimension> kernel;
    double compared = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const Row<Real> sums = wall_sums(fluid, i, fluid.place[i], kernel);
        const Real gradient[3] = {sums.x, sums.y, sums.z};
        for (int axis = 0; axis < dimension; ++axis) {
            Row<Real> ahead = fluid.place[i], behind = fluid.place[i];
            (axis == 0 ? ahead.x : axis == 1 ? ahead.y : ahead.z) += step;
            (axis == 0 ? behind.x : axis == 1 ? behind.y : behind.z) -= step;
            const Real difference =
                (wall_sums(fluid, i, ahead, kernel).w - wall_sums(fluid, i, behind, kernel).w) /
                (2 * step);
            EXPECT_NEAR(gradient[axis], difference, 50 * step);
            compared += std::abs(static_cast<double>(gradient[axis]));
        }
    }
    EXPECT_GT(compared, 1);
}

/// On a lattice one spacing off a flat wall, the first layer of fluid finds the density of all that
/// would be behind the wall, and so does the second.
TYPED_TEST(WallLayer, StandsForAllLayersBehindIt) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    for (const double ratio : {1.8, 2.0, 2.6, 3.46, 4.2}) {
        const double spacing = 1 / ratio;
        const auto wall = flat_wall<Real, dimension>(CubicSpline<Real, dimension>{}, spacing);
        EXPECT_NEAR(this->layer_density(wall, spacing, 1), this->density_behind(spacing, 1), 1e-4);
        EXPECT_NEAR(this->layer_density(wall, spacing, 2), this->density_behind(spacing, 2), 1e-4);
    }
}

/// A mirror image comes closer by twice as much as the fluid.
TYPED_TEST(WallLayer, GrowsTwiceAsFastAsTheLayersBehindIt) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    const double step = std::is_same_v<Real, float> ? 1e-3 : 1e-5;
    for (const double ratio : {1.8, 2.0, 2.6, 3.46, 4.2}) {
        const double spacing = 1 / ratio;
        const auto wall = flat_wall<Real, dimension>(CubicSpline<Real, dimension>{}, spacing);
        const double growth =
            (this->layer_density(wall, spacing, 1 - step) - this->layer_density(wall, spacing, 1)) /
            step;
        const double behind =
            (this->density_behind(spacing, 1 - step) - this->density_behind(spacing, 1)) / step;
        EXPECT_NEAR(growth, 2 * behind, 0.02 * growth);
    }
}

} // namespace
} // namespace meniscus
