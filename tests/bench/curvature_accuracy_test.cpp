// The shipped maps on clouds that they were not trained on: the mean error must stay below 5 % of
// 1 / R, the deviation below half of the closed form's. In two dimensions, where a particle has few
// neighbors on the surface, both are somewhat larger.
#include "curvature/curvature_errors.hpp"

#include <gtest/gtest.h>

namespace meniscus {
namespace {

struct Standing {
    Arrangement kind;
    double jitter;
};

/// `size` is h / R.
template <int Dimension>
void expect_true(const Shape& shape, double size, double max_bias = 0.05,
                 double max_deviation = 0.5) {
    std::uint64_t seed = 99000;
    for (const Standing& standing :
         {Standing{Arrangement::relaxed, 0}, Standing{Arrangement::relaxed, 0.1},
          Standing{Arrangement::lattice, 0.1}}) {
        CloudOptions options = known_cloud(standing.jitter, 2.1);
        options.arrangement = standing.kind;
        options.seed = seed++;
        const auto cloud = curvature_cloud(shape, options);
        for (const std::size_t samples : {0, 128}) {
            MapErrors errors;
            add_curvature_errors<Dimension>(cloud, samples, SerialLoop{}, errors);
            SCOPED_TRACE(testing::Message() << shape.name << ", h / R " << size << ", " << samples
                                            << " samples, jitter " << standing.jitter);
            EXPECT_LT(std::fabs(errors[1].mean()), max_bias * size);
            EXPECT_LT(errors[1].deviation(), max_deviation * errors[0].deviation());
        }
    }
}

TEST(ShippedCurvature, OfDropsIsTrue) {
    for (const double size : {0.25, 0.36, 0.48})
        expect_true<3>(sphere(1 / size), size);
}

TEST(ShippedCurvature, OfCavitiesIsTrue) {
    for (const double size : {0.25, 0.36, 0.48})
        expect_true<3>(outside(sphere(1 / size)), size);
}

TEST(ShippedCurvature, OfCylindersIsTrue) {
    expect_true<3>(cylinder(2.2, 9), 1 / 2.2);
    expect_true<3>(outside(cylinder(2.2, 9)), 1 / 2.2);
}

TEST(ShippedCurvature, OfCirclesIsTrue) {
    for (const double size : {0.12, 0.27}) {
        expect_true<2>(circle(1 / size), size, 0.08, 0.6);
        expect_true<2>(outside(circle(1 / size)), size, 0.08, 0.6);
    }
}

} // namespace
} // namespace meniscus
