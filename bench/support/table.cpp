#include "table.hpp"

#include <meniscus/data/text/printable.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace meniscus {
namespace {

std::string number_cell(double value, int digits) {
    std::string text = fmt::format("{:.{}g}", value, digits);
    if (text.find('e') == std::string::npos)
        return text;
    return fmt::format("{:.0f}", value).size() <= 9 && std::abs(value) >= 1
               ? fmt::format("{:.0f}", value)
               : text;
}

std::string number_text(double value, const Column& column) {
    return column.format.empty() ? number_cell(value, column.digits)
                                 : fmt::format(fmt::runtime(column.format), value);
}

std::string cell_text(const Cell& cell, const Column& column) {
    if (const auto* text = std::get_if<std::string>(&cell))
        return printable(*text);
    if (const auto* number = std::get_if<double>(&cell))
        return number_text(*number, column);
    if (const auto* time = std::get_if<RepeatedTime>(&cell))
        return fmt::format("{} ({} to {})", number_text(time->median, column),
                           number_text(time->lower, column), number_text(time->upper, column));
    const auto* figures = std::get_if<Figures>(&cell);
    std::string text = figures != nullptr ? "" : "-";
    for (std::size_t k = 0; figures != nullptr && k < figures->size(); ++k)
        text += (k > 0 ? " / " : "") + number_text((*figures)[k], column);
    return text;
}

nlohmann::json cell_json(const Cell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell))
        return printable(*text);
    if (const auto* number = std::get_if<double>(&cell))
        return *number;
    if (const auto* time = std::get_if<RepeatedTime>(&cell))
        return {{"median", time->median}, {"lower", time->lower}, {"upper", time->upper}};
    if (const auto* figures = std::get_if<Figures>(&cell))
        return *figures;
    return nullptr;
}

/// Of a row, in the columns by which it is judged.
using Judged = std::vector<std::optional<double>>;

bool has_all(const Judged& figures) {
    return std::all_of(figures.begin(), figures.end(), [](const auto& f) { return bool(f); });
}

/// True where `one` is nowhere worse than `other` and better somewhere.
bool beats(const Judged& one, const Judged& other) {
    bool is_better = false;
    for (std::size_t k = 0; k < one.size(); ++k) {
        if (*one[k] > *other[k])
            return false;
        is_better = is_better || *one[k] < *other[k];
    }
    return is_better;
}

/// Nothing where the column has none that is to be marked.
std::optional<double> bold_figure(const Table& table, std::size_t column) {
    std::optional<double> min;
    for (const auto& row : table.rows)
        if (const auto value = figure(row[column]); value && table.columns[column].bold_min)
            min = std::min(min.value_or(*value), *value);
    return min;
}

} // namespace

Table table_of(const std::string& name, const std::string& columns) {
    Table table{name, "", {}, {}};
    const std::string between = " | ";
    for (std::size_t begin = 0; begin < columns.size();) {
        const std::size_t end = std::min(columns.find(between, begin), columns.size());
        const std::string column = columns.substr(begin, end - begin);
        const std::size_t format = std::min(column.find(" {"), column.size());
        std::string heading = column.substr(0, format);
        std::string key = heading;
        for (const Column& other : table.columns)
            if (other.heading == heading)
                key = fmt::format("{} ({})", heading, table.columns.size() + 1);
        table.columns.push_back(
            {key, heading, 3, format < column.size() ? column.substr(format + 1) : ""});
        begin = end + between.size();
    }
    return table;
}

Table titled_table(const std::string& name, const std::string& title, const std::string& columns) {
    Table table = table_of(name, columns);
    table.title = title;
    table.before = fmt::format("\n**{}**\n\n", title);
    return table;
}

Table text_alone(const std::string& text) {
    Table table;
    table.before = text;
    return table;
}

std::optional<double> figure(const Cell& cell) {
    if (const auto* number = std::get_if<double>(&cell))
        return *number;
    if (const auto* time = std::get_if<RepeatedTime>(&cell))
        return time->median;
    return std::nullopt;
}

std::size_t Table::column(const std::string& key) const {
    for (std::size_t k = 0; k < columns.size(); ++k)
        if (columns[k].key == key)
            return k;
    throw std::invalid_argument("table " + name + " has no column " + key);
}

void mark_best(Table& table, const std::vector<std::string>& keys, const std::string& group) {
    std::vector<Judged> figures;
    for (const auto& row : table.rows) {
        figures.emplace_back();
        for (const std::string& key : keys)
            figures.back().push_back(figure(row[table.column(key)]));
    }
    const auto comparable = [&](std::size_t a, std::size_t b) {
        return group.empty() || std::get<std::string>(table.rows[a][table.column(group)]) ==
                                    std::get<std::string>(table.rows[b][table.column(group)]);
    };
    std::vector<std::string> marks;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        bool is_best = has_all(figures[row]);
        for (std::size_t other = 0; is_best && other < table.rows.size(); ++other)
            is_best = !(has_all(figures[other]) && comparable(row, other) &&
                        beats(figures[other], figures[row]));
        marks.emplace_back(is_best ? "yes" : "");
    }
    table.columns.push_back({"best", "best"});
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        table.rows[row].emplace_back(marks[row]);
}

std::vector<std::string> texts_of(const Table& table, const std::vector<Cell>& row) {
    std::vector<std::string> texts;
    for (std::size_t k = 0; k < row.size(); ++k)
        texts.push_back(cell_text(row[k], table.columns[k]));
    return texts;
}

std::string markdown(const Table& table) {
    if (table.columns.empty())
        return "";
    std::string text = "|";
    std::string rule = "|";
    std::vector<std::optional<double>> bold;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        text += " " + table.columns[k].heading + " |";
        rule += "---|";
        bold.push_back(bold_figure(table, k));
    }
    text += "\n" + rule + "\n";
    for (const auto& row : table.rows) {
        text += "|";
        for (std::size_t k = 0; k < row.size(); ++k) {
            const char* mark = bold[k] && figure(row[k]) == bold[k] ? "**" : "";
            text += " " + (mark + cell_text(row[k], table.columns[k]) + mark) + " |";
        }
        text += "\n";
    }
    return text;
}

nlohmann::json to_json(const Table& table) {
    nlohmann::json columns = nlohmann::json::array();
    for (const Column& column : table.columns)
        columns.push_back({{"key", column.key}, {"heading", column.heading}});
    nlohmann::json rows = nlohmann::json::array();
    for (const auto& row : table.rows) {
        nlohmann::json object;
        for (std::size_t k = 0; k < row.size(); ++k)
            object[table.columns[k].key] = cell_json(row[k]);
        rows.push_back(object);
    }
    return {{"name", table.name}, {"title", table.title}, {"columns", columns}, {"rows", rows}};
}

} // namespace meniscus
