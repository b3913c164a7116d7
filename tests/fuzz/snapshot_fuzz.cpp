// What follows on every reader: names, roles of particles, and the plane.
#include "fuzz_file.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return meniscus::run_reader(data, size, [](const std::filesystem::path& file) {
        return meniscus::read_snapshot(file);
    });
}
