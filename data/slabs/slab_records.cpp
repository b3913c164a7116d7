#include "detail/slab_records.hpp"

#include <meniscus/data/particles/particle_arrays.hpp>

#include <cstring>
#include <variant>

namespace meniscus {
namespace {

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

} // namespace

void append_part(std::size_t slab, std::string_view bytes, std::string& parts) {
    if (bytes.empty())
        return;
    add_word(std::uint64_t{slab}, parts);
    add_word(std::uint64_t{bytes.size()}, parts);
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
            masses = checked_masses(rows, valid);
        else
            whole.push_back(integer_values(rows, name, valid));
}

void RecordWriter::add(std::size_t particle, std::string& records) const {
    add_word(rows.first_particle + particle, records);
    for (const double coordinate : rows.positions[particle])
        add_word(coordinate, records);
    if (!masses.empty())
        add_word(masses[particle], records);
    for (const auto& values : whole)
        add_word(values[particle], records);
}

std::array<double, 3> position_of(std::string_view record) {
    return {word_at<double>(record.data(), 1), word_at<double>(record.data(), 2),
            word_at<double>(record.data(), 3)};
}

Snapshot empty_slab(const std::vector<std::string>& arrays, std::size_t count) {
    Snapshot slab;
    slab.positions.resize(count);
    for (const std::string& name : arrays)
        if (name == "mass")
            slab.point_data.push_back({name, 1, std::vector<double>(count)});
        else
            slab.point_data.push_back({name, 1, std::vector<std::int64_t>(count)});
    return slab;
}

void read_record(const char* record, std::size_t i, Snapshot& slab, std::uint64_t& number) {
    number = word_at<std::uint64_t>(record, 0);
    for (std::size_t axis = 0; axis < 3; ++axis)
        slab.positions[i][axis] = word_at<double>(record, 1 + axis);
    for (std::size_t a = 0; a < slab.point_data.size(); ++a) {
        ArrayValues& values = slab.point_data[a].values;
        if (auto* masses = std::get_if<std::vector<double>>(&values))
            (*masses)[i] = word_at<double>(record, record_words + a);
        else
            std::get<std::vector<std::int64_t>>(values)[i] =
                word_at<std::int64_t>(record, record_words + a);
    }
}

} // namespace meniscus
