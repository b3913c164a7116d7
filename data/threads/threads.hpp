// How many threads share a loop, and the loop: the runtime's own, which throws on, in the calling
// thread, what any thread throws. Memory that each thread works with is made before the loop, one
// for each of its workers, so that nothing can fail where no exception may leave. Not for sources
// that are compiled for several instruction sets.
#pragma once

#include <meniscus/runtime/neighbors/parallel_loop.hpp>

#include <algorithm>

namespace meniscus {

/// The most threads that a loop takes.
inline constexpr int thread_limit = 1024;

/// The threads that `threads` asks for, 0 for all that OpenMP offers: at least 1 and at most
/// thread_limit, whatever OMP_NUM_THREADS says.
inline int thread_count([[maybe_unused]] int threads) {
#if defined(_OPENMP)
    return std::clamp(threads > 0 ? threads : omp_get_max_threads(), 1, thread_limit);
#else
    return 1;
#endif
}

/// A loop over so many threads, 0 for all, that takes `chunk` indices at a time; without OpenMP
/// over the calling one.
inline auto loop_over([[maybe_unused]] int threads, [[maybe_unused]] std::size_t chunk = 256) {
#if defined(_OPENMP)
    return OpenMpLoop{thread_count(threads), chunk};
#else
    return SerialLoop{};
#endif
}

} // namespace meniscus
