// Several doubles or floats at a time, as many as the instruction set has that the including
// program is built for, by the vector types of GCC and Clang. Arithmetic is theirs; a comparison
// gives a mask, and mask ? a : b picks lane by lane. What they lack is here.
#pragma once

#include "instruction_set.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

inline constexpr std::size_t wide_count = MENISCUS_VECTOR_BYTES / sizeof(double);

using Wide = double __attribute__((vector_size(wide_count * sizeof(double))));
using WideMask = std::int64_t __attribute__((vector_size(wide_count * sizeof(double))));

inline constexpr std::size_t wide_float_count = MENISCUS_VECTOR_BYTES / sizeof(float);

using WideFloat = float __attribute__((vector_size(wide_float_count * sizeof(float))));
using WideFloatMask = std::int32_t __attribute__((vector_size(wide_float_count * sizeof(float))));

/// A count rounded up to whole vectors.
constexpr std::size_t padded_to_wide(std::size_t count) {
    return (count + wide_count - 1) / wide_count * wide_count;
}

MENISCUS_INLINE Wide load_wide(const double* from) {
    Wide values;
    std::memcpy(&values, from, sizeof values);
    return values;
}

MENISCUS_INLINE WideFloat load_wide(const float* from) {
    WideFloat values;
    std::memcpy(&values, from, sizeof values);
    return values;
}

MENISCUS_INLINE void store_wide(WideFloat values, float* to) {
    std::memcpy(to, &values, sizeof values);
}

MENISCUS_INLINE void store_wide(Wide values, double* to) {
    std::memcpy(to, &values, sizeof values);
}

MENISCUS_INLINE Wide all_lanes(double value) {
    return Wide{} + value;
}

inline double larger(double a, double b) {
    return a > b ? a : b;
}

inline double smaller(double a, double b) {
    return a < b ? a : b;
}

MENISCUS_INLINE Wide larger(Wide a, Wide b) {
    return a > b ? a : b;
}

MENISCUS_INLINE WideFloat larger(WideFloat a, WideFloat b) {
    return a > b ? a : b;
}

MENISCUS_INLINE WideFloat smaller(WideFloat a, WideFloat b) {
    return a < b ? a : b;
}

MENISCUS_INLINE Wide smaller(Wide a, Wide b) {
    return a < b ? a : b;
}

/// The size of one with the sign of another.
MENISCUS_INLINE Wide with_sign(Wide size, Wide sign) {
    return (Wide)(((WideMask)size & INT64_MAX) | ((WideMask)sign & INT64_MIN));
}

MENISCUS_INLINE Wide absolute(Wide a) {
    return (Wide)((WideMask)a & INT64_MAX);
}

MENISCUS_INLINE Wide square_root(Wide a) {
#if MENISCUS_VECTOR_BYTES == 64
    return (Wide)_mm512_maskz_sqrt_pd(0xff, (__m512d)a); // the plain one makes GCC 12 warn
#elif MENISCUS_VECTOR_BYTES == 32
    return (Wide)_mm256_sqrt_pd((__m256d)a);
#elif defined(__SSE2__)
    return (Wide)_mm_sqrt_pd((__m128d)a);
#else
    for (std::size_t lane = 0; lane < wide_count; ++lane)
        a[lane] = std::sqrt(a[lane]);
    return a;
#endif
}

MENISCUS_INLINE WideFloat square_root(WideFloat a) {
#if MENISCUS_VECTOR_BYTES == 64
    return (WideFloat)_mm512_maskz_sqrt_ps(0xffff, (__m512)a);
#elif MENISCUS_VECTOR_BYTES == 32
    return (WideFloat)_mm256_sqrt_ps((__m256)a);
#elif defined(__SSE2__)
    return (WideFloat)_mm_sqrt_ps((__m128)a);
#else
    for (std::size_t lane = 0; lane < wide_float_count; ++lane)
        a[lane] = std::sqrt(a[lane]);
    return a;
#endif
}

/// The largest of all lanes and `least`.
MENISCUS_INLINE double largest_lane(Wide a, double least) {
    for (std::size_t lane = 0; lane < wide_count; ++lane)
        least = larger(least, a[lane]);
    return least;
}

/// The smallest of all lanes and `most`.
MENISCUS_INLINE double smallest_lane(Wide a, double most) {
    for (std::size_t lane = 0; lane < wide_count; ++lane)
        most = smaller(most, a[lane]);
    return most;
}

/// True where a lane is zero or below.
MENISCUS_INLINE bool any_not_positive(WideFloat a) {
#if MENISCUS_VECTOR_BYTES == 64
    return _mm512_cmp_ps_mask((__m512)a, _mm512_setzero_ps(), _CMP_LE_OQ) != 0;
#elif MENISCUS_VECTOR_BYTES == 32
    return _mm256_movemask_ps(_mm256_cmp_ps((__m256)a, _mm256_setzero_ps(), _CMP_LE_OQ)) != 0;
#elif defined(__SSE2__)
    return _mm_movemask_ps(_mm_cmple_ps((__m128)a, _mm_setzero_ps())) != 0;
#else
    bool any = false;
    for (std::size_t lane = 0; lane < wide_float_count; ++lane)
        any |= a[lane] <= 0;
    return any;
#endif
}

/// True where a mask is set in any lane.
MENISCUS_INLINE bool any_lane(WideMask mask) {
    std::int64_t together = 0;
    for (std::size_t lane = 0; lane < wide_count; ++lane)
        together |= mask[lane];
    return together != 0;
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
