// The vector layer lane by lane, against plain numbers, for each width that is in use.
#include <meniscus/runtime/simd/vector.hpp>

#include <algorithm>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

template <class V>
class Vectors : public testing::Test {
protected:
    using Real = LaneOf<V>;
    static constexpr int count = lanes_in<V>;

    /// Numbers of both signs, in no order.
    static V numbers(int first) {
        V values;
        for (int lane = 0; lane < count; ++lane)
            values[lane] = static_cast<Real>((lane * 7 + first * 3) % 11 - 5) / 3;
        return values;
    }
};

using Widths = testing::Types<Pack<float>, Pack<double>, VectorOf<double, 4>, Lanes<float>,
                              Lanes<double>, Wide, WideFloat>;
TYPED_TEST_SUITE(Vectors, Widths);

TYPED_TEST(Vectors, AreLoadedAndStoredFromAnyPlace) {
    using Real = LaneOf<TypeParam>;
    constexpr int count = lanes_in<TypeParam>;
    Real from[count + 1], to[count + 1] = {};
    for (int n = 0; n <= count; ++n)
        from[n] = static_cast<Real>(n);
    store(load<TypeParam>(from + 1), to + 1);
    for (int n = 1; n <= count; ++n)
        EXPECT_EQ(to[n], from[n]);
    for (int lane = 0; lane < count; ++lane)
        EXPECT_EQ(all_lanes<TypeParam>(3)[lane], 3);
}

TYPED_TEST(Vectors, ComparisonsAndChoicesGoLaneByLane) {
    for (int trial = 0; trial < 11; ++trial) {
        const TypeParam a = this->numbers(trial);
        const TypeParam b = this->numbers(2 * trial + 1);
        const unsigned bits = bits_below(a, b);
        const auto mask = below(a, b);
        EXPECT_EQ(mask_bits(mask), bits);
        const TypeParam kept = keep(mask, a);
        for (int lane = 0; lane < lanes_in<TypeParam>; ++lane) {
            EXPECT_EQ((bits >> lane & 1U) != 0, a[lane] < b[lane]);
            EXPECT_EQ(kept[lane], a[lane] < b[lane] ? a[lane] : 0);
            EXPECT_EQ(larger(a, b)[lane], std::max(a[lane], b[lane]));
            EXPECT_EQ(smaller(a, b)[lane], std::min(a[lane], b[lane]));
        }
    }
    EXPECT_EQ(bits_below(this->numbers(0), this->numbers(0)), 0U);
}

TYPED_TEST(Vectors, HaveSquareRootsAsNumbersDo) {
    const TypeParam a = larger(this->numbers(1), TypeParam{});
    for (int lane = 0; lane < lanes_in<TypeParam>; ++lane)
        EXPECT_EQ(square_root(a)[lane], std::sqrt(a[lane]));
}

TYPED_TEST(Vectors, MasksOfLastLanesAreThose) {
    constexpr int count = lanes_in<TypeParam>;
    for (int n = 0; n <= count; ++n)
        EXPECT_EQ(mask_bits(last_lanes<TypeParam>(n)), ((1U << n) - 1) << (count - n));
}

TYPED_TEST(Vectors, AreAddedUpByHalves) {
    if constexpr (lanes_in<TypeParam> <= 8) {
        using Real = LaneOf<TypeParam>;
        Real lanes[8];
        store(this->numbers(3), lanes);
        for (int half = lanes_in<TypeParam> / 2; half > 0; half /= 2)
            for (int lane = 0; lane < half; ++lane)
                lanes[lane] += lanes[lane + half];
        EXPECT_EQ(sum_of_lanes(this->numbers(3)), lanes[0]);
    }
}

TYPED_TEST(Vectors, AreGatheredByIndex) {
    if constexpr (lanes_in<TypeParam> <= 8) {
        LaneOf<TypeParam> values[40];
        for (int n = 0; n < 40; ++n)
            values[n] = static_cast<LaneOf<TypeParam>>(n);
        const std::uint32_t index[8] = {39, 0, 7, 7, 12, 31, 1, 20};
        const TypeParam found = gather<TypeParam>(values, index);
        for (int lane = 0; lane < lanes_in<TypeParam>; ++lane)
            EXPECT_EQ(found[lane], values[index[lane]]);
    }
}

template <class Real>
void expect_pairs() {
    constexpr int count = lanes_in<Pack<Real>>;
    Real values[3 * count];
    for (int n = 0; n < 3 * count; ++n)
        values[n] = static_cast<Real>(n);
    const Real* from[count];
    for (int lane = 0; lane < count; ++lane)
        from[lane] = values + (lane * 5) % (3 * count - 2);
    Pack<Real> first, second;
    load_pairs(from, first, second);
    for (int lane = 0; lane < count; ++lane) {
        EXPECT_EQ(first[lane], from[lane][0]);
        EXPECT_EQ(second[lane], from[lane][1]);
        EXPECT_EQ(load_each(from, 2)[lane], from[lane][2]);
        EXPECT_EQ(load_pair(values + 1)[lane], lane < 2 ? values[1 + lane] : 0);
    }
    Real stored[3] = {-1, -1, -1};
    store_pair(first, stored);
    EXPECT_EQ(stored[0], first[0]);
    EXPECT_EQ(stored[1], first[1]);
    EXPECT_EQ(stored[2], -1);
}

TEST(Packs, AreMadeOfPairsAtScatteredPlaces) {
    expect_pairs<float>();
    expect_pairs<double>();
}

TEST(WideVectors, TellWhetherALaneIsNotPositive) {
    for (std::size_t lane = 0; lane < wide_float_count; ++lane)
        for (const float value : {1.0F, 0.0F, -1.0F}) {
            WideFloat numbers = all_lanes<WideFloat>(2);
            numbers[lane] = value;
            EXPECT_EQ(any_not_positive(numbers), value <= 0);
        }
}

TEST(WideVectors, TakeSignsAndExtremes) {
    Wide numbers = all_lanes<Wide>(-2);
    numbers[wide_count - 1] = 3;
    EXPECT_EQ(max_lane(numbers, -9), 3);
    EXPECT_EQ(max_lane(numbers, 9), 9);
    EXPECT_EQ(min_lane(numbers, 9), -2);
    EXPECT_EQ(min_lane(numbers, -9), -9);
    EXPECT_EQ(absolute(numbers)[0], 2);
    EXPECT_EQ(with_sign(all_lanes<Wide>(5), numbers)[0], -5);
    EXPECT_EQ(with_sign(all_lanes<Wide>(5), numbers)[wide_count - 1], 5);
    EXPECT_TRUE(any_lane(numbers > 2));
    EXPECT_FALSE(any_lane(numbers > 3));
}

} // namespace
} // namespace meniscus
