// Opens the region of a kernel (dispatch.hpp): what lies between this header and end_kernel.hpp is
// compiled for the instruction set that meniscus_kernel() asks for, or for that of the whole file
// where nobody does. The headers of runtime/ must not be included before.
//
// Inline functions of the standard library are shared by all files of a program, whichever of them
// the linker keeps, and must run on every machine: so all of its headers that a kernel uses are
// included here, before the region begins (tests/runtime/kernel_objects.py looks at what came out).
// Names within MENISCUS_INSTRUCTION_SET are each set's own.
#include "dispatch.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cfenv>
#include <cfloat>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>
#if defined(_OPENMP)
#include <omp.h>
#endif
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#if defined(MENISCUS_INSTRUCTION_SET)
#error "include no header of meniscus/runtime but simd/dispatch.hpp before simd/begin_kernel.hpp"
#endif

#if defined(MENISCUS_KERNEL_AVX512)
#define MENISCUS_INSTRUCTION_SET_NAME avx512
#define MENISCUS_VECTOR_BYTES 64
#define MENISCUS_KERNEL_SET ::meniscus::CompiledFor<::meniscus::InstructionSet::avx512>
#if defined(__clang__)
#pragma clang attribute push(                                                                      \
    __attribute__((target("avx2,avx512f,avx512bw,avx512cd,avx512dq,avx512vl"))),                   \
    apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,avx512f,avx512bw,avx512cd,avx512dq,avx512vl")
#endif
#elif defined(MENISCUS_KERNEL_AVX2)
#define MENISCUS_INSTRUCTION_SET_NAME avx2
#define MENISCUS_VECTOR_BYTES 32
#define MENISCUS_KERNEL_SET ::meniscus::CompiledFor<::meniscus::InstructionSet::avx2>
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
#else
#define MENISCUS_KERNEL_SET ::meniscus::CompiledFor<::meniscus::InstructionSet::baseline>
#endif
