#include "table_chart.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/printable.hpp>

namespace meniscus {
namespace {

/// Columns that one panel shows: the name as a whole, where there is one, else its parts.
std::vector<std::size_t> columns_of(const TextTable& table, const std::string& names) {
    if (const auto whole = table.find(names))
        return {*whole};
    std::vector<std::size_t> columns;
    for (std::size_t begin = 0; begin <= names.size();) {
        const std::size_t end = std::min(names.find(',', begin), names.size());
        columns.push_back(table.column(names.substr(begin, end - begin)));
        begin = end + 1;
    }
    return columns;
}

struct ChosenColumns {
    std::size_t x = 0;
    std::optional<std::size_t> y; ///< nothing: rows below each other
    std::optional<std::size_t> series, names, panel, best;
};

std::string text_at(const TextTable& table, std::size_t row, std::optional<std::size_t> column) {
    return column ? printable(table.rows[row][*column], 200) : "";
}

std::string with_colon(const std::string& a, const std::string& b) {
    return a.empty() || b.empty() ? a + b : a + ": " + b;
}

void add_column(const TextTable& table, const ChosenColumns& columns,
                const TableChartOptions& options, const std::string& label,
                const std::string& series, Chart& chart) {
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto x = table.figure(row, columns.x);
        const auto y =
            columns.y ? table.figure(row, *columns.y) : std::optional(-static_cast<double>(row));
        if (!x || !y)
            continue;
        // Panels are told apart by their titles; those of several columns by their labels.
        const std::string title =
            with_colon(text_at(table, row, columns.panel), options.y.size() > 1 ? label : "");
        ChartPanel& panel = panel_of(
            chart,
            {title,
             {printable(table.columns[columns.x].heading), options.is_logarithmic_x},
             {label, options.is_logarithmic_y && columns.y.has_value(), !columns.y.has_value()}});
        const std::string name = with_colon(series, text_at(table, row, columns.series));
        series_of(panel, {name, {}, options.is_joined ? Mark::joined : Mark::dots})
            .points.push_back({*x, *y, text_at(table, row, columns.names),
                               !columns.best || text_at(table, row, columns.best) == "yes"});
    }
}

} // namespace

void add_table(const TextTable& table, const TableChartOptions& options, const std::string& prefix,
               Chart& chart) {
    const auto optional = [&](const std::string& name) {
        return name.empty() ? std::nullopt : std::optional(table.column(name));
    };
    ChosenColumns columns{table.column(options.x),  std::nullopt,
                          optional(options.series), optional(options.names),
                          optional(options.panel),  table.find("best")};
    if (options.y.empty())
        add_column(table, columns, options, "", prefix, chart);
    for (const std::string& names : options.y) {
        const std::vector<std::size_t> shown = columns_of(table, names);
        std::string label;
        for (const std::size_t column : shown)
            label += (label.empty() ? "" : ", ") + printable(table.columns[column].heading);
        for (const std::size_t column : shown) {
            columns.y = column;
            add_column(table, columns, options, label,
                       with_colon(prefix, shown.size() > 1 ? table.columns[column].heading : ""),
                       chart);
        }
    }
}

} // namespace meniscus
