#include "spread.hpp"

#include "measures.hpp"
#include "run_tables.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <variant>

namespace meniscus {
namespace {

struct Mover {
    Place step{};

    void operator()(LatticeShape& shape) const { move(shape.first); }
    void operator()(BoxShape& shape) const {
        move(shape.low);
        move(shape.high);
    }
    void operator()(SphereShape& shape) const { move(shape.center); }
    void operator()(SnapshotShape& shape) const { move(shape.translation); }

private:
    void move(Place& place) const {
        for (int axis = 0; axis < 3; ++axis)
            place[axis] += step[axis];
    }
};

std::vector<std::string> headings_of(const std::string& columns) {
    std::vector<std::string> headings;
    for (const Column& column : table_of("", columns).columns)
        headings.push_back(column.heading);
    return headings;
}

Cell spread_of(const std::vector<double>& values) {
    if (values.empty())
        return {};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return Figures{mean_and_deviation(values).mean, *least, *most};
}

} // namespace

Scene disturbed(Scene scene, double seed) {
    constexpr double golden_angle = 2.39996322972865332;
    const double step = seed == 0 ? 0 : scene.particle_spacing / 1000;
    const Mover mover{
        {step * std::cos(golden_angle * seed), 0, step * std::sin(golden_angle * seed)}};
    std::visit(mover, scene.fluid.back().shape);
    return scene;
}

std::vector<double> Seeds::values(const std::string& figure) const {
    std::vector<double> some;
    for (const Json* run : runs)
        if (const auto value = figure_of(*run, figure))
            some.push_back(*value);
    return some;
}

std::vector<Seeds> by_seeds(const Json& result, const std::vector<std::string>& axes) {
    std::vector<Seeds> groups;
    for (const Json& run : result.at("runs")) {
        std::vector<std::string> labels;
        for (const std::string& axis : axes)
            labels.push_back(label_of(run, axis));
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const Seeds& one) { return one.labels == labels; });
        if (group == groups.end())
            group = groups.insert(groups.end(), {labels, {}});
        group->runs.push_back(&run);
    }
    return groups;
}

Table table_of_spread(const std::string& name, const Json& result, const std::string& axes,
                      const std::string& figures) {
    Table table = table_of(name, axes + " | came to their end | " + figures);
    for (const Seeds& seeds : by_seeds(result, headings_of(axes))) {
        const auto ended = std::count_if(seeds.runs.begin(), seeds.runs.end(), [](const Json* run) {
            return !run->at("figures").contains("failure");
        });
        std::vector<Cell> row(seeds.labels.begin(), seeds.labels.end());
        row.emplace_back(fmt::format("{} of {}", ended, seeds.runs.size()));
        for (const std::string& figure : headings_of(figures))
            row.push_back(spread_of(seeds.values(figure)));
        table.add(row);
    }
    table.before = "Mean / least / most of runs that differ by a thousandth of a spacing.\n\n";
    return table;
}

} // namespace meniscus
