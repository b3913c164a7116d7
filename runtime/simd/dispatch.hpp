// A kernel is one file that is compiled for several instruction sets (meniscus_kernel() in
// cmake/kernel.cmake), and the widest set that the machine has is picked at run time. All give the
// same bits. Its entry is declared once, which overloads it by instruction set,
//     MENISCUS_KERNEL(std::unique_ptr<Step>, make_step, const Scene& scene, int threads);
// the kernel's file defines it, between begin_kernel.hpp and end_kernel.hpp,
//     std::unique_ptr<Step> make_step(MENISCUS_KERNEL_SET, const Scene& scene, int threads) { ... }
// and whoever wants one asks
//     with_instruction_set(widest, [&](auto set) { return make_step(set, scene, threads); });
// What is here is the same in every file, hence in no namespace of an instruction set.
#pragma once

/// Where kernels are compiled for more than the baseline.
#if defined(__x86_64__) && defined(__GNUC__)
#define MENISCUS_HAS_WIDE_KERNELS 1
#else
#define MENISCUS_HAS_WIDE_KERNELS 0
#endif

namespace meniscus {

enum class InstructionSet { baseline, avx2, avx512 };

inline constexpr InstructionSet instruction_sets[] = {InstructionSet::baseline,
                                                      InstructionSet::avx2, InstructionSet::avx512};
inline constexpr InstructionSet widest_instruction_set = InstructionSet::avx512;

constexpr const char* name_of(InstructionSet set) {
    switch (set) {
    case InstructionSet::avx512:
        return "AVX-512";
    case InstructionSet::avx2:
        return "AVX2";
    case InstructionSet::baseline:
        break;
    }
    return "baseline";
}

/// True where this machine has all that kernels for that set use.
inline bool is_supported(InstructionSet set) {
#if MENISCUS_HAS_WIDE_KERNELS
    const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
    if (set == InstructionSet::avx512)
        return has_avx2 && __builtin_cpu_supports("avx512f") != 0 &&
               __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512cd") != 0 &&
               __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0;
    if (set == InstructionSet::avx2)
        return has_avx2;
#endif
    return set == InstructionSet::baseline;
}

/// The widest set of this machine, up to `widest`.
inline InstructionSet instruction_set_up_to(InstructionSet widest = widest_instruction_set) {
    InstructionSet found = InstructionSet::baseline;
    for (const InstructionSet set : instruction_sets)
        if (set <= widest && is_supported(set))
            found = set;
    return found;
}

/// Tells the entries of a kernel apart.
template <InstructionSet Set>
struct CompiledFor {};

/// Calls call(CompiledFor<...>{}) for the widest set of this machine, up to `widest`, and returns
/// what it does.
template <class Call>
decltype(auto) with_instruction_set(InstructionSet widest, const Call& call) {
#if MENISCUS_HAS_WIDE_KERNELS
    switch (instruction_set_up_to(widest)) {
    case InstructionSet::avx512:
        return call(CompiledFor<InstructionSet::avx512>{});
    case InstructionSet::avx2:
        return call(CompiledFor<InstructionSet::avx2>{});
    case InstructionSet::baseline:
        break;
    }
#endif
    return call(CompiledFor<InstructionSet::baseline>{});
}

} // namespace meniscus

/// Declares a kernel's entry: its result, its name, its parameters.
#define MENISCUS_KERNEL(Result, name, ...)                                                         \
    Result name(::meniscus::CompiledFor<::meniscus::InstructionSet::baseline>, __VA_ARGS__);       \
    Result name(::meniscus::CompiledFor<::meniscus::InstructionSet::avx2>, __VA_ARGS__);           \
    Result name(::meniscus::CompiledFor<::meniscus::InstructionSet::avx512>, __VA_ARGS__)
