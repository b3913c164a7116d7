// The same step compiled for each instruction set gives the same bits. Those that this machine
// lacks are left out; the baseline is everywhere.
#include "hosts.hpp"

#include <meniscus/bindings/step/surface_step.hpp>

#include <gtest/gtest.h>

namespace meniscus {
namespace {

/// What the default, the exact and the paper's way find of a jittered ball, one after another.
template <class Real, int Dimension>
std::vector<Found> found_by(InstructionSet set) {
    const Host<Real, Dimension> host(ball<Real, Dimension>(Dimension == 3 ? 7 : 25, 0.25));
    const StepParticles particles = host.step_particles();
    std::vector<SurfaceTensionOptions> choices(4);
    choices[1].coverage = CoverageMethod::exact;
    choices[1].covariance_share = 0.4;
    choices[1].curvature_passes = 1;
    choices[2] = paper_options();
    choices[3].samples = 500;
    std::vector<Found> all;
    for (auto& options : choices) {
        const auto same = options_for<Dimension>();
        options.k = same.k;
        options.d = same.d;
        options.spacing_ratio = 2.5;
        const auto step = surface_step(options, {Dimension, std::is_same_v<Real, double>, 0}, set);
        step->step(particles);
        all.push_back(Found::of<Real>(step->results(), Dimension));
        step->balance_momentum(particles);
        all.push_back(Found::of<Real>(step->results(), Dimension));
    }
    return all;
}

template <class Real, int Dimension>
void compare_instruction_sets() {
    const auto baseline = found_by<Real, Dimension>(InstructionSet::baseline);
    ASSERT_EQ(baseline.size(), 8U);
    ASSERT_GT(baseline[0].particle.size(), 100U);
    EXPECT_FALSE(baseline[0] == baseline[6]);
    for (const InstructionSet set : instruction_sets) {
        if (set == InstructionSet::baseline || !is_supported(set))
            continue;
        const auto wider = found_by<Real, Dimension>(set);
        ASSERT_EQ(wider.size(), baseline.size());
        for (std::size_t n = 0; n < wider.size(); ++n)
            EXPECT_TRUE(wider[n] == baseline[n]) << name_of(set) << ", " << n;
    }
}

TEST(InstructionSets, AgreeInFloat2D) {
    compare_instruction_sets<float, 2>();
}
TEST(InstructionSets, AgreeInFloat3D) {
    compare_instruction_sets<float, 3>();
}
TEST(InstructionSets, AgreeInDouble2D) {
    compare_instruction_sets<double, 2>();
}
TEST(InstructionSets, AgreeInDouble3D) {
    compare_instruction_sets<double, 3>();
}

} // namespace
} // namespace meniscus
