#include "process_memory.hpp"

#include <fstream>
#include <string>
#include <unistd.h>

namespace meniscus {

std::uint64_t resident_memory() {
    std::uint64_t all = 0;
    std::uint64_t resident = 0;
    std::ifstream("/proc/self/statm") >> all >> resident;
    return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

std::uint64_t peak_memory() {
    std::ifstream status("/proc/self/status");
    std::uint64_t kibibytes = 0;
    for (std::string word; status >> word;)
        if (word == "VmHWM:")
            status >> kibibytes;
    return kibibytes << 10;
}

} // namespace meniscus
