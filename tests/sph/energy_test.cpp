// What a fluid cannot do whatever the solver: gain energy, momentum or density; and what solvers
// say of themselves: iterations, errors, and whether they came to an end.
#include "small_scenes.hpp"

#include <meniscus/data/particles/particle_arrays.hpp>

namespace meniscus {
namespace {

double length_of(const Place& vector) {
    return std::hypot(vector[0], vector[1], vector[2]);
}

/// A column of water at the left of a tank three times as wide.
Scene column(int dimension, std::string_view solver, Precision precision = Precision::float32) {
    Scene scene = tank_scene(empty_scene(dimension, solver, precision), {15, 12, 5}, 8);
    scene.fluid = {{box_of(scene, {5, 8, 5}), {}}};
    scene.pressure.sound_speed = 60;
    scene.domain = {{{-5, -5, -5}, {5, 10, 5}}}; // jets rise from the corners
    return scene;
}

/// What the compression of a fluid after Becker and Teschner's equation of state stores (WCSPH):
/// the work of the pressure from the rest density on.
double elastic_energy(const Simulation& simulation, const Scene& scene) {
    if (scene.pressure.solver != "wcsph")
        return 0;
    const double mass = scene.rest_density * std::pow(scene.particle_spacing, scene.dimension);
    const double unit = mass * std::pow(scene.pressure.sound_speed, 2) / 7;
    double sum = 0;
    for (const double density : scalar_values(simulation.snapshot(), "density")) {
        const double ratio = density / scene.rest_density;
        if (ratio > 1)
            sum += unit * (std::pow(ratio, 6) / 6 + 1 / ratio - 7.0 / 6);
    }
    return sum;
}

/// A drop whose particles fly in all directions, so that it is compressed here and torn there.
std::unique_ptr<Simulation> stirred_drop(Scene scene) {
    const SceneParticles particles = fill_scene(scene);
    std::vector<Place> velocities;
    for (std::size_t i = 0; i < particles.positions.size(); ++i) {
        const double n = static_cast<double>(i);
        velocities.push_back(
            {std::sin(3 * n), std::cos(5 * n), scene.dimension == 3 ? std::sin(7 * n + 1) : 0});
    }
    return start_at(scene, particles.positions, velocities);
}

TEST(Energy, OfADamBreakDoesNotGrow) {
    for (const auto& [solver, name] : all_solvers)
        for (const int dimension : {2, 3}) {
            SCOPED_TRACE(name);
            const Scene scene = column(dimension, solver);
            const auto simulation = start(scene);
            const Balance first = simulation->balance();
            double lowest = first.potential_energy;
            double rise = 0;
            double kinetic = 0;
            run_until(*simulation, 1, [&](const StepReport&) {
                const Balance now = simulation->balance();
                const double energy =
                    now.kinetic_energy + now.potential_energy + elastic_energy(*simulation, scene);
                rise = std::max(rise, energy - lowest);
                lowest = std::min(lowest, energy);
                kinetic = std::max(kinetic, now.kinetic_energy);
            });
            EXPECT_LT(rise, 0.03 * first.potential_energy);
            EXPECT_GT(kinetic, 0.1 * first.potential_energy);
            EXPECT_LT(lowest, 0.95 * first.potential_energy); // it broke
        }
}

TEST(Energy, OfAStirredDropFalls) {
    for (const auto& [solver, name] : all_solvers)
        for (const int dimension : {2, 3}) {
            SCOPED_TRACE(name);
            Scene scene = drop_scene(empty_scene(dimension, solver), dimension == 3 ? 3 : 5);
            scene.viscosity.kinematic = 0.01;
            const auto simulation = stirred_drop(scene);
            const double first = simulation->balance().kinetic_energy;
            double max = 0;
            run_until(*simulation, 0.5, [&](const StepReport&) {
                max = std::max(max, simulation->balance().kinetic_energy);
            });
            EXPECT_LT(max, first);
            EXPECT_LT(simulation->balance().kinetic_energy, 0.7 * first);
        }
}

TEST(Momentum, IsKeptByEverySolverAndXsph) {
    for (const auto& [solver, name] : all_solvers)
        for (const int dimension : {2, 3})
            for (const Precision precision : {Precision::float32, Precision::float64})
                for (const double xsph : {0.0, 0.5}) {
                    SCOPED_TRACE(std::string(name) + ", XSPH " + std::to_string(xsph));
                    Scene scene = drop_scene(empty_scene(dimension, solver, precision), 3);
                    scene.viscosity = {0.01, true, xsph};
                    const auto simulation = stirred_drop(scene);
                    const Balance first = simulation->balance();
                    for (int n = 0; n < 20; ++n)
                        simulation->step(1);
                    const Balance last = simulation->balance();
                    Place gained{};
                    for (int axis = 0; axis < 3; ++axis)
                        gained[axis] = last.momentum[axis] - first.momentum[axis];
                    const double bound = precision == Precision::float32 ? 1e-5 : 1e-13;
                    EXPECT_LT(length_of(gained), bound * first.momentum_size);
                    EXPECT_LT(last.kinetic_energy, first.kinetic_energy);
                }
}

TEST(Momentum, XsphAloneEvensOutVelocities) {
    Scene scene = drop_scene(empty_scene(3, "wcsph", Precision::float64), 3);
    scene.volume_share = 0.5;
    scene.time_step.fixed = 1e-6;
    double kinetic = 1e300;
    for (const double share : {0.0, 0.2, 0.5}) {
        scene.viscosity.xsph = share;
        const auto simulation = stirred_drop(scene);
        const Balance first = simulation->balance();
        simulation->step(1);
        const Balance last = simulation->balance();
        EXPECT_LT(last.kinetic_energy, kinetic);
        EXPECT_LT(last.kinetic_energy, (1 - share / 2) * first.kinetic_energy * (1 + 1e-3));
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(last.momentum[axis], first.momentum[axis], 1e-13 * first.momentum_size);
        kinetic = last.kinetic_energy;
    }
}

TEST(Wcsph, CompressionFallsWithTheSquareOfTheSpeedOfSound) {
    std::vector<double> errors;
    for (const double speed : {20.0, 40.0, 80.0}) {
        Scene scene = tank_scene(empty_scene(2, "wcsph"), {8, 14, 1}, 10);
        scene.pressure.sound_speed = speed;
        scene.viscosity.kinematic = 0.05;
        const auto simulation = start(scene);
        run_until(*simulation, 1);
        double error = 0;
        int steps = 0;
        run_until(*simulation, 2, [&](const StepReport& report) {
            error += report.density_error;
            ++steps;
        });
        errors.push_back(error / steps);
    }
    for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
        EXPECT_GT(errors[i] / errors[i + 1], 2.5);
        EXPECT_LT(errors[i] / errors[i + 1], 6);
    }
}

TEST(Iterations, StayWithinTheirLimitsAndSayWhetherTheyConverged) {
    for (const std::string_view solver : {"pcisph", "iisph", "dfsph"})
        for (const bool loose : {true, false}) {
            Scene scene = column(2, solver);
            scene.pressure.min_iterations = 3;
            scene.pressure.max_iterations = loose ? 1000 : 4;
            scene.pressure.density_error = loose ? 0.01 : 1e-7;
            scene.pressure.divergence_error = loose ? 0.01 : 1e-7;
            const auto simulation = start(scene);
            int unconverged = 0;
            run_until(*simulation, 0.3, [&](const StepReport& report) {
                for (const int iterations :
                     {report.pressure_iterations, report.divergence_iterations}) {
                    if (iterations == 0 && solver != "dfsph")
                        continue; // it has no divergence-free solve
                    EXPECT_GE(iterations, 3);
                    EXPECT_LE(iterations, scene.pressure.max_iterations);
                }
                const bool within = report.density_error <= scene.pressure.density_error &&
                                    report.divergence_error <= scene.pressure.divergence_error;
                EXPECT_EQ(report.converged, within);
                unconverged += report.converged ? 0 : 1;
            });
            if (loose)
                EXPECT_EQ(unconverged, 0);
            else
                EXPECT_GT(unconverged, 10);
        }
}

TEST(Iterations, LeaveTheDivergenceFreeSolveOutWhereItHasNoLimit) {
    Scene scene = column(2, "dfsph");
    scene.pressure.divergence_error = 0;
    const auto simulation = start(scene);
    run_until(*simulation, 0.2, [](const StepReport& report) {
        EXPECT_EQ(report.divergence_iterations, 0);
        EXPECT_EQ(report.divergence_error, 0);
        EXPECT_TRUE(report.converged);
    });
}

/// Steps of a scene keep to a limit and reach it.
void expect_steps(const Scene& scene, double limit) {
    const auto simulation = start(scene);
    double longest = 0;
    for (int n = 0; n < 50; ++n) {
        const StepReport report = simulation->step(1);
        EXPECT_LE(report.time_step, limit * (1 + 1e-12));
        longest = std::max(longest, report.time_step);
    }
    EXPECT_GT(longest, 0.999 * limit);
}

TEST(TimeSteps, KeepToEachLimit) {
    Scene scene = column(2, "dfsph");
    scene.time_step.courant_factor = 0.5;
    scene.time_step.max = 0.002;
    expect_steps(scene, 0.002);
    scene.time_step.max = 1;
    scene.viscosity.kinematic = 1; // 0.0625 (h / 2)^2 / nu, and the factor
    expect_steps(scene, 0.5 * 0.0625 * 0.01);
    scene.viscosity.kinematic = 0;
    scene.surface_tension.model = "meniscus";
    scene.surface_tension.coefficient = 1e4;
    expect_steps(scene, 0.5 * std::sqrt(1000 * 0.001 / (2 * 3.14159265358979 * 1e4)));
    scene.surface_tension = {};
    scene.pressure.solver = "wcsph";
    expect_steps(scene, 0.5 * 0.4 * 0.2 / 60);
    scene.time_step.min = scene.time_step.max = 0.001; // it prevails
    scene.pressure.solver = "dfsph";
    scene.viscosity.kinematic = 2;
    expect_steps(scene, 0.001);
    scene.time_step.fixed = 0.0005;
    expect_steps(scene, 0.0005);
    EXPECT_EQ(start(scene)->step(0.0002).time_step, 0.0002);
}

TEST(TimeSteps, FollowTheSpeed) {
    for (const auto& [solver, name] : all_solvers) {
        SCOPED_TRACE(name);
        Scene scene = drop_scene(empty_scene(2, solver), 4);
        scene.fluid[0].velocity = {30, 40, 0};
        scene.volume_share = 0.7; // flies on as it is
        scene.domain = {{{-100, -100, -100}, {100, 100, 100}}};
        scene.time_step.courant_factor = 0.5;
        const auto simulation = start(scene);
        for (int n = 0; n < 10; ++n) {
            const StepReport report = simulation->step(1);
            EXPECT_NEAR(report.time_step, 0.5 * 0.4 * 0.1 / 50, 1e-9);
            EXPECT_NEAR(report.max_speed, 50, 1e-4);
        }
    }
}

} // namespace
} // namespace meniscus
