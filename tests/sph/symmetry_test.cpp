// A scene that is its own mirror image stays so: nothing in a step prefers a side, but rounding,
// since mirrored particles are summed up in another order.
#include "small_scenes.hpp"

#include <stdexcept>

namespace meniscus {
namespace {

constexpr Place middle = {0.6, 0, 0.4}; // of the mirrors, along x and, in 3D, along z

Place mirrored(const Place& place, int dimension) {
    return {2 * middle[0] - place[0], place[1],
            dimension == 3 ? 2 * middle[2] - place[2] : place[2]};
}

/// A block that falls apart over the floor of a tank, mirrored along x and, in 3D, along z. Lattice
/// planes lie no whole number of h apart, so that rounding decides about no neighbor. Neither does
/// the surface tension, whose samples would be other ones for the other side, or other neighbors.
Scene symmetric_scene(int dimension, Precision precision, std::string_view solver) {
    Scene scene = tank_scene(empty_scene(dimension, solver, precision), {12, 8, 8}, 6);
    scene.fluid = {{box_of(scene, {6, 6, 4}, {0.3, 0, dimension == 3 ? 0.2 : 0}), {}}};
    scene.support_radius = 0.23;
    scene.viscosity = {0.01, true, 0.05};
    scene.surface_tension.model = "becker_2007";
    scene.surface_tension.coefficient = 0.5;
    return scene;
}

/// For each particle the one at its mirrored place.
std::vector<std::size_t> mirror_images(const Positions& places, int dimension) {
    std::vector<std::size_t> images;
    for (const Place& place : places) {
        const Place image = mirrored(place, dimension);
        const auto found = std::find_if(places.begin(), places.end(), [&](const Place& other) {
            return std::hypot(other[0] - image[0], other[1] - image[1], other[2] - image[2]) < 1e-9;
        });
        if (found == places.end())
            throw std::logic_error("the scene is not its own mirror image");
        images.push_back(static_cast<std::size_t>(found - places.begin()));
    }
    return images;
}

/// How far particles are from where their images say, at most, in spacings.
double asymmetry(const Positions& places, const std::vector<std::size_t>& images, int dimension) {
    double max = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Place expected = mirrored(places[images[i]], dimension);
        for (int axis = 0; axis < 3; ++axis)
            max = std::max(max, std::abs(places[i][axis] - expected[axis]));
    }
    return max / 0.1;
}

/// Differences of rounding double about every ten steps once the block has reached the walls: to
/// some 1e-11 spacings after 100 steps in double, and to 1e-6 after 20 in single precision, where
/// the bounds below are ten to a hundred times that. A step that prefers a side is off by 1e-3 at
/// once.
void expect_symmetric(int dimension, Precision precision, int steps, double bound) {
    for (const auto& [solver, name] : all_solvers) {
        SCOPED_TRACE(name);
        const auto simulation = start(symmetric_scene(dimension, precision, solver));
        const Positions first = places_by_id(*simulation);
        const auto images = mirror_images(first, dimension);
        for (int n = 0; n < steps; ++n)
            simulation->step(1);
        const Positions last = places_by_id(*simulation);
        EXPECT_LT(asymmetry(last, images, dimension), bound);
        double farthest = 0;
        for (std::size_t i = 0; i < first.size(); ++i)
            farthest = std::max(farthest, std::abs(last[i][0] - first[i][0]));
        EXPECT_GT(farthest, precision == Precision::float64 ? 0.1 : 0.001); // it did move
    }
}

TEST(Symmetry, IsKeptInDoublePrecision) {
    expect_symmetric(2, Precision::float64, 100, 1e-9);
    expect_symmetric(3, Precision::float64, 100, 1e-9);
}

TEST(Symmetry, IsKeptInSinglePrecision) {
    expect_symmetric(2, Precision::float32, 20, 1e-5);
    expect_symmetric(3, Precision::float32, 20, 1e-5);
}

} // namespace
} // namespace meniscus
