#include "solver_checks.hpp"

#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace meniscus::test {
namespace {

constexpr double spacing = 0.1; // m

Scene dam_break(const Method& method) {
    Scene scene = plain_scene(method, 2 * spacing, spacing);
    scene.surface_tension.coefficient = 20;
    scene.gravity = {0, -9.81, 0};
    const double depth = method.dimension == 3 ? 0.6 : 0;
    scene.fluid = {{BoxShape{{0, 0, 0}, {0.8, 1.6, depth}, {}}, {}}};
    BoxShape tank{{-0.05, -0.05, -0.05}, {2.05, 3.05, depth + 0.05}, {"+y"}};
    if (method.dimension == 2)
        tank.low[2] = tank.high[2] = 0;
    scene.walls = {tank};
    return scene;
}

Scene droplet(const Method& method) {
    Scene scene = plain_scene(method, 2 * spacing, spacing);
    scene.surface_tension.coefficient = 200;
    const double radius = method.dimension == 3 ? 0.4 : 0.7;
    SphereShape ball{{}, {1.4 * radius, radius, method.dimension == 3 ? radius : 0}};
    scene.fluid = {{ball, {}}};
    scene.domain = {{{-10, -10, -10}, {10, 10, 10}}};
    return scene;
}

/// A flow on its way, with the shortest step, s, that it takes by itself in the hundred that
/// follow: one that stays stable as it speeds up.
struct Developed {
    Scene scene;
    SceneParticles particles;
    SimulationState state;
    Balance balance;
    double step = 0;

    Developed(const std::string& flow, const Method& method)
        : scene(flow == "droplet" ? droplet(method) : dam_break(method)) {
        scene.volume_share = 0.99;
        scene.viscosity.kinematic = 0.002;
        scene.pressure.sound_speed = 40;
        scene.time_step.max = 0.005;
        particles = fill_scene(scene);
        const auto simulation = simulate(scene, particles, 1);
        while (simulation->time() < 0.3)
            simulation->step(1);
        state = simulation->state();
        balance = simulation->balance();
        step = scene.time_step.max;
        for (int ahead = 0; ahead < 100; ++ahead)
            step = std::min(step, simulation->step(1).time_step);
    }

    [[nodiscard]] Outcome run(double share, int steps) const {
        Scene fixed = scene;
        fixed.time_step.fixed = share * step;
        return run_steps(fixed, particles, state, steps);
    }

    /// Kinetic, of gravity, and of the surface, J.
    [[nodiscard]] double energy(const Balance& sums) const {
        return sums.kinetic_energy + sums.potential_energy +
               scene.surface_tension.coefficient * sums.surface_area;
    }
    /// That the flow can lose, besides gravity's.
    [[nodiscard]] double own_energy() const {
        return balance.kinetic_energy + scene.surface_tension.coefficient * balance.surface_area;
    }
};

std::string method_text(const Method& method) {
    return name_of(method.solver) + " " + std::to_string(method.dimension) + "D " +
           name_of(method.precision);
}

std::string share_text(double share) {
    return share == 1 ? "1" : number_text(share);
}

/// A hundred steps.
Check check_run(const std::string& flow, const Method& method, const Developed& developed,
                double share) {
    const bool iterates = method.solver != "wcsph";
    Check check{flow + ", " + share_text(share) + " of the step",
                method_text(method),
                iterates ? "finite, mean compression within its limit of 0.05 %, energy up by 3 % "
                           "at most: nothing feeds it"
                         : "finite, mean compression within 1 %, energy up by 3 % at most",
                "",
                0,
                false};
    const Outcome outcome = developed.run(share, 100);
    check.result = outcome.refused + outcome.stopped;
    if (!check.result.empty() || !outcome.finite)
        return check;
    check.max_error = (developed.energy(outcome.last) - developed.energy(developed.balance)) /
                      developed.own_energy();
    check.passed = outcome.density_error <= (iterates ? 0.0005 : 0.01) && check.max_error < 0.03;
    check.result = "compression up to " + rounded_text(100 * outcome.density_error, 2) +
                   " %, speed up to " + rounded_text(outcome.last.max_speed, 3) + " m/s";
    return check;
}

/// The same time in ten steps and in a hundred.
Check check_agreement(const std::string& flow, const Method& method, const Developed& developed,
                      double share) {
    Check check{flow + ", " + share_text(share) + " and " + share_text(share / 10) + " of the step",
                method_text(method),
                "as far apart after ten of the longer steps as the order of the step says: 1 "
                "spacing times its share of the stable step, where the fastest particle went 4",
                "",
                0,
                false};
    const Outcome longer = developed.run(share, 10);
    const Outcome shorter = developed.run(share / 10, 100);
    check.result = longer.refused + longer.stopped + shorter.refused + shorter.stopped;
    if (!check.result.empty() || !longer.finite || !shorter.finite)
        return check;
    const double apart = max_distance(longer.places, shorter.places) / spacing;
    check.max_error = apart / share;
    check.passed = check.max_error < 1;
    check.result = rounded_text(apart, 2) + " spacings apart";
    return check;
}

} // namespace

Check check_long_run(const std::string& flow, const Method& method) {
    constexpr double share = 1e-3;
    constexpr int steps = 20;
    const Developed developed(flow, method);
    Check check{flow + ", for the time of 20 steps, 0.001 of the step",
                method_text(method),
                "kinetic energy as with whole steps, to 15 %, energy up by 3 % at most",
                "",
                0,
                false};
    const Outcome whole = developed.run(1, steps);
    const Outcome parts = developed.run(share, static_cast<int>(steps / share));
    check.result = whole.refused + whole.stopped + parts.refused + parts.stopped;
    if (!check.result.empty() || !parts.finite)
        return check;
    const double rise = (developed.energy(parts.last) - developed.energy(developed.balance)) /
                        developed.own_energy();
    check.max_error = std::abs(parts.last.kinetic_energy / whole.last.kinetic_energy - 1);
    check.passed = check.max_error < 0.15 && rise < 0.03;
    check.result = "energy rises by " + rounded_text(100 * rise, 2) + " %";
    return check;
}

std::vector<Check> check_step_lengths(const std::string& flow, const Method& method) {
    const Developed developed(flow, method);
    std::vector<Check> checks;
    for (const double share : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
        checks.push_back(check_run(flow, method, developed, share));
        if (share > 1e-5)
            checks.push_back(check_agreement(flow, method, developed, share));
    }
    return checks;
}

} // namespace meniscus::test
