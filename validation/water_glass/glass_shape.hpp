// What is measured of a liquid that flows from a channel into a glass: a cone around the y axis,
// narrow below, that stands on y = 0.
#pragma once

#include <meniscus/sph/scene/scene.hpp>

#include <cstddef>
#include <optional>

namespace meniscus {

/// m.
struct Glass {
    double base = 0; ///< inner radius at y = 0
    double rim = 0;  ///< and at the height
    double height = 0;
    double lip = 0; ///< height of the channel's lower end, from where the jet falls

    [[nodiscard]] double radius_at(double y) const { return base + (rim - base) * y / height; }
};

/// The fluid between the lip and the rim, which touches no wall there.
struct Jet {
    std::size_t particles = 0;
    std::size_t largest = 0;  ///< particles of its largest connected body
    std::size_t droplets = 0; ///< its other bodies
};
Jet jet_of(const Positions& positions, const Glass& glass, double support_radius);

/// Particles in the glass.
std::size_t in_glass(const Positions& positions, const Glass& glass);

/// How high the largest body in the glass stands: over squares of the ground two spacings wide,
/// each with its highest particle and half a spacing more, the median.
struct Level {
    double height = 0;       ///< of the squares within the inner half of the radius there, m
    double rise_at_wall = 0; ///< of those within two spacings of the wall over these, m
};
/// Nothing where one of the two has no squares.
std::optional<Level> level_in(const Positions& positions, const Glass& glass, double spacing,
                              double support_radius);

/// The height that a surface reaches above the level at a plane upright wall that it meets at the
/// contact angle (degrees): sqrt(2 (1 - sin theta)) capillary lengths sqrt(sigma / (rho g)), which
/// is negative above 90 degrees.
double rise_at_plane(double contact_angle, double capillary_length);

} // namespace meniscus
