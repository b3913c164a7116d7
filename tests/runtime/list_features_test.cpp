// The fast passes over neighbor lists against the plain reference.
#include <meniscus/runtime/features/classifier.hpp>

#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace meniscus {
namespace {

/// Lists of random length around random particles; some neighbors too close, too far, or i itself.
template <class Real, int Stride>
struct RandomLists {
    std::vector<Real> positions;
    std::vector<Real> masses;
    std::vector<std::size_t> offsets{0};
    std::vector<std::uint32_t> neighbors;

    explicit RandomLists(unsigned seed, bool in_range_only) {
        constexpr std::size_t count = 200;
        std::mt19937 random(seed);
        std::uniform_real_distribution<Real> coordinate(0, 2);
        for (std::size_t n = 0; n < count * Stride; ++n)
            positions.push_back(coordinate(random));
        for (std::size_t n = 0; n < count; ++n)
            masses.push_back(Real(0.5) + coordinate(random));
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t length = random() % 60;
            for (std::size_t n = 0; n < length; ++n) {
                const auto j = static_cast<std::uint32_t>(random() % count);
                if (!in_range_only || is_in_range(i, j))
                    neighbors.push_back(j);
            }
            offsets.push_back(neighbors.size());
        }
    }

    [[nodiscard]] static NeighborRange<Real> range() { return neighbor_range<Real>(1.5, 0.8); }

    [[nodiscard]] bool is_in_range(std::size_t i, std::size_t j) const {
        Real squared = 0; // of all coordinates, so of the first two as well
        Real planar = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const Real difference = positions[j * Stride + axis] - positions[i * Stride + axis];
            squared += difference * difference;
            if (axis < 2)
                planar += difference * difference;
        }
        return range().contains(squared) && range().contains(planar);
    }
};

template <int Dimension, class Real, class View>
void expect_same_as_reference(const View& view, const NeighborRange<Real>& range) {
    for (std::size_t i = 0; i < 200; ++i) {
        const auto reference = sum_features_reference<Real, Dimension>(view, i, range);
        const auto fast = sum_features<Real, Dimension>(view, i, range);
        ASSERT_EQ(fast.count, reference.count) << i;
        const double tolerance = 100 * std::numeric_limits<Real>::epsilon();
        EXPECT_NEAR(fast.total_mass(), reference.total_mass(), tolerance * 100);
        for (int axis = 0; axis < Dimension; ++axis)
            EXPECT_NEAR(fast.moment[axis], reference.moment[axis], tolerance * 100);
    }
}

template <class Real, int Dimension, int Stride>
void compare_lists() {
    for (unsigned seed = 0; seed < 20; ++seed)
        for (const bool equal_masses : {true, false}) {
            const RandomLists<Real, Stride> any(seed, false);
            expect_same_as_reference<Dimension, Real>(
                CsrNeighborhood<Real, Dimension, Stride>{any.positions.data(),
                                                         equal_masses ? nullptr : any.masses.data(),
                                                         any.offsets.data(), any.neighbors.data()},
                any.range());
            const RandomLists<Real, Stride> exact(seed, true);
            expect_same_as_reference<Dimension, Real>(
                ExactCsrNeighborhood<Real, Dimension, Stride>{
                    {exact.positions.data(), equal_masses ? nullptr : exact.masses.data(),
                     exact.offsets.data(), exact.neighbors.data()}},
                exact.range());
        }
}

TEST(ListFeatures, Float3D) {
    compare_lists<float, 3, 3>();
}
TEST(ListFeatures, Double3D) {
    compare_lists<double, 3, 3>();
}
TEST(ListFeatures, Float3DPadded) {
    compare_lists<float, 3, 4>();
}
TEST(ListFeatures, Double3DPadded) {
    compare_lists<double, 3, 4>();
}
TEST(ListFeatures, Float2DInThreeCoordinates) {
    compare_lists<float, 2, 3>();
}
TEST(ListFeatures, Double2DInThreeCoordinates) {
    compare_lists<double, 2, 3>();
}

} // namespace
} // namespace meniscus
