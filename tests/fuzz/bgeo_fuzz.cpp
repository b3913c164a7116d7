#include "fuzz_file.hpp"

#include <meniscus/data/bgeo.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return meniscus::run_reader(data, size, meniscus::read_bgeo);
}
