// Shapes with a surface that is known exactly: where the nearest point of it lies, which way its
// normal points and how strongly it is curved. Fluid fills a shape, or everything around it
// (`outside`: a bubble, a cavity). The mean curvature, in 1/m, is the average of the two principal
// ones, in two dimensions the curvature; positive where the fluid is convex (a drop), negative
// where it is hollow (a bubble). Plane, paraboloid and cylinder have no end; what is filled of them
// is a patch, whose other sides are cuts and no surface. All numbers come from the four operations
// and the square root, so that they are the same on every machine.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <string>

namespace meniscus {

/// The point of a surface nearest to a place.
struct SurfacePoint {
    std::array<double, 3> position{}; ///< m
    std::array<double, 3> normal{};   ///< of length 1, out of the fluid
    double mean_curvature = 0;        ///< 1/m
    double signed_distance = 0;       ///< of the place from it, m; negative in the fluid
    /// How far the place is from where the surface has no normal (edges of a cube), m.
    double edge_distance = std::numeric_limits<double>::infinity();
};

/// A box along the axes, m; what is not bounded is infinite.
struct Box {
    std::array<double, 3> low, high;
};

/// Which side of its surface the fluid is on.
enum class Side { inside, outside };

/// Around the origin. The functions are made for fluid inside; nearest_surface_point and in_fluid
/// heed the side.
struct Shape {
    std::string name;
    int dimension = 3; ///< 2: all in the plane z = 0
    Side side = Side::inside;
    bool bounded = true;   ///< its inside, within the patch, has a finite volume
    double min_extent = 0; ///< of all its widths, m
    Box patch;             ///< where fluid is cut off
    std::function<bool(const std::array<double, 3>& place)> contains; ///< the cheap question
    std::function<SurfacePoint(const std::array<double, 3>& place)> nearest;
    /// Holds every place of the patch that lies in a bounded inside, or within `reach` (m) of the
    /// surface.
    std::function<Box(double reach)> box_around;
};

/// The shapes; lengths in m, positive and finite, else InputError. In two dimensions a cube is a
/// square and a plane a line.
Shape circle(double radius);
Shape sphere(double radius);
Shape ellipsoid(const std::array<double, 3>& semi_axes);
/// About the z axis. Throws InputError where the tube is as thick as the ring or thicker.
Shape torus(double ring_radius, double tube_radius);
/// Along the z axis, cut at both ends; they are not surface.
Shape cylinder(double radius, double length);
Shape cube(double edge, int dimension = 3);
/// y = 0 in two dimensions, z = 0 in three, over a patch of that width; inside is below.
Shape plane(double width, int dimension = 3);
/// z = a x^2 - b y^2 over a square patch of that width; a and b in 1/m, of any sign, else
/// InputError. Inside is above, so that at the origin the mean curvature is a - b.
Shape paraboloid(double a, double b, double width);

/// The same shape with fluid on the other side of its surface.
Shape outside(Shape shape);

/// The nearest point of the shape's surface to a finite place, as the fluid's side has it. Where
/// several are equally near (the center of a sphere) it is one of them.
SurfacePoint nearest_surface_point(const Shape& shape, const std::array<double, 3>& place);

/// Whether the place is in the fluid, cuts aside.
bool in_fluid(const Shape& shape, const std::array<double, 3>& place);

} // namespace meniscus
