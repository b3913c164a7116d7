#include <meniscus/runtime/math/random_directions.hpp>
#include <meniscus/runtime/surface/curvature_map.hpp>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

constexpr double ratio = 0.8;

/// lambda of a particle on a surface of that h kappa: the neighbors that cover most stand
/// cos(alpha) radii away, where their caps have the half angle alpha, and on the surface, so that
/// cos(alpha) / 2 is the cosine of how far they lie from the normal for h kappa = -1.
template <int Dimension>
double uncovered_part(double curvature, double radius_ratio) {
    const double alpha = std::asin(radius_ratio);
    const double neighbor = std::acos(-curvature * std::cos(alpha) / 2);
    const double opening = neighbor - alpha;
    return Dimension == 2 ? opening / pi : (1 - std::cos(opening)) / 2;
}

template <int Dimension>
void expect_inverse() {
    for (const double radius_ratio : {0.5, 0.8, 0.95}) {
        const double min = -2;
        const double max = 2 / std::sqrt(1 - radius_ratio * radius_ratio);
        for (double curvature = min; curvature <= max; curvature += 0.01)
            EXPECT_NEAR(curvature_of<Dimension>(uncovered_part<Dimension>(curvature, radius_ratio),
                                                radius_ratio),
                        curvature, 1e-6)
                << radius_ratio;
    }
}

TEST(ClosedForm, InvertsTheUncoveredPartOfARoundSurface) {
    expect_inverse<2>();
    expect_inverse<3>();
}

template <int Dimension>
void expect_rising_then_constant(double turning_point) {
    double last = curvature_of<Dimension>(0, ratio);
    EXPECT_NEAR(last, -2, 1e-12);
    EXPECT_EQ(curvature_of<Dimension>(-0.1, ratio), last);
    for (double lambda = 0.001; lambda < turning_point; lambda += 0.001) {
        const double curvature = curvature_of<Dimension>(lambda, ratio);
        EXPECT_GT(curvature, last) << lambda;
        last = curvature;
    }
    for (const double lambda : {turning_point, 0.9, 0.95, 1.0, 1.1})
        EXPECT_NEAR(curvature_of<Dimension>(lambda, ratio), 2 / 0.6, 1e-9) << lambda;
}

TEST(ClosedForm, RisesUpToItsMaximumAndIsClampedThere) {
    expect_rising_then_constant<2>(1 - std::asin(ratio) / pi);
    expect_rising_then_constant<3>(0.8);
}

/// Surface particles at places, in radii, with normals; every two closer than 1 are a pair.
template <class Real, int Dimension>
SurfaceParticles<Real, Dimension> surface(const std::vector<std::array<Real, Dimension>>& places,
                                          const std::vector<std::array<Real, Dimension>>& normals) {
    SurfaceParticles<Real, Dimension> list;
    for (std::size_t i = 0; i < places.size(); ++i) {
        list.particle.push_back(static_cast<std::uint32_t>(i));
        list.slot_of.push_back(static_cast<std::int32_t>(i));
        list.pairs_begin.push_back(static_cast<std::uint32_t>(i * places.size()));
    }
    list.resize_slots(places.size() * places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        list.surface_class[i] = SurfaceClass::surface;
        list.weight[i] = 1;
        list.exposure[i] = 1;
        list.uncovered_fraction[i] = static_cast<Real>(0.2);
        list.normal[i] = normals[i];
        list.pairs_count[i] = 0;
        for (std::size_t j = 0; j < places.size(); ++j) {
            std::array<Real, Dimension> step;
            for (int axis = 0; axis < Dimension; ++axis)
                step[axis] = places[j][axis] - places[i][axis];
            const Real length = std::sqrt(product<Real, Dimension>(step, step));
            if (j != i && length < 1)
                list.pairs[list.pairs_begin[i] + list.pairs_count[i]++] = {
                    static_cast<std::uint32_t>(j), 1 - length, step};
        }
    }
    return list;
}

/// Places on a sphere of that radius (in radii of support) with its normals; those of a cavity
/// point to its center.
template <class Real, int Dimension>
SurfaceParticles<Real, Dimension> sphere_surface(double radius, double sign, int count = 200) {
    RandomDirections random(5, 0);
    std::vector<std::array<Real, Dimension>> places;
    std::vector<std::array<Real, Dimension>> normals;
    for (int i = 0; i < count; ++i) {
        const auto direction = random.next<Dimension>();
        std::array<Real, Dimension> place;
        std::array<Real, Dimension> normal;
        for (int axis = 0; axis < Dimension; ++axis) {
            place[axis] = static_cast<Real>(radius * direction[axis]);
            normal[axis] = static_cast<Real>(sign * direction[axis]);
        }
        places.push_back(place);
        normals.push_back(normal);
    }
    return surface<Real, Dimension>(places, normals);
}

TEST(Turning, IsExactOnASphereWithExactNormals) {
    for (const double radius : {0.7, 2.0, 5.0})
        for (const double sign : {1.0, -1.0}) {
            const auto list = sphere_surface<double, 3>(radius, sign);
            const auto flat = sphere_surface<double, 2>(radius, sign);
            for (std::size_t slot = 0; slot < list.size(); ++slot) {
                if (list.pairs_count[slot] > 0) {
                    EXPECT_NEAR(turning_around(list, slot).mean, sign / radius, 1e-9);
                    EXPECT_NEAR(turning_around(list, slot).square, 1 / radius / radius, 1e-9);
                }
                if (flat.pairs_count[slot] > 0) {
                    EXPECT_NEAR(turning_around(flat, slot).mean, sign / radius, 1e-9);
                }
            }
        }
}

TEST(Turning, OfACylinderIsTheMeanOfItsCurvaturesAndOfTheirSquares) {
    std::vector<std::array<double, 3>> places;
    std::vector<std::array<double, 3>> normals;
    constexpr double radius = 4;
    for (int i = -40; i <= 40; ++i)
        for (int j = -40; j <= 40; ++j) {
            const double angle = i * 0.1 / radius;
            normals.push_back({std::cos(angle), std::sin(angle), 0});
            places.push_back({radius * std::cos(angle), radius * std::sin(angle), j * 0.1});
        }
    std::vector<std::array<double, 3>> near_places;
    std::vector<std::array<double, 3>> near_normals;
    const std::array<double, 3> middle = {radius, 0, 0};
    for (std::size_t i = 0; i < places.size(); ++i) {
        double square = 0;
        for (int axis = 0; axis < 3; ++axis)
            square += (places[i][axis] - middle[axis]) * (places[i][axis] - middle[axis]);
        if (square < 1.01) {
            near_places.push_back(places[i]);
            near_normals.push_back(normals[i]);
        }
    }
    const auto list = surface<double, 3>(near_places, near_normals);
    for (std::size_t slot = 0; slot < list.size(); ++slot)
        if (near_places[slot] == middle) {
            EXPECT_NEAR(turning_around(list, slot).mean, 0.5 / radius, 0.002);
            EXPECT_NEAR(turning_around(list, slot).square, 0.5 / radius / radius, 0.001);
            return;
        }
    FAIL() << "no particle in the middle";
}

TEST(Turning, IsZeroWhereNothingIsAround) {
    const auto list = surface<double, 3>({{0, 0, 0}, {5, 0, 0}}, {{0, 0, 1}, {0, 0, 1}});
    EXPECT_EQ(turning_around(list, 0).mean, 0);
    EXPECT_EQ(turning_around(list, 0).square, 0);
}

constexpr CurvatureMap example = {3, {0.01, 1.1, -0.2, 0.3}, -0.5, 0.75};

TEST(Map, IsTheSumOfItsTermsWithinItsRange) {
    EXPECT_NEAR(curvature_of(example, {0.4, 0.3}, 0.5), 0.01 + 0.44 - 0.06 + 0.15, 1e-15);
    EXPECT_NEAR(curvature_of(example, {-0.4, 0.2}, -0.5), 0.01 - 0.44 - 0.04 - 0.15, 1e-15);
}

/// The map of a sphere, where the square of the turning is what it says.
double on_sphere(double turning) {
    return curvature_of(example, {turning, turning * turning}, 0);
}

TEST(Map, FollowsItsTangentBeyondItsRange) {
    constexpr double step = 1e-4;
    const double inside = (on_sphere(0.75) - on_sphere(0.75 - step)) / step;
    EXPECT_NEAR((on_sphere(2) - on_sphere(0.75)) / 1.25, inside, 1e-3);
    EXPECT_NEAR((on_sphere(5) - on_sphere(2)) / 3, inside, 1e-3);
    EXPECT_NEAR(on_sphere(0.75 + 1e-9), on_sphere(0.75), 1e-8);
}

TEST(Map, HoldsAbsurdSquares) {
    EXPECT_EQ(curvature_of(example, {0.1, 1e6}, 0), curvature_of(example, {0.1, 0.75 * 0.75}, 0));
}

TEST(Map, OfASphereSurface) {
    const SerialLoop loop;
    std::vector<double> memory;
    auto list = sphere_surface<double, 3>(2, 1);
    list.surface_class[3] = SurfaceClass::covered;
    list.weight[3] = 0;
    const double closed = curvature_of<3>(0.2, ratio);
    const double expected = curvature_of(example, {0.5, 0.25}, closed);
    for (const bool averaged : {true, false}) {
        CurvatureMap map = example;
        map.averaged = averaged;
        find_mapped_curvature<double, 3>(map, ratio, UniformRadius<double>{1}, loop, list, memory);
        for (std::size_t slot = 0; slot < list.size(); ++slot)
            if (list.pairs_count[slot] > 1 && slot != 3) {
                EXPECT_NEAR(list.curvature[slot], expected, 1e-9);
                EXPECT_NEAR(list.turning[slot], 0.5, 1e-9);
            }
        EXPECT_EQ(list.curvature[3], 0);
    }
}

TEST(Map, StaysWithinWhatIsPossible) {
    const SerialLoop loop;
    std::vector<float> memory;
    for (const float sign : {1.0F, -1.0F}) {
        // Two particles of a speck, as near as particles get, that look away from each other or at
        // each other.
        auto list = surface<float, 3>({{0, 0, 0}, {0.21F, 0, 0}}, {{-sign, 0, 0}, {sign, 0, 0}});
        find_mapped_curvature<float, 3>(example, ratio, UniformRadius<float>{1}, loop, list,
                                        memory);
        EXPECT_NEAR(sign * list.turning[0], 2 / 0.21F, 1e-4F);
        EXPECT_NEAR(sign * list.curvature[0], 2 / 0.6F, 1e-5F);
    }
}

TEST(Map, AveragesByExposureWeight) {
    auto list = sphere_surface<double, 3>(2, 1);
    std::vector<double> values(list.size(), 3);
    EXPECT_NEAR(surface_average(list, 0, values), 3, 1e-12);
    ASSERT_GT(list.pairs_count[0], 0U);
    const auto& pair = list.pairs[list.pairs_begin[0]];
    for (std::size_t slot = 0; slot < list.size(); ++slot)
        list.weight[slot] = 0;
    EXPECT_EQ(surface_average(list, 0, values), 0);
    list.weight[pair.slot] = 0.5;
    values[pair.slot] = 7;
    EXPECT_NEAR(surface_average(list, 0, values), 7, 1e-12);
    list.weight[0] = 1;
    EXPECT_NEAR(surface_average(list, 0, values),
                (3 + 7 * 0.5 * pair.weight) / (1 + 0.5 * pair.weight), 1e-12);
}

TEST(Smoothing, LeavesAConstantAsItIs) {
    auto list = sphere_surface<float, 3>(2, 1);
    std::vector<float> memory;
    for (float& value : list.curvature)
        value = 0.7F;
    for (int pass = 0; pass < 3; ++pass)
        smooth_curvature<float, 3>(0.5, SerialLoop{}, list, memory);
    for (const float value : list.curvature)
        EXPECT_NEAR(value, 0.7F, 1e-5F);
}

TEST(Smoothing, MixesWithTheMeanOfTheSurfaceAround) {
    auto list = surface<double, 3>({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}},
                                   {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
    std::vector<double> memory;
    list.curvature = {1, 2, 100};
    list.surface_class[2] = SurfaceClass::covered;
    smooth_curvature<double, 3>(0.25, SerialLoop{}, list, memory);
    EXPECT_NEAR(list.curvature[0], 0.75 * 1 + 0.25 * 2, 1e-12);
    EXPECT_EQ(list.curvature[2], 100);
}

TEST(TemporalSmoothing, FollowsParticlesThatAreSorted) {
    auto list =
        surface<double, 3>({{0, 0, 0}, {5, 0, 0}, {10, 0, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
    TemporalCurvature<double> memory;
    memory.share = 0.75;
    list.curvature = {1, 2, 3};
    memory.smooth(list);
    EXPECT_EQ(list.curvature, (std::vector<double>{1, 2, 3})) << "nothing was there before";

    const int permutation[] = {2, 0, 1};
    memory.reorder(permutation);
    list.curvature = {7, 5, 6};
    memory.smooth(list);
    EXPECT_EQ(list.curvature, (std::vector<double>{4, 2, 3}));

    list.surface_class[1] = SurfaceClass::covered;
    list.curvature = {4, 0, 3};
    memory.smooth(list);
    list.surface_class[1] = SurfaceClass::surface;
    list.curvature = {4, 9, 3};
    memory.smooth(list);
    EXPECT_EQ(list.curvature[1], 9) << "it was not surface in the step before";
}

TEST(TemporalSmoothing, BeginsAnewWithAnotherNumberOfParticles) {
    auto list = surface<float, 2>({{0, 0}, {5, 0}}, {{0, 1}, {0, 1}});
    TemporalCurvature<float> memory;
    list.curvature = {1, 2};
    memory.smooth(list);
    auto more = surface<float, 2>({{0, 0}, {5, 0}, {9, 0}}, {{0, 1}, {0, 1}, {0, 1}});
    more.curvature = {8, 8, 8};
    memory.smooth(more);
    EXPECT_EQ(more.curvature, (std::vector<float>{8, 8, 8}));
}

} // namespace
} // namespace meniscus
