// The headers of runtime/ compile to whatever instruction set the including program is built for.
// Two translation units built for different sets must not share one copy of an inline function
// (the linker would keep either, and the wrong one traps on an older machine), so everything lives
// in an inline namespace named after the set. Users never write that name.
#pragma once

#if defined(__AVX512F__)
#define MENISCUS_INSTRUCTION_SET_NAME avx512
#elif defined(__AVX2__)
#define MENISCUS_INSTRUCTION_SET_NAME avx2
#elif defined(__AVX__)
#define MENISCUS_INSTRUCTION_SET_NAME avx
#elif defined(__SSE4_1__)
#define MENISCUS_INSTRUCTION_SET_NAME sse4
#else
#define MENISCUS_INSTRUCTION_SET_NAME baseline
#endif

#if defined(__FAST_MATH__)
#define MENISCUS_INSTRUCTION_SET_JOIN(name) name##_fast_math
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
