#include "legacy_vtk.hpp"

#include "errors.hpp"
#include "snapshot_files.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace meniscus {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view first_line = "# vtk DataFile Version";

/// The words of a line such as "POINTS 26136 float".
using Words = std::vector<std::string>;

/// What is left of the file to read.
struct Source {
    fs::path file;
    std::string_view rest;
    std::uint64_t particles = 0; ///< as POINTS claims, 0 before
};

[[noreturn]] void fail(const Source& source, const std::string& section,
                       const std::string& expected, const std::string& found) {
    throw InputError(source.file.string() + ": section " + section + " (" +
                     std::to_string(source.particles) + " particles): expected " + expected +
                     ", found " + found);
}

/// Text of the file, fit for a message whatever bytes it is made of.
std::string shown(const Words& words) {
    if (words.empty()) {
        return "the end of the file; it is truncated, export it again";
    }
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : " ") + word;
    }
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 32 || c > 126; }, '?');
    return "'" + (text.size() > 60 ? text.substr(0, 60) + "..." : text) + "'";
}

bool is_space(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
        return std::tolower(x) == std::tolower(y);
    });
}

bool starts_with(const Words& words, std::string_view keyword) {
    return !words.empty() && same_word(words[0], keyword);
}

/// The line up to its end, which is taken too. Lines of more than 1000 characters are not text.
std::string_view take_line(Source& source) {
    const std::string_view line = source.rest.substr(0, 1000);
    const std::size_t end = std::min(line.find('\n'), line.size());
    source.rest.remove_prefix(std::min(end + 1, source.rest.size()));
    return line.substr(0, end);
}

Words split(std::string_view line) {
    Words words;
    auto begin = std::find_if_not(line.begin(), line.end(), is_space);
    while (begin != line.end()) {
        const auto end = std::find_if(begin, line.end(), is_space);
        words.emplace_back(begin, end);
        begin = std::find_if_not(end, line.end(), is_space);
    }
    return words;
}

/// The next line that has words on it; none at the end of the file.
Words next_words(Source& source) {
    Words words;
    while (words.empty() && !source.rest.empty()) {
        words = split(take_line(source));
    }
    return words;
}

/// As next_words, without the METADATA that VTK adds to arrays (it ends with an empty line).
Words next_header(Source& source) {
    Words words = next_words(source);
    while (starts_with(words, "METADATA")) {
        while (!split(take_line(source)).empty()) {
        }
        words = next_words(source);
    }
    return words;
}

/// A header of the given words after its keyword; `most` of them, `least` at least.
void expect_words(const Source& source, const Words& header, const std::string& section,
                  const std::string& form, std::size_t least, std::size_t most) {
    if (header.size() < least || header.size() > most) {
        fail(source, section, "'" + form + "'", shown(header));
    }
}

std::uint64_t parse_count(const Source& source, const std::string& section,
                          const std::string& word) {
    std::uint64_t count = 0;
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, count);
    if (error != std::errc() || stop != end) {
        fail(source, section, "a count", shown({word}));
    }
    return count;
}

int parse_components(const Source& source, const std::string& section, const std::string& word) {
    const std::uint64_t count = parse_count(source, section, word);
    if (count < 1 || count > std::numeric_limits<int>::max()) {
        fail(source, section, "one or more components", shown({word}));
    }
    return static_cast<int>(count);
}

// Numbers are stored big endian; the machines that this is built for are little endian.
template <class Number>
ArrayValues decode(std::string_view block, std::size_t count) {
    std::vector<Number> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        const char* stored = block.data() + i * sizeof(Number);
        std::reverse_copy(stored, stored + sizeof(Number), reinterpret_cast<char*>(&values[i]));
    }
    return values;
}

ArrayValues decode_bits(std::string_view block, std::size_t count) {
    std::vector<std::uint8_t> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = (static_cast<unsigned char>(block[i / 8]) >> (7 - i % 8)) & 1;
    }
    return values;
}

struct ScalarType {
    std::string_view name;
    std::uint64_t bits; ///< per value
    ArrayValues (*decode)(std::string_view block, std::size_t count);
};

// VTK writes long with the size that it has on Unix, and vtkIdType always as int.
constexpr ScalarType scalar_types[] = {
    {"bit", 1, decode_bits},
    {"char", 8, decode<std::int8_t>},
    {"signed_char", 8, decode<std::int8_t>},
    {"unsigned_char", 8, decode<std::uint8_t>},
    {"short", 16, decode<std::int16_t>},
    {"unsigned_short", 16, decode<std::uint16_t>},
    {"int", 32, decode<std::int32_t>},
    {"vtkidtype", 32, decode<std::int32_t>},
    {"unsigned_int", 32, decode<std::uint32_t>},
    {"long", 64, decode<std::int64_t>},
    {"vtktypeint64", 64, decode<std::int64_t>},
    {"unsigned_long", 64, decode<std::uint64_t>},
    {"vtktypeuint64", 64, decode<std::uint64_t>},
    {"float", 32, decode<float>},
    {"double", 64, decode<double>},
};

const ScalarType& parse_type(const Source& source, const std::string& section,
                             const std::string& word) {
    const auto* type =
        std::find_if(std::begin(scalar_types), std::end(scalar_types),
                     [&](const ScalarType& known) { return same_word(known.name, word); });
    if (type == std::end(scalar_types)) {
        fail(source, section, "a number type such as float or unsigned_int", shown({word}));
    }
    return *type;
}

/// The bytes of `tuples` times `components` values. Nothing is allocated or multiplied before the
/// claim is known to fit into what is left of the file.
std::string_view take_block(Source& source, const std::string& section, std::uint64_t tuples,
                            std::uint64_t components, const ScalarType& type) {
    const std::uint64_t values_left =
        static_cast<std::uint64_t>(source.rest.size()) * 8 / type.bits;
    if (tuples > values_left / components) {
        fail(source, section,
             std::to_string(tuples) + " x " + std::to_string(components) + " values of type " +
                 std::string(type.name),
             std::to_string(source.rest.size()) +
                 " bytes left in the file; it is truncated or damaged, export it again");
    }
    const std::uint64_t bytes = (tuples * components * type.bits + 7) / 8;
    const std::string_view block = source.rest.substr(0, bytes);
    source.rest.remove_prefix(bytes);
    return block;
}

ArrayValues take_values(Source& source, const std::string& section, std::uint64_t tuples,
                        std::uint64_t components, const ScalarType& type) {
    const std::string_view block = take_block(source, section, tuples, components, type);
    return type.decode(block, tuples * components);
}

/// VTK writes characters of a name that could be mistaken for the format's own as %20 and so on.
std::string decoded_name(const std::string& stored) {
    std::string name;
    for (std::size_t i = 0; i < stored.size(); ++i) {
        unsigned char code = 0;
        const char* digits = stored.data() + i + 1;
        if (stored[i] == '%' && i + 2 < stored.size() &&
            std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
            name += static_cast<char>(code);
            i += 2;
        } else {
            name += stored[i];
        }
    }
    return name;
}

void add_array(const Source& source, std::vector<PointArray>& arrays, PointArray array) {
    for (const PointArray& other : arrays) {
        if (other.name == array.name) {
            fail(source, "array " + shown({array.name}), "every array name once",
                 "it a second time; rename one of them");
        }
    }
    arrays.push_back(std::move(array));
}

/// FIELD name n, then n times: name components tuples type, and the values. Each array has the
/// given number of tuples, or any where none is given.
void read_field(Source& source, const Words& header, std::vector<PointArray>& arrays,
                std::optional<std::uint64_t> tuples) {
    expect_words(source, header, "FIELD", "FIELD name arrays", 3, 3);
    const std::uint64_t count = parse_count(source, "FIELD", header[2]);
    for (std::uint64_t i = 0; i < count; ++i) {
        const Words words = next_header(source);
        expect_words(source, words,
                     "FIELD, array " + std::to_string(i + 1) + " of " + std::to_string(count),
                     "name components tuples type", 4, 4);
        const std::string section = "FIELD, array " + shown({words[0]});
        const int components = parse_components(source, section, words[1]);
        const std::uint64_t stored = parse_count(source, section, words[2]);
        if (tuples && stored != *tuples) {
            fail(source, section, std::to_string(*tuples) + " tuples", words[2]);
        }
        const ScalarType& type = parse_type(source, section, words[3]);
        ArrayValues values =
            take_values(source, section, stored, static_cast<std::uint64_t>(components), type);
        add_array(source, arrays, {decoded_name(words[0]), components, std::move(values)});
    }
}

/// SCALARS name type [components], LOOKUP_TABLE name, and the values.
void read_scalars(Source& source, const Words& header, std::vector<PointArray>& arrays,
                  std::uint64_t tuples) {
    expect_words(source, header, "SCALARS", "SCALARS name type [components]", 3, 4);
    const std::string section = "SCALARS " + shown({header[1]});
    const ScalarType& type = parse_type(source, section, header[2]);
    const int components = header.size() == 4 ? parse_components(source, section, header[3]) : 1;
    const Words table = next_words(source);
    if (!starts_with(table, "LOOKUP_TABLE")) {
        fail(source, section, "'LOOKUP_TABLE name'", shown(table));
    }
    ArrayValues values =
        take_values(source, section, tuples, static_cast<std::uint64_t>(components), type);
    add_array(source, arrays, {decoded_name(header[1]), components, std::move(values)});
}

/// A lookup table's own colors, which say nothing about particles.
void skip_lookup_table(Source& source, const Words& header) {
    expect_words(source, header, "LOOKUP_TABLE", "LOOKUP_TABLE name size", 3, 3);
    take_block(source, "LOOKUP_TABLE", parse_count(source, "LOOKUP_TABLE", header[2]), 4,
               parse_type(source, "LOOKUP_TABLE", "unsigned_char"));
}

struct FixedAttribute {
    std::string_view keyword;
    int components;
};

constexpr FixedAttribute fixed_attributes[] = {{"VECTORS", 3},    {"NORMALS", 3},
                                               {"TENSORS", 9},    {"TENSORS6", 6},
                                               {"GLOBAL_IDS", 1}, {"PEDIGREE_IDS", 1}};

/// One section of POINT_DATA or CELL_DATA.
void read_attribute(Source& source, const Words& header, std::vector<PointArray>& arrays,
                    std::uint64_t tuples) {
    if (starts_with(header, "FIELD")) {
        return read_field(source, header, arrays, tuples);
    }
    if (starts_with(header, "SCALARS")) {
        return read_scalars(source, header, arrays, tuples);
    }
    if (starts_with(header, "LOOKUP_TABLE")) {
        return skip_lookup_table(source, header);
    }
    for (const FixedAttribute& attribute : fixed_attributes) {
        if (starts_with(header, attribute.keyword)) {
            expect_words(source, header, header[0], header[0] + " name type", 3, 3);
            const std::string section = header[0] + " " + shown({header[1]});
            const ScalarType& type = parse_type(source, section, header[2]);
            ArrayValues values = take_values(
                source, section, tuples, static_cast<std::uint64_t>(attribute.components), type);
            return add_array(source, arrays,
                             {decoded_name(header[1]), attribute.components, std::move(values)});
        }
    }
    fail(source, "POINT_DATA", "SCALARS, VECTORS, NORMALS, TENSORS or FIELD", shown(header));
}

/// Title, BINARY and DATASET; what is not supported is refused by name.
void read_preamble(Source& source) {
    take_line(source); // the title, which may be empty
    const Words encoding = next_words(source);
    if (!starts_with(encoding, "BINARY")) {
        fail(source, "header", "BINARY (ASCII is not supported yet)", shown(encoding));
    }
    const Words dataset = next_words(source);
    if (!starts_with(dataset, "DATASET") || dataset.size() != 2 ||
        !same_word(dataset[1], "UNSTRUCTURED_GRID")) {
        fail(source, "header", "DATASET UNSTRUCTURED_GRID (others are not supported yet)",
             shown(dataset));
    }
}

void read_points(Source& source, const Words& header, Snapshot& snapshot) {
    if (!starts_with(header, "POINTS")) {
        fail(source, "POINTS", "'POINTS particles type'", shown(header));
    }
    expect_words(source, header, "POINTS", "POINTS particles type", 3, 3);
    source.particles = parse_count(source, "POINTS", header[1]);
    const ScalarType& type = parse_type(source, "POINTS", header[2]);
    if (type.name != "float" && type.name != "double") {
        fail(source, "POINTS", "float or double", shown({header[2]}));
    }
    snapshot.position_precision = type.name == "float" ? Precision::float32 : Precision::float64;
    const ArrayValues values = take_values(source, "POINTS", source.particles, 3, type);
    snapshot.positions.resize(source.particles);
    std::visit(
        [&](const auto& coordinates) {
            for (std::size_t i = 0; i < snapshot.size(); ++i) {
                std::copy_n(coordinates.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                            snapshot.positions[i].begin());
            }
        },
        values);
}

/// Cells carry nothing that positions do not say; they are stepped over. Since version 5 they are
/// two arrays with headers of their own.
void skip_cells(Source& source, const Words& header, int version) {
    expect_words(source, header, "CELLS", "CELLS cells size", 3, 3);
    if (version < 5) {
        take_block(source, "CELLS", parse_count(source, "CELLS", header[2]), 1,
                   parse_type(source, "CELLS", "int"));
        return;
    }
    for (const int part : {1, 2}) {
        const std::string keyword = part == 1 ? "OFFSETS" : "CONNECTIVITY";
        const Words words = next_header(source);
        if (!starts_with(words, keyword) || words.size() != 2) {
            fail(source, "CELLS", "'" + keyword + " type'", shown(words));
        }
        take_block(source, "CELLS, " + keyword,
                   parse_count(source, "CELLS", header[static_cast<std::size_t>(part)]), 1,
                   parse_type(source, "CELLS", words[1]));
    }
}

/// A mesh has points too, but they are no particles.
void check_cell_types(Source& source) {
    const Words header = next_header(source);
    if (!starts_with(header, "CELL_TYPES") || header.size() != 2) {
        fail(source, "CELL_TYPES", "'CELL_TYPES cells'", shown(header));
    }
    const std::uint64_t cells = parse_count(source, "CELL_TYPES", header[1]);
    const ArrayValues types =
        take_values(source, "CELL_TYPES", cells, 1, parse_type(source, "CELL_TYPES", "int"));
    for (const std::int32_t type : std::get<std::vector<std::int32_t>>(types)) {
        if (type != 1 && type != 2) {
            fail(source, "CELL_TYPES", "particles (vertex cells, type 1)",
                 "type " + std::to_string(type) + "; a mesh is no snapshot");
        }
    }
}

/// POINT_DATA and CELL_DATA to the end of the file.
void read_data(Source& source, Words header, Snapshot& snapshot) {
    std::vector<PointArray> cell_data;
    std::vector<PointArray>* arrays = nullptr;
    std::uint64_t tuples = 0;
    while (!header.empty()) {
        if (starts_with(header, "POINT_DATA") || starts_with(header, "CELL_DATA")) {
            const bool of_points = starts_with(header, "POINT_DATA");
            expect_words(source, header, header[0], header[0] + " tuples", 2, 2);
            tuples = parse_count(source, header[0], header[1]);
            if (of_points && tuples != source.particles) {
                fail(source, header[0], std::to_string(source.particles) + " tuples", header[1]);
            }
            arrays = of_points ? &snapshot.point_data : &cell_data;
            header = next_header(source);
            if (header.empty() && tuples > 0) {
                fail(source, of_points ? "POINT_DATA" : "CELL_DATA", "an array", shown(header));
            }
        } else if (arrays != nullptr) {
            read_attribute(source, header, *arrays, tuples);
            header = next_header(source);
        } else {
            fail(source, "after POINTS", "CELLS, POINT_DATA or CELL_DATA", shown(header));
        }
    }
}

} // namespace

bool is_legacy_vtk(const fs::path& file) {
    return read_whole(file, first_line.size()) == first_line;
}

Snapshot read_legacy_vtk(const fs::path& file) {
    const std::string bytes = read_whole(file);
    Source source{file, bytes};
    const Words first = split(take_line(source));
    if (std::string_view(bytes).substr(0, first_line.size()) != first_line || first.size() < 5) {
        fail(source, "header", "'" + std::string(first_line) + " 4.1'", shown(first));
    }
    const int version = first[4][0] - '0';
    read_preamble(source);

    Snapshot snapshot;
    Words header = next_header(source);
    std::vector<PointArray> about_the_file;
    while (starts_with(header, "FIELD")) {
        read_field(source, header, about_the_file, std::nullopt);
        header = next_header(source);
    }
    read_points(source, header, snapshot);
    header = next_header(source);
    if (starts_with(header, "CELLS")) {
        skip_cells(source, header, version);
        check_cell_types(source);
        header = next_header(source);
    } else if (header.empty() && snapshot.size() > 0) {
        fail(source, "CELLS", "'CELLS cells size'", shown(header));
    }
    read_data(source, header, snapshot);
    snapshot.dimension = dimension_of(snapshot.positions);
    return snapshot;
}

} // namespace meniscus
