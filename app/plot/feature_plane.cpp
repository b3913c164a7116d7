#include "feature_plane.hpp"

#include <meniscus/app/features/model_features.hpp>
#include <meniscus/app/picture/class_colors.hpp>
#include <meniscus/data/formats/snapshot_files.hpp>

#include <algorithm>
#include <fmt/format.h>

namespace meniscus {
namespace {

/// Series of a plane in the order in which they are drawn.
struct Kind {
    enum : std::size_t { interior, passed, surface, missed };
};

ChartPanel empty_panel(const FeaturePair& features) {
    ChartPanel panel{"", {feature_list[features.first].name}, {feature_list[features.second].name}};
    panel.series = {{"interior", {}, Mark::cloud, interior_color},
                    {"let through", {}, Mark::cloud, passed_color},
                    {"surface", {}, Mark::cloud, surface_color},
                    {"missed", {}, Mark::dots, ink}};
    return panel;
}

/// A line of a model, with the features of a state.
struct Plane {
    const Line& line;
    const std::vector<double>& x;
    const std::vector<double>& y;
    std::array<double, 2> scales;

    [[nodiscard]] ChartPoint point(std::size_t i) const {
        return {x[i] / scales[0], y[i] / scales[1], {}, false};
    }
    [[nodiscard]] bool lets_through(const ChartPoint& point) const {
        return predicts_surface(line, point.x, point.y);
    }
};

/// Adds a state to the panels of all lines.
void add_state(const Model& model, const std::filesystem::path& file, int threads,
               std::vector<ChartPanel>& panels) {
    const Snapshot snapshot = read_snapshot(file);
    const LabelledState state = labelled_state(snapshot, file);
    check_dimension(model, state.dimension, file.string());
    check_radius_ratio(model, state.radius_ratio, file.string());
    check_boundary_weight(model, state.boundary_weight, file.string());
    const auto values = feature_values(snapshot, state, model, threads);
    const auto plane = [&](const Line& line, const FeaturePair& features) {
        return Plane{line, values.at(features.first), values.at(features.second),
                     feature_scales(features, state, model)};
    };
    std::vector<Plane> planes = {plane(model.line, model.features)};
    if (model.second)
        planes.push_back(plane(model.second->line, model.second->features));
    const std::vector<std::size_t> places = places_of_valid(snapshot);
    for (std::size_t entry = 0; entry < places.size(); ++entry) {
        if (state.is_alone(entry))
            continue;
        const bool is_surface = state.uncovered_fraction[entry] > model.label_threshold;
        bool is_candidate = true;
        for (std::size_t p = 0; p < planes.size() && is_candidate; ++p) {
            const ChartPoint point = planes[p].point(places[entry]);
            is_candidate = planes[p].lets_through(point);
            const std::size_t kind = is_surface ? (is_candidate ? Kind::surface : Kind::missed)
                                                : (is_candidate ? Kind::passed : Kind::interior);
            panels[p].series[kind].points.push_back(point);
        }
    }
}

/// Adds the line through all that is shown, and what it errs in as title.
void finish(const Line& line, ChartPanel& panel) {
    double high = 0;
    for (const ChartSeries& series : panel.series)
        for (const ChartPoint& point : series.points)
            high = std::max(high, 1.1 * point.x);
    const auto count = [&](std::size_t kind) { return panel.series[kind].points.size(); };
    panel.title = fmt::format("{} of {} surface particles missed, {} of {} others let through",
                              count(Kind::missed), count(Kind::missed) + count(Kind::surface),
                              count(Kind::passed), count(Kind::passed) + count(Kind::interior));
    panel.series.push_back(
        {"line", {{0, line.d}, {high, line.k * high + line.d}}, Mark::line, ink});
}

} // namespace

Chart feature_planes(const Model& model, const std::vector<std::filesystem::path>& files,
                     int threads) {
    Chart chart;
    chart.panels.push_back(empty_panel(model.features));
    if (model.second)
        chart.panels.push_back(empty_panel(model.second->features));
    for (const auto& file : files)
        add_state(model, file, threads, chart.panels);
    finish(model.line, chart.panels[0]);
    if (model.second)
        finish(model.second->line, chart.panels[1]);
    return chart;
}

} // namespace meniscus
