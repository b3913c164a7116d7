// Walls as particles: one layer of samples on the sides of a box, on an ellipsoid or on a mesh of
// triangles, close enough together that no fluid passes. Boxes are sampled by an even grid. On
// curved and triangulated surfaces, places are tried in turn, first those of a coarse even pattern
// and then those of a fine one, and a place is taken unless one already taken is closer than 0.75
// spacings: so there are neither holes nor samples on top of each other, whatever the shapes of
// the triangles. Samples differ in the area they stand for; boundary models that weight them by
// their own number density (Akinci et al. 2012) make up for it. Lengths are in m. All numbers come
// from the four operations and the square root, so that they are the same on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace meniscus {

/// The four or six sides of a box along the axes.
struct BoxSides {
    std::array<double, 3> low{};
    std::array<double, 3> high{};
    std::array<bool, 6> open{}; ///< sides left out: -x, +x, -y, +y, -z, +z
};

/// Points on the sides of a box, in two dimensions (z stays 0) of a rectangle: an even grid from
/// edge to edge, between half a spacing and one apart along each axis; points of shared edges once.
/// Throws InputError where a number is not finite, the spacing is not positive, the box is thinner
/// than half a spacing along an axis, or there would be more than 5e8 points.
std::vector<std::array<double, 3>> sample_box(const BoxSides& box, double spacing, int dimension);

/// Points on an ellipsoid along the axes, 0.75 spacings apart or more and no place farther than a
/// spacing from the next of them; in two dimensions (z stays 0) on an ellipse, at equal distances
/// along it of at most a spacing, but never closer than half a spacing. Throws InputError where a
/// number is not finite, the spacing is not positive, a half axis is shorter than half a spacing or
/// longer than 1000 of them.
std::vector<std::array<double, 3>> sample_ellipsoid(const std::array<double, 3>& center,
                                                    const std::array<double, 3>& half_axes,
                                                    double spacing, int dimension);

struct TriangleMesh {
    std::vector<std::array<double, 3>> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Reads vertices and faces of a Wavefront OBJ file; faces of more than three corners become fans
/// of triangles, everything else (normals, texture, groups, materials) is skipped. Throws
/// InputError that names file and line where a vertex is not three finite numbers, or where a face
/// has fewer than three corners or one that is not there; or the file, where it cannot be read or
/// has no face.
TriangleMesh read_obj(const std::filesystem::path& file);

/// About how many points sample_mesh() would put on the triangles, all of whose vertices are there.
double expected_points(const TriangleMesh& mesh, double spacing);

/// Points on the triangles, 0.75 spacings apart or more and no place farther than a spacing from
/// the next of them. Throws InputError where the spacing is not positive and finite, a vertex is
/// not finite, a triangle has a vertex that is not there, or the mesh is so large against the
/// spacing that there would be more than about 1e8 points.
std::vector<std::array<double, 3>> sample_mesh(const TriangleMesh& mesh, double spacing);

} // namespace meniscus
