// What hosts ask for around a step: ratio of spacings, time step, values a particle, options that
// change while they run.
#include "fluids.hpp"

#include <meniscus/runtime/surface/host_quantities.hpp>
#include <meniscus/runtime/surface/scatter.hpp>

#include <gtest/gtest.h>
#include <limits>

namespace meniscus {
namespace {

/// The message of what is refused.
template <class Act>
std::string refusal(const Act& act) {
    try {
        act();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(HostQuantities, SpacingRatioIsThatOfTheVolumeAtRest) {
    EXPECT_DOUBLE_EQ(spacing_ratio_of(2, 1, 3), 2);
    EXPECT_DOUBLE_EQ(spacing_ratio_of(0.1, 0.05 * 0.05, 2), 2);
    const double r = 0.025; // the particles of SPlisHSPlasH
    EXPECT_NEAR(spacing_ratio_of(4 * r, 0.8 * 8 * r * r * r, 3), 2 / std::cbrt(0.8), 1e-12);
    EXPECT_NE(refusal([] { spacing_ratio_of(1, 1, 4); }).find("dimension"), std::string::npos);
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
        EXPECT_NE(refusal([&] { spacing_ratio_of(bad, 1, 3); }).find("support_radius"),
                  std::string::npos);
        EXPECT_NE(refusal([&] { spacing_ratio_of(1, bad, 3); }).find("volume"), std::string::npos);
    }
}

TEST(HostQuantities, CapillaryTimeStepIsThatOfBrackbill) {
    // The shortest wave is two spacings long: its phase speed, sqrt(pi sigma / (rho spacing)) for
    // one fluid, crosses half a spacing.
    const double sigma = 0.072, density = 1000, spacing = 1e-3;
    const double speed = std::sqrt(pi * sigma / (density * spacing));
    EXPECT_NEAR(capillary_time_step(sigma, density, spacing), spacing / speed / std::sqrt(2),
                1e-15);
    EXPECT_GT(capillary_time_step(0, density, spacing), 1e300);
    const double nan = std::nan("");
    for (const double bad : {-1.0, nan}) {
        EXPECT_NE(refusal([&] { capillary_time_step(bad, 1, 1); }).find("surface_tension"),
                  std::string::npos);
        EXPECT_NE(refusal([&] { capillary_time_step(1, bad, 1); }).find("density"),
                  std::string::npos);
        EXPECT_NE(refusal([&] { capillary_time_step(1, 1, bad); }).find("spacing"),
                  std::string::npos);
    }
}

TEST(Scatter, GivesOneValueAParticle) {
    const auto fluid = ball<double, 3>(5, 0.2);
    SurfaceTension<double, 3> tension(options_for<3>());
    tension.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
    const auto& list = tension.surface();
    ASSERT_LT(list.size(), fluid.size());
    const std::size_t count = fluid.size();
    std::vector<double> curvatures(count, 9), packed(3 * count, 9), padded(4 * count, 9);
    std::vector<SurfaceClass> classes(count, SurfaceClass::surface);
    scatter(list, list.curvature, curvatures.data());
    scatter(list, list.surface_class, classes.data());
    scatter(list, list.normal, packed.data());
    scatter(list, list.normal, padded.data(), 4);
    std::vector<double> masses(count), accelerations(3 * count, 100), of_equal(4 * count, 0);
    for (std::size_t i = 0; i < count; ++i)
        masses[i] = 1 + static_cast<double>(i);
    add_accelerations(list, masses.data(), accelerations.data());
    add_accelerations(list, 0.5, of_equal.data(), 4);
    for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t slot = list.slot_of[i];
        const auto place = static_cast<std::size_t>(slot);
        EXPECT_EQ(curvatures[i], slot < 0 ? 0 : list.curvature[place]);
        EXPECT_EQ(classes[i], slot < 0 ? SurfaceClass::interior : list.surface_class[place]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double normal = slot < 0 ? 0 : list.normal[place][axis];
            const double force = slot < 0 ? 0 : list.force[place][axis];
            EXPECT_EQ(packed[3 * i + axis], normal);
            EXPECT_EQ(padded[4 * i + axis], normal);
            EXPECT_EQ(accelerations[3 * i + axis], 100 + force / masses[i]);
            EXPECT_EQ(of_equal[4 * i + axis], force / 0.5);
        }
        EXPECT_EQ(padded[4 * i + 3], 9) << "padding is the host's";
    }
}

/// Changed while it runs, an object gives what a new one gives.
TEST(ChangedOptions, AreThoseOfANewObject) {
    const auto fluid = ball<double, 3>(5, 0.2);
    auto options = options_for<3>();
    SurfaceTension<double, 3> changed(options);
    const auto forces = [&](SurfaceTension<double, 3>& tension) {
        tension.step(fluid.view(), fluid.size(), fluid.radii(), SerialLoop{});
        return tension.surface().force;
    };
    auto before = forces(changed);
    const auto expect_same = [&] {
        SurfaceTension<double, 3> fresh(options);
        const auto now = forces(changed);
        EXPECT_EQ(now, forces(fresh));
        EXPECT_NE(now, before);
        before = now;
    };
    changed.set_surface_tension(options.surface_tension = 0.5);
    expect_same();
    changed.set_fade(options.fade = 0.9);
    expect_same();
    changed.set_smoothing(options.normal_passes = 3, options.curvature_passes = 2);
    expect_same();
    changed.set_samples(options.samples = 256);
    expect_same();
    changed.set_line({options.k = 0, options.d = 1000});
    forces(changed);
    EXPECT_EQ(changed.surface().size(), fluid.size());
    changed.set_contact_angle(options.contact_angle = 40);
    EXPECT_EQ(changed.options().contact_angle, 40);
}

TEST(ChangedOptions, AreCheckedAndKeptWhereRefused) {
    SurfaceTension<double, 3> tension;
    const double nan = std::nan("");
    const auto refuses = [&](const char* name, const auto& change) {
        EXPECT_NE(refusal(change).find(std::string(name) + " must be"), std::string::npos) << name;
    };
    const SurfaceTensionOptions before = tension.options();
    refuses("surface_tension", [&] { tension.set_surface_tension(nan); });
    refuses("contact_angle", [&] { tension.set_contact_angle(9); });
    refuses("fade", [&] { tension.set_fade(1.5); });
    refuses("normal_passes", [&] { tension.set_smoothing(-1, 0); });
    refuses("curvature_passes", [&] { tension.set_smoothing(2, 2000); });
    refuses("samples", [&] { tension.set_samples(3); });
    refuses("samples", [&] { tension.set_samples(16385); });
    refuses("k", [&] { tension.set_line({nan, 1}); });
    refuses("d", [&] { tension.set_line({1, 2e6}); });
    const SurfaceTensionOptions& after = tension.options();
    EXPECT_EQ(after.k, before.k);
    EXPECT_EQ(after.d, before.d);
    EXPECT_EQ(after.surface_tension, before.surface_tension);
    EXPECT_EQ(after.contact_angle, before.contact_angle);
    EXPECT_EQ(after.fade, before.fade);
    EXPECT_EQ(after.normal_passes, before.normal_passes);
    EXPECT_EQ(after.samples, before.samples);
}

TEST(RefusedSteps, NameRadiiThatTheNumberTypeCannotHold) {
    const auto fluid = ball<float, 3>(3, 0.2);
    SurfaceTension<float, 3> tension(options_for<3>());
    const auto refusal_of = [&](std::size_t i, float radius) {
        std::vector<float> radii(fluid.size(), 1);
        radii[i] = radius;
        return refusal([&] {
            tension.step(fluid.view(), fluid.size(), VaryingRadii<float>{radii.data()},
                         SerialLoop{});
        });
    };
    EXPECT_EQ(refusal_of(3, 1.5F), "");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float radius :
         {0.0F, -1.0F, nan, -nan, 1e30F, 1e-30F, std::numeric_limits<float>::infinity()})
        EXPECT_NE(refusal_of(7, radius).find("that of particle 7 is"), std::string::npos) << radius;
    EXPECT_NE(refusal_of(2, 1e7F).find("1000000 times the smallest"), std::string::npos);
    tension.set_surface_tension(1e38);
    EXPECT_NE(refusal_of(0, 1).find("surface_tension is so large"), std::string::npos);
    tension.set_surface_tension(1e20);
    EXPECT_EQ(refusal_of(0, 1), "");
    for (const auto& force : tension.surface().force)
        for (const float part : force)
            EXPECT_TRUE(std::isfinite(part));
}

} // namespace
} // namespace meniscus
