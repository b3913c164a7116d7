// A host's own loop, for tests of what must not depend on threads: small chunks, each taken by
// whichever thread comes first.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace meniscus {

struct ThreadedLoop {
    int threads;
    std::size_t chunk = 16;

    [[nodiscard]] int workers() const { return threads; }

    template <class Body>
    void operator()(std::size_t count, Body&& body) const {
        std::atomic<std::size_t> next{0};
        std::vector<std::thread> running;
        running.reserve(static_cast<std::size_t>(threads));
        for (int worker = 0; worker < threads; ++worker)
            running.emplace_back([&, worker] {
                for (std::size_t begin; (begin = next.fetch_add(chunk)) < count;)
                    body(begin, std::min(begin + chunk, count), worker);
            });
        for (std::thread& thread : running)
            thread.join();
    }
};

} // namespace meniscus
