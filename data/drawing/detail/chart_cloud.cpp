#include "chart_cloud.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace meniscus {
namespace {

constexpr double cell = 2;
constexpr double weakest = 0.3; ///< of a cell with one point, between white and the color

struct CellSum {
    double count = 0;
    std::array<double, 3> color = {};
};

Color color_of(const CellSum& sum, double max) {
    const double strength =
        weakest + (1 - weakest) * (max > 1 ? std::log(sum.count) / std::log(max) : 1);
    Color color = white;
    for (std::size_t c = 0; c < 3; ++c)
        color[c] = static_cast<std::uint8_t>(
            std::lround(255 + strength * (sum.color[c] / sum.count - 255)));
    return color;
}

} // namespace

Mosaic mosaic_of(const std::vector<Cloud>& clouds, const DrawingFrame& frame) {
    const auto cells = [](double length) { return static_cast<int>(std::ceil(length / cell)); };
    Mosaic mosaic{frame.low, cell,
                  Image(cells(frame.high.x - frame.low.x), cells(frame.high.y - frame.low.y))};
    Image& image = mosaic.cells;
    std::vector<CellSum> sums(image.pixels.size());
    double max = 0;
    for (const Cloud& cloud : clouds)
        for (const DrawingPoint& place : cloud.places) {
            const double x = std::floor((place.x - frame.low.x) / cell);
            const double y = std::floor((place.y - frame.low.y) / cell);
            if (!(x >= 0 && y >= 0 && x < image.width && y < image.height))
                continue;
            CellSum& sum =
                sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(x)];
            max = std::max(max, ++sum.count);
            for (std::size_t c = 0; c < 3; ++c)
                sum.color[c] += cloud.color[c];
        }
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (sums[i].count > 0)
            image.pixels[i] = color_of(sums[i], max);
    return mosaic;
}

} // namespace meniscus
