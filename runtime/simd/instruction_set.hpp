// The headers of runtime/ compile to whatever instruction set the including program is built for.
// Two translation units built for different sets must not share one copy of an inline function
// (the linker would keep either, and the wrong one traps on an older machine), so everything lives
// in an inline namespace named after the set, and after other ways of building that change what
// functions do. Users never write that name.
#pragma once

// A file that compiles only a part of itself for another set, by `#pragma GCC target`, defines both
// before it includes any of these headers: the pragma does not tell the preprocessor.
#if !defined(MENISCUS_INSTRUCTION_SET_NAME)
#if defined(__AVX512F__)
#define MENISCUS_INSTRUCTION_SET_NAME avx512
#define MENISCUS_VECTOR_BYTES 64
#elif defined(__AVX2__)
#define MENISCUS_INSTRUCTION_SET_NAME avx2
#define MENISCUS_VECTOR_BYTES 32
#elif defined(__AVX__)
#define MENISCUS_INSTRUCTION_SET_NAME avx
#define MENISCUS_VECTOR_BYTES 32
#elif defined(__SSE4_1__)
#define MENISCUS_INSTRUCTION_SET_NAME sse4
#define MENISCUS_VECTOR_BYTES 16
#else
#define MENISCUS_INSTRUCTION_SET_NAME baseline
#define MENISCUS_VECTOR_BYTES 16
#endif
#endif

#if defined(__FAST_MATH__) && !defined(__cpp_exceptions)
#define MENISCUS_INSTRUCTION_SET_JOIN(name) name##_fast_math_without_exceptions
#elif defined(__FAST_MATH__)
#define MENISCUS_INSTRUCTION_SET_JOIN(name) name##_fast_math
#elif !defined(__cpp_exceptions)
#define MENISCUS_INSTRUCTION_SET_JOIN(name) name##_without_exceptions
#else
#define MENISCUS_INSTRUCTION_SET_JOIN(name) name
#endif
#define MENISCUS_INSTRUCTION_SET_EXPAND(name) MENISCUS_INSTRUCTION_SET_JOIN(name)
#define MENISCUS_INSTRUCTION_SET MENISCUS_INSTRUCTION_SET_EXPAND(MENISCUS_INSTRUCTION_SET_NAME)

// For the few functions whose result the compiler would otherwise pass through memory.
#if defined(__GNUC__)
#define MENISCUS_INLINE inline __attribute__((always_inline))
#else
#define MENISCUS_INLINE inline
#endif
