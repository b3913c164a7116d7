#include "fuzz_file.hpp"

#include <meniscus/data/legacy_vtk.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return meniscus::run_reader(data, size, meniscus::read_legacy_vtk);
}
