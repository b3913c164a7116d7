#include "packed_datasets.hpp"

#include <meniscus/data/ranks/packing.hpp>

#include <algorithm>

namespace meniscus {
namespace {

/// Bytes that are sent at a time, about.
constexpr std::size_t max_message = std::size_t{4} << 20;

/// A chunk on its way to the first rank.
struct SentChunk {
    std::string dataset;
    std::uint64_t chunk = 0;
    std::string packed;
};

template <class Pack>
void carry(Pack& pack, SentChunk& sent) {
    carry(pack, sent.dataset);
    pack.number(sent.chunk);
    carry(pack, sent.packed);
}

} // namespace

void PackedDatasets::add(const std::string& dataset, std::uint64_t chunk,
                         const std::string& packed) {
    places[dataset][chunk] = {bytes.size(), packed.size()};
    bytes.append(packed.data(), packed.size());
}

std::string PackedDatasets::chunk(const std::string& dataset, std::uint64_t chunk) const {
    const Place& place = places.at(dataset).at(chunk);
    std::string packed(place.size, '\0');
    bytes.read(place.first, packed.data(), packed.size());
    return packed;
}

void PackedDatasets::gather_on_first(Ranks& ranks) {
    std::vector<std::pair<std::string, std::uint64_t>> waiting;
    for (const auto& [dataset, chunks] : places)
        for (const auto& [chunk, place] : chunks)
            waiting.emplace_back(dataset, chunk);
    for (int sender = 1; sender < ranks.size(); ++sender) {
        auto next = ranks.rank() == sender ? waiting.begin() : waiting.end();
        // The others learn from an empty message that there is no more.
        for (bool is_over = false; !is_over;) {
            std::vector<std::string> for_rank(static_cast<std::size_t>(ranks.size()));
            do_together(ranks, [&] {
                Packer packer;
                for (; next != waiting.end() && packer.bytes.size() < max_message; ++next) {
                    SentChunk one{next->first, next->second, chunk(next->first, next->second)};
                    carry(packer, one);
                }
                for_rank[0] = std::move(packer.bytes);
            });
            std::vector<std::uint64_t> size = {for_rank[0].size()};
            ranks.sum(size);
            is_over = size[0] == 0;
            sent += for_rank[0].size();
            const auto received = ranks.exchange(std::move(for_rank));
            do_together(ranks, [&] {
                if (ranks.rank() > 0)
                    return;
                Unpacker unpacker(received[static_cast<std::size_t>(sender)]);
                while (!unpacker.is_empty()) {
                    SentChunk one;
                    carry(unpacker, one);
                    add(one.dataset, one.chunk, one.packed);
                }
            });
        }
    }
}

} // namespace meniscus
