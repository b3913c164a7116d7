#include "comparison/table.hpp"

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

std::string cell_text(const Cell& cell, int digits) {
    if (const auto* text = std::get_if<std::string>(&cell))
        return *text;
    if (const auto* number = std::get_if<double>(&cell))
        return number_cell(*number, digits);
    if (const auto* time = std::get_if<RepeatedTime>(&cell))
        return fmt::format("{} ({} to {})", number_cell(time->median, digits),
                           number_cell(time->lower, digits), number_cell(time->upper, digits));
    return "-";
}

nlohmann::json cell_json(const Cell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell))
        return *text;
    if (const auto* number = std::get_if<double>(&cell))
        return *number;
    if (const auto* time = std::get_if<RepeatedTime>(&cell))
        return {{"median", time->median}, {"lower", time->lower}, {"upper", time->upper}};
    return nullptr;
}

using Figures = std::vector<std::optional<double>>;

bool has_all(const Figures& figures) {
    return std::all_of(figures.begin(), figures.end(), [](const auto& f) { return bool(f); });
}

/// True where `one` is nowhere worse than `other` and better somewhere.
bool beats(const Figures& one, const Figures& other) {
    bool is_better = false;
    for (std::size_t k = 0; k < one.size(); ++k) {
        if (*one[k] > *other[k])
            return false;
        is_better = is_better || *one[k] < *other[k];
    }
    return is_better;
}

} // namespace

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
    std::vector<Figures> figures;
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

void number_rows(Table& table, const std::string& group) {
    std::string current;
    int number = 0;
    for (auto& row : table.rows) {
        const std::string of_row =
            group.empty() ? "" : std::get<std::string>(row[table.column(group)]);
        number = of_row == current ? number + 1 : 1;
        current = of_row;
        row.insert(row.begin(), Cell{std::to_string(number)});
    }
    table.columns.insert(table.columns.begin(), {"number", "no."});
}

std::string markdown(const Table& table) {
    std::string text = "|";
    for (const Column& column : table.columns)
        text += " " + column.heading + " |";
    text += "\n|";
    for (std::size_t k = 0; k < table.columns.size(); ++k)
        text += "---|";
    text += "\n";
    for (const auto& row : table.rows) {
        text += "|";
        for (std::size_t k = 0; k < row.size(); ++k)
            text += " " + cell_text(row[k], table.columns[k].digits) + " |";
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
