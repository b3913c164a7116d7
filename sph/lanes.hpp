// The step works on the neighbors of a particle eight at a time, whatever the instruction set:
// eight lanes are one register with AVX2 and two or four with less, and the order in which numbers
// are added up is the same, so that all give the same bits. Particles are stored as rows of four
// numbers, a place or a velocity and one more, which are fetched row by row and turned into lanes.
#pragma once

#include <meniscus/runtime/instruction_set.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

inline constexpr int lane_count = 8;

template <class Real>
struct LaneTypes;
template <>
struct LaneTypes<float> {
    using Four = float __attribute__((vector_size(16)));
    using Eight = float __attribute__((vector_size(32)));
};
template <>
struct LaneTypes<double> {
    using Four = double __attribute__((vector_size(32)));
    using Eight = double __attribute__((vector_size(64)));
};

/// Eight numbers. Arithmetic is the compiler's; a comparison gives a mask, mask ? a : b picks.
template <class Real>
using Lanes = typename LaneTypes<Real>::Eight;

/// x, y, z (0 in two dimensions) and whatever a loop needs beside them.
template <class Real>
struct alignas(4 * sizeof(Real)) Row {
    Real x = 0, y = 0, z = 0, w = 0;
};

/// Eight rows, turned.
template <class Real>
struct RowLanes {
    Lanes<Real> x, y, z, w;
};

template <class Real>
MENISCUS_INLINE Lanes<Real> all_lanes_of(Real value) {
    return Lanes<Real>{} + value;
}

template <class Real>
MENISCUS_INLINE Lanes<Real> load_lanes(const Real* from) {
    Lanes<Real> lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

template <class Real>
MENISCUS_INLINE void store_lanes(Lanes<Real> lanes, Real* to) {
    std::memcpy(to, &lanes, sizeof lanes);
}

template <class Real>
MENISCUS_INLINE typename LaneTypes<Real>::Four load_row(const Row<Real>* from) {
    typename LaneTypes<Real>::Four row;
    std::memcpy(&row, from, sizeof row);
    return row;
}

/// The rows at eight places of an array.
template <class Real>
MENISCUS_INLINE RowLanes<Real> gather_rows(const Row<Real>* rows, const std::uint32_t* index) {
    // Row n beside row n + 4, so that what follows stays within halves of a register.
    const auto beside = [&](int n) {
        return __builtin_shufflevector(load_row(rows + index[n]), load_row(rows + index[n + 4]), 0,
                                       1, 2, 3, 4, 5, 6, 7);
    };
    const Lanes<Real> a = beside(0), b = beside(1), c = beside(2), d = beside(3);
    const Lanes<Real> ab_low = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
    const Lanes<Real> cd_low = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
    const Lanes<Real> ab_high = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    const Lanes<Real> cd_high = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    return {__builtin_shufflevector(ab_low, cd_low, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(ab_low, cd_low, 2, 3, 10, 11, 6, 7, 14, 15),
            __builtin_shufflevector(ab_high, cd_high, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(ab_high, cd_high, 2, 3, 10, 11, 6, 7, 14, 15)};
}

/// The numbers at eight places of an array.
template <class Real>
MENISCUS_INLINE Lanes<Real> gather(const Real* values, const std::uint32_t* index) {
    return Lanes<Real>{values[index[0]], values[index[1]], values[index[2]], values[index[3]],
                       values[index[4]], values[index[5]], values[index[6]], values[index[7]]};
}

template <class Real>
MENISCUS_INLINE Real sum_of_lanes(Lanes<Real> a) {
    return ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7]));
}

template <class Real>
MENISCUS_INLINE Lanes<Real> square_root_of(Lanes<Real> a) {
    for (int lane = 0; lane < lane_count; ++lane) // one instruction, or as many as needed
        a[lane] = std::sqrt(a[lane]);
    return a;
}

template <class Real>
MENISCUS_INLINE Lanes<Real> larger_of(Lanes<Real> a, Lanes<Real> b) {
    return a > b ? a : b;
}

/// Bit n: lane n of a is smaller than b.
MENISCUS_INLINE unsigned smaller_bits(Lanes<float> a, float b) {
#if MENISCUS_VECTOR_BYTES >= 32
    const __m256 limit = _mm256_set1_ps(b);
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps((__m256)a, limit, _CMP_LT_OQ)));
#elif defined(__SSE2__)
    const __m128 limit = _mm_set1_ps(b);
    __m128 half[2];
    std::memcpy(half, &a, sizeof half);
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(half[0], limit)) |
                                 _mm_movemask_ps(_mm_cmplt_ps(half[1], limit)) << 4);
#else
    unsigned bits = 0;
    for (int lane = 0; lane < lane_count; ++lane)
        bits |= static_cast<unsigned>(a[lane] < b) << lane;
    return bits;
#endif
}

MENISCUS_INLINE unsigned smaller_bits(Lanes<double> a, double b) {
#if MENISCUS_VECTOR_BYTES >= 32
    const __m256d limit = _mm256_set1_pd(b);
    __m256d half[2];
    std::memcpy(half, &a, sizeof half);
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(half[0], limit, _CMP_LT_OQ)) |
                                 _mm256_movemask_pd(_mm256_cmp_pd(half[1], limit, _CMP_LT_OQ))
                                     << 4);
#elif defined(__SSE2__)
    const __m128d limit = _mm_set1_pd(b);
    __m128d part[4];
    std::memcpy(part, &a, sizeof part);
    unsigned bits = 0;
    for (int p = 0; p < 4; ++p)
        bits |= static_cast<unsigned>(_mm_movemask_pd(_mm_cmplt_pd(part[p], limit))) << (2 * p);
    return bits;
#else
    unsigned bits = 0;
    for (int lane = 0; lane < lane_count; ++lane)
        bits |= static_cast<unsigned>(a[lane] < b) << lane;
    return bits;
#endif
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
