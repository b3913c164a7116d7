// The HDF5 library lets one thread in at a time, by a lock of its own. A child that is forked while
// another thread is inside would wait for that lock for ever. So whoever forks a child that reads,
// and whoever calls the library in this process, holds this one.
#pragma once

#include <mutex>

namespace meniscus {

inline std::mutex& hdf5_lock() {
    static std::mutex lock;
    return lock;
}

} // namespace meniscus
