#include "inspect_arrays.hpp"

#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <vector>

namespace meniscus {
namespace {

constexpr const char* type_names[] = {"int8",   "uint8", "int16",  "uint16", "int32",
                                      "uint32", "int64", "uint64", "float",  "double"};

/// Bars over equal parts of a range that is none of one number.
std::string histogram(const std::vector<double>& values, double min, double max) {
    constexpr std::size_t parts = 8;
    constexpr std::size_t width = 40;
    const double part_width = max / parts - min / parts; // whose difference may be too large
    const auto part_of = [&](double value) {
        const double part = (value / parts - min / parts) / part_width * parts;
        return std::min(parts - 1, static_cast<std::size_t>(std::max(part, 0.0)));
    };
    std::array<std::size_t, parts> counts{};
    for (const double value : values)
        if (std::isfinite(value))
            ++counts[part_of(value)];
    const std::size_t most = *std::max_element(counts.begin(), counts.end());
    std::string text;
    for (std::size_t part = 0; part < parts; ++part)
        text += fmt::format("{:>18} to {:<9} {:>9} {:#<{}}\n",
                            rounded_text(min + part_width * static_cast<double>(part), 3),
                            rounded_text(min + part_width * static_cast<double>(part + 1), 3),
                            counts[part], "", (counts[part] * width + most - 1) / most);
    return text;
}

} // namespace

std::string short_text(double value) {
    return rounded_text(value, 5);
}

Extent extent_of(const Positions& positions) {
    Extent extent;
    for (const auto& position : positions) {
        if (!std::all_of(position.begin(), position.end(),
                         [](double x) { return std::isfinite(x); }))
            continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = position[axis];
            extent.min[axis] = extent.finite == 0 ? x : std::min(extent.min[axis], x);
            extent.max[axis] = extent.finite == 0 ? x : std::max(extent.max[axis], x);
        }
        ++extent.finite;
    }
    return extent;
}

std::string extent_text(const Extent& extent, int dimension) {
    std::string text;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension) && extent.finite > 0;
         ++axis)
        text += fmt::format("{}{} {} to {} m", axis == 0 ? "" : ", ", "xyz"[axis],
                            short_text(extent.min[axis]), short_text(extent.max[axis]));
    return text;
}

std::string phases_text(const Snapshot& snapshot) {
    constexpr std::size_t max_length = 200;
    const PointArray* phase = find_array(snapshot, "phase");
    std::map<double, std::size_t> counts;
    if (phase != nullptr)
        for (const double value : as_doubles(*phase))
            if (!std::isnan(value))
                ++counts[value];
    std::string text;
    for (const auto& [value, count] : counts)
        if (text.size() < max_length)
            text += fmt::format("{}{}: {} particles", text.empty() ? "" : ", ", value, count);
    return text;
}

std::string array_lines(const PointArray& array) {
    const std::vector<double> values = as_doubles(array);
    double min = std::numeric_limits<double>::infinity();
    double max = -min;
    std::size_t not_finite = 0;
    for (const double value : values) {
        if (std::isfinite(value)) {
            min = std::min(min, value);
            max = std::max(max, value);
        } else {
            ++not_finite;
        }
    }
    const std::string components =
        array.components == 1 ? "" : fmt::format(" x{}", array.components);
    std::string text =
        fmt::format("    {:<28} {:<9}", array.name, type_names[array.values.index()] + components);
    if (min <= max)
        text += fmt::format(" {} to {}", short_text(min), short_text(max));
    if (not_finite > 0)
        text += fmt::format(", {} not finite", not_finite);
    text += '\n';
    return array.components == 1 && min < max && array.name != "id"
               ? text + histogram(values, min, max)
               : text;
}

} // namespace meniscus
