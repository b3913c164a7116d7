// Shapes of a surface at rest between gravity and surface tension, integrated from the equation of
// Young and Laplace: along the profile, from where it is level,
//     d(angle)/ds = curvature at the level point + z / l^2   (in 3D less sin(angle) / x),
// z being the depth below the top of a drop, or the height above the lowest point of a meniscus,
// and l = sqrt(sigma / (rho g)) the capillary length. Angles in radians, lengths in any one unit.
#pragma once

namespace meniscus {

/// A drop on a level wall.
struct SessileDrop {
    double height = 0;
    double contact_radius = 0; ///< where it meets the wall; in 2D half the width there
    double max_radius = 0;
};

/// Of that volume (in 2D area). In 3D it is a body of revolution. Throws std::invalid_argument for
/// an angle that isn't between 0 and pi, and for lengths or volumes that aren't above 0.
SessileDrop sessile_drop(int dimension, double contact_angle, double capillary_length,
                         double volume);

/// The liquid between two upright plates, in 2D; both are below 0 above a right angle.
struct PlateMeniscus {
    double middle = 0; ///< height of the surface half way between the plates, over a wide bath
    double rise = 0;   ///< of the surface above the middle, at a distance from a plate
};

/// Plates that stand `gap` apart; `rise` is taken at the distance `from_plate` from one. Throws as
/// sessile_drop() does.
PlateMeniscus plate_meniscus(double contact_angle, double capillary_length, double gap,
                             double from_plate);

} // namespace meniscus
