#include "exact_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#include <immintrin.h>
#define MENISCUS_INSTRUCTION_SET_NAME avx512
#define MENISCUS_VECTOR_BYTES 64
#pragma GCC push_options
#pragma GCC target("avx2,avx512f,avx512bw,avx512cd,avx512dq,avx512vl")
#include "exact_labels_kernel.hpp"
#pragma GCC pop_options
#define MENISCUS_HAS_KERNEL 1
#endif

namespace meniscus {

std::unique_ptr<ExactLabels> exact_labels_avx512() {
#if defined(MENISCUS_HAS_KERNEL)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        return make_exact_labels();
#endif
    return nullptr;
}

} // namespace meniscus
