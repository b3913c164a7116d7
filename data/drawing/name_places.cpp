#include "name_places.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace meniscus {
namespace {

constexpr double point_radius = 5;
constexpr double near = 14; ///< beyond it a line leads to the point

double overlap(const DrawingFrame& a, const DrawingFrame& b) {
    const double width = std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x);
    const double height = std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y);
    return std::max(width, 0.0) * std::max(height, 0.0);
}

double area(const DrawingFrame& frame) {
    return (frame.high.x - frame.low.x) * (frame.high.y - frame.low.y);
}

DrawingFrame around(const DrawingPoint& place, double radius) {
    return {{place.x - radius, place.y - radius}, {place.x + radius, place.y + radius}};
}

/// To which side of a point its name may stand; names are wide, hence most are to one side.
constexpr std::array<DrawingPoint, 10> directions = {
    DrawingPoint{1, 0},     DrawingPoint{1, -0.7}, DrawingPoint{1, 0.7}, DrawingPoint{-1, 0},
    DrawingPoint{-1, -0.7}, DrawingPoint{-1, 0.7}, DrawingPoint{0, -1},  DrawingPoint{0, 1},
    DrawingPoint{0.5, -1},  DrawingPoint{0.5, 1}};
constexpr std::array<double, 8> distances = {8, 14, 24, 36, 50, 68, 90, 120};

Lettering beside(const NamedPoint& point, const DrawingPoint& direction, double distance) {
    Lettering lettering;
    lettering.place = {point.place.x + distance * direction.x,
                       point.place.y + distance * direction.y};
    lettering.text = point.name;
    lettering.anchor = direction.x > 0   ? Anchor::begin
                       : direction.x < 0 ? Anchor::end
                                         : Anchor::middle;
    return lettering;
}

DrawingFrame frame_of(const Lettering& lettering) {
    const double width = lettering_width(lettering.text);
    const double left = lettering.place.x - (lettering.anchor == Anchor::begin    ? 0
                                             : lettering.anchor == Anchor::middle ? width / 2
                                                                                  : width);
    const double top = lettering.place.y - lettering_height / 2;
    return {{left, top}, {left + width, top + lettering_height}};
}

/// What a name covers of others and of points, and what of it lies outside.
double covered(const DrawingFrame& name, const std::vector<DrawingFrame>& taken,
               const DrawingFrame& frame) {
    double sum = 4 * (area(name) - overlap(name, frame));
    for (const DrawingFrame& other : taken)
        sum += overlap(name, other);
    return sum;
}

} // namespace

std::vector<NamePlace> name_places(const std::vector<NamedPoint>& points,
                                   const DrawingFrame& frame) {
    std::vector<DrawingFrame> taken;
    taken.reserve(2 * points.size());
    for (const NamedPoint& point : points)
        taken.push_back(around(point.place, point_radius));
    std::vector<NamePlace> places;
    for (const NamedPoint& point : points) {
        if (point.name.empty()) {
            places.emplace_back();
            continue;
        }
        double least = std::numeric_limits<double>::infinity();
        NamePlace best;
        for (const double distance : distances)
            for (const DrawingPoint& direction : directions) {
                const Lettering lettering = beside(point, direction, distance);
                const double cost = covered(frame_of(lettering), taken, frame);
                if (cost < least - 1e-6) { // not by rounding
                    least = cost;
                    best = {lettering, distance > near};
                }
            }
        if (least > 0 && !point.is_needed)
            best.lettering.text.clear();
        if (!best.lettering.text.empty())
            taken.push_back(frame_of(best.lettering));
        places.push_back(best);
    }
    return places;
}

} // namespace meniscus
