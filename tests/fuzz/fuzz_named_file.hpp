// HDF5 wants a file with a name of its own, which one in memory alone has not.
#pragma once

#include "fuzz_file.hpp"

#include <pthread.h>

namespace meniscus {

/// libFuzzer saves an input that ends its process, and would do so in a child that HDF5 ends, which
/// is no finding. It saves nothing where nothing can be written.
inline void save_nothing_in_children() {
    static const int registered =
        pthread_atfork(nullptr, nullptr, [] { require(chdir("/proc") == 0, "there is a /proc"); });
    require(registered == 0, "children can be told");
}

/// As run_reader, with a file that is there as long as it is read.
template <class Reader>
int run_reader_of_named_file(const std::uint8_t* data, std::size_t size, Reader reader) {
    save_nothing_in_children();
    const std::filesystem::path named = "/dev/shm/meniscus_fuzz_" + std::to_string(getpid());
    const int result = run_reader(data, size, [&](const std::filesystem::path& in_memory) {
        std::filesystem::copy_file(in_memory, named,
                                   std::filesystem::copy_options::overwrite_existing);
        return reader(named);
    });
    std::filesystem::remove(named);
    return result;
}

} // namespace meniscus
