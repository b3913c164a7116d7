#include "host_threads.hpp"

#include <meniscus/runtime/neighbors/parallel_loop.hpp>

#include <algorithm>
#include <atomic>
#include <unistd.h>

namespace meniscus {
namespace {

/// The process whose threads these are; 0 before there are any.
std::atomic<pid_t> owner_of_threads{0};

bool may_use_threads() {
    const pid_t self = getpid();
    pid_t owner = 0;
    return owner_of_threads.compare_exchange_strong(owner, self) || owner == self;
}

} // namespace

int usual_threads() {
    return std::clamp(omp_get_max_threads(), 1, max_threads); // OMP_NUM_THREADS says anything
}

void run_in_threads(int threads, std::size_t count, const LoopBody& body) {
    if (threads == 1 || !may_use_threads())
        SerialLoop{}(count, body);
    else
        OpenMpLoop{threads}(count, body);
}

} // namespace meniscus
