#include <meniscus/labeler/sampling/direction_table.hpp>

#include <gtest/gtest.h>
#include <set>

namespace meniscus {
namespace {

template <class Dimension>
class DirectionTables : public testing::Test {};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(DirectionTables, Dimensions);

TYPED_TEST(DirectionTables, HoldUnitVectorsEvenlySpread) {
    constexpr int dimension = TypeParam::value;
    const DirectionTable<dimension> table(4);
    std::array<double, dimension> mean{};
    std::array<double, dimension> square{};
    for (std::size_t k = 0; k < table.size; ++k) {
        double length_squared = 0;
        for (int axis = 0; axis < dimension; ++axis) {
            const double coordinate = table[k][axis];
            mean[axis] += coordinate / table.size;
            square[axis] += coordinate * coordinate / table.size;
            length_squared += coordinate * coordinate;
        }
        ASSERT_NEAR(std::sqrt(length_squared), 1, 1e-7);
    }
    // Four standard errors.
    const double bound = 4 / std::sqrt(static_cast<double>(dimension * table.size));
    for (int axis = 0; axis < dimension; ++axis) {
        EXPECT_NEAR(mean[axis], 0, bound);
        EXPECT_NEAR(square[axis], 1.0 / dimension, bound);
    }
}

TYPED_TEST(DirectionTables, DoNotRepeatWithinTheTableAndDoAfterIt) {
    const DirectionTable<TypeParam::value> table;
    std::set<std::array<float, TypeParam::value>> different;
    for (std::size_t k = 0; k < table.size; ++k)
        different.insert(table[k]);
    EXPECT_GT(different.size(), table.size - 4); // in float two may fall together
    EXPECT_EQ(table[table.size], table[0]);
    EXPECT_EQ(table[5 * table.size + 17], table[17]);
}

TYPED_TEST(DirectionTables, DifferWithTheSeedAlone) {
    using Table = DirectionTable<TypeParam::value>;
    EXPECT_EQ(Table(1)[9], Table(1)[9]);
    EXPECT_NE(Table(1)[9], Table(2)[9]);
    EXPECT_EQ(Table(1).slice_begin(8), Table(1).slice_begin(8));
    EXPECT_NE(Table(1).slice_begin(8), Table(2).slice_begin(8));
}

TYPED_TEST(DirectionTables, BeginSlicesAllOver) {
    const DirectionTable<TypeParam::value> table;
    std::set<std::size_t> begins;
    double mean = 0;
    for (std::uint64_t particle = 0; particle < 1000; ++particle) {
        const std::size_t begin = table.slice_begin(particle);
        ASSERT_LT(begin, table.size);
        begins.insert(begin);
        mean += static_cast<double>(begin) / 1000;
    }
    EXPECT_GT(begins.size(), 900U); // of random ones about 970 differ
    EXPECT_NEAR(mean / table.size, 0.5, 0.05);
}

TEST(RandomDirections, StreamsDifferByBothKeys) {
    const auto first = RandomDirections(1, 2).next<3>();
    EXPECT_EQ(first, (RandomDirections(1, 2).next<3>()));
    EXPECT_NE(first, (RandomDirections(2, 2).next<3>()));
    EXPECT_NE(first, (RandomDirections(1, 3).next<3>()));
}

} // namespace
} // namespace meniscus
