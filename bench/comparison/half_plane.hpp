// The straight line with the fewest false positives among all lines without a false negative, in
// any plane of two features: what classifier/neyman_pearson.hpp finds for the paper's own two, but
// for lines of every direction, both sides of them, and without a margin for rounding.
//
// Exact: for a direction the best line rests on the convex hull of the surface particles. An
// interior particle outside of that hull is told apart by the directions between its two tangents
// to it, and the best direction is where most of these intervals overlap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meniscus {

struct PlanePoint {
    double x;
    double y;
};

/// Particles by two features. Arrays have one entry a particle.
struct LabelledPoints {
    std::vector<PlanePoint> points;
    std::vector<std::uint8_t> surface;
    std::vector<std::int64_t> weight; ///< what a false positive costs; all add up to less than 2^63

    void add(PlanePoint point, bool is_surface, std::int64_t its_weight) {
        points.push_back(point);
        surface.push_back(static_cast<std::uint8_t>(is_surface));
        weight.push_back(its_weight);
    }
};

/// Contains what is taken for surface: x * point.x + y * point.y <= limit.
struct HalfPlane {
    double x = 0;
    double y = 0;
    double limit = 0;

    [[nodiscard]] bool contains(const PlanePoint& point) const {
        return x * point.x + y * point.y <= limit;
    }
};

/// The half-plane that contains all surface particles and the least weight of interior ones. Throws
/// InputError where the surface particles do not span a plane.
HalfPlane tightest_half_plane(const LabelledPoints& particles);

/// The same with a line at right angles to the x-axis: a threshold of that feature alone.
HalfPlane tightest_threshold(const LabelledPoints& particles);

} // namespace meniscus
