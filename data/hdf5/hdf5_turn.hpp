// Who of us may be inside HDF5 in this process, one thread at a time: it is built for several
// threads in some places only, and its own lock lets a busy thread have it again and again. For the
// sources of data/ only.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace meniscus {

/// A lock that threads get in the order in which they ask for it.
class FairLock {
public:
    void lock() {
        std::unique_lock<std::mutex> guard(mutex);
        const std::uint64_t ticket = next++;
        changed.wait(guard, [&] { return ticket == served; });
    }

    void unlock() {
        const std::lock_guard<std::mutex> guard(mutex);
        ++served;
        changed.notify_all();
    }

private:
    std::mutex mutex;
    std::condition_variable changed;
    std::uint64_t next = 0;
    std::uint64_t served = 0;
};

inline FairLock& hdf5_turn() {
    static FairLock turn;
    return turn;
}

} // namespace meniscus
