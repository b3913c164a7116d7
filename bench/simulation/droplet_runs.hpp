// What is measured of a droplet in zero gravity while it finds its shape or oscillates.
#pragma once

#include "watched_run.hpp"

#include <optional>

namespace meniscus {

/// How a droplet ended up. Values at the end are means over the last tenth of the run.
struct DropletRun {
    RunSummary summary;
    double radius = 0;          ///< mean of the outermost layer (droplet_shape), m
    double deviation = 0;       ///< standard deviation of that, over the mean
    double speed = 0;           ///< root mean square, m/s
    double capillary_speed = 0; ///< sqrt(sigma / (rho R)), m/s; 0 where the model knows no sigma
    double aspect_ratio = 0;    ///< longest over shortest axis (aspect_ratio())
    /// First time after which the deviation stays within a tenth of its end value, or below 1.5 %,
    /// s; none where that is in the last tenth of the run.
    std::optional<double> equilibrium;
};

/// Runs a scene of one or more droplets that become one. On one thread.
DropletRun run_droplet(const Scene& scene);

/// Root of the largest over the smallest second moment about the center of mass; in 2D
/// (`dimension`) of those in the plane.
double aspect_ratio(const Positions& positions, int dimension);

/// R of the ball (in 2D the disk) of as much volume as the particles have, m.
double volume_radius(const Scene& scene, const SceneParticles& particles);

/// A droplet of R = 0.5 m of water, 10 % longer in x than a ball, R / resolution between particles,
/// with the sigma for which its slowest oscillation takes 1 s; viscosity 1e-3 m^2/s, three seconds.
Scene stretched_droplet(int dimension, int resolution);

struct Oscillation {
    std::size_t particles = 0;
    double theory = 0;   ///< period of a slightly stretched droplet without viscosity (Lamb), s
    double period = 0;   ///< from the zeros of the quadrupole moment, s; 0: fewer than three
    std::string failure; ///< why it ended early; empty: it did not
};

/// Runs a droplet that is stretched in x. On one thread.
Oscillation watch_oscillation(const Scene& scene);

} // namespace meniscus
