#include "text_table.hpp"

#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/spelling.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

constexpr const char* expected =
    "expected the log of a run (CSV), or a table as meniscus_bench writes it (Markdown or JSON)";

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    const std::size_t end = text.find_last_not_of(" \t\r");
    return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

std::vector<std::string> split(const std::string& text, char between) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(between, begin), text.size());
        parts.push_back(trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return parts;
}

/// Adds a row of cells, the first of which are the headings.
void add_row(const std::vector<std::string>& cells, TextTable& table) {
    if (table.columns.empty()) {
        for (const std::string& cell : cells)
            table.columns.push_back({cell, cell});
        return;
    }
    if (cells.size() != table.columns.size())
        throw InputError("row " + std::to_string(table.rows.size() + 1) + " has " +
                         std::to_string(cells.size()) + " cells, expected " +
                         std::to_string(table.columns.size()) + " as there are columns");
    table.rows.push_back(cells);
}

std::vector<TextTable> tables_of_csv(const std::vector<std::string>& lines) {
    TextTable table;
    table.name = "1";
    for (const std::string& line : lines)
        if (!line.empty())
            add_row(split(line, ','), table);
    table.is_log = table.find("frame") && table.find("time");
    return {table};
}

bool is_rule(const std::string& line) {
    return line.find("---") != std::string::npos &&
           line.find_first_not_of("|-: ") == std::string::npos;
}

/// The text of a heading, or of a line in bold; empty for any other.
std::string title_of(const std::string& line) {
    const std::size_t begin = line.find_first_not_of("#*");
    if (begin == 0 || begin == std::string::npos)
        return "";
    const std::string text = line.substr(begin);
    return trimmed(text.substr(0, text.find("**")));
}

/// A table's title is that of the last line of text before it.
std::vector<TextTable> tables_of_markdown(const std::vector<std::string>& lines) {
    std::vector<TextTable> tables;
    std::string title;
    bool is_inside = false;
    for (const std::string& line : lines) {
        const bool is_row = line.size() > 1 && line[0] == '|';
        if (is_row && !is_inside) {
            tables.emplace_back();
            tables.back().name = std::to_string(tables.size());
            tables.back().title = title;
        }
        if (is_row && !is_rule(line))
            add_row(split(line.substr(1, line.rfind('|') - 1), '|'), tables.back());
        if (!is_row && !line.empty() && line[0] != '<') // no comment
            title = title_of(line);
        is_inside = is_row;
    }
    return tables;
}

/// A figure, a time's median, or the first of several figures.
std::string cell_of(const Json& value) {
    if (value.is_string())
        return value.get<std::string>();
    if (value.is_number())
        return number_text(value.get<double>());
    if (value.is_object() && value.contains("median"))
        return cell_of(value["median"]);
    if (value.is_array() && !value.empty())
        return cell_of(value.front());
    return "-";
}

TextTable table_of_json(const JsonReader& json, const std::string& file) {
    TextTable table;
    table.name = json.text("name");
    table.title = json.text("title");
    for (const JsonReader& column : json.objects("columns"))
        table.columns.push_back({column.text("key"), column.text("heading")});
    for (const Json& row : json.value("rows")) {
        if (!row.is_object())
            throw InputError(file + ": " + expected);
        table.rows.emplace_back();
        for (const TextColumn& column : table.columns)
            table.rows.back().push_back(row.contains(column.key) ? cell_of(row[column.key]) : "-");
    }
    return table;
}

std::vector<TextTable> tables_of_json(const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file, "tables of meniscus_bench");
    if (!json.is_object() || !json.contains("tables"))
        throw InputError(expected);
    std::vector<TextTable> tables;
    for (const JsonReader& table : JsonReader(json, file, "").objects("tables"))
        tables.push_back(table_of_json(table, file));
    return tables;
}

std::vector<TextTable> tables_of(const std::string& text, const std::string& file) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos)
        throw InputError(std::string("is empty; ") + expected);
    if (text[first] == '{' || text[first] == '[')
        return tables_of_json(text, file);
    const std::vector<std::string> lines = split(text, '\n');
    const bool has_markdown = std::any_of(lines.begin(), lines.end(), is_rule);
    return has_markdown ? tables_of_markdown(lines) : tables_of_csv(lines);
}

} // namespace

std::optional<std::size_t> TextTable::find(const std::string& name) const {
    for (std::size_t k = 0; k < columns.size(); ++k)
        if (columns[k].key == name || columns[k].heading == name)
            return k;
    return std::nullopt;
}

std::size_t TextTable::column(const std::string& name) const {
    if (const auto place = find(name))
        return *place;
    std::vector<std::string> names;
    for (const TextColumn& column : columns)
        names.push_back(column.key);
    const std::string meant = likely_spelling(name, names);
    throw InputError("no column " + quoted_text(name) +
                     (meant.empty() ? "." : ", did you mean " + quoted_text(meant) + "?") +
                     " There are: " + columns_text(*this));
}

std::optional<double> TextTable::figure(std::size_t row, std::size_t column) const {
    std::string text = rows[row][column];
    text.erase(0, std::min(text.find_first_not_of("*+"), text.size()));
    const std::string first = text.substr(0, text.find_first_of(" *%,/"));
    if (first.empty() || first == "-")
        return std::nullopt;
    const auto number = number_from_text(first);
    if (!number)
        throw InputError("row " + std::to_string(row + 1) + ", column " +
                         quoted_text(columns[column].key) + ": " + quoted_text(rows[row][column]) +
                         " is no number");
    return std::isfinite(*number) ? number : std::nullopt;
}

std::string columns_text(const TextTable& table) {
    std::string all;
    for (const TextColumn& column : table.columns)
        all += (all.empty() ? "" : "; ") + column.key;
    return printable(all, 300);
}

std::vector<TextTable> read_tables(const std::filesystem::path& file) {
    return naming_file(file, [&] {
        std::vector<TextTable> tables = tables_of(read_whole(file), file.string());
        if (std::all_of(tables.begin(), tables.end(),
                        [](const TextTable& table) { return table.rows.empty(); }))
            throw InputError(std::string("has no rows; ") + expected);
        return tables;
    });
}

} // namespace meniscus
