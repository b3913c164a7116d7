// The fast kernels of a step against the same in plain loops.
#include "reference/surface_reference.hpp"

#include "jittered_ball.hpp"

#include <gtest/gtest.h>

namespace meniscus {
namespace {

template <class Real>
double tolerance() {
    return sizeof(Real) == sizeof(float) ? 2e-4 : 1e-10;
}

template <class Real, int Dimension>
struct Step {
    JitteredBall<Real, Dimension> ball{6, 0.2};
    SurfaceTensionOptions options = completed({}, Dimension);
    SurfaceParticles<Real, Dimension> list;
    SampleDirections directions;
    HeldCells cells;
    std::vector<ExposureMemory> memory{1};

    Step() {
        fill_outward_directions<Dimension>(200, 1, directions);
        // Every particle, so that covered ones are tested as well.
        find_candidates<Real, Dimension>(ball.view(), ball.size(), ball.radii(),
                                         SurfaceLine<Real>{0, 1000}, 0.8, SerialLoop{}, list);
    }

    void expose(const SurfaceTensionOptions& how, SurfaceParticles<Real, Dimension>& into) {
        find_exposure<Real, Dimension>(ball.view(), NoBoundary{}, ball.radii(), nullptr, directions,
                                       cells, how, SerialLoop{}, memory.data(), into);
    }
};

template <class Real, int Dimension>
void expect_same_exposure(CoverageMethod method, Verification verification) {
    Step<Real, Dimension> step;
    SurfaceTensionOptions how;
    how.coverage = method;
    how.verification = verification;
    auto plain = step.list;
    step.expose(how, step.list);
    ExactCoverage exact;
    find_exposure_reference<Real, Dimension>(step.ball.view(), step.ball.radii(), step.directions,
                                             step.cells.coarse, how, exact, plain);
    const double max_weight = 0.5 / 40; // of a sample, behind the particle
    int decided_otherwise = 0;
    for (std::size_t slot = 0; slot < step.list.size(); ++slot) {
        const double difference = std::abs(static_cast<double>(step.list.uncovered_fraction[slot] -
                                                               plain.uncovered_fraction[slot]));
        EXPECT_LE(difference, 2 * max_weight) << slot;
        if (difference > 1e-5) { // a sample on the edge of a cap
            ++decided_otherwise;
            continue;
        }
        EXPECT_EQ(step.list.surface_class[slot], plain.surface_class[slot]) << slot;
        EXPECT_NEAR(step.list.exposure[slot], plain.exposure[slot], 1e-5);
        if (plain.exposure[slot] <= Real(1e-3))
            continue;
        for (int axis = 0; axis < Dimension; ++axis)
            EXPECT_NEAR(step.list.normal[slot][axis], plain.normal[slot][axis], 1e-3);
    }
    EXPECT_LE(decided_otherwise, static_cast<int>(step.list.size() / 100));
}

template <class Real, int Dimension>
void expect_same_everywhere() {
    expect_same_exposure<Real, Dimension>(CoverageMethod::sampled, Verification::exact);
    expect_same_exposure<Real, Dimension>(CoverageMethod::sampled, Verification::drop);
    expect_same_exposure<Real, Dimension>(CoverageMethod::exact, Verification::exact);
}

TEST(SurfaceReference, ExposureIsThatOfPlainLoops) {
    expect_same_everywhere<float, 3>();
    expect_same_everywhere<double, 3>();
    expect_same_everywhere<float, 2>();
    expect_same_everywhere<double, 2>();
}

template <class Real, int Dimension>
void expect_same_force() {
    Step<Real, Dimension> step;
    step.expose({}, step.list);
    auto plain = step.list;
    find_force_reference<Real, Dimension>(step.ball.view(), step.ball.radii(), step.options, plain);
    std::vector<std::array<Real, Dimension>> normals;
    std::vector<Real> curvatures;
    const SerialLoop loop;
    smooth_normals<Real, Dimension>(step.options.tau, loop, step.list, normals);
    find_turning<Real, Dimension>(step.ball.radii(), loop, step.list);
    find_mapped_curvature<Real, Dimension>(step.options.curvature_map, 0.8, step.ball.radii(), loop,
                                           step.list, curvatures);
    find_force<Real, Dimension>(step.options, step.ball.radii(), loop, step.list);
    int surface = 0;
    for (std::size_t slot = 0; slot < step.list.size(); ++slot) {
        surface += step.list.surface_class[slot] == SurfaceClass::surface ? 1 : 0;
        EXPECT_NEAR(step.list.curvature[slot], plain.curvature[slot], 5 * tolerance<Real>());
        for (int axis = 0; axis < Dimension; ++axis) {
            EXPECT_NEAR(step.list.normal[slot][axis], plain.normal[slot][axis], tolerance<Real>());
            EXPECT_NEAR(step.list.force[slot][axis], plain.force[slot][axis], tolerance<Real>());
        }
    }
    EXPECT_GT(surface, 20);
    EXPECT_LT(surface, static_cast<int>(step.list.size()));
}

TEST(SurfaceReference, ForceIsThatOfPlainLoops) {
    expect_same_force<float, 3>();
    expect_same_force<double, 3>();
    expect_same_force<float, 2>();
    expect_same_force<double, 2>();
}

} // namespace
} // namespace meniscus
