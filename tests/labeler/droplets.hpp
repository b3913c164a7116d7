// Droplets whose particles differ in size, each with a support radius of its own, and of which it
// is known where the surface is.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace meniscus::test {

using Place = std::array<double, 3>;

struct Droplet {
    Snapshot snapshot;              ///< with arrays `mass` and `support_radius`
    std::vector<double> radii;      ///< support radii in m
    std::vector<bool> outermost;    ///< a neighbor in the particle's own lattice is missing
    std::vector<double> depth;      ///< below the surface, in particle spacings
    std::vector<double> spacing;    ///< m
    double spacings_per_radius = 2; ///< support radius / spacing

    void add(const Place& position, double particle_spacing, bool is_outermost,
             double depth_in_spacings) {
        snapshot.positions.push_back(position);
        spacing.push_back(particle_spacing);
        radii.push_back(spacings_per_radius * particle_spacing);
        outermost.push_back(is_outermost);
        depth.push_back(depth_in_spacings);
    }

    void store_arrays() {
        std::vector<double> masses;
        for (const double length : spacing)
            masses.push_back(std::pow(length, snapshot.dimension));
        set_array(snapshot, {"mass", 1, masses});
        set_array(snapshot, {"support_radius", 1, radii});
    }
};

inline double length(const Place& x) {
    return std::hypot(x[0], x[1], x[2]);
}

/// Calls add(position, outermost) with the points of a lattice of that spacing in a ball (in two
/// dimensions disk) around the origin.
template <class Add>
void for_lattice_in_ball(int dimension, double spacing, double radius, Add&& add) {
    const int max = static_cast<int>(radius / spacing) + 1;
    const auto at = [&](int n) { return (n + 0.5) * spacing; };
    for (int x = -max; x < max; ++x)
        for (int y = -max; y < max; ++y)
            for (int z = dimension == 2 ? 0 : -max; z < (dimension == 2 ? 1 : max); ++z) {
                const Place position{at(x), at(y), dimension == 2 ? 0 : at(z)};
                if (length(position) >= radius)
                    continue;
                bool outermost = false;
                for (int axis = 0; axis < dimension; ++axis) {
                    Place beyond = position;
                    beyond[axis] += std::copysign(spacing, position[axis]);
                    outermost = outermost || length(beyond) >= radius;
                }
                add(position, outermost);
            }
}

/// A ball of lattices of spacing 1 and `coarse`, which meet halfway between their particles: fine
/// where `is_fine` says so of a position.
inline Droplet two_resolutions(int dimension, double radius, double spacings_per_radius,
                               const std::function<bool(const Place&)>& is_fine,
                               double coarse = 2) {
    Droplet droplet;
    droplet.snapshot.dimension = dimension;
    droplet.spacings_per_radius = spacings_per_radius;
    for (const double spacing : {1.0, coarse})
        for_lattice_in_ball(dimension, spacing, radius, [&](const Place& position, bool outermost) {
            if (is_fine(position) == (spacing == 1))
                droplet.add(position, spacing, outermost, (radius - length(position)) / spacing);
        });
    droplet.store_arrays();
    return droplet;
}

/// Half of the ball fine, half coarse.
inline Droplet halves(int dimension, double radius, double spacings_per_radius) {
    return two_resolutions(dimension, radius, spacings_per_radius,
                           [](const Place& position) { return position[0] < 0; });
}

/// A cube inside the ball coarse, the rest fine, as where the surface is refined.
inline Droplet refined_surface(int dimension, double radius, double spacings_per_radius) {
    return two_resolutions(dimension, radius, spacings_per_radius, [](const Place& position) {
        return std::max({std::fabs(position[0]), std::fabs(position[1]), std::fabs(position[2])}) >
               6;
    });
}

/// A cube inside the ball fine, the rest coarse: the surface is that of the coarse lattice.
inline Droplet refined_core(int dimension, double radius, double spacings_per_radius) {
    return two_resolutions(dimension, radius, spacings_per_radius, [](const Place& position) {
        return std::max({std::fabs(position[0]), std::fabs(position[1]), std::fabs(position[2])}) <
               6;
    });
}

/// A lattice in a ball of that radius (spacing 1), seen in a spherical mirror that stands three
/// radii off its middle. It stays a ball, and spacings, the same in all directions, grow smoothly
/// by a factor of four from one side to the other.
inline Droplet graded(int dimension, double radius, double spacings_per_radius) {
    Droplet droplet;
    droplet.snapshot.dimension = dimension;
    droplet.spacings_per_radius = spacings_per_radius;
    const double off = 3 * radius;
    for_lattice_in_ball(dimension, 1, radius, [&](const Place& position, bool outermost) {
        const Place seen{position[0] + off, position[1], position[2]};
        const double scale = off * off / (length(seen) * length(seen));
        droplet.add({scale * seen[0], scale * seen[1], scale * seen[2]}, scale, outermost,
                    radius - length(position));
    });
    droplet.store_arrays();
    return droplet;
}

/// Moves each particle by up to that many of its spacings along each axis.
inline void shake(double spacings, Droplet& droplet) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> step(-spacings, spacings);
    for (std::size_t i = 0; i < droplet.snapshot.size(); ++i)
        for (int axis = 0; axis < droplet.snapshot.dimension; ++axis)
            droplet.snapshot.positions[i][axis] += droplet.spacing[i] * step(random);
}

} // namespace meniscus::test
