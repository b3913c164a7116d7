// The threads of a step behind its class (surface_step.hpp): those of OpenMP, for a host that may
// have set OMP_NUM_THREADS to anything, and that may fork. A forked child has none of its parent's
// threads, and OpenMP's would be waited for without end: so in the child of a process in which a
// step has used them, steps work on the calling thread. Results are the same.
#pragma once

#include <cstddef>

namespace meniscus {

/// The most threads that a setup may ask for.
inline constexpr int max_threads = 1024;

/// As many as OpenMP offers, at least 1 and at most max_threads.
int usual_threads();

/// A body of a loop (runtime/neighbors/parallel_loop.hpp), whatever its type.
struct LoopBody {
    const void* body;
    void (*call)(const void* body, std::size_t begin, std::size_t end, int worker);

    void operator()(std::size_t begin, std::size_t end, int worker) const {
        call(body, begin, end, worker);
    }
};

/// Runs it over `count` indices with so many threads at most.
void run_in_threads(int threads, std::size_t count, const LoopBody& body);

/// The loop over them.
struct HostLoop {
    int threads;

    [[nodiscard]] int workers() const { return threads; }

    template <class Body>
    void operator()(std::size_t count, const Body& body) const {
        run_in_threads(threads, count,
                       {&body, [](const void* of, std::size_t begin, std::size_t end, int worker) {
                            (*static_cast<const Body*>(of))(begin, end, worker);
                        }});
    }
};

} // namespace meniscus
