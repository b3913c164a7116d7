// The shipped maps on clouds that they were not trained on: the mean curvature must be right to
// 5 %, and scatter at most half as much as the closed form's.
#include <bench/curvature_errors.hpp>

#include <gtest/gtest.h>

namespace meniscus {
namespace {

struct Standing {
    Arrangement kind;
    double jitter;
};

template <int Dimension>
void expect_true(const Shape& shape, double curvature, double largest_bias) {
    std::uint64_t seed = 99000;
    for (const Standing& standing :
         {Standing{Arrangement::relaxed, 0}, Standing{Arrangement::relaxed, 0.1},
          Standing{Arrangement::lattice, 0.1}})
        for (const std::size_t samples : {0, 128}) {
            Spread errors[2];
            for (const double spacing_ratio : {2.05, 2.2})
                for (int repeat = 0; repeat < 3; ++repeat)
                    KnownCloud<Dimension>(shape, spacing_ratio, standing.kind, standing.jitter,
                                          seed++)
                        .add_errors({closed_form_map(Dimension), shipped_curvature_map(Dimension)},
                                    samples, SerialLoop{}, errors);
            SCOPED_TRACE(testing::Message() << shape.name << ", h kappa " << curvature << ", "
                                            << samples << " samples, jitter " << standing.jitter);
            EXPECT_LT(std::fabs(errors[1].mean()), largest_bias * std::fabs(curvature));
            EXPECT_LT(errors[1].deviation(), errors[0].deviation() / 2);
        }
}

TEST(ShippedCurvature, OfDropsIsTrue) {
    for (const double curvature : {0.18, 0.36, 0.48})
        expect_true<3>(sphere(1 / curvature), curvature, 0.05);
}

TEST(ShippedCurvature, OfCavitiesIsTrue) {
    for (const double curvature : {0.18, 0.36, 0.48})
        expect_true<3>(outside(sphere(1 / curvature)), -curvature, 0.05);
}

TEST(ShippedCurvature, OfACylinderIsTrue) {
    expect_true<3>(cylinder(2.2, 9), 0.5 / 2.2, 0.05);
}

} // namespace
} // namespace meniscus
