// How long a step is. The CFL condition and accelerations bound it (Monaghan 1992), and so does
// what a scene's methods say is stable. A solver that iterates takes compression back within the
// step; in a step much shorter than a stable one it is given longer, since what it took back at
// once would throw particles apart, the faster, the shorter the step. Speeds are in support radii a
// second, accelerations in support radii over s^2, all times in s.
#pragma once

#include <meniscus/sph/scene/scene.hpp>

namespace meniscus {

/// The step that the scene's options allow at that speed and acceleration, at most `longest`.
double time_step_for(const Scene& scene, double speed, double acceleration, double longest);

/// Whether a step is so short that a solver gets more time than it.
bool is_short_step(const Scene& scene, double time_step, double speed);

/// The time within which a solver that iterates takes compression back: that of the step, but
/// longer, up to a whole stable one, where the step is short.
double solve_time(const Scene& scene, double time_step, double speed);

} // namespace meniscus
