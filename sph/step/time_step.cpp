#include "time_step.hpp"

#include <meniscus/sph/scene/methods.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {

namespace {

/// Of Monaghan (1992), for speeds and for the root of accelerations.
constexpr double courant_number = 0.4;

/// The longest step that is stable at that speed, with viscosity left out: what it allows says
/// nothing of how fast pressure may act. Compression taken back within so short a step as that of a
/// thick fluid would blow it up.
double stable_step(const Scene& scene, double speed) {
    double step =
        std::min(std::max(scene.time_step.max, default_max_time_step(scene.particle_spacing)),
                 longest_inviscid_step(scene));
    if (speed > 0)
        step = std::min(step,
                        courant_number * scene.particle_spacing / (speed * scene.support_radius));
    return step;
}

} // namespace

double time_step_for(const Scene& scene, double speed, double acceleration, double longest) {
    const TimeStepOptions& options = scene.time_step;
    if (options.fixed)
        return std::min(*options.fixed, longest);
    const double spacing = scene.particle_spacing / scene.support_radius;
    const double courant = courant_number * options.courant_factor;
    double step = std::min(options.max, options.courant_factor * longest_stable_step(scene));
    if (speed > 0)
        step = std::min(step, courant * spacing / speed);
    if (acceleration > 0)
        step = std::min(step, courant * std::sqrt(spacing / acceleration));
    return std::min(std::max(step, options.min), longest);
}

bool is_short_step(const Scene& scene, double time_step, double speed) {
    return time_step < stable_step(scene, speed) / 8;
}

double solve_time(const Scene& scene, double time_step, double speed) {
    if (!is_short_step(scene, time_step, speed))
        return time_step;
    const double stable = stable_step(scene, speed);
    return std::min(stable, stable * stable / (64 * time_step));
}

} // namespace meniscus
