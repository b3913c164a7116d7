// How the runtime spreads its work: over a loop that the host supplies. A loop is anything that has
//     workers()            the largest number of bodies that run at one time, and
//     loop(count, body)    which calls body(begin, end, worker) until every index below count lies
//                          in exactly one range, and returns when all have;
// `worker`, below workers(), must not be the same for two bodies that run at one time: it says
// whose memory a body may use. No result depends on how the range is cut, or on the number of
// workers; another kind of loop may change last bits where the compiler has leave to round
// otherwise (-ffast-math, contraction). SerialLoop is there for one thread, OpenMpLoop where the
// including program is built with OpenMP; one over a host's own thread pool takes five lines.
#pragma once

#include "../simd/instruction_set.hpp"

#include <cstddef>

#if defined(_OPENMP)
#include <atomic>
#include <exception>
#include <omp.h>
#endif

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// All in the calling thread.
struct SerialLoop {
    [[nodiscard]] static int workers() { return 1; }

    template <class Body>
    void operator()(std::size_t count, Body&& body) const {
        if (count > 0)
            body(std::size_t{0}, count, 0);
    }
};

#if defined(_OPENMP)

/// Chunks of particles, taken by whichever thread is free: surface particles cost far more than
/// others and lie together. What a body throws is thrown on in the calling thread, and no
/// other chunk begins after it.
struct OpenMpLoop {
    int threads = omp_get_max_threads();
    std::size_t chunk = 256; ///< particles; fewer where each takes long

    [[nodiscard]] int workers() const { return threads; }

    template <class Body>
    void operator()(std::size_t count, Body&& body) const {
        const std::size_t chunks = (count + chunk - 1) / chunk;
        std::exception_ptr thrown; // none may leave the parallel region
        std::atomic<bool> goes_on{true};
#pragma omp parallel for schedule(dynamic) num_threads(threads)
        for (std::size_t c = 0; c < chunks; ++c) {
            const std::size_t end = (c + 1) * chunk < count ? (c + 1) * chunk : count;
#if defined(__cpp_exceptions)
            try {
                if (goes_on.load(std::memory_order_relaxed))
                    body(c * chunk, end, omp_get_thread_num());
            } catch (...) {
                goes_on.store(false, std::memory_order_relaxed);
#pragma omp critical(meniscus_thrown)
                thrown = std::current_exception();
            }
#else
            body(c * chunk, end, omp_get_thread_num());
#endif
        }
        if (thrown)
            std::rethrow_exception(thrown);
    }
};

#endif

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
