// VTK's legacy format ("# vtk DataFile Version ..."), versions 1.0 to 5.1, ASCII or binary:
// UNSTRUCTURED_GRID with vertex cells, as SPlisHSPlasH writes it, and POLYDATA with vertices or
// mere points, as DualSPHysics does. Point data keeps the names that the solver gave;
// SPlisHSPlasH's `id`, `velocity` and `density` coincide with ours.
#include "snapshot_formats.hpp"

#include <meniscus/data/formats/detail/legacy_vtk_numbers.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace meniscus {

namespace {

namespace fs = std::filesystem;
using namespace legacy_vtk;

constexpr std::string_view first_line = "# vtk DataFile Version";

/// As next_words, without the METADATA that VTK adds to arrays (it ends with an empty line).
Words next_header(Source& source) {
    Words words = next_words(source);
    while (starts_with(words, "METADATA")) {
        while (!line_words(source).empty()) {
        }
        words = next_words(source);
    }
    return words;
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

/// Arrays of numbers, and the names of those that are texts, which say nothing that we use.
struct Arrays : std::vector<PointArray> {
    std::vector<std::string> texts;
};

void skip_texts(Source& source, const std::string& section, std::uint64_t tuples,
                std::uint64_t components) {
    if (tuples > source.rest.size() / components)
        fail(source, section, std::to_string(tuples) + " texts", "fewer bytes left in the file");
    take_texts(source, section, tuples * components);
}

/// FIELD name n, then n times: name components tuples type, and the values. Each array has the
/// given number of tuples, or any where none is given.
void read_field(Source& source, const Words& header, Arrays& arrays,
                std::optional<std::uint64_t> tuples) {
    expect_words(source, header, "FIELD", "FIELD name arrays", 3, 3);
    const std::uint64_t count = parse_count(source, "FIELD", header[2]);
    for (std::uint64_t i = 0; i < count; ++i) {
        const Words words = next_header(source);
        expect_words(source, words,
                     "FIELD, array " + std::to_string(i + 1) + " of " + std::to_string(count),
                     "name components tuples type", 4, 4);
        const std::string section = "FIELD, array " + quoted_text(words[0]);
        const int components = parse_components(source, section, words[1]);
        const std::uint64_t stored = parse_count(source, section, words[2]);
        if (tuples && stored != *tuples)
            fail(source, section, std::to_string(*tuples) + " tuples", words[2]);
        if (lowered(words[3]) == "string") {
            skip_texts(source, section, stored, static_cast<std::uint64_t>(components));
            arrays.texts.push_back(decoded_name(words[0]));
            continue;
        }
        const ScalarType& type = parse_type(source, section, words[3]);
        ArrayValues values =
            take_values(source, section, stored, static_cast<std::uint64_t>(components), type);
        arrays.push_back({decoded_name(words[0]), components, std::move(values)});
    }
}

/// SCALARS name type [components], LOOKUP_TABLE name, and the values.
void read_scalars(Source& source, const Words& header, Arrays& arrays, std::uint64_t tuples) {
    expect_words(source, header, "SCALARS", "SCALARS name type [components]", 3, 4);
    const std::string section = "SCALARS " + quoted_text(header[1]);
    const ScalarType& type = parse_type(source, section, header[2]);
    const int components = header.size() == 4 ? parse_components(source, section, header[3]) : 1;
    const Words table = next_words(source);
    if (!starts_with(table, "LOOKUP_TABLE"))
        fail(source, section, "'LOOKUP_TABLE name'", shown(table));
    ArrayValues values =
        take_values(source, section, tuples, static_cast<std::uint64_t>(components), type);
    arrays.push_back({decoded_name(header[1]), components, std::move(values)});
}

/// A lookup table's own colors, which say nothing about particles. They are bytes in binary files,
/// fractions of 255 in ASCII ones.
void skip_lookup_table(Source& source, const Words& header) {
    expect_words(source, header, "LOOKUP_TABLE", "LOOKUP_TABLE name size", 3, 3);
    take_values(source, "LOOKUP_TABLE", parse_count(source, "LOOKUP_TABLE", header[2]), 4,
                parse_type(source, "LOOKUP_TABLE", source.binary ? "unsigned_char" : "float"));
}

/// COLOR_SCALARS name components: how VTK writes unsigned_char values that it would color by. They
/// are bytes in binary files, fractions of 255 in ASCII ones.
void read_color_scalars(Source& source, const Words& header, Arrays& arrays, std::uint64_t tuples) {
    expect_words(source, header, "COLOR_SCALARS", "COLOR_SCALARS name components", 3, 3);
    const std::string section = "COLOR_SCALARS " + quoted_text(header[1]);
    const int components = parse_components(source, section, header[2]);
    PointArray array{
        decoded_name(header[1]), components,
        take_values(source, section, tuples, static_cast<std::uint64_t>(components),
                    parse_type(source, section, source.binary ? "unsigned_char" : "double"))};
    if (!source.binary) {
        std::vector<std::uint8_t> bytes;
        for (const double fraction : as_doubles(array)) {
            if (!(fraction >= 0 && fraction <= 1))
                fail(source, section, "fractions from 0 to 1", number_text(fraction));
            bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * fraction)));
        }
        array.values = std::move(bytes);
    }
    arrays.push_back(std::move(array));
}

/// KEYWORD name type, and the values.
void read_plain(Source& source, const Words& header, Arrays& arrays, std::uint64_t tuples,
                int components) {
    expect_words(source, header, header[0], header[0] + " name type", 3, 3);
    const std::string section = header[0] + " " + quoted_text(header[1]);
    const ScalarType& type = parse_type(source, section, header[2]);
    ArrayValues values =
        take_values(source, section, tuples, static_cast<std::uint64_t>(components), type);
    arrays.push_back({decoded_name(header[1]), components, std::move(values)});
}

/// TEXTURE_COORDINATES name components type, and the values.
void read_texture_coordinates(Source& source, Words header, Arrays& arrays, std::uint64_t tuples) {
    expect_words(source, header, "TEXTURE_COORDINATES", "TEXTURE_COORDINATES name components type",
                 4, 4);
    const int components = parse_components(source, header[0], header[2]);
    header.erase(header.begin() + 2);
    read_plain(source, header, arrays, tuples, components);
}

struct PlainAttribute {
    std::string_view keyword;
    int components;
};

constexpr PlainAttribute plain_attributes[] = {
    {"VECTORS", 3},    {"NORMALS", 3},      {"TENSORS", 9},   {"TENSORS6", 6},
    {"GLOBAL_IDS", 1}, {"PEDIGREE_IDS", 1}, {"EDGE_FLAGS", 1}};

/// One section of POINT_DATA or CELL_DATA.
void read_attribute(Source& source, const Words& header, Arrays& arrays, std::uint64_t tuples) {
    if (starts_with(header, "FIELD"))
        return read_field(source, header, arrays, tuples);
    if (starts_with(header, "SCALARS"))
        return read_scalars(source, header, arrays, tuples);
    if (starts_with(header, "COLOR_SCALARS"))
        return read_color_scalars(source, header, arrays, tuples);
    if (starts_with(header, "LOOKUP_TABLE"))
        return skip_lookup_table(source, header);
    if (starts_with(header, "TEXTURE_COORDINATES"))
        return read_texture_coordinates(source, header, arrays, tuples);
    for (const PlainAttribute& attribute : plain_attributes)
        if (starts_with(header, attribute.keyword))
            return read_plain(source, header, arrays, tuples, attribute.components);
    fail(source, "POINT_DATA", "SCALARS, VECTORS, NORMALS, TENSORS or FIELD", shown(header));
}

/// The major version of "# vtk DataFile Version 4.1".
int read_version(Source& source) {
    const bool begins_well = source.rest.substr(0, first_line.size()) == first_line;
    const Words words = line_words(source);
    int major = 0;
    if (!begins_well || words.size() != 5 ||
        read_number(words[4].substr(0, words[4].find('.')), major) != std::errc() || major < 1 ||
        major > 5)
        fail(source, "header", "'" + std::string(first_line) + "' 1.0 to 5.1", shown(words));
    return major;
}

/// Title, ASCII or BINARY, and DATASET; what is not supported is refused by name. Returns true for
/// UNSTRUCTURED_GRID, false for POLYDATA.
bool read_preamble(Source& source) {
    line_words(source); // the title, which may be empty
    const Words encoding = next_words(source);
    source.binary = starts_with(encoding, "BINARY");
    if (!source.binary && !starts_with(encoding, "ASCII"))
        fail(source, "header", "ASCII or BINARY", shown(encoding));
    const Words dataset = next_words(source);
    const std::string kind =
        starts_with(dataset, "DATASET") && dataset.size() == 2 ? lowered(dataset[1]) : "";
    if (kind != "unstructured_grid" && kind != "polydata")
        fail(source, "header", "DATASET UNSTRUCTURED_GRID or POLYDATA", shown(dataset));
    return kind == "unstructured_grid";
}

void read_points(Source& source, const Words& header, Snapshot& snapshot) {
    if (!starts_with(header, "POINTS"))
        fail(source, "POINTS", "'POINTS particles type'", shown(header));
    expect_words(source, header, "POINTS", "POINTS particles type", 3, 3);
    source.particles = parse_count(source, "POINTS", header[1]);
    const ScalarType& type = parse_type(source, "POINTS", header[2]);
    if (type.name != "float" && type.name != "double")
        fail(source, "POINTS", "float or double", shown({header[2]}));
    snapshot.position_precision = type.name == "float" ? Precision::float32 : Precision::float64;
    const ArrayValues values = take_values(source, "POINTS", source.particles, 3, type);
    snapshot.positions.resize(source.particles);
    std::visit(
        [&](const auto& coordinates) {
            for (std::size_t i = 0; i < snapshot.size(); ++i)
                std::copy_n(coordinates.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                            snapshot.positions[i].begin());
        },
        values);
}

/// KEYWORD type, and the values: half of the cells since version 5.
void take_cell_array(Source& source, const std::string& section, const std::string& keyword,
                     std::uint64_t count) {
    const Words words = next_header(source);
    if (!starts_with(words, keyword) || words.size() != 2)
        fail(source, section, "'" + keyword + " type'", shown(words));
    take_values(source, section + ", " + keyword, count, 1, parse_type(source, section, words[1]));
}

/// Cells carry nothing that positions do not say; they are stepped over. Since version 5 they are
/// two arrays with headers of their own. Returns their number.
std::uint64_t skip_cells(Source& source, const Words& header, int version) {
    const std::string& section = header[0];
    expect_words(source, header, section, section + " cells size", 3, 3);
    const std::uint64_t first = parse_count(source, section, header[1]);
    const std::uint64_t second = parse_count(source, section, header[2]);
    if (version < 5) {
        take_values(source, section, second, 1, parse_type(source, section, "int"));
        return first;
    }
    take_cell_array(source, section, "OFFSETS", first);
    take_cell_array(source, section, "CONNECTIVITY", second);
    return first > 0 ? first - 1 : 0;
}

/// A mesh has points too, but they are no particles.
void check_cell_types(Source& source) {
    const Words header = next_header(source);
    if (!starts_with(header, "CELL_TYPES") || header.size() != 2)
        fail(source, "CELL_TYPES", "'CELL_TYPES cells'", shown(header));
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

/// The cells of an UNSTRUCTURED_GRID from `header` on. Returns the header after them.
Words read_grid_cells(Source& source, const Words& header, int version) {
    if (starts_with(header, "CELLS")) {
        skip_cells(source, header, version);
        check_cell_types(source);
        return next_header(source);
    }
    if (header.empty() && source.particles > 0)
        fail(source, "CELLS", "'CELLS cells size'", shown(header));
    return header;
}

/// The same for POLYDATA, where points without any cells are particles too.
Words read_polydata_cells(Source& source, Words header, int version) {
    const auto is_cells = [&](std::string_view keyword) { return starts_with(header, keyword); };
    for (; is_cells("VERTICES") || is_cells("LINES") || is_cells("POLYGONS") ||
           is_cells("TRIANGLE_STRIPS");
         header = next_header(source)) {
        const std::uint64_t cells = skip_cells(source, header, version);
        if (!is_cells("VERTICES") && cells > 0) {
            fail(source, header[0], "no cells but VERTICES",
                 std::to_string(cells) + "; a mesh is no snapshot");
        }
    }
    return header;
}

/// POINT_DATA and CELL_DATA to the end of the file.
void read_data(Source& source, Words header, Snapshot& snapshot) {
    Arrays cell_data;
    Arrays point_data;
    Arrays* arrays = nullptr;
    std::uint64_t tuples = 0;
    while (!header.empty()) {
        if (starts_with(header, "POINT_DATA") || starts_with(header, "CELL_DATA")) {
            const bool of_points = starts_with(header, "POINT_DATA");
            expect_words(source, header, header[0], header[0] + " tuples", 2, 2);
            tuples = parse_count(source, header[0], header[1]);
            if (of_points && tuples != source.particles)
                fail(source, header[0], std::to_string(source.particles) + " tuples", header[1]);
            arrays = of_points ? &point_data : &cell_data;
            if (of_points && tuples > 0 && source.rest.empty()) // not even an empty line
                fail(source, "POINT_DATA", "an array", shown({}));
            header = next_header(source);
        } else if (arrays != nullptr) {
            read_attribute(source, header, *arrays, tuples);
            header = next_header(source);
        } else {
            fail(source, "after POINTS", "cells, POINT_DATA or CELL_DATA", shown(header));
        }
    }
    for (const std::string& name : point_data.texts)
        snapshot.notes.push_back("point data " + quoted_text(name) + " is text and left out");
    snapshot.point_data = std::move(point_data);
}

void check_names(const Source& source, const Snapshot& snapshot) {
    std::vector<std::string> names;
    for (const PointArray& array : snapshot.point_data)
        names.push_back(array.name);
    if (const auto repeated = repeated_name(std::move(names))) {
        fail(source, "POINT_DATA", "every array name once",
             quoted_text(*repeated) + " a second time; rename one of them");
    }
}

/// True where the file begins with the legacy format's first line.
bool is_legacy_vtk(const fs::path& file) {
    return read_whole(file, first_line.size()) == first_line;
}

/// Reads positions and point data. Throws InputError, naming the section, on anything that is not
/// well formed; memory is bounded by the file's own size whatever its header claims.
Snapshot read_legacy_vtk(const fs::path& file, const ReadChoices& /*choices*/) {
    const std::string bytes = read_whole(file);
    Source source{file, bytes};
    const int version = read_version(source);
    const bool is_grid = read_preamble(source);

    Snapshot snapshot;
    Words header = next_header(source);
    Arrays about_the_file;
    while (starts_with(header, "FIELD")) {
        read_field(source, header, about_the_file, std::nullopt);
        header = next_header(source);
    }
    read_points(source, header, snapshot);
    header = next_header(source);
    header = is_grid ? read_grid_cells(source, header, version)
                     : read_polydata_cells(source, header, version);
    read_data(source, header, snapshot);
    check_names(source, snapshot);
    snapshot.dimension = dimension_of(snapshot.positions);
    return snapshot;
}

} // namespace

SnapshotFormat legacy_vtk_format() {
    return {"legacy VTK", is_legacy_vtk, read_legacy_vtk};
}

} // namespace meniscus
