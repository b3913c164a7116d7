// The large datasets of a file that is to be written, compressed chunk by chunk, in a file without
// a name: several ranks make them, and the first, which writes, puts them in their places.
#pragma once

#include <meniscus/data/ranks/ranks.hpp>
#include <meniscus/data/text/scratch_file.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace meniscus {

class PackedDatasets {
public:
    /// None yet. Throws as ScratchFile does, and so does what follows.
    explicit PackedDatasets(const std::filesystem::path& scratch) : bytes(scratch) {}

    /// Adds a chunk of the dataset with that path.
    void add(const std::string& dataset, std::uint64_t chunk, const std::string& packed);

    [[nodiscard]] bool has(const std::string& dataset) const { return places.count(dataset) > 0; }

    /// A chunk that was added.
    [[nodiscard]] std::string chunk(const std::string& dataset, std::uint64_t chunk) const;

    /// Adds to those of the first rank those of all others, one after the other. Collective; throws
    /// on all ranks alike.
    void gather_on_first(Ranks& ranks);

    [[nodiscard]] std::uint64_t bytes_sent() const { return sent; }

private:
    struct Place {
        std::uint64_t first = 0; ///< byte
        std::uint64_t size = 0;
    };

    ScratchFile bytes;
    std::uint64_t sent = 0;
    std::map<std::string, std::map<std::uint64_t, Place>> places;
};

} // namespace meniscus
