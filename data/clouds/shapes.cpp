#include "shapes.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <meniscus/runtime/math/vector3.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace meniscus {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Box everywhere{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};

void check_length(double value, const std::string& what) {
    if (!(value > 0) || !std::isfinite(value))
        throw InputError(what + " must be positive and finite, found " + number_text(value));
}

void check_dimension(int dimension, const std::string& name) {
    if (dimension != 2 && dimension != 3)
        throw InputError("a " + name + " has 2 or 3 dimensions, found " +
                         std::to_string(dimension));
}

Box box_of_half_widths(const Vector3& half) {
    return {scaled(-1, half), half};
}

double length_of(const Vector3& a) {
    return std::sqrt(dot(a, a));
}

/// The vector at length 1; where it has none, the x axis.
Vector3 direction_of(const Vector3& a) {
    const double length = length_of(a);
    return length > 0 ? scaled(1 / length, a) : Vector3{1, 0, 0};
}

/// The point of a ball's or disc's surface nearest to `place`.
SurfacePoint nearest_on_ball(const Vector3& place, double radius) {
    SurfacePoint point;
    point.normal = direction_of(place);
    point.position = scaled(radius, point.normal);
    point.mean_curvature = 1 / radius;
    point.signed_distance = length_of(place) - radius;
    return point;
}

Shape ball(const std::string& name, double radius, int dimension) {
    check_length(radius, name + " radius");
    Shape shape;
    shape.name = name;
    shape.dimension = dimension;
    shape.min_extent = 2 * radius;
    shape.patch = everywhere;
    shape.contains = [=](const Vector3& place) { return dot(place, place) < radius * radius; };
    shape.nearest = [=](const Vector3& place) { return nearest_on_ball(place, radius); };
    shape.box_around = [=](double reach) {
        const double half = radius + reach;
        return box_of_half_widths({half, half, dimension == 3 ? half : 0});
    };
    return shape;
}

/// The point of an ellipsoid nearest to a place (Eberly, Distance from a point to an ellipsoid). It
/// is x_i = a_i^2 y_i / (s + a_i^2 - c^2), c the smallest semi-axis, where s > 0 puts it onto the
/// surface. What tells how far it is off falls with s and bends upwards, so that Newton's method
/// from below climbs to the root and never beyond.
Vector3 nearest_on_ellipsoid(const Vector3& place, const Vector3& semi_axes) {
    const double min = std::min({semi_axes[0], semi_axes[1], semi_axes[2]});
    Vector3 offset;
    Vector3 from_origin;
    double s = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = semi_axes[axis];
        offset[axis] = (a - min) * (a + min);
        // Off the planes of symmetry, where the nearest point jumps from one side to the other.
        from_origin[axis] = std::max(std::fabs(place[axis]), 1e-12 * min);
        s = std::max(s, a * from_origin[axis] - offset[axis]);
    }
    for (int step = 0; step < 100; ++step) {
        double off = -1;
        double slope = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double inverse = 1 / (s + offset[axis]);
            const double part = semi_axes[axis] * from_origin[axis] * inverse;
            off += part * part;
            slope -= 2 * part * part * inverse;
        }
        const double next = s - off / slope;
        if (!(next > s))
            break;
        s = next;
    }
    Vector3 nearest;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = semi_axes[axis];
        nearest[axis] = std::copysign(a * a * from_origin[axis] / (s + offset[axis]), place[axis]);
    }
    return nearest;
}

/// Normal and mean curvature of an ellipsoid at a point on it.
SurfacePoint point_of_ellipsoid(const Vector3& position, const Vector3& semi_axes) {
    SurfacePoint point;
    point.position = position;
    Vector3 gradient;
    double squares = 0;
    for (int axis = 0; axis < 3; ++axis) {
        gradient[axis] = position[axis] / (semi_axes[axis] * semi_axes[axis]);
        squares += semi_axes[axis] * semi_axes[axis];
    }
    point.normal = direction_of(gradient);
    const double height = 1 / length_of(gradient); // of the tangent plane above the center
    const double product = semi_axes[0] * semi_axes[1] * semi_axes[2];
    const double ratio = height / product;
    point.mean_curvature = ratio * ratio * height * (squares - dot(position, position)) / 2;
    return point;
}

SurfacePoint nearest_on_torus(const Vector3& place, double ring_radius, double tube_radius) {
    const Vector3 across = direction_of({place[0], place[1], 0}); // away from the axis
    const Vector3 ring = scaled(ring_radius, across);
    const Vector3 from_ring = difference(place, ring);
    SurfacePoint point;
    const double distance = length_of(from_ring);
    point.normal = distance > 0 ? scaled(1 / distance, from_ring) : across;
    point.position = sum(ring, scaled(tube_radius, point.normal));
    const double cosine = dot(point.normal, across);
    point.mean_curvature = (1 / tube_radius + cosine / (ring_radius + tube_radius * cosine)) / 2;
    point.signed_distance = distance - tube_radius;
    return point;
}

SurfacePoint nearest_on_cylinder(const Vector3& place, double radius) {
    SurfacePoint point = nearest_on_ball({place[0], place[1], 0}, radius);
    point.position[2] = place[2];
    point.mean_curvature /= 2;
    return point;
}

double cube_edge_distance(const Vector3& place, double half, int dimension) {
    Vector3 square{};
    Vector3 beyond_square{};
    for (int axis = 0; axis < dimension; ++axis) {
        const double from_face = std::fabs(place[axis]) - half;
        square[axis] = from_face * from_face;
        const double beyond = std::max(from_face, 0.0);
        beyond_square[axis] = beyond * beyond;
    }
    if (dimension == 2)
        return std::sqrt(square[0] + square[1]);
    return std::sqrt(std::min({square[0] + square[1] + beyond_square[2],
                               square[1] + square[2] + beyond_square[0],
                               square[2] + square[0] + beyond_square[1]}));
}

SurfacePoint nearest_on_cube(const Vector3& place, double half, int dimension) {
    int face = 0;
    for (int axis = 1; axis < dimension; ++axis)
        if (std::fabs(place[axis]) > std::fabs(place[face]))
            face = axis;
    SurfacePoint point;
    for (int axis = 0; axis < dimension; ++axis)
        point.position[axis] = std::clamp(place[axis], -half, half);
    point.position[face] = std::copysign(half, place[face]);
    point.normal[face] = std::copysign(1.0, place[face]);
    const double distance = length_of(difference(place, point.position));
    point.signed_distance = std::fabs(place[face]) < half ? -distance : distance;
    point.edge_distance = cube_edge_distance(place, half, dimension);
    return point;
}

/// The quadric z = A x^2 + B y^2.
struct Quadric {
    double A, B; // NOLINT(readability-identifier-naming)
};

double height_of(const Quadric& quadric, double x, double y) {
    return quadric.A * x * x + quadric.B * y * y;
}

/// How far z lies above the quadric once x and y have followed its normal by t, z going down: the
/// nearest point is where this is zero, between the poles.
double height_after(const Quadric& quadric, const Vector3& place, double t) {
    return place[2] - t -
           height_of(quadric, place[0] / (1 - 2 * quadric.A * t),
                     place[1] / (1 - 2 * quadric.B * t));
}

/// The place, off the planes of symmetry by next to nothing: beyond the focus the nearest point
/// jumps there from one side to the other.
Vector3 off_symmetry(Vector3 place, const Quadric& quadric) {
    for (const auto& [axis, coefficient] : {std::pair{0, quadric.A}, std::pair{1, quadric.B}}) {
        const double min = 1e-10 * std::min(std::fabs(1 / coefficient), std::fabs(place[2]));
        place[axis] = std::copysign(std::max(std::fabs(place[axis]), min), place[axis]);
    }
    return place;
}

/// Between which values of t the root of height_after lies.
std::array<double, 2> bracket_of_root(const Vector3& place, const Quadric& quadric) {
    const double max =
        std::fabs(quadric.A) * place[0] * place[0] + std::fabs(quadric.B) * place[1] * place[1];
    double low = std::min(0.0, place[2] - max);
    double high = std::max(0.0, place[2] + max);
    for (const double coefficient : {quadric.A, quadric.B}) {
        if (coefficient > 0)
            high = std::min(high, 1 / (2 * coefficient));
        if (coefficient < 0)
            low = std::max(low, 1 / (2 * coefficient));
    }
    return {low, high};
}

/// The point of a quadric nearest to a place, by Newton's method, and bisection where that leaves
/// the bracket: height_after falls throughout.
Vector3 nearest_on_quadric(const Vector3& true_place, const Quadric& quadric) {
    const Vector3 place = off_symmetry(true_place, quadric);
    auto [low, high] = bracket_of_root(place, quadric);
    double t = 0;
    for (int step = 0; step < 200; ++step) {
        const double height = height_after(quadric, place, t);
        (height > 0 ? low : high) = t;
        const double x_scale = 1 / (1 - 2 * quadric.A * t);
        const double y_scale = 1 / (1 - 2 * quadric.B * t);
        const double x = quadric.A * place[0] * x_scale;
        const double y = quadric.B * place[1] * y_scale;
        double next = t + height / (1 + 4 * (x * x * x_scale + y * y * y_scale));
        if (!(next >= low && next <= high))
            next = (low + high) / 2;
        const double change = std::fabs(next - t);
        t = next;
        if (change <= 1e-16 * (std::fabs(t) + std::fabs(place[2])))
            break;
    }
    const double x = place[0] / (1 - 2 * quadric.A * t);
    const double y = place[1] / (1 - 2 * quadric.B * t);
    return {x, y, height_of(quadric, x, y)};
}

/// The fluid is above the quadric.
SurfacePoint nearest_point_of_quadric(const Vector3& place, const Quadric& quadric) {
    SurfacePoint point;
    point.position = nearest_on_quadric(place, quadric);
    const double slope_x = 2 * quadric.A * point.position[0];
    const double slope_y = 2 * quadric.B * point.position[1];
    const double square = 1 + slope_x * slope_x + slope_y * slope_y;
    const double root = std::sqrt(square);
    point.normal = {slope_x / root, slope_y / root, -1 / root};
    point.mean_curvature =
        (quadric.A * (1 + slope_y * slope_y) + quadric.B * (1 + slope_x * slope_x)) /
        (square * root);
    const double distance = length_of(difference(place, point.position));
    const bool above = place[2] > height_of(quadric, place[0], place[1]);
    point.signed_distance = above ? -distance : distance;
    return point;
}

} // namespace

Shape circle(double radius) {
    return ball("circle", radius, 2);
}

Shape sphere(double radius) {
    return ball("sphere", radius, 3);
}

Shape ellipsoid(const std::array<double, 3>& semi_axes) {
    for (const double a : semi_axes)
        check_length(a, "semi-axis of an ellipsoid");
    Shape shape;
    shape.name = "ellipsoid";
    shape.min_extent = 2 * std::min({semi_axes[0], semi_axes[1], semi_axes[2]});
    shape.patch = everywhere;
    shape.contains = [=](const Vector3& place) {
        const Vector3 part{place[0] / semi_axes[0], place[1] / semi_axes[1],
                           place[2] / semi_axes[2]};
        return dot(part, part) < 1;
    };
    shape.nearest = [=, contains = shape.contains](const Vector3& place) {
        SurfacePoint point = point_of_ellipsoid(nearest_on_ellipsoid(place, semi_axes), semi_axes);
        const double distance = length_of(difference(place, point.position));
        point.signed_distance = contains(place) ? -distance : distance;
        return point;
    };
    shape.box_around = [=](double reach) {
        return box_of_half_widths(sum(semi_axes, {reach, reach, reach}));
    };
    return shape;
}

Shape torus(double ring_radius, double tube_radius) {
    check_length(ring_radius, "ring radius of a torus");
    check_length(tube_radius, "tube radius of a torus");
    if (!(ring_radius > tube_radius))
        throw InputError("the ring radius of a torus must exceed its tube radius " +
                         number_text(tube_radius) + ", found " + number_text(ring_radius));
    Shape shape;
    shape.name = "torus";
    shape.min_extent = 2 * tube_radius;
    shape.patch = everywhere;
    shape.nearest = [=](const Vector3& place) {
        return nearest_on_torus(place, ring_radius, tube_radius);
    };
    shape.contains = [=](const Vector3& place) {
        const double across = std::sqrt(place[0] * place[0] + place[1] * place[1]) - ring_radius;
        return across * across + place[2] * place[2] < tube_radius * tube_radius;
    };
    shape.box_around = [=](double reach) {
        const double half = ring_radius + tube_radius + reach;
        return box_of_half_widths({half, half, tube_radius + reach});
    };
    return shape;
}

Shape cylinder(double radius, double length) {
    check_length(radius, "cylinder radius");
    check_length(length, "cylinder length");
    Shape shape;
    shape.name = "cylinder";
    shape.min_extent = std::min(2 * radius, length);
    shape.patch = box_of_half_widths({infinity, infinity, length / 2});
    shape.contains = [=](const Vector3& place) {
        return place[0] * place[0] + place[1] * place[1] < radius * radius;
    };
    shape.nearest = [=](const Vector3& place) { return nearest_on_cylinder(place, radius); };
    shape.box_around = [=](double reach) {
        return box_of_half_widths({radius + reach, radius + reach, length / 2});
    };
    return shape;
}

Shape cube(double edge, int dimension) {
    check_length(edge, "cube edge");
    check_dimension(dimension, "cube");
    Shape shape;
    shape.name = "cube";
    shape.dimension = dimension;
    shape.min_extent = edge;
    shape.patch = everywhere;
    shape.contains = [=](const Vector3& place) {
        return std::max({std::fabs(place[0]), std::fabs(place[1]), std::fabs(place[2])}) < edge / 2;
    };
    shape.nearest = [=](const Vector3& place) {
        return nearest_on_cube(place, edge / 2, dimension);
    };
    shape.box_around = [=](double reach) {
        const double half = edge / 2 + reach;
        return box_of_half_widths({half, half, dimension == 3 ? half : 0});
    };
    return shape;
}

Shape plane(double width, int dimension) {
    check_length(width, "width of a plane");
    check_dimension(dimension, "plane");
    const int up = dimension - 1;
    Shape shape;
    shape.name = "plane";
    shape.dimension = dimension;
    shape.bounded = false;
    shape.min_extent = width;
    shape.patch = box_of_half_widths({width / 2, width / 2, width / 2});
    for (int axis = up; axis < 3; ++axis) {
        shape.patch.low[axis] = -infinity;
        shape.patch.high[axis] = infinity;
    }
    shape.contains = [=](const Vector3& place) { return place[up] < 0; };
    shape.nearest = [=](const Vector3& place) {
        SurfacePoint point;
        point.position = place;
        point.position[up] = 0;
        point.normal[up] = 1;
        point.signed_distance = place[up];
        return point;
    };
    shape.box_around = [=](double reach) {
        Vector3 half{width / 2, width / 2, 0};
        half[up] = reach;
        return box_of_half_widths(half);
    };
    return shape;
}

Shape paraboloid(double a, double b, double width) {
    for (const double coefficient : {a, b})
        if (!std::isfinite(coefficient))
            throw InputError("coefficients of a paraboloid must be finite, found " +
                             number_text(coefficient));
    check_length(width, "width of a paraboloid");
    const Quadric quadric{a, -b};
    Shape shape;
    shape.name = "paraboloid";
    shape.bounded = false;
    shape.min_extent = width;
    shape.patch = box_of_half_widths({width / 2, width / 2, infinity});
    shape.contains = [=](const Vector3& place) {
        return place[2] > height_of(quadric, place[0], place[1]);
    };
    shape.nearest = [=](const Vector3& place) { return nearest_point_of_quadric(place, quadric); };
    shape.box_around = [=](double reach) {
        const double half = width / 2;
        const double square = (half + reach) * (half + reach); // nearest points may lie beyond
        return Box{{-half, -half, square * std::min({a, -b, a - b, 0.0}) - reach},
                   {half, half, square * std::max({a, -b, a - b, 0.0}) + reach}};
    };
    return shape;
}

Shape outside(Shape shape) {
    shape.side = shape.side == Side::inside ? Side::outside : Side::inside;
    return shape;
}

SurfacePoint nearest_surface_point(const Shape& shape, const std::array<double, 3>& place) {
    SurfacePoint point = shape.nearest(place);
    if (shape.side == Side::outside) {
        point.normal = scaled(-1, point.normal);
        point.mean_curvature = -point.mean_curvature;
        point.signed_distance = -point.signed_distance;
    }
    return point;
}

bool in_fluid(const Shape& shape, const std::array<double, 3>& place) {
    return shape.contains(place) == (shape.side == Side::inside);
}

} // namespace meniscus
