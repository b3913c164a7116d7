// An axis of a chart: which numbers it goes through, where each stands, and where ticks are.
#pragma once

#include <meniscus/data/drawing/chart.hpp>

#include <optional>
#include <string>
#include <vector>

namespace meniscus {

struct Tick {
    double value = 0;
    std::string text;
};

struct Scale {
    double low = 0; ///< numbers, or their logarithms to base 10
    double high = 1;
    bool is_logarithmic = false;
    std::optional<double> zero = {}; ///< where zeros stand on a logarithmic axis
    std::vector<Tick> ticks = {};

    /// How far along the axis a number stands, 0 to 1.
    [[nodiscard]] double share(double value) const;
};

/// For the numbers, of which there is at least one.
Scale scale_of(const ChartAxis& axis, const std::vector<double>& values);

} // namespace meniscus
