// Features where every particle has a support radius of its own.
#include <meniscus/runtime/features/classifier.hpp>

#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace meniscus {
namespace {

/// Particles that all see each other: lists hold everyone, i itself included.
template <class Real, int Dimension>
struct Crowd {
    std::vector<Real> positions;
    std::vector<Real> masses;
    std::vector<Real> radii;
    std::vector<std::size_t> offsets{0};
    std::vector<std::uint32_t> neighbors;

    Crowd(std::size_t count, unsigned seed, Real max_radius) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<Real> coordinate(0, 2);
        for (std::size_t n = 0; n < count * Dimension; ++n)
            positions.push_back(coordinate(random));
        for (std::size_t n = 0; n < count; ++n) {
            masses.push_back(Real(0.5) + coordinate(random));
            radii.push_back(1 + (max_radius - 1) * coordinate(random) / 2);
            for (std::uint32_t j = 0; j < count; ++j)
                neighbors.push_back(j);
            offsets.push_back(neighbors.size());
        }
    }

    [[nodiscard]] CsrNeighborhood<Real, Dimension> view() const {
        return {positions.data(), masses.data(), offsets.data(), neighbors.data()};
    }
};

template <class Real>
class ScaledFeatures : public testing::Test {};
using RealTypes = testing::Types<float, double>;
TYPED_TEST_SUITE(ScaledFeatures, RealTypes);

/// x and y of particle i by their definition, in double.
template <class Real, int Dimension>
std::array<double, 2> features_by_definition(const Crowd<Real, Dimension>& crowd, std::size_t i) {
    double moment[Dimension] = {};
    double weights = 0;
    double count = 0;
    for (std::size_t j = 0; j < crowd.radii.size(); ++j) {
        const double radius = 0.5 * (double{crowd.radii[i]} + double{crowd.radii[j]});
        double offset[Dimension];
        double square = 0;
        for (int axis = 0; axis < Dimension; ++axis) {
            offset[axis] = (double{crowd.positions[j * Dimension + axis]} -
                            double{crowd.positions[i * Dimension + axis]}) /
                           radius;
            square += offset[axis] * offset[axis];
        }
        const double distance = std::sqrt(square);
        if (!(distance > 0.2 * (1 + neighbor_band) && distance < 1 - neighbor_band))
            continue;
        const double weight = crowd.masses[j] / std::pow(radius, Dimension);
        for (int axis = 0; axis < Dimension; ++axis)
            moment[axis] += weight * offset[axis];
        weights += weight;
        count += std::pow(crowd.radii[j] / radius, Dimension);
    }
    double square = 0;
    for (const double component : moment)
        square += component * component;
    return {weights == 0 ? 0 : std::sqrt(square) / weights, count};
}

template <class Real, int Dimension>
void expect_definition() {
    const Crowd<Real, Dimension> crowd(150, 1, 3);
    const VaryingRadii<Real> radii{crowd.radii.data()};
    const auto range = neighbor_range<Real>(1, 0.8);
    const double tolerance = 1000 * std::numeric_limits<Real>::epsilon();
    for (std::size_t i = 0; i < crowd.radii.size(); ++i) {
        const auto sum = sum_features<Real, Dimension>(crowd.view(), i, radii, range);
        const auto [x, y] = features_by_definition<Real, Dimension>(crowd, i);
        EXPECT_NEAR(mass_offset(sum, Real(1)), x, tolerance) << i;
        EXPECT_NEAR(sum.count, y, y * tolerance) << i;
        EXPECT_GT(y, 1);
    }
}

TYPED_TEST(ScaledFeatures, AreTheirDefinition) {
    expect_definition<TypeParam, 2>();
    expect_definition<TypeParam, 3>();
}

TYPED_TEST(ScaledFeatures, OfEqualRadiiAreThoseOfOneRadius) {
    using Real = TypeParam;
    Crowd<Real, 3> crowd(150, 2, 1);
    const Real h = Real(0.7); // so that 1 / h is rounded
    crowd.radii.assign(150, h);
    const VaryingRadii<Real> radii{crowd.radii.data()};
    const auto range = neighbor_range<Real>(1, 0.8);
    const auto range_of_one = neighbor_range<Real>(h, 0.8);
    const double tolerance = 100 * std::numeric_limits<Real>::epsilon();
    for (std::size_t i = 0; i < 150; ++i) {
        const auto each = sum_features<Real, 3>(crowd.view(), i, radii, range);
        const auto one = sum_features_reference<Real, 3>(crowd.view(), i, range_of_one);
        EXPECT_EQ(each.count, static_cast<Real>(one.count)); // whole, to the bit
        EXPECT_EQ(each.mass, one.mass);
        EXPECT_NEAR(mass_offset(each, Real(1)), mass_offset(one, h), tolerance);
    }
    // Far off the line, where rounding does not matter, the classes are the same.
    const SurfaceLine<Real> line{Real(20.3), Real(3.7)};
    std::vector<std::uint8_t> of_each(150);
    std::vector<std::uint8_t> of_one(150);
    classify<Real, 3>(crowd.view(), 0, 150, radii, line, 0.8, of_each.data());
    const auto found =
        classify<Real, 3>(crowd.view(), 0, 150, h, line, range_of_one, of_one.data());
    EXPECT_EQ(of_each, of_one);
    EXPECT_GT(found, 0U);
    EXPECT_LT(found, 150U);
}

TYPED_TEST(ScaledFeatures, DoNotDependOnTheUnits) {
    using Real = TypeParam;
    Crowd<Real, 3> crowd(100, 3, 4);
    const auto range = neighbor_range<Real>(1, 0.8);
    const VaryingRadii<Real> radii{crowd.radii.data()};
    std::vector<FeatureSum<Real, 3, Real>> sums;
    for (std::size_t i = 0; i < 100; ++i)
        sums.push_back(sum_features<Real, 3>(crowd.view(), i, radii, range));
    for (Real& value : crowd.positions)
        value *= Real(0x1p-40);
    for (Real& value : crowd.radii)
        value *= Real(0x1p-40);
    for (Real& value : crowd.masses)
        value *= Real(0x1p-30);
    for (std::size_t i = 0; i < 100; ++i) {
        const auto sum = sum_features<Real, 3>(crowd.view(), i, radii, range);
        EXPECT_EQ(sum.count, sums[i].count);
        // Rounded alike, but for fast mathematics.
        EXPECT_NEAR(mass_offset(sum, Real(1)), mass_offset(sums[i], Real(1)),
                    std::numeric_limits<Real>::epsilon());
    }
}

TYPED_TEST(ScaledFeatures, ParticlesOfOneResolutionSeenFromAnother) {
    using Real = TypeParam;
    // A large neighbor on one side, eight small ones in its place on the other: no offset.
    std::vector<Real> positions{0, 0, 0, 1, 0, 0};
    std::vector<Real> masses{1, 8};
    std::vector<Real> radii{2, 2};
    std::vector<std::size_t> offsets{0, 9};
    std::vector<std::uint32_t> neighbors{1};
    for (std::uint32_t n = 0; n < 8; ++n) {
        positions.insert(positions.end(), {Real(-0.75), 0, 0}); // as far in its own h_ij = 1.5
        masses.push_back(Real(8 * 0.421875 / 8));               // (1.5 / 2)^3
        radii.push_back(1);
        neighbors.push_back(2 + n);
    }
    const CsrNeighborhood<Real, 3> view{positions.data(), masses.data(), offsets.data(),
                                        neighbors.data()};
    const auto sum = sum_features<Real, 3>(view, 0, VaryingRadii<Real>{radii.data()},
                                           neighbor_range<Real>(1, 0.8));
    EXPECT_NEAR(mass_offset(sum, Real(1)), 0, 1e-6);
    EXPECT_NEAR(sum.count, 1 + 8 / 3.375, 1e-5); // (1 / 1.5)^3 each
}

struct ExportedLine {
    static constexpr double k = 116.7;
    static constexpr double d = 25.97;
    static constexpr int dimension = 3;
    static constexpr double radius_ratio = 0.8;
};

TYPED_TEST(ScaledFeatures, ClassifyByTheExportedLine) {
    using Real = TypeParam;
    const Crowd<Real, 3> crowd(150, 4, 2);
    const VaryingRadii<Real> radii{crowd.radii.data()};
    std::vector<std::uint8_t> surface(150, 7);
    const std::size_t found =
        classify<ExportedLine, Real, 3>(crowd.view(), 10, 140, radii, surface.data());
    std::size_t expected = 0;
    for (std::size_t i = 0; i < 150; ++i) {
        const auto sum = sum_features<Real, 3>(crowd.view(), i, radii,
                                               neighbor_range<Real>(1, ExportedLine::radius_ratio));
        const bool below =
            sum.count <= ExportedLine::k * mass_offset(sum, Real(1)) + ExportedLine::d;
        if (i < 10 || i >= 140) {
            EXPECT_EQ(surface[i], 7) << i;
        } else {
            EXPECT_EQ(surface[i], below ? 1 : 0) << i;
            expected += below ? 1 : 0;
        }
    }
    EXPECT_EQ(found, expected);
}

TYPED_TEST(ScaledFeatures, RadiiThatAreNotFiniteMakeSurface) {
    using Real = TypeParam;
    Crowd<Real, 3> crowd(60, 5, 2);
    crowd.radii[7] = std::numeric_limits<Real>::quiet_NaN();
    std::vector<std::uint8_t> surface(60);
    const VaryingRadii<Real> radii{crowd.radii.data()};
    classify<Real, 3>(crowd.view(), 0, 60, radii, {Real(0), Real(0)}, 0.8, surface.data());
    for (std::size_t i = 0; i < 60; ++i)
        EXPECT_EQ(surface[i], i == 7 ? 1 : 0) << i; // to the others it is no neighbor
}

} // namespace
} // namespace meniscus
