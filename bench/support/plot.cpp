#include "plot.hpp"

#include <meniscus/data/drawing/draw_chart.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/printable.hpp>

namespace meniscus {
namespace {

std::string text_of(const Table& table, const std::vector<Cell>& row, const std::string& key) {
    return key.empty() ? "" : printable(std::get<std::string>(row[table.column(key)]));
}

Chart chart_of(const Table& table, const Plot& plot) {
    const auto heading = [&](const std::string& key) {
        return table.columns[table.column(key)].heading;
    };
    const bool has_best = table.columns.back().key == "best";
    Chart chart{printable(plot.title)};
    for (const auto& row : table.rows) {
        const auto x = figure(row[table.column(plot.x)]);
        const auto y = figure(row[table.column(plot.y)]);
        if (!x || !y)
            continue;
        ChartPanel& panel = panel_of(chart, {text_of(table, row, plot.panel),
                                             {heading(plot.x), plot.logarithmic_x},
                                             {heading(plot.y), plot.logarithmic_y}});
        series_of(panel,
                  {text_of(table, row, plot.series), {}, plot.joined ? Mark::joined : Mark::dots})
            .points.push_back({*x, *y, text_of(table, row, plot.label),
                               !has_best || text_of(table, row, "best") == "yes"});
    }
    return chart;
}

} // namespace

std::string svg_of(const Table& table, const Plot& plot) {
    const Chart chart = chart_of(table, plot);
    return chart.panels.empty() ? "" : to_svg(draw_chart(chart));
}

void draw(const Table& table, const Plot& plot, const std::filesystem::path& folder) {
    const std::string svg = svg_of(table, plot);
    if (!svg.empty())
        write_whole(folder / plot.file, svg);
}

} // namespace meniscus
