// Closes the region that begin_kernel.hpp opens.
#if defined(MENISCUS_KERNEL_AVX512) || defined(MENISCUS_KERNEL_AVX2)
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
