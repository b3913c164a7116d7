// Houdini's classic binary geometry (`.bgeo`, version 5) as the Partio library writes it for
// particles, which is how SPlisHSPlasH's Partio exporter stores a state: points with attributes and
// nothing else but perhaps one particle primitive around them, gzip-compressed or not.
#include "snapshot_formats.hpp"

#include <meniscus/data/hdf5/deflate.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <string>
#include <string_view>
#include <utility>

namespace meniscus {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "BgeoV";
constexpr std::string_view end_mark("\x00\xff", 2);

// Houdini's own attributes are tens at most; each may cost more memory than it has bytes.
constexpr std::uint32_t max_attributes = 1000;

// The numbers that the format has for types of attributes. There are texts too (2), which Partio
// does not write.
constexpr std::uint32_t float_type = 0;
constexpr std::uint32_t integer_type = 1;
constexpr std::uint32_t index_type = 4;
constexpr std::uint32_t vector_type = 5;

constexpr std::uint32_t particle_primitive = 0x8000;
constexpr std::uint64_t max_short_index = 1 << 16; // points up to which an index has two bytes

/// The file's bytes one after another, decompressed as they are asked for.
class Stream {
public:
    explicit Stream(std::string_view stored) : rest(stored) {
        compressed = stored.substr(0, 2) == "\x1f\x8b";
        constexpr int gzip_only = 16;
        if (compressed && inflateInit2(&inflater, MAX_WBITS + gzip_only) != Z_OK)
            throw std::bad_alloc();
    }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
    ~Stream() {
        if (compressed)
            inflateEnd(&inflater);
    }

    /// Fills `to` with the next bytes; returns how many there were.
    std::size_t read(char* to, std::size_t size) {
        std::size_t made = 0;
        while (made < size && (!ready.empty() || refill())) {
            const std::size_t taken = ready.copy(to + made, size - made);
            ready.remove_prefix(taken);
            made += taken;
        }
        return made;
    }

    /// More bytes than this cannot come.
    [[nodiscard]] std::uint64_t max_left() const {
        const std::uint64_t within_inflater = compressed ? 1 << 13 : 0; // codes and one copy
        return ready.size() + within_inflater + rest.size() * max_compression;
    }

    /// Whether everything was read, and compression ended well with its checksum.
    bool ends_here() { return ready.empty() && !refill() && rest.empty() && ended; }

private:
    /// Makes some more bytes ready, if there are any.
    bool refill() {
        if (!compressed) {
            ready = std::exchange(rest, {});
            ended = true;
            return !ready.empty();
        }
        constexpr std::size_t most_at_once = 1 << 30; // zlib counts in unsigned int
        inflater.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest.data()));
        inflater.avail_in = static_cast<uInt>(std::min(rest.size(), most_at_once));
        inflater.next_out = reinterpret_cast<Bytef*>(inflated.data());
        inflater.avail_out = static_cast<uInt>(inflated.size());
        const uInt available = inflater.avail_in;
        // Damage, and an end that is missing, leave it not ended.
        if (!ended && inflate(&inflater, Z_NO_FLUSH) == Z_STREAM_END)
            ended = true;
        rest.remove_prefix(available - inflater.avail_in);
        ready = std::string_view(inflated).substr(0, inflated.size() - inflater.avail_out);
        return !ready.empty();
    }

    std::string_view rest;                             ///< of the file
    std::string_view ready;                            ///< of it, or of what was inflated
    std::string inflated = std::string(1 << 16, '\0'); ///< room for some of it
    z_stream inflater = {};
    bool compressed = false;
    bool ended = false;
};

/// A file that is being read.
struct Source {
    fs::path file;
    Stream stream;
    std::uint64_t particles = 0; ///< as the header claims, 0 before
};

struct Attribute {
    std::string name;
    std::size_t components = 0; ///< each of four bytes
    bool is_whole = false;      ///< int32, else float
};

[[noreturn]] void fail(const Source& source, const std::string& section,
                       const std::string& expected, const std::string& found) {
    std::string message = section + " (" + std::to_string(source.particles) +
                          " particles): expected " + expected + ", found " + found;
    // Names of the file may be made of any bytes.
    std::replace_if(
        message.begin(), message.end(), [](unsigned char c) { return c < 32 || c == 127; }, '?');
    throw InputError(source.file.string() + ": section " + message);
}

void take(Source& source, const std::string& section, char* to, std::size_t size) {
    if (source.stream.read(to, size) < size) {
        fail(source, section, std::to_string(size) + " more bytes",
             "the end of the file or damaged compression; export it again");
    }
}

// Numbers are stored big endian; the machines that this is built for are little endian.
template <class Number>
Number decoded(const char* stored) {
    char bytes[sizeof(Number)];
    std::reverse_copy(stored, stored + sizeof(Number), bytes);
    Number number;
    std::memcpy(&number, bytes, sizeof(Number));
    return number;
}

template <class Number>
Number take_number(Source& source, const std::string& section) {
    char bytes[sizeof(Number)];
    take(source, section, bytes, sizeof bytes);
    return decoded<Number>(bytes);
}

std::string take_text(Source& source, const std::string& section) {
    std::string text(take_number<std::uint16_t>(source, section), '\0');
    take(source, section, text.data(), text.size());
    return text;
}

/// Skips bytes that may be more than memory should hold.
void skip(Source& source, const std::string& section, std::uint64_t size) {
    char ignored[1024];
    for (; size > 0; size -= std::min<std::uint64_t>(size, sizeof ignored))
        take(source, section, ignored, std::min<std::uint64_t>(size, sizeof ignored));
}

/// What the header says; the counts in their order.
struct Header {
    std::uint32_t version = 0;
    std::uint32_t points = 0;
    std::uint32_t primitives = 0;
    std::uint32_t point_groups = 0;
    std::uint32_t primitive_groups = 0;
    std::uint32_t point_attributes = 0;
    std::uint32_t vertex_attributes = 0;
    std::uint32_t primitive_attributes = 0;
    std::uint32_t detail_attributes = 0;
};

Header take_header(Source& source) {
    char begin[magic.size()];
    take(source, "header", begin, sizeof begin);
    if (std::string_view(begin, sizeof begin) != magic)
        fail(source, "header", "'" + std::string(magic) + "'", "something else");
    Header header;
    for (std::uint32_t* number :
         {&header.version, &header.points, &header.primitives, &header.point_groups,
          &header.primitive_groups, &header.point_attributes, &header.vertex_attributes,
          &header.primitive_attributes, &header.detail_attributes})
        *number = take_number<std::uint32_t>(source, "header");
    if (header.version != 5)
        fail(source, "header", "version 5", std::to_string(header.version));
    for (const std::uint32_t count :
         {header.point_groups, header.primitive_groups, header.vertex_attributes,
          header.primitive_attributes, header.primitives > 1 ? header.primitives : 0}) {
        if (count != 0) {
            fail(source, "header", "points alone or one particle primitive, as Partio writes them",
                 std::to_string(count) + " primitives, groups or their attributes");
        }
    }
    if (header.point_attributes > max_attributes || header.detail_attributes > max_attributes) {
        fail(source, "header", "at most " + std::to_string(max_attributes) + " attributes",
             std::to_string(std::max(header.point_attributes, header.detail_attributes)));
    }
    return header;
}

/// The type and what belongs to it: default values, or the table of an index.
void take_type(Source& source, const std::string& section, Attribute& attribute) {
    const auto type = take_number<std::uint32_t>(source, section);
    attribute.is_whole = type == integer_type || type == index_type;
    if (type == index_type) {
        const auto texts = take_number<std::uint32_t>(source, section);
        if (texts > source.stream.max_left() / 2) { // each has a length of two bytes at least
            fail(source, section, std::to_string(texts) + " texts",
                 "fewer bytes in the file; it is truncated or damaged, export it again");
        }
        for (std::uint32_t i = 0; i < texts; ++i)
            skip(source, section, take_number<std::uint16_t>(source, section));
    } else if (type == float_type || type == integer_type || type == vector_type) {
        skip(source, section, 4 * attribute.components);
    } else {
        fail(source, section, "float (0), int (1), index (4) or vector (5)",
             "type " + std::to_string(type));
    }
}

std::vector<Attribute> take_attributes(Source& source, const std::string& kind,
                                       std::uint32_t count) {
    std::vector<Attribute> attributes;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::string place =
            kind + " attribute " + std::to_string(i + 1) + " of " + std::to_string(count);
        Attribute attribute;
        attribute.name = take_text(source, place);
        const std::string section = kind + " attribute '" + attribute.name + "'";
        attribute.components = take_number<std::uint16_t>(source, section);
        if (attribute.components == 0)
            fail(source, section, "one or more values", "0");
        take_type(source, section, attribute);
        for (const Attribute& other : attributes)
            if (other.name == attribute.name)
                fail(source, section, "every name once", "it a second time; rename one of them");
        attributes.push_back(std::move(attribute));
    }
    return attributes;
}

std::size_t bytes_of(const std::vector<Attribute>& attributes) {
    std::size_t values = 0;
    for (const Attribute& attribute : attributes)
        values += attribute.components;
    return 4 * values;
}

/// Adds the values of one particle.
void append_values(PointArray& array, const char* stored) {
    for (int i = 0; i < array.components; ++i, stored += 4) {
        if (auto* numbers = std::get_if<std::vector<float>>(&array.values)) {
            numbers->push_back(decoded<float>(stored));
        } else {
            std::get<std::vector<std::int32_t>>(array.values)
                .push_back(decoded<std::int32_t>(stored));
        }
    }
}

/// Points follow one another, each with its position (x, y, z and a weight that positions have no
/// part in) and the values of its attributes. They are taken some at a time, so that a claim costs
/// no more memory than there are bytes behind it.
void take_points(Source& source, const std::vector<Attribute>& attributes, Snapshot& snapshot) {
    constexpr std::size_t position_bytes = 16;
    const std::size_t point_bytes = position_bytes + bytes_of(attributes);
    if (source.particles > source.stream.max_left() / point_bytes) {
        fail(source, "points",
             std::to_string(source.particles) + " x " + std::to_string(point_bytes) + " bytes",
             "fewer in the file; it is truncated or damaged, export it again");
    }
    for (const Attribute& attribute : attributes) {
        snapshot.point_data.push_back({attribute.name, static_cast<int>(attribute.components),
                                       attribute.is_whole ? ArrayValues(std::vector<std::int32_t>())
                                                          : ArrayValues(std::vector<float>())});
    }
    const std::uint64_t at_once =
        std::min<std::uint64_t>(source.particles, 1 + 65536 / point_bytes);
    std::string block(at_once * point_bytes, '\0');
    for (std::uint64_t left = source.particles; left > 0;) {
        const std::size_t count = std::min(left, at_once);
        take(source, "points", block.data(), count * point_bytes);
        for (std::size_t i = 0; i < count; ++i) {
            const char* stored = block.data() + i * point_bytes;
            snapshot.positions.push_back(
                {decoded<float>(stored), decoded<float>(stored + 4), decoded<float>(stored + 8)});
            stored += position_bytes;
            for (PointArray& array : snapshot.point_data) {
                append_values(array, stored);
                stored += 4 * static_cast<std::size_t>(array.components);
            }
        }
        left -= count;
    }
}

/// A particle primitive is a list of points, which says nothing that they do not. Another is a
/// curve or a surface.
void skip_primitive(Source& source) {
    const auto type = take_number<std::uint32_t>(source, "primitive");
    if (type != particle_primitive) {
        fail(source, "primitive", "particles, type " + std::to_string(particle_primitive),
             "type " + std::to_string(type) + "; a curve or surface is no snapshot");
    }
    const std::uint64_t points = take_number<std::uint32_t>(source, "primitive");
    skip(source, "primitive", points * (source.particles > max_short_index ? 4 : 2));
}

/// Attributes of the whole, which say nothing of particles, and the end.
void skip_details(Source& source, std::uint32_t count) {
    const std::vector<Attribute> details = take_attributes(source, "detail", count);
    skip(source, "detail values", bytes_of(details));
    char end[end_mark.size()];
    take(source, "end", end, sizeof end);
    if (std::string_view(end, sizeof end) != end_mark || !source.stream.ends_here())
        fail(source, "end", "the end of the file", "more bytes or damaged compression");
}

/// True where the file begins as classic geometry does, after decompression where it is compressed.
bool is_bgeo(const fs::path& file) {
    // A gzip header is longer than this only with a name of 4000 letters in it.
    const std::string stored = read_whole(file, 4096);
    Stream stream(stored);
    char begin[magic.size()];
    return stream.read(begin, sizeof begin) == sizeof begin &&
           std::string_view(begin, sizeof begin) == magic;
}

/// Reads positions and attributes of numbers; of attributes that index a table of texts, the index.
/// Throws InputError, naming the section, on anything that is not well formed, and on points that
/// belong to curves or surfaces. Memory is bounded by what the file's bytes can hold, whatever its
/// header claims.
Snapshot read_bgeo(const fs::path& file, const ReadChoices& /*choices*/) {
    const std::string stored = read_whole(file);
    Source source{file, Stream(stored)};
    const Header header = take_header(source);
    source.particles = header.points;
    Snapshot snapshot;
    snapshot.position_precision = Precision::float32;
    take_points(source, take_attributes(source, "point", header.point_attributes), snapshot);
    if (header.primitives > 0)
        skip_primitive(source);
    skip_details(source, header.detail_attributes);
    snapshot.dimension = dimension_of(snapshot.positions);
    return snapshot;
}

} // namespace

SnapshotFormat bgeo_format() {
    return {"bgeo", is_bgeo, read_bgeo};
}

} // namespace meniscus
