#include "droplet_runs.hpp"

#include <meniscus/runtime/math/angles.hpp>
#include <meniscus/sph/scene/methods.hpp>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

/// A droplet at one moment.
struct Look {
    double time;
    double radius;
    double deviation; ///< over the radius
    double speed;
};

Look look_at(const Simulation& simulation, double support_radius) {
    const SimulationState state = simulation.state();
    const DropletShape shape = droplet_shape(state, support_radius);
    return {state.time, shape.radius, shape.deviation / shape.radius, mean_speed(state)};
}

/// Sets the values at the end and the time of equilibrium.
void sum_up(const std::vector<Look>& looks, DropletRun& run) {
    const std::size_t last = std::max<std::size_t>(1, looks.size() / 10);
    const auto tail = looks.end() - static_cast<std::ptrdiff_t>(last);
    for (auto look = tail; look != looks.end(); ++look) {
        run.radius += look->radius / static_cast<double>(last);
        run.deviation += look->deviation / static_cast<double>(last);
        run.speed += look->speed / static_cast<double>(last);
    }
    const auto is_off = [&](const Look& look) {
        return look.deviation > 0.015 &&
               std::abs(look.deviation - run.deviation) > 0.1 * run.deviation;
    };
    const auto off = std::find_if(looks.rbegin(), looks.rend(), is_off);
    if (off.base() < tail)
        run.equilibrium = off.base()->time;
}

/// The share of sum m x^2 that lies in x beyond its part in a ball, over the volume: the sign says
/// which way the droplet is stretched.
double quadrupole(const SimulationState& state, int dimension) {
    Place center{};
    Place squares{};
    const auto count = static_cast<double>(state.positions.size());
    for (const Place& place : state.positions)
        for (int axis = 0; axis < 3; ++axis)
            center[axis] += place[axis] / count;
    for (const Place& place : state.positions)
        for (int axis = 0; axis < 3; ++axis)
            squares[axis] += std::pow(place[axis] - center[axis], 2) / count;
    return squares[0] - (squares[1] + squares[2]) / (dimension - 1);
}

double lamb_period(const Scene& scene, double radius) {
    const double stiffness = scene.dimension == 3 ? 8 : 6; // n (n - 1)(n + 2) and n (n^2 - 1)
    return 2 * pi *
           std::sqrt(scene.rest_density * std::pow(radius, 3) /
                     (stiffness * scene.surface_tension.coefficient));
}

} // namespace

DropletRun run_droplet(const Scene& scene) {
    DropletRun run;
    std::vector<Look> looks;
    Positions last;
    constexpr double interval = 0.02;
    double next = 0;
    const SceneParticles particles = fill_scene(scene);
    run.summary = watch_run(
        scene, particles,
        [&](const Simulation& simulation, const StepReport&) {
            const bool ends = simulation.time() >= scene.duration;
            if (simulation.time() < next && !ends)
                return;
            next = simulation.time() + interval;
            looks.push_back(look_at(simulation, scene.support_radius));
            if (ends)
                last = simulation.state().positions;
        },
        1);
    if (!run.summary.failure.empty())
        return run;
    sum_up(looks, run);
    run.aspect_ratio = aspect_ratio(last, scene.dimension);
    if (has_sigma(scene.surface_tension))
        run.capillary_speed = std::sqrt(scene.surface_tension.coefficient /
                                        (scene.rest_density * volume_radius(scene, particles)));
    return run;
}

double aspect_ratio(const Positions& positions, int dimension) {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const Place& place : positions)
        center += Eigen::Map<const Eigen::Vector3d>(place.data());
    center /= static_cast<double>(positions.size());
    for (const Place& place : positions) {
        const Eigen::Vector3d offset = Eigen::Map<const Eigen::Vector3d>(place.data()) - center;
        squares += offset * offset.transpose();
    }
    const Eigen::Vector3d moments =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(squares).eigenvalues(); // rising
    return std::sqrt(moments[2] / moments[3 - dimension]);
}

double volume_radius(const Scene& scene, const SceneParticles& particles) {
    const double volume =
        particles.mass * static_cast<double>(particles.positions.size()) / scene.rest_density;
    return scene.dimension == 3 ? std::cbrt(3 * volume / (4 * pi)) : std::sqrt(volume / pi);
}

Scene stretched_droplet(int dimension, int resolution) {
    constexpr double radius = 0.5;
    constexpr double stretch = 1.1;
    const double aside = radius * (dimension == 3 ? 1 / std::sqrt(stretch) : 1 / stretch);
    Scene scene;
    scene.name = "stretched_droplet";
    scene.dimension = dimension;
    scene.particle_spacing = radius / resolution;
    scene.support_radius = 2 * scene.particle_spacing;
    scene.duration = scene.frame_interval = 3;
    scene.fluid = {{SphereShape{{}, {radius * stretch, aside, aside}}, {}}};
    scene.pressure.sound_speed = 16; // ten times that of free fall under the pressure inside
    scene.viscosity.kinematic = 1e-3;
    scene.surface_tension.model = "meniscus";
    scene.surface_tension.coefficient = 1;
    scene.surface_tension.coefficient = std::pow(lamb_period(scene, radius), 2);
    scene.time_step.fixed = 1e-3;
    return scene;
}

Oscillation watch_oscillation(const Scene& scene) {
    const SceneParticles particles = fill_scene(scene);
    std::vector<double> zeros;
    double before = 0;
    const RunSummary run = watch_run(
        scene, particles,
        [&](const Simulation& simulation, const StepReport& report) {
            const double moment = quadrupole(simulation.state(), scene.dimension);
            if (before * moment < 0)
                zeros.push_back(report.time - report.time_step * moment / (moment - before));
            before = moment;
        },
        1);
    Oscillation found;
    found.failure = run.failure;
    found.particles = particles.positions.size();
    found.theory = lamb_period(scene, volume_radius(scene, particles));
    // Over an even number of zeros, so that a droplet that comes to rest a little off a ball counts
    // as one that does not.
    if (zeros.size() > 2) {
        const std::size_t periods = (zeros.size() - 1) / 2;
        found.period = (zeros[2 * periods] - zeros[0]) / static_cast<double>(periods);
    }
    return found;
}

} // namespace meniscus
