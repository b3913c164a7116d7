// Stanford's PLY: the element `vertex` with x, y and z is the particles, its other properties of
// one number are point data. Text or bytes of either order. Faces would make it a mesh.
#include "snapshot_formats.hpp"

#include "detail/number_blocks.hpp"
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

enum class Encoding { text, little_endian, big_endian };

struct Property {
    std::string name;
    NumberType type;
};

struct Header {
    Encoding encoding = Encoding::text;
    std::uint64_t vertices = 0;
    std::vector<Property> properties; ///< of a vertex
};

[[noreturn]] void fail(const fs::path& file, const std::string& where, const std::string& expected,
                       const std::string& found) {
    throw InputError(file.string() + ": " + where + ": expected " + expected + ", found " + found);
}

struct TypeName {
    std::string_view name;
    NumberType type;
};

constexpr TypeName type_names[] = {
    {"char", NumberType::int8},      {"int8", NumberType::int8},
    {"uchar", NumberType::uint8},    {"uint8", NumberType::uint8},
    {"short", NumberType::int16},    {"int16", NumberType::int16},
    {"ushort", NumberType::uint16},  {"uint16", NumberType::uint16},
    {"int", NumberType::int32},      {"int32", NumberType::int32},
    {"uint", NumberType::uint32},    {"uint32", NumberType::uint32},
    {"float", NumberType::float32},  {"float32", NumberType::float32},
    {"double", NumberType::float64}, {"float64", NumberType::float64},
};

NumberType type_of(const fs::path& file, std::string_view name) {
    const auto* type = std::find_if(std::begin(type_names), std::end(type_names),
                                    [&](const TypeName& known) { return known.name == name; });
    if (type == std::end(type_names))
        fail(file, "header", "properties of a vertex that are numbers, such as 'float x'",
             quoted_text(name));
    return type->type;
}

std::string_view take_line(std::string_view& rest) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (!line.empty() && line.back() == '\r')
        line.remove_suffix(1);
    return line;
}

Encoding encoding_of(const fs::path& file, std::string_view name) {
    if (name == "ascii")
        return Encoding::text;
    if (name == "binary_little_endian")
        return Encoding::little_endian;
    if (name != "binary_big_endian")
        fail(file, "header", "format ascii, binary_little_endian or binary_big_endian",
             quoted_text(name));
    return Encoding::big_endian;
}

/// The element that follows the vertices says nothing of particles, unless it is a face.
Header take_header(const fs::path& file, std::string_view& rest) {
    Header header;
    std::string element;
    take_line(rest); // "ply"
    for (;;) {
        if (rest.empty())
            fail(file, "header", "end_header", "the end of the file; export it again");
        std::string_view line = take_line(rest);
        const std::string_view word = take_word(line);
        if (word == "end_header")
            return header;
        if (word == "format") {
            header.encoding = encoding_of(file, take_word(line));
        } else if (word == "element") {
            if (element.empty() && line.substr(0, 7) != " vertex")
                fail(file, "header", "vertices as the first element", quoted_text(line));
            element = take_word(line);
            std::uint64_t count = 0;
            if (read_number(take_word(line), count) != std::errc())
                fail(file, "header", "a count of element " + quoted_text(element), "none");
            if (element == "vertex")
                header.vertices = count;
            else if (count > 0 && element == "face")
                fail(file, "element face", "points alone", "faces; a mesh is no snapshot");
        } else if (word == "property" && element == "vertex") {
            const NumberType type = type_of(file, take_word(line));
            header.properties.push_back({std::string(take_word(line)), type});
        }
    }
}

void check_properties(const fs::path& file, const Header& header) {
    std::vector<std::string> names;
    for (const Property& property : header.properties)
        names.push_back(property.name);
    for (const char* axis : {"x", "y"})
        if (std::find(names.begin(), names.end(), axis) == names.end())
            fail(file, "element vertex", std::string("a property ") + axis, "none");
    if (const auto repeated = repeated_name(names))
        fail(file, "element vertex", "every property once", quoted_text(*repeated) + " twice");
}

std::vector<ArrayValues> read_rows(const fs::path& file, const Header& header,
                                   std::string_view rest) {
    std::vector<ArrayValues> columns;
    std::uint64_t row_bytes = 0;
    for (const Property& property : header.properties) {
        columns.push_back(values_of(property.type));
        row_bytes += header.encoding == Encoding::text ? 2 : size_of(property.type);
    }
    if (header.vertices > (rest.size() + 1) / row_bytes)
        fail(file, "element vertex", std::to_string(header.vertices) + " vertices",
             "fewer bytes; it is truncated or damaged, export it again");
    for (std::uint64_t i = 0; i < header.vertices; ++i) {
        for (std::size_t column = 0; column < columns.size(); ++column) {
            if (header.encoding != Encoding::text) {
                append_stored(columns[column], rest.data(),
                              header.encoding == Encoding::big_endian);
                rest.remove_prefix(size_of(header.properties[column].type));
                continue;
            }
            const std::string_view word = take_word(rest);
            if (!append_word(columns[column], word))
                fail(file, "vertex " + std::to_string(i),
                     "a number for " + quoted_text(header.properties[column].name),
                     word.empty() ? "the end of the file; export it again" : quoted_text(word));
        }
    }
    return columns;
}

Snapshot snapshot_of(const Header& header, std::vector<ArrayValues> columns) {
    Snapshot snapshot;
    snapshot.positions.resize(header.vertices);
    bool has_z = false;
    snapshot.position_precision = Precision::float32;
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const std::string& name = header.properties[column].name;
        const std::size_t axis = name.size() == 1 ? std::string_view("xyz").find(name) : 3;
        if (axis > 2) {
            snapshot.point_data.push_back({name, 1, std::move(columns[column])});
            continue;
        }
        has_z = has_z || axis == 2;
        if (header.properties[column].type != NumberType::float32)
            snapshot.position_precision = Precision::float64;
        const std::vector<double> values = as_doubles({name, 1, std::move(columns[column])});
        for (std::size_t i = 0; i < values.size(); ++i)
            snapshot.positions[i][axis] = values[i];
    }
    snapshot.dimension_is_stated = !has_z;
    snapshot.dimension = has_z ? dimension_of(snapshot.positions) : 2;
    return snapshot;
}

bool is_ply(const fs::path& file) {
    const std::string begin = read_whole(file, 5);
    return begin == "ply\n" || begin.rfind("ply\n", 0) == 0 || begin.rfind("ply\r\n", 0) == 0;
}

/// Throws InputError on anything that is not well formed; memory is bounded by the file's own size.
Snapshot read_ply(const fs::path& file, const ReadChoices& /*choices*/) {
    const std::string bytes = read_whole(file);
    std::string_view rest = bytes;
    const Header header = take_header(file, rest);
    check_properties(file, header);
    return snapshot_of(header, read_rows(file, header, rest));
}

} // namespace

SnapshotFormat ply_format() {
    return {"PLY", is_ply, read_ply};
}

} // namespace meniscus
