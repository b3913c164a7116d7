// Every feature of the list against its definition, and lines in any two of them.
#include "reference/feature_reference.hpp"

#include <meniscus/runtime/features/classifier.hpp>

#include <gtest/gtest.h>
#include <random>

namespace meniscus {
namespace {

/// Random particles around the first one, with masses and radii; lists of the first hold all
/// others.
template <class Real, int Dimension>
struct Cloud {
    std::vector<Real> positions;
    std::vector<Real> masses;
    std::vector<Real> radii;

    Cloud(std::size_t count, unsigned seed, Real h, bool vary) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> unit(0, 1);
        for (std::size_t n = 0; n < count; ++n) {
            for (int axis = 0; axis < Dimension; ++axis)
                positions.push_back(n == 0 ? Real(0)
                                           : static_cast<Real>((2 * unit(random) - 0.8)) * h);
            masses.push_back(static_cast<Real>(0.5 + unit(random)));
            radii.push_back(vary ? h * static_cast<Real>(0.7 + 0.6 * unit(random)) : h);
        }
    }

    /// The first particle's neighbors; the view of a host.
    template <class Visit>
    void operator()(std::size_t /*i*/, Visit&& visit) const {
        for (std::size_t j = 0; j < masses.size(); ++j) {
            std::array<Real, Dimension> displacement;
            for (int axis = 0; axis < Dimension; ++axis)
                displacement[axis] = positions[j * Dimension + axis] - positions[axis];
            visit(j, displacement, masses[j]);
        }
    }

    [[nodiscard]] std::map<std::string, double> by_definition() const {
        std::vector<test::ReferenceNeighbor<Dimension>> around;
        for (std::size_t j = 1; j < masses.size(); ++j) {
            const double mean = (double{radii[0]} + double{radii[j]}) / 2;
            test::ReferenceNeighbor<Dimension> neighbor;
            for (int axis = 0; axis < Dimension; ++axis)
                neighbor.step[axis] = double{positions[j * Dimension + axis]} / mean;
            neighbor.mass = double{masses[j]};
            neighbor.own_radius = double{radii[0]} / mean;
            neighbor.its_radius = double{radii[j]} / mean;
            around.push_back(neighbor);
        }
        return test::features_by_definition<Dimension>(around);
    }

    /// Turned by some angle about some axis.
    [[nodiscard]] Cloud turned(double angle) const {
        Cloud other = *this;
        const auto c = static_cast<Real>(std::cos(angle));
        const auto s = static_cast<Real>(std::sin(angle));
        for (std::size_t j = 0; j < masses.size(); ++j)
            for (int axis = 1; axis < Dimension; ++axis) {
                Real& a = other.positions[j * Dimension + axis - 1];
                Real& b = other.positions[j * Dimension + axis];
                const Real turned = c * a - s * b;
                b = s * a + c * b;
                a = turned;
            }
        return other;
    }
};

template <class Real, int Dimension, class Radii>
std::vector<FeatureNeighbor<Real, Dimension>> counted(const Cloud<Real, Dimension>& cloud,
                                                      const Radii& radii) {
    const auto range = range_of(radii, 0.8);
    std::vector<FeatureNeighbor<Real, Dimension>> neighbors;
    cloud(0, [&](std::size_t j, const auto& displacement, Real mass) {
        visit_if_in_range<Dimension>(displacement, mass, 0, j, radii, range,
                                     [&](const auto& one) { neighbors.push_back(one); });
    });
    return neighbors;
}

template <class Real, int Dimension, class Radii>
void expect_as_defined(const Cloud<Real, Dimension>& cloud, const Radii& radii) {
    const auto neighbors = counted(cloud, radii);
    const auto expected = cloud.by_definition();
    for (std::size_t f = 0; f < feature_count; ++f) {
        const double value = expected.at(feature_list[f].name);
        // Where eigenvalues are alike the closed form is off by the root of the rounding.
        const double error = std::is_same_v<Real, double> ? 1e-7 : feature_list[f].float_error;
        // Bounds hold for up to 64 neighbors, which a full support radius has.
        EXPECT_NEAR((feature_value<Real, Dimension>(f, neighbors.data(), neighbors.size())), value,
                    error * std::max(1.0, std::abs(value)))
            << feature_list[f].name << " of " << neighbors.size();
    }
}

template <class Real>
class EachFeature : public testing::Test {};
using RealTypes = testing::Types<float, double>;
TYPED_TEST_SUITE(EachFeature, RealTypes);

template <class Real, int Dimension>
void expect_clouds_as_defined() {
    for (const std::size_t count : {1U, 2U, 3U, 5U, 40U, 120U})
        for (unsigned seed = 1; seed < 6; ++seed)
            for (const Real h : {Real(1), Real(0.025)}) {
                const Cloud<Real, Dimension> cloud(count, seed, h, false);
                expect_as_defined(cloud, UniformRadius<Real>{h});
                expect_as_defined(cloud.turned(0.3 * seed), UniformRadius<Real>{h});
                const Cloud<Real, Dimension> varying(count, seed, h, true);
                expect_as_defined(varying, VaryingRadii<Real>{varying.radii.data()});
            }
}

TYPED_TEST(EachFeature, IsAsDefined) {
    expect_clouds_as_defined<TypeParam, 2>();
    expect_clouds_as_defined<TypeParam, 3>();
}

TYPED_TEST(EachFeature, EqualRadiiGiveTheFeaturesOfOne) {
    const Cloud<TypeParam, 3> cloud(60, 3, TypeParam(0.5), false);
    const auto one = counted(cloud, UniformRadius<TypeParam>{TypeParam(0.5)});
    const auto each = counted(cloud, VaryingRadii<TypeParam>{cloud.radii.data()});
    ASSERT_EQ(one.size(), each.size());
    for (std::size_t f = 0; f < feature_count; ++f)
        EXPECT_EQ((feature_value<TypeParam, 3>(f, one.data(), one.size())),
                  (feature_value<TypeParam, 3>(f, each.data(), each.size())));
}

TYPED_TEST(EachFeature, PapersPairAsItsOwnSums) {
    const Cloud<TypeParam, 3> cloud(60, 5, TypeParam(0.5), false);
    const auto neighbors = counted(cloud, UniformRadius<TypeParam>{TypeParam(0.5)});
    const auto sum = sum_features<TypeParam, 3>(cloud, 0, neighbor_range<TypeParam>(0.5, 0.8));
    constexpr FeaturePair pair;
    EXPECT_EQ((feature_value<TypeParam, 3>(pair.second, neighbors.data(), neighbors.size())),
              static_cast<TypeParam>(sum.count));
    EXPECT_NEAR((feature_value<TypeParam, 3>(pair.first, neighbors.data(), neighbors.size())),
                mass_offset(sum, TypeParam(0.5)), 1e-6);
}

TEST(Features, AreFoundByName) {
    static_assert(find_feature("mass_offset") == FeaturePair{}.first);
    static_assert(find_feature("density") == feature_count);
    for (std::size_t f = 0; f < feature_count; ++f) {
        EXPECT_EQ(find_feature(feature_list[f].name), f); // no name twice
        EXPECT_GT(feature_list[f].float_error, 0);
    }
}

struct Falling {
    static constexpr const char* features[] = {"gradient_eigenvalue", "direction_offset"};
    static constexpr bool surface_above = true;
    static constexpr double k = -0.02;
    static constexpr double d = 0.35;
    static constexpr int dimension = 3;
    static constexpr double radius_ratio = 0.8;
};

template <class Real, class Radii>
void expect_classified(const Cloud<Real, 3>& cloud, const Radii& radii, std::size_t& surface) {
    const auto expected = cloud.by_definition();
    const double above = expected.at("direction_offset") -
                         (Falling::k * expected.at("gradient_eigenvalue") + Falling::d);
    if (std::abs(above) < 1e-4)
        return;
    std::uint8_t found = 2;
    classify<Falling, Real, 3>(cloud, 0, 1, radii, &found);
    EXPECT_EQ(found, above > 0 ? 1 : 0);
    surface += found;
}

TYPED_TEST(EachFeature, ClassifyByTheFeaturesThatTheHeaderNames) {
    std::size_t surface = 0;
    for (unsigned seed = 1; seed < 60; ++seed) {
        const Cloud<TypeParam, 3> cloud(90, seed, TypeParam(0.5), false);
        expect_classified(cloud, UniformRadius<TypeParam>{TypeParam(0.5)}, surface);
        const Cloud<TypeParam, 3> varying(90, seed, TypeParam(0.5), true);
        expect_classified(varying, VaryingRadii<TypeParam>{varying.radii.data()}, surface);
    }
    EXPECT_GT(surface, 10U);
    EXPECT_LT(surface, 108U);
    static_assert(!has_features_of_paper<Falling>);
}

TYPED_TEST(EachFeature, WithoutNeighborsOrWithoutAValueIsSurface) {
    std::uint8_t found = 0;
    const UniformRadius<TypeParam> radius{TypeParam(0.5)};
    const Cloud<TypeParam, 3> alone(1, 1, TypeParam(0.5), false);
    EXPECT_EQ((classify<Falling, TypeParam, 3>(alone, 0, 1, TypeParam(0.5), &found)), 1U);
    Cloud<TypeParam, 3> cloud(90, 1, TypeParam(0.5), false);
    for (TypeParam& mass : cloud.masses)
        mass = std::numeric_limits<TypeParam>::infinity();
    EXPECT_EQ((classify<Falling, TypeParam, 3>(cloud, 0, 1, radius, &found)), 1U);
}

template <int Dimension>
void expect_min_eigenvalues() {
    using Matrix = Eigen::Matrix<double, Dimension, Dimension>;
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 1000; ++trial) {
        Matrix root;
        for (int row = 0; row < Dimension; ++row)
            for (int column = 0; column < Dimension; ++column)
                root(row, column) = normal(random);
        Matrix matrix = root + root.transpose();
        if (trial % 4 == 1) // of rank one, all other eigenvalues alike
            matrix = root.col(0) * root.col(0).transpose();
        if (trial % 4 == 2)
            matrix = Matrix::Identity() * root(0, 0);
        double lower[matrix_terms<Dimension>];
        int entry = 0;
        for (int row = 0; row < Dimension; ++row)
            for (int column = 0; column <= row; ++column)
                lower[entry++] = matrix(row, column);
        EXPECT_NEAR(min_eigenvalue<Dimension>(lower),
                    Eigen::SelfAdjointEigenSolver<Matrix>(matrix).eigenvalues()[0],
                    1e-7 * std::max(1.0, matrix.norm()));
    }
}

TEST(MinEigenvalue, IsThatOfEigen) {
    expect_min_eigenvalues<2>();
    expect_min_eigenvalues<3>();
}

} // namespace
} // namespace meniscus
