// What a host has beside one fluid and one step: several phases, and curvatures of the last step.
#include "jittered_ball.hpp"

#include <meniscus/runtime/surface/surface_tension.hpp>

#include <gtest/gtest.h>

namespace meniscus {
namespace {

TEST(Phases, EachHasASurfaceWhereItMeetsTheOther) {
    const JitteredBall<double, 3> ball(6, 0.1);
    std::vector<int> phases(ball.size());
    for (std::size_t i = 0; i < ball.size(); ++i)
        phases[i] = ball.positions[3 * i] < 0.5 ? 0 : 1;
    const SamePhase<CsrNeighborhood<double, 3>, int> view{ball.view(), phases.data()};
    SurfaceTension<double, 3> one_fluid;
    SurfaceTension<double, 3> two_phases;
    one_fluid.step(ball.view(), ball.size(), ball.radii(), SerialLoop{});
    two_phases.step(view, ball.size(), ball.radii(), SerialLoop{});
    int at_interface = 0;
    for (std::size_t slot = 0; slot < two_phases.surface().size(); ++slot) {
        const double* x = &ball.positions[std::size_t{3} * two_phases.surface().particle[slot]];
        const bool is_inside = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] < 9;
        if (!is_inside || two_phases.surface().surface_class[slot] != SurfaceClass::surface ||
            two_phases.surface().weight[slot] < 1)
            continue;
        ++at_interface;
        const double outward = x[0] < 0.5 ? 1 : -1;
        EXPECT_GT(two_phases.surface().normal[slot][0] * outward, 0.8);
    }
    EXPECT_GT(at_interface, 30);
    EXPECT_GT(two_phases.surface().size(), one_fluid.surface().size());
}

/// Curvature by particle; 0 where it is not surface.
std::vector<double> curvatures(const SurfaceParticles<double, 2>& surface) {
    std::vector<double> by_particle(surface.slot_of.size(), 0.0);
    for (std::size_t slot = 0; slot < surface.size(); ++slot)
        by_particle[surface.particle[slot]] = surface.curvature[slot];
    return by_particle;
}

SurfaceParticles<double, 2> stepped(const JitteredBall<double, 2>& ball,
                                    TemporalCurvature<double>* history) {
    SurfaceTension<double, 2> tension;
    tension.history = history;
    tension.step(ball.view(), ball.size(), ball.radii(), SerialLoop{});
    return tension.surface();
}

TEST(History, SecondStepIsBlendedWithTheFirst) {
    const JitteredBall<double, 2> before(6, 0.05, 1);
    const JitteredBall<double, 2> after(6, 0.05, 2);
    const auto first = stepped(before, nullptr);
    const auto alone = stepped(after, nullptr);
    TemporalCurvature<double> history;
    EXPECT_EQ(curvatures(stepped(before, &history)), curvatures(first));
    const auto blended = stepped(after, &history);
    const auto from = curvatures(first);
    const auto to = curvatures(alone);
    const auto between = curvatures(blended);
    int changed = 0;
    for (std::size_t i = 0; i < between.size(); ++i) {
        const bool in_both = from[i] != 0 && to[i] != 0;
        EXPECT_NEAR(between[i], in_both ? (from[i] + to[i]) / 2 : to[i], 1e-12);
        changed += in_both ? 1 : 0;
    }
    EXPECT_GT(changed, 20);
}

TEST(History, FollowsTheParticles) {
    TemporalCurvature<double> history;
    history.curvature = {10, 11, 12, 13};
    const std::vector<int> permutation = {2, 0, 3, 1};
    history.reorder(permutation.data());
    EXPECT_EQ(history.curvature, (std::vector<double>{12, 10, 13, 11}));
}

TEST(History, BeginsAnewWhereTheNumberOfParticlesChanges) {
    const JitteredBall<double, 2> small(5, 0.05);
    const JitteredBall<double, 2> large(6, 0.05);
    TemporalCurvature<double> history;
    stepped(small, &history);
    EXPECT_EQ(curvatures(stepped(large, &history)), curvatures(stepped(large, nullptr)));
}

} // namespace
} // namespace meniscus
