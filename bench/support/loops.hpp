// The loops over particles of what is compared: all methods share their work among threads in the
// same way.
#pragma once

#include <meniscus/runtime/neighbors/parallel_loop.hpp>

namespace meniscus {

/// Particles that a thread takes at a time, where nothing else is said.
inline constexpr std::size_t usual_chunk = 256;

/// Calls use(loop) with the runtime's loop for so many threads.
template <class Use>
void with_loop(int threads, const Use& use, std::size_t chunk = usual_chunk) {
    if (threads == 1)
        use(SerialLoop{});
    else
        use(OpenMpLoop{threads, chunk});
}

/// Calls body(begin, end, worker) over all indices below `count`.
template <class Body>
void over_particles(std::size_t count, int threads, const Body& body,
                    std::size_t chunk = usual_chunk) {
    with_loop(
        threads, [&](const auto& loop) { loop(count, body); }, chunk);
}

} // namespace meniscus
