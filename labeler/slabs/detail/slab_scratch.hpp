// The particles and labels of one slab, in files: records of 8-byte words, in the order of the
// state.
#pragma once

#include "slab_plan.hpp"

#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/data/text/scratch_file.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus {

/// Adds one value as a word.
template <class Value>
void add_word(Value value, std::string& bytes) {
    static_assert(sizeof value == 8);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// The word at a place, as that type.
template <class Value>
Value word_at(const char* bytes, std::size_t place) {
    Value value;
    static_assert(sizeof value == 8);
    std::memcpy(&value, bytes + 8 * place, sizeof value);
    return value;
}

/// Packs bytes for a slab among those for others, and takes them out again.
void append_part(std::size_t slab, std::string_view bytes, std::string& parts);
void visit_parts(std::string_view parts,
                 const std::function<void(std::size_t slab, std::string_view bytes)>& visit);

/// Writes valid particles of a block of rows as records: number, layer, position, and the values of
/// these arrays.
class RecordWriter {
public:
    RecordWriter(const Snapshot& rows, const std::vector<std::uint8_t>& valid,
                 const std::vector<std::string>& arrays);

    void add(std::size_t particle, std::int64_t layer, std::string& records) const;

private:
    const Snapshot& rows;
    std::vector<double> masses;
    std::vector<std::vector<std::int64_t>> whole; ///< phase and id, where asked for
};

class SlabScratch {
public:
    SlabScratch(const Slab& layers, std::size_t number, const std::vector<std::string>& arrays,
                const std::filesystem::path& folder);

    [[nodiscard]] std::size_t number() const { return place; }

    void append(std::string_view records) { particles.append(records.data(), records.size()); }

    /// The slab's particles and its halo, with their arrays.
    [[nodiscard]] Snapshot load(StatePart& part) const;

    /// Keeps the labels of the own particles.
    void store(const Labels& found, const StatePart& part);

private:
    friend class SlabLabels;

    Slab layers;
    std::size_t place;
    std::vector<std::string> arrays;
    ScratchFile particles;
    ScratchFile labels;
};

/// A slab's labels, taken in the order of the state.
class SlabLabels {
public:
    SlabLabels(const SlabScratch& slab, std::size_t features);

    /// Adds the records of all particles before this number that were not taken yet.
    void take(std::uint64_t end, std::string& records);

private:
    const ScratchFile* file;
    std::size_t record;     ///< bytes
    std::uint64_t read = 0; ///< bytes of the file
    std::string waiting;
    std::size_t taken = 0; ///< bytes of what waits
};

/// Labels of so many particles from `first` on; not valid where no record has them.
Labels labels_of_rows(const std::vector<std::string>& records, std::uint64_t first,
                      std::uint64_t count, std::size_t features);

} // namespace meniscus
