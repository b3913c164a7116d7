#include "fuzz_file.hpp"

#include <meniscus/data/formats/snapshot_formats.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return meniscus::run_reader(data, size, [](const std::filesystem::path& file) {
        return meniscus::ply_format().read(file);
    });
}
