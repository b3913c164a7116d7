// A chart: points over two axes in one panel or several beside each other, with names at the
// points, in the one style of all plots of the project. Colors can be told apart by people of every
// color vision.
#pragma once

#include "image.hpp"

#include <optional>
#include <string>
#include <vector>

namespace meniscus {

struct ChartPoint {
    double x = 0;
    double y = 0;
    std::string name = {}; ///< stands at the point
    bool is_filled = true; ///< or a ring
};

/// How the points of a series are drawn: as dots, with lines between them, as the line alone, or as
/// a cloud of very many, of which each cell shows the mean color, the stronger the more there are.
enum class Mark { dots, joined, line, cloud };

struct ChartSeries {
    std::string name; ///< in the legend, once for all panels; empty: not there
    std::vector<ChartPoint> points = {};
    Mark mark = Mark::dots;
    /// In place of one of the series' own, which those of one name share.
    std::optional<Color> color = {};
};

struct ChartAxis {
    std::string label;
    bool is_logarithmic = false; ///< zeros then stand a decade below the smallest number, marked 0
    bool is_bare = false;        ///< without ticks: rows below each other
};

struct ChartPanel {
    std::string title;
    ChartAxis x;
    ChartAxis y;
    std::vector<ChartSeries> series = {};
};

struct Chart {
    std::string title;
    std::vector<ChartPanel> panels = {};
};

/// The panel, and in it the series, of the name that `empty` has; added as that where there
/// is none.
ChartPanel& panel_of(Chart& chart, const ChartPanel& empty);
ChartSeries& series_of(ChartPanel& panel, const ChartSeries& empty);

} // namespace meniscus
