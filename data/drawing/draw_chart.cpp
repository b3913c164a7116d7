#include "draw_chart.hpp"

#include "detail/chart_axis.hpp"
#include "detail/chart_cloud.hpp"
#include "name_places.hpp"

#include <algorithm>

namespace meniscus {
namespace {

/// Of series, in their order; after the last they begin again. Okabe and Ito's for the color-blind,
/// without the yellow that is lost on white.
constexpr std::array<Color, 8> colors = {
    Color{0, 114, 178},  Color{213, 94, 0},  Color{0, 158, 115}, Color{204, 121, 167},
    Color{86, 180, 233}, Color{230, 159, 0}, Color{0, 0, 0},     Color{153, 153, 153}};
constexpr Color faint = {221, 221, 221};

constexpr double dot_radius = 3.5;
constexpr double title_height = 26;
constexpr double row_height = 18; ///< of the legend
constexpr double edge = 12;

struct LegendEntry {
    std::string name;
    Color color;
    Mark mark;
    bool is_filled;
};

bool has_filled(const ChartSeries& series) {
    return std::any_of(series.points.begin(), series.points.end(),
                       [](const ChartPoint& point) { return point.is_filled; });
}

/// The series that have a name, once each, with their colors.
std::vector<LegendEntry> legend_of(const Chart& chart) {
    std::vector<LegendEntry> legend;
    for (const ChartPanel& panel : chart.panels)
        for (const ChartSeries& series : panel.series) {
            const bool is_known = std::any_of(legend.begin(), legend.end(), [&](const auto& one) {
                return one.name == series.name;
            });
            if (!is_known && !series.name.empty())
                legend.push_back({series.name,
                                  series.color.value_or(colors[legend.size() % colors.size()]),
                                  series.mark, series.mark == Mark::cloud || has_filled(series)});
        }
    return legend;
}

Color color_of(const ChartSeries& series, const std::vector<LegendEntry>& legend) {
    for (const LegendEntry& entry : legend)
        if (entry.name == series.name)
            return entry.color;
    return series.color.value_or(colors[0]);
}

std::vector<double> values_of(const ChartPanel& panel, double ChartPoint::*coordinate) {
    std::vector<double> values;
    for (const ChartSeries& series : panel.series)
        if (series.mark != Mark::line)
            for (const ChartPoint& point : series.points)
                values.push_back(point.*coordinate);
    return values;
}

/// One panel in its frame, as it is drawn.
struct PanelDrawing {
    const ChartPanel& panel;
    Scale x, y;
    DrawingFrame frame = {};

    [[nodiscard]] DrawingPoint place(const ChartPoint& point) const {
        return {frame.low.x + x.share(point.x) * (frame.high.x - frame.low.x),
                frame.high.y - y.share(point.y) * (frame.high.y - frame.low.y)};
    }
};

/// Tick labels and the axis' own beside them.
double left_margin(const Scale& y) {
    double width = 0;
    for (const Tick& tick : y.ticks)
        width = std::max(width, lettering_width(tick.text));
    return edge + 18 + width;
}

void add_axes(const PanelDrawing& drawn, Drawing& drawing) {
    const auto& [low, high] = drawn.frame;
    auto& shapes = drawing.shapes;
    for (const Tick& tick : drawn.x.ticks) {
        const double x = low.x + drawn.x.share(tick.value) * (high.x - low.x);
        shapes.emplace_back(Stroke{{{x, low.y}, {x, high.y}}, faint, 0.8});
        shapes.emplace_back(Lettering{{x, high.y + 11}, tick.text, ink, Anchor::middle});
    }
    for (const Tick& tick : drawn.y.ticks) {
        const double y = high.y - drawn.y.share(tick.value) * (high.y - low.y);
        shapes.emplace_back(Stroke{{{low.x, y}, {high.x, y}}, faint, 0.8});
        shapes.emplace_back(Lettering{{low.x - 5, y}, tick.text, ink, Anchor::end});
    }
    shapes.emplace_back(
        Stroke{{low, {high.x, low.y}, high, {low.x, high.y}, low}, {120, 120, 120}, 1});
    const double middle = (low.x + high.x) / 2;
    shapes.emplace_back(Lettering{{middle, high.y + 28}, drawn.panel.x.label, ink, Anchor::middle});
    shapes.emplace_back(Lettering{{low.x - left_margin(drawn.y) + edge, (low.y + high.y) / 2},
                                  drawn.panel.y.label,
                                  ink,
                                  Anchor::middle,
                                  true});
    if (!drawn.panel.title.empty())
        shapes.emplace_back(
            Lettering{{middle, low.y - 10}, drawn.panel.title, ink, Anchor::middle});
}

/// The part of a segment inside the frame; nothing where none is.
std::optional<Stroke> clipped(DrawingPoint a, DrawingPoint b, const DrawingFrame& frame,
                              Stroke stroke) {
    double begin = 0;
    double end = 1;
    const auto keep = [&](double from, double to, double low, double high) {
        if (from == to)
            return from >= low && from <= high;
        const double at_low = (low - from) / (to - from);
        const double at_high = (high - from) / (to - from);
        begin = std::max(begin, std::min(at_low, at_high));
        end = std::min(end, std::max(at_low, at_high));
        return begin < end;
    };
    if (!keep(a.x, b.x, frame.low.x, frame.high.x) || !keep(a.y, b.y, frame.low.y, frame.high.y))
        return std::nullopt;
    stroke.points = {{a.x + begin * (b.x - a.x), a.y + begin * (b.y - a.y)},
                     {a.x + end * (b.x - a.x), a.y + end * (b.y - a.y)}};
    return stroke;
}

void add_line(const PanelDrawing& drawn, const ChartSeries& series, const Color& color,
              Drawing& drawing) {
    const bool is_line = series.mark == Mark::line;
    Stroke whole{{}, color, is_line ? 2.0 : 1.2};
    for (const ChartPoint& point : series.points)
        whole.points.push_back(drawn.place(point));
    if (!is_line) {
        drawing.shapes.emplace_back(whole);
        return;
    }
    for (std::size_t k = 1; k < series.points.size(); ++k)
        if (const auto part = clipped(whole.points[k - 1], whole.points[k], drawn.frame, whole))
            drawing.shapes.emplace_back(*part);
}

void add_dots(const PanelDrawing& drawn, const ChartSeries& series, const Color& color,
              Drawing& drawing) {
    // Where they stand closely, smaller ones.
    const double radius = series.points.size() > 60 ? dot_radius / 2 : dot_radius;
    for (const ChartPoint& point : series.points)
        drawing.shapes.emplace_back(Dot{drawn.place(point), radius, color, point.is_filled});
}

/// Names of all series, those of filled points first.
void add_names(const PanelDrawing& drawn, const std::vector<LegendEntry>& legend,
               Drawing& drawing) {
    std::vector<NamedPoint> points;
    std::vector<Color> of_point;
    for (const bool is_filled : {true, false})
        for (const ChartSeries& series : drawn.panel.series)
            if (series.mark == Mark::dots || series.mark == Mark::joined)
                for (const ChartPoint& point : series.points)
                    if (point.is_filled == is_filled) {
                        points.push_back({drawn.place(point), point.name, is_filled});
                        of_point.push_back(color_of(series, legend));
                    }
    const std::vector<NamePlace> places = name_places(points, drawn.frame);
    for (std::size_t k = 0; k < places.size(); ++k) {
        Lettering lettering = places[k].lettering;
        if (lettering.text.empty())
            continue;
        lettering.color = of_point[k];
        if (places[k].is_far)
            drawing.shapes.emplace_back(
                Stroke{{points[k].place, lettering.place}, {190, 190, 190}, 0.7});
        drawing.shapes.emplace_back(lettering);
    }
}

void add_panel(const PanelDrawing& drawn, const std::vector<LegendEntry>& legend,
               Drawing& drawing) {
    std::vector<Cloud> clouds;
    for (const ChartSeries& series : drawn.panel.series) {
        if (series.mark != Mark::cloud)
            continue;
        clouds.push_back({color_of(series, legend), {}});
        for (const ChartPoint& point : series.points)
            clouds.back().places.push_back(drawn.place(point));
    }
    if (!clouds.empty())
        drawing.shapes.emplace_back(mosaic_of(clouds, drawn.frame));
    add_axes(drawn, drawing);
    for (const ChartSeries& series : drawn.panel.series) {
        const Color color = color_of(series, legend);
        if (series.mark == Mark::joined || series.mark == Mark::line)
            add_line(drawn, series, color, drawing);
        if (series.mark == Mark::joined || series.mark == Mark::dots)
            add_dots(drawn, series, color, drawing);
    }
    add_names(drawn, legend, drawing);
}

double entry_width(const LegendEntry& entry) {
    return 20 + lettering_width(entry.name) + 18;
}

/// Rows of entries from a height on; returns the height below them.
double add_legend(const std::vector<LegendEntry>& legend, double top, Drawing& drawing) {
    double x = edge + 20;
    double y = top + row_height / 2;
    for (const LegendEntry& entry : legend) {
        if (x + entry_width(entry) > drawing.width && x > edge + 20) {
            x = edge + 20;
            y += row_height;
        }
        if (entry.mark == Mark::joined || entry.mark == Mark::line)
            drawing.shapes.emplace_back(Stroke{{{x, y}, {x + 14, y}}, entry.color, 1.5});
        if (entry.mark != Mark::line)
            drawing.shapes.emplace_back(Dot{{x + 7, y}, dot_radius, entry.color, entry.is_filled});
        drawing.shapes.emplace_back(Lettering{{x + 20, y}, entry.name, ink});
        x += entry_width(entry);
    }
    return legend.empty() ? top : y + row_height / 2;
}

} // namespace

Drawing draw_chart(const Chart& chart) {
    const auto count = static_cast<int>(chart.panels.size());
    const int panel_width = count == 1 ? 860 : 460;
    const double panel_height = count == 1 ? 480 : 400;
    const bool has_titles = std::any_of(chart.panels.begin(), chart.panels.end(),
                                        [](const auto& panel) { return !panel.title.empty(); });
    Drawing drawing{count * panel_width, 0, {}};
    const double top = edge + (chart.title.empty() ? 0 : title_height) + (has_titles ? 20 : 0);
    const std::vector<LegendEntry> legend = legend_of(chart);
    if (!chart.title.empty())
        drawing.shapes.emplace_back(
            Lettering{{drawing.width / 2.0, edge + 6}, chart.title, ink, Anchor::middle});
    for (int k = 0; k < count; ++k) {
        const ChartPanel& panel = chart.panels[static_cast<std::size_t>(k)];
        PanelDrawing drawn{panel, scale_of(panel.x, values_of(panel, &ChartPoint::x)),
                           scale_of(panel.y, values_of(panel, &ChartPoint::y))};
        drawn.frame = {{k * panel_width + left_margin(drawn.y), top},
                       {(k + 1) * panel_width - edge, top + panel_height}};
        add_panel(drawn, legend, drawing);
    }
    const double below = add_legend(legend, top + panel_height + 40, drawing);
    drawing.height = static_cast<int>(below + edge);
    return drawing;
}

} // namespace meniscus
