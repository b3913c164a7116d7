// Vectors of 16 bytes, the width that every x86-64 has: four floats or two doubles. Only what the
// pass over neighbor lists needs. Fetching scattered neighbors costs more there than calculating
// with them, so wider ones would not help much. Without SSE2 there is nothing here, and that pass
// goes neighbor by neighbor.
#pragma once

#include "instruction_set.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

#if defined(__SSE2__)

struct FloatLanes {
    static constexpr int count = 4;
    __m128 value;

    static FloatLanes all(float x) { return {_mm_set1_ps(x)}; }
    static FloatLanes of(const float* a, const float* b, const float* c, const float* d) {
        return {_mm_set_ps(*d, *c, *b, *a)};
    }
    /// 1 in the last `n` lanes, 0 in the others; as a mask.
    static FloatLanes last(int n) {
        return {_mm_cmplt_ps(_mm_set_ps(0, 1, 2, 3), _mm_set1_ps(static_cast<float>(n)))};
    }
    /// Two values side by side, zeros in the other lanes. Floats need not lie as doubles would,
    /// hence the loads that move halves.
    static FloatLanes pair(const float* from) {
        return {_mm_loadl_pi(_mm_setzero_ps(), reinterpret_cast<const __m64*>(from))};
    }
    /// First and second value at each of four places.
    static void pairs_of(const float* const (&from)[count], FloatLanes& first, FloatLanes& second) {
        const __m128 front =
            _mm_loadh_pi(pair(from[0]).value, reinterpret_cast<const __m64*>(from[1]));
        const __m128 back =
            _mm_loadh_pi(pair(from[2]).value, reinterpret_cast<const __m64*>(from[3]));
        first.value = _mm_shuffle_ps(front, back, _MM_SHUFFLE(2, 0, 2, 0));
        second.value = _mm_shuffle_ps(front, back, _MM_SHUFFLE(3, 1, 3, 1));
    }
    static FloatLanes singles_of(const float* const (&from)[count], int offset) {
        return of(from[0] + offset, from[1] + offset, from[2] + offset, from[3] + offset);
    }
    void store_pair(float* to) const { _mm_storel_pi(reinterpret_cast<__m64*>(to), value); }
    [[nodiscard]] float sum() const {
        const __m128 halves = _mm_add_ps(value, _mm_movehl_ps(value, value));
        return _mm_cvtss_f32(_mm_add_ss(halves, _mm_shuffle_ps(halves, halves, 1)));
    }
    /// A mask's lanes as bits.
    [[nodiscard]] unsigned bits() const { return static_cast<unsigned>(_mm_movemask_ps(value)); }
    friend FloatLanes operator+(FloatLanes a, FloatLanes b) {
        return {_mm_add_ps(a.value, b.value)};
    }
    friend FloatLanes operator-(FloatLanes a, FloatLanes b) {
        return {_mm_sub_ps(a.value, b.value)};
    }
    friend FloatLanes operator*(FloatLanes a, FloatLanes b) {
        return {_mm_mul_ps(a.value, b.value)};
    }
    friend FloatLanes operator<(FloatLanes a, FloatLanes b) {
        return {_mm_cmplt_ps(a.value, b.value)};
    }
    friend FloatLanes operator&(FloatLanes a, FloatLanes b) {
        return {_mm_and_ps(a.value, b.value)};
    }
};

struct DoubleLanes {
    static constexpr int count = 2;
    __m128d value;

    static DoubleLanes all(double x) { return {_mm_set1_pd(x)}; }
    static DoubleLanes last(int n) {
        return {_mm_cmplt_pd(_mm_set_pd(0, 1), _mm_set1_pd(static_cast<double>(n)))};
    }
    static DoubleLanes pair(const double* from) { return {_mm_loadu_pd(from)}; }
    static void pairs_of(const double* const (&from)[count], DoubleLanes& first,
                         DoubleLanes& second) {
        const __m128d front = _mm_loadu_pd(from[0]);
        const __m128d back = _mm_loadu_pd(from[1]);
        first.value = _mm_unpacklo_pd(front, back);
        second.value = _mm_unpackhi_pd(front, back);
    }
    static DoubleLanes singles_of(const double* const (&from)[count], int offset) {
        return {_mm_set_pd(from[1][offset], from[0][offset])};
    }
    void store_pair(double* to) const { _mm_storeu_pd(to, value); }
    [[nodiscard]] double sum() const {
        return _mm_cvtsd_f64(_mm_add_sd(value, _mm_unpackhi_pd(value, value)));
    }
    [[nodiscard]] unsigned bits() const { return static_cast<unsigned>(_mm_movemask_pd(value)); }
    friend DoubleLanes operator+(DoubleLanes a, DoubleLanes b) {
        return {_mm_add_pd(a.value, b.value)};
    }
    friend DoubleLanes operator-(DoubleLanes a, DoubleLanes b) {
        return {_mm_sub_pd(a.value, b.value)};
    }
    friend DoubleLanes operator*(DoubleLanes a, DoubleLanes b) {
        return {_mm_mul_pd(a.value, b.value)};
    }
    friend DoubleLanes operator<(DoubleLanes a, DoubleLanes b) {
        return {_mm_cmplt_pd(a.value, b.value)};
    }
    friend DoubleLanes operator&(DoubleLanes a, DoubleLanes b) {
        return {_mm_and_pd(a.value, b.value)};
    }
};

template <class Real>
struct LanesOf;
template <>
struct LanesOf<float> {
    using Type = FloatLanes;
};
template <>
struct LanesOf<double> {
    using Type = DoubleLanes;
};

#endif

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
