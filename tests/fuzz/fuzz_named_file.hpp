// HDF5 wants a file with a name of its own, which one in memory alone has not.
#pragma once

#include "fuzz_file.hpp"

#include <fstream>

namespace meniscus {

/// As run_reader, with a file that is there as long as it is read.
template <class Reader>
int run_reader_of_named_file(const std::uint8_t* data, std::size_t size, Reader reader) {
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
