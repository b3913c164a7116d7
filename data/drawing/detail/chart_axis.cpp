#include "chart_axis.hpp"

#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace meniscus {
namespace {

constexpr double margin = 0.04; ///< of the axis, beyond the outermost numbers

Tick tick_at(double value) {
    return {value, rounded_text(value, 6)};
}

/// 1, 2 or 5 times a power of ten, so that some five steps make up the span.
double step_of(double span) {
    const double power = std::pow(10, std::floor(std::log10(span / 5)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (span / (factor * power) <= 7)
            return factor * power;
    return 10 * power;
}

void add_linear_ticks(Scale& scale) {
    const double step = step_of(scale.high - scale.low);
    for (double k = std::ceil(scale.low / step); k * step <= scale.high; ++k)
        scale.ticks.push_back(tick_at(k == 0 ? 0 : k * step));
}

/// Powers of ten, some of them where there are many; 1, 2 and 5 times them where there are few.
void add_logarithmic_ticks(Scale& scale) {
    const double decades = scale.high - scale.low;
    const int every = std::max(1, static_cast<int>(std::ceil(decades / 8)));
    const double first = scale.zero ? std::log10(*scale.zero) + 0.5 : scale.low;
    for (int power = static_cast<int>(std::floor(scale.low)); power <= scale.high; ++power)
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double place = power + std::log10(factor);
            if (place >= first && place <= scale.high && (factor == 1 || decades < 2.5) &&
                power % every == 0)
                scale.ticks.push_back(tick_at(factor * std::pow(10, power)));
        }
    if (scale.zero)
        scale.ticks.push_back({*scale.zero, "0"});
}

double smallest_positive(const std::vector<double>& values) {
    double min = HUGE_VAL;
    for (const double value : values)
        if (value > 0)
            min = std::min(min, value);
    return min == HUGE_VAL ? 10 : min;
}

} // namespace

double Scale::share(double value) const {
    if (is_logarithmic)
        value = std::log10(value > 0 ? value : *zero);
    return (value - low) / (high - low);
}

Scale scale_of(const ChartAxis& axis, const std::vector<double>& values) {
    Scale scale;
    scale.is_logarithmic = axis.is_logarithmic;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    std::array<double, 2> ends = {*low, *high};
    if (axis.is_logarithmic) {
        const double min = smallest_positive(values);
        if (ends[0] <= 0)
            scale.zero = std::pow(10, std::floor(std::log10(min)) - 1);
        ends = {std::log10(scale.zero ? *scale.zero : ends[0]), std::log10(std::max(min, ends[1]))};
    }
    const double span = ends[1] - ends[0];
    const double flat = axis.is_logarithmic || ends[0] == 0 ? 1 : std::abs(ends[0]) / 2;
    const double beyond = span > 1e-9 * std::abs(ends[0]) ? margin * span : flat;
    scale.low = ends[0] - beyond;
    scale.high = ends[1] + beyond;
    if (axis.is_logarithmic)
        add_logarithmic_ticks(scale);
    else if (!axis.is_bare)
        add_linear_ticks(scale);
    return scale;
}

} // namespace meniscus
