// Particle clouds with known answers: a shape (see shapes.hpp) filled with particles, each of which
// knows the normal and the mean curvature at the nearest point of the surface and how deep below it
// lies. The number of particles is the filled volume over spacing^dimension (where they are random,
// on average), so that a ball of N particles has the radius that its volume gives it. Where the
// fluid has no end (outside of a shape, below a plane) a layer is filled, and `trusted` tells
// particles that see nothing of where it was cut off.
#pragma once

#include "shapes.hpp"
#include <meniscus/data/particles/snapshot.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace meniscus {

enum class Arrangement {
    random,  ///< anywhere, independent of each other
    lattice, ///< cubic, in two dimensions square, turned and shifted at random
    /// As a solver with surface tension leaves them. The outermost layer lies half a spacing deep
    /// and is packed more densely than the rest: at h = 2.15 spacings its particles have 28
    /// neighbors, in the droplets of data/samples 28 and 29. Inside, it is 41 +- 2.2, in
    /// droplet_iisph_14 41 +- 2.3. There the nearest neighbor is 0.95 spacings away, in the
    /// droplets 0.8 to 0.9; a jitter between 0.1 and 0.3 brings it as close.
    relaxed,
};

struct CloudOptions {
    double spacing = 0;        ///< m; its power of the dimension is the volume of a particle
    double support_radius = 0; ///< h, m
    Arrangement arrangement = Arrangement::relaxed;
    std::uint64_t seed = 0;
    /// How deep below its surface fluid is filled, m. Without it: all of a bounded inside, else
    /// four support radii, so that particles are trusted to a depth of two.
    std::optional<double> thickness;
    double surface_share = 0; ///< share of the particles that lie on the surface; `random` only
    double jitter = 0; ///< each is moved this far at most along each axis afterwards, in spacings
    int threads = 0;   ///< 0 takes all cores; no result depends on it
};

/// Arrays have one entry a particle.
struct Cloud {
    int dimension = 3;
    double spacing = 0;        ///< m
    double support_radius = 0; ///< m
    Positions positions;
    Positions normal;                   ///< of length 1, out of the fluid
    std::vector<double> mean_curvature; ///< 1/m
    std::vector<double> depth;          ///< below the surface, m; never negative
    /// 1 where nothing within two support radii is cut off and no edge is there, so that the
    /// particle and all of its neighbors have the neighbors that they would have in all of the
    /// fluid.
    std::vector<std::uint8_t> trusted;

    [[nodiscard]] std::size_t size() const { return positions.size(); }
};

/// The support radius, in spacings, at which a particle inside has that many neighbors on average:
/// it is one of its own h-ball's particles, except where they are independent of each other.
/// Throws InputError where the number is not positive and finite or the dimension not 2 or 3.
double support_radius_in_spacings(double mean_neighbors, int dimension, Arrangement arrangement);

/// The shape's fluid as particles. The same for a seed on every machine. Throws InputError, naming
/// the value, where spacing, support radius or thickness are not positive and finite, share or
/// jitter are not in [0, 1), the shape is smaller than a spacing, a share on the surface is asked
/// of another arrangement than `random`, or the box around the fluid holds more than 5e8 particles.
Cloud fill(const Shape& shape, const CloudOptions& options);

/// The fluid around one place: particle 0 there, all others within `radius` (m) of it that are in
/// the fluid, independent of each other, about one in spacing^dimension. Cheap enough to be drawn
/// anew thousands of times; twice the support radius gives the neighbors all of their neighbors.
/// Throws InputError where radius or spacing are not positive and finite, the place is not finite,
/// or the box around the ball holds more than 5e8 particles.
Positions random_neighborhood(const Shape& shape, const std::array<double, 3>& place, double radius,
                              double spacing, std::uint64_t seed);

} // namespace meniscus
