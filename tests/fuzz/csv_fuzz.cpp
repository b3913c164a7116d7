#include "fuzz_file.hpp"

#include <meniscus/data/csv.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return meniscus::run_reader(data, size, [](const std::filesystem::path& file) {
        const bool told = meniscus::is_csv(file);
        meniscus::Snapshot snapshot = meniscus::read_csv(file);
        meniscus::require(told, "what is read is told to be CSV");
        return snapshot;
    });
}
