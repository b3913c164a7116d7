#include "solver_checks.hpp"

#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace meniscus::test {
namespace {

Check begun(const std::string& name, const Method& method, const std::string& expected) {
    return {name,
            name_of(method.solver) + ", " + name_of(method.tension) + ", " +
                name_of(method.precision),
            expected,
            "",
            0,
            false};
}

/// Takes the outcome's failure, if any; true where it went on.
bool went_on(const Outcome& outcome, Check& check) {
    check.result = outcome.refused + outcome.stopped;
    if (check.result.empty() && !outcome.finite)
        check.result = "not finite";
    return check.result.empty();
}

Check check_pair_at_rest(Method method) {
    method.tension = "none";
    Check check = begun("pair_at_rest", method,
                        "stays to the last bit: farther apart than at rest, and nothing pulls");
    const Scene scene = plain_scene(method, 1, 0.5);
    const Positions places{{0, 0, 0}, {0.7, 0, 0}};
    const Outcome outcome = run_steps(scene, particles_of(scene, places), 20);
    if (!went_on(outcome, check))
        return check;
    check.max_error = max_distance(outcome.places, places);
    check.passed = check.max_error == 0;
    check.result = check.passed ? "stays" : "moves";
    return check;
}

Check check_coincident_inside(Method method) {
    method.tension = "none";
    Check check = begun("coincident_pair_inside", method,
                        "parts by more than half a spacing: the fluid is too dense there");
    Scene scene = plain_scene(method, 1, 0.5);
    scene.domain = {{{-100, -100, -100}, {100, 100, 100}}}; // nothing holds the ball together
    Positions places = jittered_ball(method.dimension, 2).places;
    const auto middle =
        std::min_element(places.begin(), places.end(), [](const Place& a, const Place& b) {
            return distance_of(a, {}) < distance_of(b, {});
        });
    const auto i = static_cast<std::size_t>(middle - places.begin());
    places.push_back(places[i]);
    const Outcome outcome = run_steps(scene, particles_of(scene, places), 100);
    if (!went_on(outcome, check))
        return check;
    const double distance = distance_of(outcome.places[i], outcome.places.back());
    check.max_error = std::max(0.0, 0.5 - distance);
    check.passed = distance > 0.25;
    check.result = check.passed ? "parts" : "stays within " + rounded_text(distance, 2) + " h";
    return check;
}

double mean_neighbors(const Positions& places) {
    double sum = 0;
    for (const Place& a : places)
        for (const Place& b : places)
            sum += &a != &b && distance_of(a, b) < 1 ? 1 : 0;
    return sum / static_cast<double>(places.size());
}

/// A ball whose distances are `stretch` times those at rest.
Check check_density(const Method& method, double stretch) {
    const Scene scene = plain_scene(method, 1, 0.5);
    Positions places = jittered_ball(method.dimension, method.dimension == 3 ? 2 : 4).places;
    for (Place& place : places)
        for (double& coordinate : place)
            coordinate *= stretch;
    Check check =
        begun("stretched_by_" + rounded_text(stretch, 2), method,
              stretch < 1 ? "finds its density again within 200 steps, to 1 %, or stops: too dense"
                          : "finite, and momentum stays: a fluid of holes, which tension closes");
    SceneParticles particles = particles_of(scene, places);
    Scene open = scene;
    open.domain = {{{-100, -100, -100}, {100, 100, 100}}};
    const auto simulation = simulate(open, particles, 1);
    double error = 0;
    check.result = message_of([&] {
        for (int step = 0; step < 200; ++step)
            error = simulation->step(1).density_error;
    });
    const Balance last = simulation->balance();
    const bool momentum_stays = std::hypot(last.momentum[0], last.momentum[1], last.momentum[2]) <=
                                bound_of(method, 1e-6, 1e-14) * last.momentum_size;
    check.max_error = error;
    const std::string neighbors = rounded_text(mean_neighbors(places), 2) + " neighbors: ";
    const bool says_why = check.result.find("the mean density error is") != std::string::npos;
    check.passed = check.result.empty() ? momentum_stays && error < 0.01 : stretch < 1 && says_why;
    if (check.passed)
        check.result = neighbors + (says_why ? "stops, too dense" : "goes on");
    return check;
}

Check check_momentum(const Method& method) {
    const bool has_pairs = method.tension != "color_field";
    Check check = begun("momentum", method,
                        has_pairs ? "stays to rounding: pairs push each other by opposite forces"
                                  : "changes by some percent: the model's forces are no pairs");
    const Scene scene = plain_scene(method, 1, 0.5);
    const Ball ball = jittered_ball(method.dimension, 2);
    const Outcome outcome = run_steps(scene, particles_of(scene, ball.places, ball.velocities), 20);
    if (!went_on(outcome, check))
        return check;
    check.max_error = outcome.momentum_error();
    const bool stays = check.max_error < bound_of(method, 1e-6, 1e-14);
    check.passed = has_pairs ? stays : !stays && check.max_error < 0.05;
    check.result = stays ? "stays" : "changes";
    return check;
}

/// Twenty steps of the jittered ball, moved and scaled; places as if it were neither.
Outcome moved_ball(const Method& method, double offset, double scale) {
    const Scene scene = plain_scene(method, scale, 0.5 * scale);
    Ball ball = jittered_ball(method.dimension, 2);
    for (auto* vectors : {&ball.places, &ball.velocities})
        for (Place& vector : *vectors)
            for (int axis = 0; axis < method.dimension; ++axis)
                vector[axis] = scale * (vector[axis] + (vectors == &ball.places ? offset : 0));
    Outcome outcome = run_steps(scene, particles_of(scene, ball.places, ball.velocities), 20);
    for (Place& place : outcome.places)
        for (int axis = 0; axis < method.dimension; ++axis)
            place[axis] = place[axis] / scale - offset;
    return outcome;
}

Check check_same(Check check, const Outcome& one, const Outcome& other, double bound) {
    if (!went_on(one, check) || !went_on(other, check))
        return check;
    check.max_error = max_distance(one.places, other.places);
    check.passed = check.max_error < bound;
    check.result = check.passed ? "the same" : "differs";
    return check;
}

Check check_translation(const Method& method, double offset) {
    const Check check = begun("moved_by_" + rounded_text(offset, 1) + "_h", method,
                              "the same flow as at the origin, to rounding of places out there");
    return check_same(check, moved_ball(method, 0, 1), moved_ball(method, offset, 1),
                      bound_of(method, 1e-5, 1e-12) + 1e-14 * offset);
}

Check check_scale(const Method& method, double radius) {
    const Check check = begun("radius_" + rounded_text(radius, 1) + "_m", method,
                              "the same flow as with h = 1 m, to rounding");
    return check_same(check, moved_ball(method, 0, 1), moved_ball(method, 0, radius),
                      bound_of(method, 1e-5, 1e-12));
}

Check check_order(const Method& method) {
    const Check check =
        begun("order_of_storage", method, "the same flow, to rounding of sums, in any order");
    const Scene scene = plain_scene(method, 1, 0.5);
    const Ball ball = jittered_ball(method.dimension, 2);
    const SceneParticles particles = particles_of(scene, ball.places, ball.velocities);
    SimulationState state = simulate(scene, particles, 1)->state();
    std::vector<std::uint32_t> order(state.ids.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), std::mt19937(3));
    const SimulationState before = state;
    for (std::size_t i = 0; i < order.size(); ++i) {
        state.ids[i] = before.ids[order[i]];
        state.positions[i] = before.positions[order[i]];
        state.velocities[i] = before.velocities[order[i]];
    }
    return check_same(check, run_steps(scene, particles, 20),
                      run_steps(scene, particles, state, 20), bound_of(method, 1e-5, 1e-12));
}

/// Gravity's part of a velocity in one step is less than float keeps of it.
Check check_fall_in_tiny_steps(Method method) {
    method.tension = "none";
    Check check = begun("fall_in_steps_of_1e-9_s", method,
                        "falls: what a velocity rounds off in a step is kept for the next");
    Scene scene = plain_scene(method, 1, 0.5);
    scene.gravity = {0, -9.81, 0};
    scene.time_step.fixed = 1e-9;
    const Outcome outcome = run_steps(scene, particles_of(scene, {{0, 0, 0}}, {{0, -3, 0}}), 1000);
    if (!went_on(outcome, check))
        return check;
    const double gained = -3 - outcome.velocities[0][1];
    check.max_error = std::abs(gained / (9.81 * 1e-6) - 1);
    check.passed = check.max_error < 1e-5;
    check.result = check.passed ? "falls" : "gains " + rounded_text(gained, 3) + " m/s";
    return check;
}

} // namespace

std::vector<Check> check_motion(const Method& method) {
    std::vector<Check> checks{check_momentum(method), check_order(method),
                              check_translation(method, 1e4), check_translation(method, 1e7)};
    if (method.tension != "meniscus")
        return checks;
    for (const double radius : {1e-9, 1e9})
        checks.push_back(check_scale(method, radius));
    for (const double stretch : {0.75, 0.8, 0.9, 1.1, 1.2})
        checks.push_back(check_density(method, stretch));
    checks.push_back(check_pair_at_rest(method));
    checks.push_back(check_coincident_inside(method));
    checks.push_back(check_fall_in_tiny_steps(method));
    return checks;
}

} // namespace meniscus::test
