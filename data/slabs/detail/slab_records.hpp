// Particles on their way into slabs: records of 8-byte words.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus {

/// Number and position, before the values of arrays.
inline constexpr std::size_t record_words = 4;

/// Packs bytes for a slab among those for others, and takes them out again.
void append_part(std::size_t slab, std::string_view bytes, std::string& parts);
void visit_parts(std::string_view parts,
                 const std::function<void(std::size_t slab, std::string_view bytes)>& visit);

/// Writes valid particles of a block of rows as records: number, position, and the values of these
/// arrays: mass, phase or id. Throws InputError where such a value cannot be used.
class RecordWriter {
public:
    RecordWriter(const Snapshot& rows, const std::vector<std::uint8_t>& valid,
                 const std::vector<std::string>& arrays);

    void add(std::size_t particle, std::string& records) const;

private:
    const Snapshot& rows;
    std::vector<double> masses;
    std::vector<std::vector<std::int64_t>> whole; ///< phase and id, where asked for
};

std::array<double, 3> position_of(std::string_view record);

/// So many particles with these arrays, all 0.
Snapshot empty_slab(const std::vector<std::string>& arrays, std::size_t count);

/// Sets particle i of such a slab, and its number, from a record.
void read_record(const char* record, std::size_t i, Snapshot& slab, std::uint64_t& number);

} // namespace meniscus
