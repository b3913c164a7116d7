#include "fuzz_named_file.hpp"

#include <meniscus/data/formats/snapshot_formats.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return meniscus::run_reader_of_named_file(data, size, [](const std::filesystem::path& file) {
        return meniscus::hdf5_format().read(file);
    });
}
