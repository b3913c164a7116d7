// Tables of particles as text: one line that names the columns, then one line a particle. What
// ParaView exports ("Points:0","velocity:0"), what DualSPHysics' PartVTK saves (Pos.x [m];Idp; with
// lines about the time step in front), and plain x,y,z. Columns are separated by commas, semicolons
// or tabs, numbers have a decimal point, texts may stand in double quotes.
//
// Columns that are known under several names get ours (`id`, `velocity`, `density`, `mass`,
// `phase`, `support_radius`); others keep theirs. docs/file_formats.md has the names.
#include "snapshot_formats.hpp"

#include <meniscus/data/formats/detail/csv_cells.hpp>
#include <meniscus/data/particles/known_names.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

namespace meniscus {

namespace {

namespace fs = std::filesystem;
using namespace csv;

/// A column's name, and what it is compared with known names by.
struct Name {
    std::string text;
    std::string plain; ///< in lower case, without the unit
    std::string unit;  ///< that stands behind it in brackets
};

Name parsed_name(std::string text) {
    const std::size_t open = text.find_last_of("[(");
    const bool has_unit =
        open != std::string::npos && open > 0 && (text.back() == ']' || text.back() == ')');
    const std::string_view name = std::string_view(text).substr(0, has_unit ? open : text.size());
    std::string plain = lowered(without_spaces_behind(name));
    std::string unit = has_unit ? text.substr(open + 1, text.size() - open - 2) : "";
    return {std::move(text), std::move(plain), std::move(unit)};
}

/// Which of x, y and z (0, 1 and 2) of a vector a column is: "pos.x", "pos_0", "pos:0", "posx".
std::optional<std::size_t> axis_of(std::string_view name, std::string_view vector) {
    if (name.substr(0, vector.size()) != vector)
        return std::nullopt;
    std::string_view axis = name.substr(vector.size());
    std::string_view axes = "xyz";
    if (axis.size() == 2 && !vector.empty() && std::string_view(".:_ ").find(axis[0]) < 4) {
        axis.remove_prefix(1);
        axes = axis[0] <= '9' ? "012" : "xyz";
    }
    const std::size_t found = axis.size() == 1 ? axes.find(axis[0]) : std::string_view::npos;
    return found == std::string_view::npos ? std::nullopt : std::make_optional(found);
}

/// The columns of a vector's x, y and z.
using Axes = std::array<std::optional<std::size_t>, 3>;

Axes find_axes(const std::vector<Name>& names, std::string_view vector) {
    Axes axes;
    for (std::size_t column = 0; column < names.size(); ++column) {
        const auto axis = axis_of(names[column].plain, vector);
        if (axis && !axes[*axis])
            axes[*axis] = column;
    }
    return axes;
}

std::ptrdiff_t axis_count(const Axes& axes) {
    return std::count_if(axes.begin(), axes.end(),
                         [](const auto& axis) { return axis.has_value(); });
}

// Names of vectors in lower case, the likeliest first.
constexpr std::string_view position_names[] = {"points", "position",    "positions", "pos",
                                               "coords", "coordinates", "",          "p"};
constexpr std::string_view velocity_names[] = {"velocity", "vel", "v"};

/// Two axes of a position at least; fewer are none.
Axes find_positions(const std::vector<Name>& names) {
    for (const std::string_view vector : position_names) {
        const Axes axes = find_axes(names, vector);
        if (axis_count(axes) >= 2)
            return axes;
    }
    return {};
}

struct Header {
    char separator = ',';
    std::vector<Name> names;
    std::optional<std::string_view> time; ///< what PartVTK writes in front
};

/// The lines up to the one that names the columns are within so many bytes, and so many lines.
constexpr std::size_t max_header_bytes = 1 << 16;
constexpr std::size_t max_header_lines = 20;

/// Takes lines up to the one that names columns of positions, if there is one.
std::optional<Header> find_header(Source& source) {
    Header header;
    bool time_follows = false;
    const std::size_t size = source.rest.size();
    while (source.line < max_header_lines && !source.rest.empty()) {
        std::string_view line = take_line(source);
        if (size - source.rest.size() > max_header_bytes)
            break;
        if (time_follows)
            header.time = line.substr(0, line.find_first_of(",;\t"));
        time_follows = lowered(line.substr(0, 8)) == "timestep";
        if (!line.empty() && line.front() == '#') // as NumPy writes it
            line.remove_prefix(1);
        for (const char separator : {',', ';', '\t'}) {
            header.separator = separator;
            header.names.clear();
            for (std::string& name : names_of(line, separator))
                header.names.push_back(parsed_name(std::move(name)));
            if (axis_count(find_positions(header.names)) > 0)
                return header;
        }
    }
    return std::nullopt;
}

/// The unit of the SI; empty for numbers of things.
std::string_view unit_of(std::string_view quantity) {
    return quantity == "density"          ? "kg/m^3"
           : quantity == "mass"           ? "kg"
           : quantity == "support_radius" ? "m"
                                          : "";
}

struct NoNumbers {};
using Numbers = std::variant<std::vector<std::int64_t>, std::vector<double>, NoNumbers>;

struct Column {
    Name name;
    std::string array; ///< the name that it gets as point data; empty where it is none of itself
    bool is_needed = false;   ///< must hold numbers
    bool is_left_out = false; ///< for its empty cells
    Numbers values;           ///< integers until one is not
};

struct Table {
    std::vector<Column> columns;
    std::vector<std::size_t> position; ///< columns of the coordinates
    std::vector<std::size_t> velocity; ///< columns of its components, or none
    bool plane_is_xz = false;          ///< there is no y
};

/// Columns of a vector in the order of the positions' coordinates, any further one behind.
std::vector<std::size_t> ordered(const Axes& axes, const Axes& positions) {
    std::vector<std::size_t> columns;
    for (const bool in_positions : {true, false}) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (axes[axis] && positions[axis].has_value() == in_positions)
                columns.push_back(*axes[axis]);
    }
    return columns;
}

/// Of the velocity, where it has every axis that the positions have.
std::vector<std::size_t> find_velocity(const std::vector<Name>& names, const Axes& positions) {
    for (const std::string_view vector : velocity_names) {
        const Axes axes = find_axes(names, vector);
        const auto lacks = [](const auto& axis, const auto& position) { return !axis && position; };
        if (std::equal(axes.begin(), axes.end(), positions.begin(), std::not_fn(lacks)))
            return ordered(axes, positions);
    }
    return {};
}

void check_unit(const Source& source, const Name& name, std::string_view expected) {
    std::string_view unit = name.unit;
    if (unit == "kg/m3")
        unit = "kg/m^3";
    if (!unit.empty() && !expected.empty() && unit != expected) {
        fail(source, name.text, "the unit " + std::string(expected),
             quoted_text(unit) + "; convert the column, or rename it");
    }
}

/// The columns of a vector, which are needed and no point data each of its own.
void claim(const Source& source, Table& table, const std::vector<std::size_t>& columns,
           std::string_view unit) {
    for (const std::size_t index : columns) {
        Column& column = table.columns[index];
        check_unit(source, column.name, unit);
        column.array.clear();
        column.is_needed = true;
        column.values = std::vector<double>();
    }
}

/// Whether the column is the likeliest of those that mean the same.
bool means_most(const std::vector<Name>& names, const Name& name, const KnownName& known) {
    return std::none_of(names.begin(), names.end(), [&](const Name& other) {
        const auto meant = known_name(other.plain);
        return meant && meant->ours == known.ours &&
               (meant->rank < known.rank || (meant->rank == known.rank && &other < &name));
    });
}

Column column_of(const Source& source, const std::vector<Name>& names, const Name& name) {
    Column column{name, name.text, false, false, {}};
    if (name.text.empty())
        column.values = NoNumbers();
    const auto known = known_name(name.plain);
    if (known && known->ours != "velocity" && means_most(names, name, *known)) {
        const std::string_view unit = unit_of(known->ours);
        check_unit(source, name, unit);
        column.array = known->ours;
        column.is_needed = true;
        if (!unit.empty())
            column.values = std::vector<double>();
    }
    return column;
}

void check_unique(const Source& source, std::vector<std::string> names, const char* found) {
    names.erase(std::remove(names.begin(), names.end(), ""), names.end());
    if (const auto repeated = repeated_name(std::move(names)))
        fail(source, *repeated, "one such column", found);
}

std::string listed(const std::vector<Name>& names) {
    std::string list;
    for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 20); ++i)
        list += (i == 0 ? "" : ", ") + quoted_text(names[i].text);
    return list + (names.size() > 20 ? ", ..." : "");
}

/// The table that a header promises, without rows.
Table table_of(const Source& source, const Header& header) {
    std::vector<std::string> texts;
    for (const Name& name : header.names)
        texts.push_back(name.text);
    check_unique(source, texts, "two of the same name; rename or remove one");
    const Axes positions = find_positions(header.names);
    if (!positions[0])
        fail(source, "", "a column x of the positions", "columns " + listed(header.names));
    Table table;
    for (const Name& name : header.names)
        table.columns.push_back(column_of(source, header.names, name));
    table.position = ordered(positions, positions);
    table.plane_is_xz = !positions[1];
    table.velocity = find_velocity(header.names, positions);
    claim(source, table, table.position, "m");
    claim(source, table, table.velocity, "m/s");

    std::vector<std::string> arrays{table.velocity.empty() ? "" : "velocity"};
    for (const Column& column : table.columns)
        arrays.push_back(column.array);
    check_unique(source, arrays, "several columns that mean it; rename or remove all but one");
    return table;
}

/// Adds a number; false where the cell is none.
bool append_number(Column& column, std::string_view cell) {
    if (auto* integers = std::get_if<std::vector<std::int64_t>>(&column.values)) {
        std::int64_t integer = 0;
        if (read_number(cell, integer) == std::errc()) {
            integers->push_back(integer);
            return true;
        }
    }
    double real = 0;
    if (read_number(cell, real) != std::errc())
        return false;
    if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&column.values))
        column.values = std::vector<double>(integers->begin(), integers->end());
    std::get<std::vector<double>>(column.values).push_back(real);
    return true;
}

/// A column that begins with text is one of text all along, so that a slip in a number is found.
/// One that nothing needs is left out where it has empty cells.
void append(const Source& source, Column& column, std::string_view cell) {
    if (column.is_left_out)
        return;
    if (cell.empty() && !column.is_needed && !column.name.text.empty() &&
        !std::holds_alternative<NoNumbers>(column.values)) {
        column.is_left_out = true;
        column.values = NoNumbers();
        return;
    }
    if (std::holds_alternative<NoNumbers>(column.values)) {
        double number = 0;
        if (!column.name.text.empty() && read_number(cell, number) == std::errc())
            fail(source, column.name.text, "text, as in the lines before", quoted_text(cell));
        return;
    }
    if (append_number(column, cell))
        return;
    const auto* integers = std::get_if<std::vector<std::int64_t>>(&column.values);
    if (column.is_needed || cell.empty() || integers == nullptr || !integers->empty()) {
        fail(source, column.name.text, "a number such as -0.5",
             cell.empty() ? "an empty cell" : quoted_text(cell));
    }
    column.values = NoNumbers();
}

void read_row(const Source& source, std::string_view line, char separator, Table& table) {
    Cells cells{line, separator};
    for (Column& column : table.columns) {
        if (!cells.more) {
            // A separator at the end of the header need not be in every line.
            if (&column == &table.columns.back() && column.name.text.empty())
                return;
            fail(source, column.name.text, "a cell", "the end of the line");
        }
        const auto cell = take_cell(cells);
        if (!cell) {
            fail(source, column.name.text, "a cell that is in quotes as a whole or not at all",
                 quoted_text(cells.rest));
        }
        append(source, column, *cell);
    }
    if (cells.more) {
        fail(source, "",
             std::to_string(table.columns.size()) + " cells, the last of column " +
                 quoted_text(table.columns.back().name.text),
             "more: " + quoted_text(cells.rest));
    }
}

void read_rows(Source& source, char separator, Table& table) {
    while (!source.rest.empty()) {
        const std::string_view line = take_line(source);
        if (!line.empty())
            read_row(source, line, separator, table);
        else if (source.rest.find_first_not_of(" \r\n") != std::string_view::npos)
            fail(source, "", "cells", "an empty line");
        else
            return;
    }
}

/// Three numbers a particle, column by column; those of missing columns are 0.
std::vector<double> interleaved(const Table& table, const std::vector<std::size_t>& columns) {
    std::vector<double> vectors;
    for (std::size_t component = 0; component < columns.size(); ++component) {
        const auto& values =
            std::get<std::vector<double>>(table.columns[columns[component]].values);
        vectors.resize(3 * values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            vectors[3 * i + component] = values[i];
    }
    return vectors;
}

void set_positions(Snapshot& snapshot, const Table& table) {
    const std::vector<double> coordinates = interleaved(table, table.position);
    snapshot.positions.resize(coordinates.size() / 3);
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
        std::copy_n(coordinates.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                    snapshot.positions[i].begin());
    }
    snapshot.dimension_is_stated = table.position.size() == 2;
    snapshot.dimension = snapshot.dimension_is_stated ? 2 : dimension_of(snapshot.positions);
}

/// What the person who reads the file should know of its columns.
void add_notes(Snapshot& snapshot, const Table& table) {
    std::string left_out;
    for (const Column& column : table.columns)
        if (column.is_left_out)
            left_out += (left_out.empty() ? "" : ", ") + quoted_text(column.name.text);
    if (!left_out.empty())
        snapshot.notes.push_back("left out for empty cells: " + left_out);
    if (table.plane_is_xz)
        snapshot.notes.push_back("2D in the plane xz, taken as x, y");
}

Snapshot snapshot_of(Table& table) {
    Snapshot snapshot;
    set_positions(snapshot, table);
    if (!table.velocity.empty())
        snapshot.point_data.push_back({"velocity", 3, interleaved(table, table.velocity)});
    for (Column& column : table.columns) {
        if (column.array.empty())
            continue;
        if (auto* integers = std::get_if<std::vector<std::int64_t>>(&column.values))
            snapshot.point_data.push_back({column.array, 1, std::move(*integers)});
        else if (auto* reals = std::get_if<std::vector<double>>(&column.values))
            snapshot.point_data.push_back({column.array, 1, std::move(*reals)});
    }
    return snapshot;
}

/// True where one of the first lines names columns with positions.
bool is_csv(const fs::path& file) {
    const std::string bytes = read_whole(file, max_header_bytes);
    Source source = source_of(file, bytes);
    return find_header(source).has_value();
}

/// Reads positions, point data, and the time where PartVTK wrote it. Without a column z the
/// snapshot is two-dimensional; without y too, with z for the second coordinate. Throws InputError,
/// naming the line and the column, where a cell is missing, one too many, or no number; where two
/// columns have one name; where a unit is not the SI's; and where the file does not end with a line
/// break, since it may then be cut within a number. A file that is cut at the end of a line cannot
/// be told from a whole one. Memory is bounded by the file's own size.
Snapshot read_csv(const fs::path& file, const ReadChoices& /*choices*/) {
    const std::string bytes = read_whole(file);
    Source source = source_of(file, bytes);
    const std::optional<Header> header = find_header(source);
    if (!header) {
        fail(source, "", "a line up to here that names columns of positions, such as 'x,y,z'",
             "none");
    }
    if (source.rest.empty() && bytes.back() != '\n')
        fail(source, "", "a line break behind the names", "none; export the file again");
    check_end(source, header->separator);
    double time = 0;
    if (header->time && (read_number(*header->time, time) != std::errc() || !std::isfinite(time)))
        fail(source, "", "the time in the line after TimeStep", quoted_text(*header->time));
    Table table = table_of(source, *header);
    read_rows(source, header->separator, table);
    Snapshot snapshot = snapshot_of(table);
    add_notes(snapshot, table);
    snapshot.time = header->time ? std::make_optional(time) : std::nullopt;
    return snapshot;
}

} // namespace

SnapshotFormat csv_format() {
    return {"CSV with columns x, y and z", is_csv, read_csv};
}

} // namespace meniscus
