// The headers of runtime/ compile to whatever instruction set the including program is built for.
// Two translation units built for different sets must not share one copy of an inline function
// (the linker would keep either, and the wrong one traps on an older machine or rounds otherwise),
// so everything lives in an inline namespace named after all that changes code and can be told: the
// widest vectors, FMA, bit instructions, parts of AVX-512, parts of fast mathematics, exceptions.
// Users never write that name.
//
// -ffp-contract leaves nothing to tell it by. Files of one program that differ in it alone give
// themselves names: -DMENISCUS_BUILD=some_word adds the word.
#pragma once

// A file that compiles only a part of itself for another set, by `#pragma GCC target`, defines both
// before it includes any of these headers: the pragma does not tell the preprocessor.
#if defined(MENISCUS_INSTRUCTION_SET_NAME)
#define MENISCUS_IS_NAMED_SET
#elif defined(__AVX512F__)
#define MENISCUS_INSTRUCTION_SET_NAME for_avx512
#define MENISCUS_VECTOR_BYTES 64
#elif defined(__AVX2__)
#define MENISCUS_INSTRUCTION_SET_NAME for_avx2
#define MENISCUS_VECTOR_BYTES 32
#elif defined(__AVX__)
#define MENISCUS_INSTRUCTION_SET_NAME for_avx
#define MENISCUS_VECTOR_BYTES 32
#elif defined(__SSE4_2__)
#define MENISCUS_INSTRUCTION_SET_NAME for_sse4_2
#define MENISCUS_VECTOR_BYTES 16
#elif defined(__SSE4_1__)
#define MENISCUS_INSTRUCTION_SET_NAME for_sse4_1
#define MENISCUS_VECTOR_BYTES 16
#elif defined(__SSSE3__)
#define MENISCUS_INSTRUCTION_SET_NAME for_ssse3
#define MENISCUS_VECTOR_BYTES 16
#elif defined(__SSE3__)
#define MENISCUS_INSTRUCTION_SET_NAME for_sse3
#define MENISCUS_VECTOR_BYTES 16
#elif defined(__SSE2__)
#define MENISCUS_INSTRUCTION_SET_NAME baseline
#define MENISCUS_VECTOR_BYTES 16
#elif defined(__ARM_FEATURE_SVE)
#define MENISCUS_INSTRUCTION_SET_NAME for_sve
#define MENISCUS_VECTOR_BYTES 16
#else
#define MENISCUS_INSTRUCTION_SET_NAME without_sse2
#define MENISCUS_VECTOR_BYTES 16
#endif

// Each of these is a part of the name, or nothing.
#define MENISCUS_SET_FMA
#define MENISCUS_SET_BMI
#define MENISCUS_SET_BMI2
#define MENISCUS_SET_LZCNT
#define MENISCUS_SET_AVX512
#define MENISCUS_SET_AVX512_MORE
#if !defined(MENISCUS_IS_NAMED_SET) // the name says all
#if defined(__FMA4__)
#undef MENISCUS_SET_FMA
#define MENISCUS_SET_FMA _fma4
#elif defined(__FMA__) || defined(__FP_FAST_FMA)
#undef MENISCUS_SET_FMA
#define MENISCUS_SET_FMA _fma
#endif
#if defined(__BMI__)
#undef MENISCUS_SET_BMI
#define MENISCUS_SET_BMI _bmi
#endif
#if defined(__BMI2__)
#undef MENISCUS_SET_BMI2
#define MENISCUS_SET_BMI2 _bmi2
#endif
#if defined(__LZCNT__)
#undef MENISCUS_SET_LZCNT
#define MENISCUS_SET_LZCNT _lzcnt
#endif
#if defined(__AVX512VL__) && defined(__AVX512DQ__) && defined(__AVX512BW__)
#undef MENISCUS_SET_AVX512
#define MENISCUS_SET_AVX512 _vl_dq_bw
#elif defined(__AVX512VL__) && defined(__AVX512DQ__)
#undef MENISCUS_SET_AVX512
#define MENISCUS_SET_AVX512 _vl_dq
#elif defined(__AVX512VL__) && defined(__AVX512BW__)
#undef MENISCUS_SET_AVX512
#define MENISCUS_SET_AVX512 _vl_bw
#elif defined(__AVX512DQ__) && defined(__AVX512BW__)
#undef MENISCUS_SET_AVX512
#define MENISCUS_SET_AVX512 _dq_bw
#elif defined(__AVX512VL__)
#undef MENISCUS_SET_AVX512
#define MENISCUS_SET_AVX512 _vl
#elif defined(__AVX512DQ__)
#undef MENISCUS_SET_AVX512
#define MENISCUS_SET_AVX512 _dq
#elif defined(__AVX512BW__)
#undef MENISCUS_SET_AVX512
#define MENISCUS_SET_AVX512 _bw
#endif
#if defined(__AVX512FP16__)
#undef MENISCUS_SET_AVX512_MORE
#define MENISCUS_SET_AVX512_MORE _fp16
#elif defined(__AVX512VBMI2__) || defined(__AVX512VPOPCNTDQ__)
#undef MENISCUS_SET_AVX512_MORE
#define MENISCUS_SET_AVX512_MORE _vbmi2
#elif defined(__AVX512VBMI__)
#undef MENISCUS_SET_AVX512_MORE
#define MENISCUS_SET_AVX512_MORE _vbmi
#elif defined(__AVX512CD__)
#undef MENISCUS_SET_AVX512_MORE
#define MENISCUS_SET_AVX512_MORE _cd
#endif
#endif
#undef MENISCUS_IS_NAMED_SET

#define MENISCUS_SET_REORDERED
#define MENISCUS_SET_FINITE
#define MENISCUS_SET_ROUNDED
#define MENISCUS_SET_EXCEPTIONS
#define MENISCUS_SET_BUILD
#if defined(__FAST_MATH__)
#undef MENISCUS_SET_REORDERED
#define MENISCUS_SET_REORDERED _fast_math
#elif defined(__ASSOCIATIVE_MATH__) && defined(__RECIPROCAL_MATH__)
#undef MENISCUS_SET_REORDERED
#define MENISCUS_SET_REORDERED _unsafe_math
#elif defined(__ASSOCIATIVE_MATH__)
#undef MENISCUS_SET_REORDERED
#define MENISCUS_SET_REORDERED _associative
#elif defined(__RECIPROCAL_MATH__)
#undef MENISCUS_SET_REORDERED
#define MENISCUS_SET_REORDERED _reciprocal
#elif defined(__NO_SIGNED_ZEROS__)
#undef MENISCUS_SET_REORDERED
#define MENISCUS_SET_REORDERED _unsigned_zeros
#endif
#if defined(__FINITE_MATH_ONLY__)
#if __FINITE_MATH_ONLY__
#undef MENISCUS_SET_FINITE
#define MENISCUS_SET_FINITE _finite
#endif
#endif
#if defined(__ROUNDING_MATH__)
#undef MENISCUS_SET_ROUNDED
#define MENISCUS_SET_ROUNDED _rounding
#endif
#if !defined(__cpp_exceptions)
#undef MENISCUS_SET_EXCEPTIONS
#define MENISCUS_SET_EXCEPTIONS _without_exceptions
#endif

#define MENISCUS_JOIN_2(a, b) a##b
#define MENISCUS_JOIN(a, b) MENISCUS_JOIN_2(a, b)
#if defined(MENISCUS_BUILD)
#undef MENISCUS_SET_BUILD
#define MENISCUS_SET_BUILD MENISCUS_JOIN(_, MENISCUS_BUILD)
#endif
#define MENISCUS_JOIN_SET_2(name, fma, bmi, bmi2, lzcnt, avx512, more, reordered, finite, rounded, \
                            exceptions, build)                                                     \
    name##fma##bmi##bmi2##lzcnt##avx512##more##reordered##finite##rounded##exceptions##build
#define MENISCUS_JOIN_SET(...) MENISCUS_JOIN_SET_2(__VA_ARGS__)
#define MENISCUS_INSTRUCTION_SET                                                                   \
    MENISCUS_JOIN_SET(MENISCUS_INSTRUCTION_SET_NAME, MENISCUS_SET_FMA, MENISCUS_SET_BMI,           \
                      MENISCUS_SET_BMI2, MENISCUS_SET_LZCNT, MENISCUS_SET_AVX512,                  \
                      MENISCUS_SET_AVX512_MORE, MENISCUS_SET_REORDERED, MENISCUS_SET_FINITE,       \
                      MENISCUS_SET_ROUNDED, MENISCUS_SET_EXCEPTIONS, MENISCUS_SET_BUILD)

// Functions that a kernel of a GPU may call, too: with nvcc, `--expt-relaxed-constexpr`
// (docs/hosts.md).
#if defined(__CUDACC__) || defined(__HIPCC__)
#define MENISCUS_HOST_DEVICE __host__ __device__
#else
#define MENISCUS_HOST_DEVICE
#endif

// For the few functions whose result the compiler would otherwise pass through memory.
#if defined(__GNUC__)
#define MENISCUS_INLINE inline __attribute__((always_inline))
#else
#define MENISCUS_INLINE inline
#endif
