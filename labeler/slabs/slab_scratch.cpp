#include "detail/slab_scratch.hpp"

#include <meniscus/data/particles/particle_arrays.hpp>

#include <algorithm>

namespace meniscus {
namespace {

constexpr std::size_t position_words = 5; ///< number, layer and position
constexpr std::size_t label_words = 4;    ///< number, lambda, mass offset and count
constexpr std::size_t bytes_at_once = 1 << 20;

} // namespace

void append_part(std::size_t slab, std::string_view bytes, std::string& parts) {
    if (bytes.empty())
        return;
    add_word(static_cast<std::uint64_t>(slab), parts);
    add_word(static_cast<std::uint64_t>(bytes.size()), parts);
    parts.append(bytes);
}

void visit_parts(std::string_view parts,
                 const std::function<void(std::size_t, std::string_view)>& visit) {
    while (!parts.empty()) {
        const auto slab = word_at<std::uint64_t>(parts.data(), 0);
        const auto size = word_at<std::uint64_t>(parts.data(), 1);
        visit(slab, parts.substr(16, size));
        parts.remove_prefix(16 + size);
    }
}

RecordWriter::RecordWriter(const Snapshot& rows, const std::vector<std::uint8_t>& valid,
                           const std::vector<std::string>& arrays)
    : rows(rows) {
    for (const std::string& name : arrays)
        if (name == "mass")
            masses = scalar_values(rows, name);
        else
            whole.push_back(integer_values(rows, name, valid));
}

void RecordWriter::add(std::size_t particle, std::int64_t layer, std::string& records) const {
    add_word(rows.first_particle + particle, records);
    add_word(layer, records);
    for (const double coordinate : rows.positions[particle])
        add_word(coordinate, records);
    if (!masses.empty())
        add_word(masses[particle], records);
    for (const auto& values : whole)
        add_word(values[particle], records);
}

SlabScratch::SlabScratch(const Slab& layers, std::size_t number,
                         const std::vector<std::string>& arrays,
                         const std::filesystem::path& folder)
    : layers(layers), place(number), arrays(arrays), particles(folder), labels(folder) {}

Snapshot SlabScratch::load(StatePart& part) const {
    const std::size_t words = position_words + arrays.size();
    const std::size_t count = particles.size() / (8 * words);
    Snapshot slab;
    slab.positions.resize(count);
    part.numbers.resize(count);
    part.own.resize(count);
    for (const std::string& name : arrays)
        if (name == "mass")
            slab.point_data.push_back({name, 1, std::vector<double>(count)});
        else
            slab.point_data.push_back({name, 1, std::vector<std::int64_t>(count)});
    std::string block;
    const std::size_t at_once = bytes_at_once / (8 * words);
    for (std::size_t first = 0; first < count; first += at_once) {
        block.resize(std::min(at_once, count - first) * 8 * words);
        particles.read(first * 8 * words, block.data(), block.size());
        for (std::size_t i = first; i < std::min(first + at_once, count); ++i) {
            const char* record = block.data() + (i - first) * 8 * words;
            const auto layer = word_at<std::int64_t>(record, 1);
            part.numbers[i] = word_at<std::uint64_t>(record, 0);
            part.own[i] = layer >= layers.first && layer < layers.end ? 1 : 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                slab.positions[i][axis] = word_at<double>(record, 2 + axis);
            for (std::size_t a = 0; a < arrays.size(); ++a)
                std::visit(
                    [&](auto& values) {
                        using Value = typename std::decay_t<decltype(values)>::value_type;
                        if constexpr (sizeof(Value) == 8)
                            values[i] = word_at<Value>(record, position_words + a);
                    },
                    slab.point_data[a].values);
        }
    }
    return slab;
}

void SlabScratch::store(const Labels& found, const StatePart& part) {
    std::string records;
    for (std::size_t i = 0; i < part.own.size(); ++i) {
        if (part.own[i] == 0)
            continue;
        add_word(part.numbers[i], records);
        add_word(found.uncovered_fraction[i], records);
        add_word(found.mass_offset[i], records);
        add_word(found.neighbor_count[i], records);
        for (const auto& values : found.features)
            add_word(values[i], records);
        if (records.size() >= bytes_at_once) {
            labels.append(records.data(), records.size());
            records.clear();
        }
    }
    labels.append(records.data(), records.size());
}

SlabLabels::SlabLabels(const SlabScratch& slab, std::size_t features)
    : file(&slab.labels), record(8 * (label_words + features)) {}

void SlabLabels::take(std::uint64_t end, std::string& records) {
    while (taken < waiting.size() || read < file->size()) {
        if (taken == waiting.size()) {
            const std::uint64_t most = bytes_at_once / 16 / record * record;
            waiting.resize(std::min<std::uint64_t>(most, file->size() - read));
            file->read(read, waiting.data(), waiting.size());
            read += waiting.size();
            taken = 0;
        }
        if (word_at<std::uint64_t>(waiting.data() + taken, 0) >= end)
            return;
        records.append(waiting, taken, record);
        taken += record;
    }
}

Labels labels_of_rows(const std::vector<std::string>& records, std::uint64_t first,
                      std::uint64_t count, std::size_t features) {
    Labels found;
    found.uncovered_fraction.resize(count);
    found.mass_offset.resize(count);
    found.neighbor_count.resize(count);
    found.valid.resize(count);
    found.features.assign(features, std::vector<double>(count));
    const std::size_t words = label_words + features;
    for (const std::string& some : records)
        for (std::size_t at = 0; at < some.size(); at += 8 * words) {
            const char* record = some.data() + at;
            const std::size_t i = word_at<std::uint64_t>(record, 0) - first;
            found.valid[i] = 1;
            found.uncovered_fraction[i] = word_at<double>(record, 1);
            found.mass_offset[i] = word_at<double>(record, 2);
            found.neighbor_count[i] = word_at<double>(record, 3);
            for (std::size_t f = 0; f < features; ++f)
                found.features[f][i] = word_at<double>(record, label_words + f);
        }
    return found;
}

} // namespace meniscus
