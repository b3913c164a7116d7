// The runtime in a program built with -fno-exceptions and -fno-rtti: it works, and what it refuses
// ends the program with the message that an exception would carry.
#include "runtime/fluids.hpp"

#include <meniscus/runtime/neighbors/parallel_loop.hpp>

#include <gtest/gtest.h>

#if defined(__cpp_exceptions)
#error "built with exceptions, so that this tests nothing"
#endif

namespace meniscus {
namespace {

#if defined(_OPENMP)
using Loop = OpenMpLoop;
#else
using Loop = SerialLoop;
#endif

TEST(WithoutExceptions, SurfaceTensionDrawsACornerInwards) {
    const auto fluid = block<float, 3>({8, 8, 8});
    SurfaceTension<float, 3> tension(options_for<3>());
    tension.step(fluid.view(), fluid.size(), fluid.radii(), Loop{});
    ASSERT_GT(tension.surface().size(), 0U);
    ASSERT_EQ(tension.surface().particle[0], 0U);
    for (const float component : tension.surface().force[0])
        EXPECT_GT(component, 0);
}

TEST(WithoutExceptionsDeathTest, RefusedOptionEndsTheProgramWithItsName) {
    SurfaceTensionOptions options = options_for<3>();
    options.tau = 2;
    EXPECT_DEATH((SurfaceTension<float, 3>{options}), "meniscus: tau must be between 0 and 1");
}

TEST(WithoutExceptionsDeathTest, RefusedRadiusEndsTheProgramWithItsName) {
    auto fluid = block<float, 3>({2, 2, 2});
    fluid.radius = -1;
    SurfaceTension<float, 3> tension(options_for<3>());
    EXPECT_DEATH(tension.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{}),
                 "meniscus: the support radius must be positive");
}

} // namespace
} // namespace meniscus
