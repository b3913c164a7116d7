// A host that traps floating-point exceptions, as Fortran codes do, runs steps over a loop that
// holds traps off, and finds its traps and flags as it left them.
#include "fluids.hpp"

#include <meniscus/runtime/neighbors/held_traps.hpp>
#include <meniscus/runtime/neighbors/wall_planes.hpp>

#include <cfenv>
#include <csignal>
#include <gtest/gtest.h>
#include <memory>

namespace meniscus {
namespace {

constexpr int trapped = FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW;

/// Traps while it lives, which no test's own check should run into.
class Traps {
public:
    Traps() {
        std::feclearexcept(FE_ALL_EXCEPT);
        feenableexcept(trapped);
    }
    ~Traps() { fedisableexcept(FE_ALL_EXCEPT); }
};

/// A jittered ball with a pair of equal particles and one particle of spray.
template <class Real, int Dimension>
Fluid<Real, Dimension> ball_and_spray() {
    auto places = ball<Real, Dimension>(Dimension == 3 ? 4 : 9, 0.2).positions;
    places.push_back(places[5]);
    places.push_back({Real(30)});
    return {std::move(places), 1};
}

struct OneWall {
    template <class Visit>
    void operator()(std::size_t /*i*/, Visit&& visit) const {
        visit(std::size_t{0}, 0.25, std::array<double, 3>{0.6, 0.8, 0});
    }
};

template <class Real, int Dimension>
void step_with_traps(const SurfaceTensionOptions& options) {
    const auto fluid = ball_and_spray<Real, Dimension>();
    const auto view = fluid.view();
    std::vector<std::array<Real, Dimension>> untrapped;
    for (const bool traps_are_on : {false, true}) {
        SurfaceTension<Real, Dimension> tension(options);
        TemporalCurvature<Real> history;
        tension.history = &history;
        const WithHeldTraps<SerialLoop> loop;
        const auto step = [&](const auto& boundary) {
            tension.step(view, boundary, fluid.size(), fluid.radii(), nullptr, loop);
            tension.template balance_momentum<Dimension>(view, boundary, fluid.radii(),
                                                         fluid.coordinates(), loop);
        };
        int enabled = trapped;
        int raised = 0;
        {
            std::unique_ptr<Traps> traps(traps_are_on ? new Traps : nullptr);
            step(wall_planes_of<Dimension>(OneWall{}, fluid.radii(), options.spacing_ratio));
            step(NoBoundary{});
            if (traps_are_on) {
                enabled = fegetexcept();
                raised = std::fetestexcept(trapped);
            }
        }
        EXPECT_EQ(enabled, trapped);
        EXPECT_EQ(raised, 0);
        ASSERT_GT(tension.surface().size(), 20U);
        EXPECT_TRUE(!traps_are_on || tension.surface().force == untrapped);
        untrapped = tension.surface().force;
    }
}

template <class Real, int Dimension>
void step_with_traps() {
    for (const auto coverage : {CoverageMethod::sampled, CoverageMethod::exact})
        for (const bool paper : {false, true}) {
            SurfaceTensionOptions options = paper ? paper_options() : SurfaceTensionOptions{};
            options.coverage = coverage;
            options.covariance_share = 0.3;
            step_with_traps<Real, Dimension>(options);
        }
}

TEST(HeldTraps, LetAStepRunInFloat2D) {
    step_with_traps<float, 2>();
}
TEST(HeldTraps, LetAStepRunInFloat3D) {
    step_with_traps<float, 3>();
}
TEST(HeldTraps, LetAStepRunInDouble2D) {
    step_with_traps<double, 2>();
}
TEST(HeldTraps, LetAStepRunInDouble3D) {
    step_with_traps<double, 3>();
}

/// What the tests above would run into.
TEST(HeldTrapsDeathTest, TrapsAreTrapsOutside) {
    volatile double zero = 0;
    EXPECT_EXIT(
        {
            const Traps traps;
            zero = zero / zero;
        },
        testing::KilledBySignal(SIGFPE), "");
    const Traps traps;
    const HeldTraps held;
    zero = zero / zero;
}

} // namespace
} // namespace meniscus
