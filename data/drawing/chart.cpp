#include "chart.hpp"

#include <algorithm>

namespace meniscus {
namespace {

/// The entry of that name, added where there is none.
template <class Named>
Named& entry_of(std::vector<Named>& all, const Named& empty, std::string Named::*name) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Named& one) { return one.*name == empty.*name; });
    return found != all.end() ? *found : all.emplace_back(empty);
}

} // namespace

ChartPanel& panel_of(Chart& chart, const ChartPanel& empty) {
    return entry_of(chart.panels, empty, &ChartPanel::title);
}

ChartSeries& series_of(ChartPanel& panel, const ChartSeries& empty) {
    return entry_of(panel.series, empty, &ChartSeries::name);
}

} // namespace meniscus
