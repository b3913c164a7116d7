#include "fuzz_file.hpp"

#include <meniscus/data/formats/snapshot_formats.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return meniscus::run_reader(data, size, [](const std::filesystem::path& file) {
        return meniscus::deep_lagrangian_fluids_format().read(file);
    });
}
