// One particle at a time in scalar arithmetic, as kernels call it, against the vectors of the step:
// the same bits.
#include <meniscus/runtime/surface/one_particle.hpp>

#include <gtest/gtest.h>
#include <random>

namespace meniscus {
namespace {

constexpr double ratio = 0.8;
constexpr std::size_t capacity = 128;

template <class Type>
struct OneParticleAtATime : ::testing::Test {};

template <class Real_, int Dimension_>
struct Setting {
    using Real = Real_;
    static constexpr int dimension = Dimension_;
};
using Settings =
    ::testing::Types<Setting<float, 2>, Setting<float, 3>, Setting<double, 2>, Setting<double, 3>>;
TYPED_TEST_SUITE(OneParticleAtATime, Settings);

/// Neighbors of a particle `depth` spacings below a surface, on a lattice that is shaken.
template <class Real, int Dimension>
std::vector<std::array<Real, 3>> steps_at(double depth, std::mt19937& random) {
    std::uniform_real_distribution<double> shake(-0.1, 0.1);
    const double tilt = shake(random) * 5;
    std::vector<std::array<Real, 3>> steps;
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y)
            for (int z = Dimension == 3 ? -3 : 0; z <= (Dimension == 3 ? 3 : 0); ++z) {
                if (y + tilt * x > depth || (x == 0 && y == 0 && z == 0))
                    continue;
                const double spacing = 0.45;
                steps.push_back(
                    {static_cast<Real>(spacing * (x + shake(random))),
                     static_cast<Real>(spacing * (y + shake(random))),
                     static_cast<Real>(Dimension == 3 ? spacing * (z + shake(random)) : 0)});
            }
    return steps;
}

/// The caps as the step collects them.
template <class Real, int Dimension>
Vector3 collect(const std::vector<std::array<Real, 3>>& steps, SampledCaps& caps) {
    const auto range = neighbor_range<Real>(1, ratio);
    std::array<Real, 3> inward = {};
    for (const auto& step : steps) {
        const Real squared = squared_length<Real, Dimension>(step);
        if (!range.contains(squared))
            continue;
        caps.reserve(caps.count + 1);
        caps.x[caps.count] = static_cast<float>(step[0]);
        caps.y[caps.count] = static_cast<float>(step[1]);
        caps.z[caps.count] = static_cast<float>(step[2]);
        caps.limit[caps.count] =
            0.5F * static_cast<float>(squared) + static_cast<float>((1 - ratio * ratio) / 2);
        ++caps.count;
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            inward[axis] += step[axis];
    }
    return {-static_cast<double>(inward[0]), -static_cast<double>(inward[1]),
            -static_cast<double>(inward[2])};
}

template <class Real, int Dimension>
ParticleCaps<Real, capacity> caps_of(const std::vector<std::array<Real, 3>>& steps) {
    ParticleCaps<Real, capacity> caps;
    for (const auto& step : steps)
        caps.template add<Dimension>(step.data(), neighbor_range<Real>(1, ratio), ratio);
    return caps;
}

TYPED_TEST(OneParticleAtATime, SaysWhatTheStepSays) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    SampleDirections directions;
    fill_outward_directions<dimension>(100, 7, directions);
    const HeldCells cells;
    std::vector<float> limits;
    std::mt19937 random(1);
    int certain = 0;
    int held = 0;
    for (std::uint32_t id = 0; id < 400; ++id) {
        const auto steps = steps_at<Real, dimension>(id % 3, random);
        SampledCaps caps;
        const Vector3 outward = collect<Real, dimension>(steps, caps);
        const SampledPart expected =
            sample_coverage<dimension>(directions, directions.set_begin(id), outward, caps);
        auto own = caps_of<Real, dimension>(steps);
        const SampledPart found = sampled_part<dimension>(sets_of(directions), id, own);
        EXPECT_FALSE(own.is_full);
        EXPECT_EQ(found.fraction, expected.fraction);
        EXPECT_EQ(found.moment, expected.moment);
        EXPECT_EQ(found.is_certain, expected.is_certain);
        certain += found.is_certain ? 1 : 0;
        if constexpr (dimension == 3) {
            const bool is_covered = is_surely_covered(cells, caps, limits);
            EXPECT_EQ(is_held(set_of(cells.coarse), own) || is_held(set_of(cells.fine), own),
                      is_covered);
            held += is_covered ? 1 : 0;
        }
    }
    EXPECT_GT(certain, 100);
    EXPECT_LT(certain, 300);
    EXPECT_TRUE(dimension == 2 || held > 50);
}

TYPED_TEST(OneParticleAtATime, HasTheNormalAndForceOfAFlatSurface) {
    using Real = typename TypeParam::Real;
    constexpr int dimension = TypeParam::dimension;
    SampleDirections directions;
    fill_outward_directions<dimension>(4096, 7, directions);
    std::mt19937 random(2);
    auto caps = caps_of<Real, dimension>(steps_at<Real, dimension>(0, random));
    const SampledPart part = sampled_part<dimension>(sets_of(directions), 0, caps);
    ASSERT_TRUE(part.is_certain);
    const auto found = one_particle<Real, dimension>(part, ratio, 0);
    EXPECT_GT(found.normal[1], Real(0.8));
    EXPECT_EQ(found.weight, Real(1));
    Real force[dimension];
    set_paper_force<Real, dimension>(found, Real(2), Real(0.5), Real(0.25), force);
    const Real face = dimension == 2 ? Real(0.25) : Real(0.0625);
    const Real size = Real(2) * (found.curvature / Real(0.5)) * face;
    for (std::size_t axis = 0; axis < dimension; ++axis)
        EXPECT_EQ(force[axis], -size * found.normal[axis]);
}

TEST(ParticleCapsTest, SaysWhereANeighborFoundNoRoom) {
    ParticleCaps<float, 2> caps;
    const float step[3] = {0.5F, 0, 0};
    for (int neighbor = 0; neighbor < 2; ++neighbor)
        caps.add<3>(step, neighbor_range<float>(1, ratio), ratio);
    EXPECT_FALSE(caps.is_full);
    const float far_step[3] = {1.5F, 0, 0};
    caps.add<3>(far_step, neighbor_range<float>(1, ratio), ratio);
    EXPECT_FALSE(caps.is_full);
    caps.add<3>(step, neighbor_range<float>(1, ratio), ratio);
    EXPECT_TRUE(caps.is_full);
    EXPECT_EQ(caps.count, 2U);
}

} // namespace
} // namespace meniscus
