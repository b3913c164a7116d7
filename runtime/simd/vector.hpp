// Several numbers at a time, by the vector types of GCC and Clang, for everything in the project
// that works on more than one. Arithmetic is the compiler's, also with a number on one side; a
// comparison gives a mask, and mask ? a : b picks lane by lane. What the compilers lack is here.
//
// Three widths are in use. Wide and WideFloat are as wide as the instruction set that the including
// program is built for. A Pack has 16 bytes, the width that every x86-64 has, for loops over
// scattered neighbors: to fetch them costs more than to calculate with them, so wider vectors would
// not help much. Lanes are eight, whatever the set. Where results must be the same for each set,
// numbers are added up in an order that does not depend on it: sum_of_lanes().
#pragma once

#include "instruction_set.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

template <class Real, std::size_t Count>
struct VectorType {
    typedef Real Type __attribute__((vector_size(Count * sizeof(Real))));
};

/// `Count` (a power of two) numbers.
template <class Real, std::size_t Count>
using VectorOf = typename VectorType<Real, Count>::Type;

template <class Real>
using Pack = VectorOf<Real, 16 / sizeof(Real)>;

inline constexpr int lane_count = 8;
template <class Real>
using Lanes = VectorOf<Real, lane_count>;

inline constexpr std::size_t wide_count = MENISCUS_VECTOR_BYTES / sizeof(double);
inline constexpr std::size_t wide_float_count = MENISCUS_VECTOR_BYTES / sizeof(float);

using Wide = VectorOf<double, wide_count>;
using WideFloat = VectorOf<float, wide_float_count>;

/// The type of one lane, and how many there are.
template <class V>
using LaneOf = std::remove_reference_t<decltype(std::declval<V&>()[0])>;
template <class V>
inline constexpr int lanes_in = static_cast<int>(sizeof(V) / sizeof(LaneOf<V>));

/// What a comparison gives: a lane is 0 or all ones.
template <class V>
using MaskOf = decltype(std::declval<V>() < std::declval<V>());

using WideMask = MaskOf<Wide>;

/// A count rounded up to whole Wides.
constexpr std::size_t padded_to_wide(std::size_t count) {
    return (count + wide_count - 1) / wide_count * wide_count;
}

/// As many numbers as V has, one after another; they need not be aligned.
template <class V>
MENISCUS_INLINE V load(const LaneOf<V>* from) {
    V values;
    std::memcpy(&values, from, sizeof values);
    return values;
}

template <class V>
MENISCUS_INLINE void store(V values, LaneOf<V>* to) {
    std::memcpy(to, &values, sizeof values);
}

template <class V>
MENISCUS_INLINE V all_lanes(LaneOf<V> value) {
    return value - V{}; // which changes no value, as a sum with zero would that of -0
}

/// The numbers at as many places of an array as V has lanes.
template <class V>
MENISCUS_INLINE V gather(const LaneOf<V>* values, const std::uint32_t* index) {
    static_assert(lanes_in<V> == 2 || lanes_in<V> == 4 || lanes_in<V> == 8);
    if constexpr (lanes_in<V> == 2)
        return V{values[index[0]], values[index[1]]};
    else if constexpr (lanes_in<V> == 4)
        return V{values[index[0]], values[index[1]], values[index[2]], values[index[3]]};
    else
        return V{values[index[0]], values[index[1]], values[index[2]], values[index[3]],
                 values[index[4]], values[index[5]], values[index[6]], values[index[7]]};
}

MENISCUS_HOST_DEVICE inline double larger(double a, double b) {
    return a > b ? a : b;
}

MENISCUS_HOST_DEVICE inline double smaller(double a, double b) {
    return a < b ? a : b;
}

template <class V>
MENISCUS_INLINE V larger(V a, V b) {
    return a > b ? a : b;
}

template <class V>
MENISCUS_INLINE V smaller(V a, V b) {
    return a < b ? a : b;
}

/// The size of one with the sign of another.
MENISCUS_INLINE Wide with_sign(Wide size, Wide sign) {
    return Wide((WideMask(size) & INT64_MAX) | (WideMask(sign) & INT64_MIN));
}

MENISCUS_INLINE Wide absolute(Wide a) {
    return Wide(WideMask(a) & INT64_MAX);
}

/// By name, and by halves where V is wider than a register: a host's compiler may be told that
/// square roots set errno, or not to look for vectors by itself.
template <class V>
MENISCUS_INLINE V square_root(V a) {
    [[maybe_unused]] constexpr bool is_float = std::is_same_v<LaneOf<V>, float>;
#if MENISCUS_VECTOR_BYTES == 64 // by mask, because the plain ones make GCC 12 warn
    if constexpr (sizeof(V) == 64 && is_float)
        return V(_mm512_maskz_sqrt_ps(0xffff, __m512(a)));
    if constexpr (sizeof(V) == 64 && !is_float)
        return V(_mm512_maskz_sqrt_pd(0xff, __m512d(a)));
#endif
#if MENISCUS_VECTOR_BYTES >= 32
    if constexpr (sizeof(V) == 32 && is_float)
        return V(_mm256_sqrt_ps(__m256(a)));
    if constexpr (sizeof(V) == 32 && !is_float)
        return V(_mm256_sqrt_pd(__m256d(a)));
#endif
#if defined(__SSE2__)
    if constexpr (sizeof(V) == 16 && is_float)
        return V(_mm_sqrt_ps(__m128(a)));
    if constexpr (sizeof(V) == 16 && !is_float)
        return V(_mm_sqrt_pd(__m128d(a)));
    if constexpr (sizeof(V) > MENISCUS_VECTOR_BYTES) {
        VectorOf<LaneOf<V>, lanes_in<V> / 2> halves[2];
        std::memcpy(halves, &a, sizeof a);
        halves[0] = square_root(halves[0]);
        halves[1] = square_root(halves[1]);
        std::memcpy(&a, halves, sizeof a);
        return a;
    }
#endif
    for (int lane = 0; lane < lanes_in<V>; ++lane)
        a[lane] = std::sqrt(a[lane]);
    return a;
}

/// Halves are added up until one number is left: in the same order for each instruction set.
template <class V>
MENISCUS_INLINE LaneOf<V> sum_of_lanes(V a) {
    static_assert(lanes_in<V> == 2 || lanes_in<V> == 4 || lanes_in<V> == 8);
    if constexpr (lanes_in<V> == 8)
        return ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7]));
    else if constexpr (lanes_in<V> == 2)
        return a[0] + a[1];
#if defined(__SSE2__)
    else if constexpr (sizeof(V) == 16) {
        const V halves = a + V(_mm_movehl_ps(__m128(a), __m128(a)));
        return halves[0] + halves[1];
    }
#endif
    else
        return (a[0] + a[2]) + (a[1] + a[3]);
}

/// The largest of all lanes and `min`.
MENISCUS_INLINE double max_lane(Wide a, double min) {
    for (std::size_t lane = 0; lane < wide_count; ++lane)
        min = larger(min, a[lane]);
    return min;
}

/// The smallest of all lanes and `max`.
MENISCUS_INLINE double min_lane(Wide a, double max) {
    for (std::size_t lane = 0; lane < wide_count; ++lane)
        max = smaller(max, a[lane]);
    return max;
}

/// a < b. By name, because where there are mask registers compilers use one for vectors smaller
/// than the widest, and make a vector of it again; and lacking SSE4.1 they go lane by lane for
/// doubles.
template <class V>
MENISCUS_INLINE MaskOf<V> below(V a, V b) {
    [[maybe_unused]] constexpr bool is_float = std::is_same_v<LaneOf<V>, float>;
#if defined(__SSE2__)
    if constexpr (sizeof(V) == 16 && is_float)
        return MaskOf<V>(_mm_cmplt_ps(__m128(a), __m128(b)));
    if constexpr (sizeof(V) == 16 && !is_float)
        return MaskOf<V>(_mm_cmplt_pd(__m128d(a), __m128d(b)));
#endif
#if MENISCUS_VECTOR_BYTES >= 32
    if constexpr (sizeof(V) == 32 && is_float)
        return MaskOf<V>(_mm256_cmp_ps(__m256(a), __m256(b), _CMP_LT_OQ));
    if constexpr (sizeof(V) == 32 && !is_float)
        return MaskOf<V>(_mm256_cmp_pd(__m256d(a), __m256d(b), _CMP_LT_OQ));
#endif
    return a < b;
}

/// Bit n: lane n of a mask is set.
template <class Mask>
MENISCUS_INLINE unsigned mask_bits(Mask mask) {
    [[maybe_unused]] constexpr bool is_float = sizeof(LaneOf<Mask>) == sizeof(float);
#if defined(__SSE2__)
    if constexpr (sizeof(Mask) == 16 && is_float)
        return static_cast<unsigned>(_mm_movemask_ps(__m128(mask)));
    if constexpr (sizeof(Mask) == 16 && !is_float)
        return static_cast<unsigned>(_mm_movemask_pd(__m128d(mask)));
#endif
#if MENISCUS_VECTOR_BYTES >= 32
    if constexpr (sizeof(Mask) == 32 && is_float)
        return static_cast<unsigned>(_mm256_movemask_ps(__m256(mask)));
    if constexpr (sizeof(Mask) == 32 && !is_float)
        return static_cast<unsigned>(_mm256_movemask_pd(__m256d(mask)));
#endif
    unsigned bits = 0;
    for (int lane = 0; lane < lanes_in<Mask>; ++lane)
        bits |= static_cast<unsigned>(mask[lane] != 0) << lane;
    return bits;
}

/// Bit n: lane n of a is smaller than that of b.
template <class V>
MENISCUS_INLINE unsigned bits_below(V a, V b) {
    if constexpr (sizeof(V) > MENISCUS_VECTOR_BYTES) {
        using Half = VectorOf<LaneOf<V>, lanes_in<V> / 2>;
        Half of_a[2], of_b[2];
        std::memcpy(of_a, &a, sizeof a);
        std::memcpy(of_b, &b, sizeof b);
        return bits_below(of_a[0], of_b[0]) | bits_below(of_a[1], of_b[1]) << lanes_in<Half>;
    }
#if MENISCUS_VECTOR_BYTES == 64
    if constexpr (std::is_same_v<V, WideFloat>)
        return _mm512_cmp_ps_mask(__m512(a), __m512(b), _CMP_LT_OQ);
    if constexpr (std::is_same_v<V, Wide>)
        return _mm512_cmp_pd_mask(__m512d(a), __m512d(b), _CMP_LT_OQ);
#endif
    return mask_bits(below(a, b));
}

/// True where a lane is zero or below.
MENISCUS_INLINE bool any_not_positive(WideFloat a) {
#if MENISCUS_VECTOR_BYTES == 64
    return _mm512_cmp_ps_mask(__m512(a), _mm512_setzero_ps(), _CMP_LE_OQ) != 0;
#else
    return mask_bits(a <= WideFloat{}) != 0;
#endif
}

/// True where a mask is set in any lane.
MENISCUS_INLINE bool any_lane(WideMask mask) {
    std::int64_t together = 0;
    for (std::size_t lane = 0; lane < wide_count; ++lane)
        together |= mask[lane];
    return together != 0;
}

/// The lanes that a mask sets, and 0 in the others.
template <class V>
MENISCUS_INLINE V keep(MaskOf<V> mask, V values) {
    return V(mask & MaskOf<V>(values));
}

/// A mask of the last `n` lanes.
template <class V>
MENISCUS_INLINE MaskOf<V> last_lanes(int n) {
    V from_the_end;
    for (int lane = 0; lane < lanes_in<V>; ++lane)
        from_the_end[lane] = static_cast<LaneOf<V>>(lanes_in<V> - 1 - lane);
    return below(from_the_end, all_lanes<V>(static_cast<LaneOf<V>>(n)));
}

/// Two numbers side by side, zeros in the other lanes. Floats need not lie as doubles would, hence
/// the load that moves a half.
template <class Real>
MENISCUS_INLINE Pack<Real> load_pair(const Real* from) {
#if defined(__SSE2__)
    if constexpr (std::is_same_v<Real, float>)
        return Pack<Real>(_mm_loadl_pi(_mm_setzero_ps(), reinterpret_cast<const __m64*>(from)));
#endif
    Pack<Real> pair{};
    std::memcpy(&pair, from, 2 * sizeof(Real));
    return pair;
}

template <class Real>
MENISCUS_INLINE void store_pair(Pack<Real> values, Real* to) {
    std::memcpy(to, &values, 2 * sizeof(Real));
}

/// One number at each of some places.
template <class Real>
MENISCUS_INLINE Pack<Real> load_each(const Real* const (&from)[lanes_in<Pack<Real>>], int offset) {
    if constexpr (std::is_same_v<Real, float>)
        return Pack<Real>{from[0][offset], from[1][offset], from[2][offset], from[3][offset]};
    else
        return Pack<Real>{from[0][offset], from[1][offset]};
}

/// The first and the second number at each of some places.
template <class Real>
MENISCUS_INLINE void load_pairs(const Real* const (&from)[lanes_in<Pack<Real>>], Pack<Real>& first,
                                Pack<Real>& second) {
#if defined(__SSE2__)
    if constexpr (std::is_same_v<Real, float>) {
        const auto half = [&](int n) { return reinterpret_cast<const __m64*>(from[n]); };
        const __m128 front = _mm_loadh_pi(__m128(load_pair(from[0])), half(1));
        const __m128 back = _mm_loadh_pi(__m128(load_pair(from[2])), half(3));
        first = Pack<Real>(_mm_shuffle_ps(front, back, _MM_SHUFFLE(2, 0, 2, 0)));
        second = Pack<Real>(_mm_shuffle_ps(front, back, _MM_SHUFFLE(3, 1, 3, 1)));
    } else {
        const auto front = __m128d(load_pair(from[0]));
        const auto back = __m128d(load_pair(from[1]));
        first = Pack<Real>(_mm_unpacklo_pd(front, back));
        second = Pack<Real>(_mm_unpackhi_pd(front, back));
    }
#else
    first = load_each(from, 0);
    second = load_each(from, 1);
#endif
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
