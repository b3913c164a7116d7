#include "coloring.hpp"

#include "class_colors.hpp"
#include <meniscus/data/text/errors.hpp>
#include <meniscus/runtime/surface/surface_particles.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace meniscus {
namespace {

constexpr Color gray = {154, 154, 154};

using Scale = std::array<Color, 5>;
constexpr Scale viridis = {Color{68, 1, 84}, Color{59, 82, 139}, Color{33, 145, 140},
                           Color{94, 201, 98}, Color{253, 231, 37}};
constexpr Scale blue_to_red = {Color{33, 102, 172}, Color{146, 197, 222}, Color{221, 221, 221},
                               Color{244, 165, 130}, Color{178, 24, 43}};

Coloring by_class(const Snapshot& snapshot) {
    Coloring coloring;
    if (find_array(snapshot, "surface_class") != nullptr) {
        for (const double value : scalar_values(snapshot, "surface_class"))
            coloring.colors.push_back(
                value == static_cast<double>(SurfaceClass::surface)   ? surface_color
                : value == static_cast<double>(SurfaceClass::covered) ? passed_color
                                                                      : interior_color);
        coloring.classes = {{surface_color, "surface"},
                            {passed_color, "passed by the line, covered"},
                            {interior_color, "interior by the line"}};
    } else if (find_array(snapshot, "surface") != nullptr) {
        for (const double value : scalar_values(snapshot, "surface"))
            coloring.colors.push_back(value != 0 ? surface_color : interior_color);
        coloring.classes = {{surface_color, "surface by label"}, {interior_color, "interior"}};
    } else {
        coloring.colors.assign(snapshot.size(), interior_color);
        coloring.classes = {{interior_color, "fluid"}};
    }
    return coloring;
}

const PointArray& array_named(const Snapshot& snapshot, const std::string& name) {
    if (const PointArray* array = find_array(snapshot, name))
        return *array;
    std::string names = "class";
    for (const PointArray& array : snapshot.point_data)
        names += ", " + array.name;
    throw InputError("--color: no point data of the name '" + name + "'; there are " + names);
}

/// Values of one component, or lengths.
std::vector<double> numbers_of(const PointArray& array) {
    std::vector<double> values = as_doubles(array);
    if (array.components == 1)
        return values;
    const auto components = static_cast<std::size_t>(array.components);
    std::vector<double> lengths;
    for (std::size_t i = 0; i < values.size(); i += components) {
        double squares = 0;
        for (std::size_t c = 0; c < components; ++c)
            squares += values[i + c] * values[i + c];
        lengths.push_back(std::sqrt(squares));
    }
    return lengths;
}

std::pair<double, double> range_of(const std::vector<double>& values) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : values)
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    if (low > high)
        return {0, 1};
    if (low < 0 && high > 0)
        return {-std::max(-low, high), std::max(-low, high)};
    return {low, high};
}

} // namespace

Color scale_color(bool is_signed, double share) {
    const Scale& scale = is_signed ? blue_to_red : viridis;
    const double place = std::clamp(share, 0.0, 1.0) * (scale.size() - 1);
    const std::size_t low = std::min(static_cast<std::size_t>(place), scale.size() - 2);
    Color color;
    for (std::size_t c = 0; c < 3; ++c)
        color[c] = static_cast<std::uint8_t>(
            std::lround(scale[low][c] +
                        (place - static_cast<double>(low)) * (scale[low + 1][c] - scale[low][c])));
    return color;
}

Coloring coloring_of(const Snapshot& snapshot, const std::string& quantity,
                     const std::optional<std::pair<double, double>>& range) {
    if (quantity == "class")
        return by_class(snapshot);
    const std::vector<double> values = numbers_of(array_named(snapshot, quantity));
    Coloring coloring;
    coloring.quantity = quantity;
    std::tie(coloring.low, coloring.high) = range ? *range : range_of(values);
    coloring.is_signed = coloring.low < 0 && coloring.high > 0;
    const double span = coloring.high > coloring.low ? coloring.high - coloring.low : 1;
    for (const double value : values)
        coloring.colors.push_back(
            std::isfinite(value) ? scale_color(coloring.is_signed, (value - coloring.low) / span)
                                 : gray);
    return coloring;
}

} // namespace meniscus
