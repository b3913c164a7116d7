#include "fuzz_file.hpp"

#include <meniscus/data/formats/snapshot_formats.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return meniscus::run_reader(data, size, [](const std::filesystem::path& file) {
        const bool told = meniscus::csv_format().detect(file);
        meniscus::Snapshot snapshot = meniscus::csv_format().read(file);
        meniscus::require(told, "what is read is told to be CSV");
        return snapshot;
    });
}
