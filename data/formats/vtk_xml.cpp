// VTK's XML files (`.vtu`, `.vtp`): UnstructuredGrid of vertex cells, and PolyData of vertices or
// mere points, in one piece or several. Numbers are text, base64, or appended behind all else in
// base64 or as they are; compressed by zlib or not.
#include "snapshot_formats.hpp"

#include "detail/number_blocks.hpp"
#include "detail/xml_tags.hpp"
#include <meniscus/data/hdf5/deflate.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

struct Source {
    fs::path file;
    std::string_view bytes;
    std::string kind; ///< UnstructuredGrid or PolyData
    bool big_endian = false;
    std::size_t header_bytes = 4; ///< of each number in front of a block
    bool compressed = false;
    bool appended_is_raw = false;
    std::string_view appended; ///< what is behind the underscore
    std::uint64_t room = 0;    ///< bytes that the file's own can still stand for
};

[[noreturn]] void fail(const Source& source, const std::string& where, const std::string& expected,
                       const std::string& found) {
    throw InputError(source.file.string() + ": " + where + ": expected " + expected + ", found " +
                     found);
}

constexpr const char* damaged = "fewer bytes; it is truncated or damaged, export it again";

/// Bytes as they are, or out of base64, of which several pieces may follow each other.
class Stream {
public:
    Stream(const Source& source, std::string where, std::string_view text, bool is_raw)
        : source(source), where(std::move(where)), rest(text), is_raw(is_raw) {}

    std::string take(std::uint64_t size) {
        if (size > rest.size() + ready.size())
            fail(source, where, std::to_string(size) + " bytes", damaged);
        if (is_raw) {
            std::string taken(rest.substr(0, size));
            rest.remove_prefix(size);
            return taken;
        }
        while (ready.size() < size && take_group()) {
        }
        if (ready.size() < size)
            fail(source, where, std::to_string(size) + " bytes", damaged);
        std::string taken = ready.substr(0, size);
        ready.erase(0, size);
        return taken;
    }

private:
    bool take_group() {
        std::uint32_t bits = 0;
        int digits = 0;
        int padding = 0;
        for (; digits < 4 && !rest.empty(); rest.remove_prefix(1)) {
            const char c = rest.front();
            if (std::string_view(" \t\r\n").find(c) != std::string_view::npos)
                continue;
            constexpr std::string_view alphabet =
                "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
            const std::size_t value = c == '=' ? 0 : alphabet.find(c);
            if (value == std::string_view::npos)
                return false;
            bits = bits * 64 + static_cast<std::uint32_t>(value);
            padding += c == '=' ? 1 : 0;
            ++digits;
        }
        for (int byte = 0; digits == 4 && byte < 3 - padding; ++byte)
            ready += static_cast<char>(bits >> (16 - 8 * byte));
        return digits == 4;
    }

    const Source& source;
    std::string where;
    std::string_view rest;
    std::string ready;
    bool is_raw;
};

std::uint64_t take_header_number(const Source& source, Stream& stream) {
    const std::string stored = stream.take(source.header_bytes);
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < stored.size(); ++i) {
        const std::size_t at = source.big_endian ? i : stored.size() - 1 - i;
        number = number * 256 + static_cast<unsigned char>(stored[at]);
    }
    return number;
}

std::string inflated(const Source& source, const std::string& where, const std::string& stored,
                     std::uint64_t size) {
    std::string block(size, '\0');
    uLongf made = block.size();
    if (uncompress(reinterpret_cast<Bytef*>(block.data()), &made,
                   reinterpret_cast<const Bytef*>(stored.data()), stored.size()) != Z_OK ||
        made != size)
        fail(source, where, "compressed numbers", "damaged ones; export the file again");
    return block;
}

/// Blocks of one size, the last of another, each compressed by itself.
std::string take_compressed(const Source& source, const std::string& where, Stream& stream,
                            std::uint64_t expected) {
    const std::uint64_t blocks = take_header_number(source, stream);
    const std::uint64_t block_size = take_header_number(source, stream);
    const std::uint64_t last_size = take_header_number(source, stream);
    if (blocks > source.bytes.size() || block_size > expected + (std::uint64_t{1} << 26) ||
        last_size > block_size)
        fail(source, where, "blocks that the file can hold", "more; it is damaged");
    std::vector<std::uint64_t> sizes;
    for (std::uint64_t block = 0; block < blocks; ++block)
        sizes.push_back(take_header_number(source, stream));
    std::string all;
    for (std::uint64_t block = 0; block < blocks; ++block) {
        const bool is_last = block + 1 == blocks && last_size > 0;
        const std::uint64_t size = is_last ? last_size : block_size;
        if (all.size() + size > expected)
            fail(source, where, std::to_string(expected) + " bytes of numbers", "more");
        all += inflated(source, where, stream.take(sizes[block]), size);
    }
    return all;
}

struct TypeName {
    std::string_view name;
    NumberType type;
};

constexpr TypeName type_names[] = {
    {"Int8", NumberType::int8},       {"UInt8", NumberType::uint8},
    {"Int16", NumberType::int16},     {"UInt16", NumberType::uint16},
    {"Int32", NumberType::int32},     {"UInt32", NumberType::uint32},
    {"Int64", NumberType::int64},     {"UInt64", NumberType::uint64},
    {"Float32", NumberType::float32}, {"Float64", NumberType::float64},
};

NumberType type_of(const Source& source, const std::string& where, const xml::Tag& tag) {
    const std::string name = xml::attribute(tag, "type");
    const auto* type = std::find_if(std::begin(type_names), std::end(type_names),
                                    [&](const TypeName& known) { return known.name == name; });
    if (type == std::end(type_names))
        fail(source, where, "a type such as Float64", quoted_text(name));
    return type->type;
}

std::uint64_t count_attribute(const Source& source, const xml::Tag& tag, const std::string& name,
                              std::uint64_t otherwise) {
    const std::string text = xml::attribute(tag, name);
    std::uint64_t count = otherwise;
    if (!text.empty() && read_number(text, count) != std::errc())
        fail(source, tag.name + " " + name, "a count", quoted_text(text));
    return count;
}

ArrayValues parsed(const Source& source, const std::string& where, std::string_view text,
                   NumberType type, std::uint64_t count) {
    ArrayValues values = values_of(type);
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::string_view word = take_word(text);
        if (!append_word(values, word)) {
            fail(source, where,
                 "a number at index " + std::to_string(i) + " of " + std::to_string(count),
                 word.empty() ? "the end of the array; export the file again" : quoted_text(word));
        }
    }
    return values;
}

/// `count` numbers of a DataArray whose own text is given.
ArrayValues read_values(Source& source, const xml::Tag& tag, std::string_view text,
                        std::uint64_t count) {
    const std::string where = "DataArray " + quoted_text(xml::attribute(tag, "Name"));
    const NumberType type = type_of(source, where, tag);
    const std::string format = xml::attribute(tag, "format");
    if (count > source.room / size_of(type))
        fail(source, where, std::to_string(count) + " values", damaged);
    const std::uint64_t size = count * size_of(type);
    source.room -= size;
    if (format == "ascii")
        return parsed(source, where, text, type, count);
    const bool is_appended = format == "appended";
    if (!is_appended && format != "binary")
        fail(source, where, "format ascii, binary or appended", quoted_text(format));
    const std::uint64_t offset = count_attribute(source, tag, "offset", 0);
    if (is_appended && offset > source.appended.size())
        fail(source, where, "bytes at offset " + std::to_string(offset), damaged);
    Stream stream(source, where, is_appended ? source.appended.substr(offset) : text,
                  is_appended && source.appended_is_raw);
    const std::string block = source.compressed
                                  ? take_compressed(source, where, stream, size)
                                  : stream.take(std::min(take_header_number(source, stream), size));
    if (block.size() != size)
        fail(source, where, std::to_string(size) + " bytes", std::to_string(block.size()));
    return decoded(type, block, source.big_endian);
}

/// What a piece says of itself.
struct Piece {
    std::uint64_t points = 0;
    std::uint64_t cells = 0;
    bool has_points = false;
};

void append_values(ArrayValues& values, const ArrayValues& more) {
    std::visit(
        [&](auto& numbers) {
            const auto& added = std::get<std::decay_t<decltype(numbers)>>(more);
            numbers.insert(numbers.end(), added.begin(), added.end());
        },
        values);
}

/// Adds a piece's array to that of the pieces before.
void add_point_data(const Source& source, Snapshot& snapshot, PointArray array,
                    std::uint64_t points_before) {
    auto& arrays = snapshot.point_data;
    const auto same = std::find_if(arrays.begin(), arrays.end(), [&](const PointArray& other) {
        return other.name == array.name;
    });
    const auto components = static_cast<std::size_t>(array.components);
    if (same == arrays.end() && points_before == 0) {
        arrays.push_back(std::move(array));
    } else if (same != arrays.end() && same->components == array.components &&
               same->values.index() == array.values.index() &&
               count_of(same->values) == points_before * components) {
        append_values(same->values, array.values);
    } else {
        fail(source, "PointData", "each array once in every piece, of one type",
             quoted_text(array.name) + " otherwise");
    }
}

void check_types(const Source& source, const ArrayValues& types) {
    for (const double type : as_doubles({"types", 1, types}))
        if (type != 1 && type != 2)
            fail(source, "Cells", "particles (vertex cells, type 1)",
                 "cell type " + rounded_text(type, 3) + "; a mesh is no snapshot");
}

Piece piece_of(const Source& source, const xml::Tag& tag) {
    for (const char* mesh : {"NumberOfLines", "NumberOfStrips", "NumberOfPolys"})
        if (count_attribute(source, tag, mesh, 0) > 0)
            fail(source, "Piece", "points and vertices",
                 std::string(mesh) + " = " + xml::attribute(tag, mesh) + "; a mesh is no snapshot");
    return {count_attribute(source, tag, "NumberOfPoints", 0),
            count_attribute(source, tag, "NumberOfCells", 0)};
}

/// One array of the section that it is in.
void read_array(Source& source, const xml::Tag& tag, std::string_view text,
                const std::string& section, Piece& piece, Snapshot& snapshot) {
    const std::string name = xml::attribute(tag, "Name");
    const std::uint64_t components = count_attribute(source, tag, "NumberOfComponents", 1);
    if (section == "PointData" && tag.name == "Array") {
        snapshot.notes.push_back("point data " + quoted_text(name) + " is text and left out");
    } else if (section == "PointData") {
        if (components < 1 || components > 1'000'000 || piece.points > source.room / components)
            fail(source, "DataArray " + quoted_text(name), "values that the file can hold",
                 std::to_string(components) + " components");
        add_point_data(source, snapshot,
                       {name, static_cast<int>(components),
                        read_values(source, tag, text, piece.points * components)},
                       snapshot.size() - (piece.has_points ? piece.points : 0));
    } else if (section == "Points" && !piece.has_points) {
        if (components != 3 || piece.points > source.room / 3)
            fail(source, "Points", "3 components", std::to_string(components));
        set_positions(snapshot, read_values(source, tag, text, piece.points * 3), 3);
        piece.has_points = true;
    } else if (section == "Cells" && name == "types") {
        check_types(source, read_values(source, tag, text, piece.cells));
    } else if (section == "FieldData" && lowered(name) == "timevalue" && tag.name != "Array") {
        const auto time = as_doubles({name, 1, read_values(source, tag, text, 1)});
        if (std::isfinite(time[0]))
            snapshot.time = time[0];
    }
}

/// The text of an element, without that of those in it.
std::string own_text(std::string_view& rest, const xml::Tag& element) {
    std::string text(element.text_after);
    for (int depth = element.is_whole ? 0 : 1; depth > 0;) {
        const auto tag = xml::take_tag(rest);
        if (!tag)
            break;
        if (!tag->is_whole)
            depth += tag->name.front() == '/' ? -1 : 1;
        if (depth == 1)
            text += tag->text_after;
    }
    return text;
}

void check_piece(const Source& source, const Piece& piece) {
    if (piece.points > 0 && !piece.has_points)
        fail(source, "Points", std::to_string(piece.points) + " points", "none");
}

void read_elements(Source& source, std::string_view rest, Snapshot& snapshot) {
    Piece piece;
    std::string section;
    while (const auto tag = xml::take_tag(rest)) {
        const std::string& name = tag->name;
        if (name == "AppendedData" || name == "/VTKFile")
            break;
        if (name == "Piece") {
            piece = piece_of(source, *tag);
        } else if (name == "/Piece") {
            check_piece(source, piece);
        } else if (name == "DataArray" || name == "Array") {
            const std::string text = own_text(rest, *tag);
            read_array(source, *tag, text, section, piece, snapshot);
        } else {
            section = tag->is_whole || name.front() == '/' ? "" : name;
        }
    }
    for (const PointArray& array : snapshot.point_data)
        if (count_of(array.values) != snapshot.size() * static_cast<std::size_t>(array.components))
            fail(source, "PointData",
                 "values for all " + std::to_string(snapshot.size()) + " points",
                 quoted_text(array.name) + " of other length");
}

/// What the file's first element and the appended data say.
void read_preamble(Source& source, std::string_view rest) {
    const auto tag = xml::take_tag(rest);
    if (!tag || tag->name != "VTKFile")
        fail(source, "header", "<VTKFile ...>", "something else");
    source.kind = xml::attribute(*tag, "type");
    if (source.kind != "UnstructuredGrid" && source.kind != "PolyData") {
        const bool is_index =
            !source.kind.empty() && (source.kind.front() == 'P' || source.kind == "Collection" ||
                                     source.kind.rfind("vtk", 0) == 0);
        fail(source, "VTKFile type", "UnstructuredGrid or PolyData",
             quoted_text(source.kind) + (is_index ? ", which names other files; give those"
                                                  : "; export particles as one of these"));
    }
    source.big_endian = xml::attribute(*tag, "byte_order") == "BigEndian";
    source.header_bytes = xml::attribute(*tag, "header_type") == "UInt64" ? 8 : 4;
    const std::string compressor = xml::attribute(*tag, "compressor");
    source.compressed = !compressor.empty();
    if (source.compressed && compressor != "vtkZLibDataCompressor")
        fail(source, "VTKFile compressor", "vtkZLibDataCompressor or none",
             quoted_text(compressor) + "; export with zlib or without compression");
    const std::size_t begin = source.bytes.find("<AppendedData");
    if (begin == std::string_view::npos)
        return;
    std::string_view behind = source.bytes.substr(begin);
    const auto appended = xml::take_tag(behind);
    const std::size_t mark = behind.find('_');
    if (appended && mark != std::string_view::npos) {
        source.appended_is_raw = xml::attribute(*appended, "encoding") == "raw";
        source.appended = behind.substr(mark + 1);
    }
}

/// True where an element VTKFile comes first.
bool is_vtk_xml(const fs::path& file) {
    const std::string begin = read_whole(file, 1024);
    std::string_view rest = begin;
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n\xef\xbb\xbf"), rest.size()));
    return !rest.empty() && rest.front() == '<' && rest.find("<VTKFile") != std::string_view::npos;
}

/// Throws InputError, naming the array, on anything that is not well formed. Memory is bounded by
/// what the file's bytes can hold.
Snapshot read_vtk_xml(const fs::path& file, const ReadChoices& /*choices*/) {
    const std::string bytes = read_whole(file);
    Source source;
    source.file = file;
    source.bytes = bytes;
    source.room = max_compression * bytes.size();
    read_preamble(source, bytes);
    if (source.bytes.find("</VTKFile>") == std::string_view::npos)
        fail(source, "end", "</VTKFile>", "none; it is truncated, export it again");
    Snapshot snapshot;
    read_elements(source, bytes, snapshot);
    return snapshot;
}

} // namespace

SnapshotFormat vtk_xml_format() {
    return {"VTK XML (.vtu, .vtp)", is_vtk_xml, read_vtk_xml};
}

} // namespace meniscus
