#include "solver_runs.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/sph/scene/methods.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace meniscus::test {
namespace {

bool is_finite(const std::vector<Place>& vectors) {
    return std::all_of(vectors.begin(), vectors.end(), [](const Place& vector) {
        return std::all_of(vector.begin(), vector.end(), [](double x) { return std::isfinite(x); });
    });
}

double length_of(const Place& vector) {
    return std::hypot(vector[0], vector[1], vector[2]);
}

void look_at(const SimulationState& state, Outcome& outcome) {
    const std::size_t count = state.positions.size();
    outcome.places.resize(count);
    outcome.velocities.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        outcome.places[state.ids[i]] = state.positions[i];
        outcome.velocities[state.ids[i]] = state.velocities[i];
    }
    outcome.time = state.time;
    outcome.finite = is_finite(outcome.places) && is_finite(outcome.velocities);
}

Outcome outcome_of(const std::function<std::unique_ptr<Simulation>()>& start, int steps) {
    Outcome outcome;
    std::unique_ptr<Simulation> simulation;
    try {
        simulation = start();
        outcome.first = outcome.last = simulation->balance();
        for (int step = 0; step < steps; ++step) {
            look_at(simulation->state(), outcome);
            const StepReport report = simulation->step(1e30);
            outcome.density_error = std::max(outcome.density_error, report.density_error);
        }
        look_at(simulation->state(), outcome);
        outcome.last = simulation->balance();
    } catch (const InputError& error) {
        outcome.refused = error.what();
    } catch (const Divergence& error) {
        outcome.stopped = error.what();
    }
    return outcome;
}

} // namespace

std::string name_of(std::string_view method) {
    static const std::map<std::string_view, const char*> names = {{"wcsph", "WCSPH"},
                                                                  {"pcisph", "PCISPH"},
                                                                  {"iisph", "IISPH"},
                                                                  {"dfsph", "DFSPH"},
                                                                  {"none", "none"},
                                                                  {"meniscus", "ours"},
                                                                  {"becker_2007", "Becker"},
                                                                  {"huber_2015", "Huber"},
                                                                  {"akinci_2013", "Akinci"},
                                                                  {"he_2014", "He"},
                                                                  {"color_field", "color field"}};
    return names.at(method);
}

std::string name_of(Precision precision) {
    return precision == Precision::float32 ? "float" : "double";
}

double bound_of(const Method& method, double in_float, double in_double) {
    return method.precision == Precision::float32 ? in_float : in_double;
}

Scene plain_scene(const Method& method, double support_radius, double spacing) {
    Scene scene;
    scene.name = "hard_case";
    scene.dimension = method.dimension;
    scene.precision = method.precision;
    scene.particle_spacing = spacing;
    scene.support_radius = support_radius;
    scene.pressure.solver = method.solver;
    scene.pressure.sound_speed = 20 * support_radius;
    scene.surface_tension.model = method.tension;
    // Of the rivals no coefficient means the same for two of them: one that each of them feels.
    scene.surface_tension.coefficient =
        has_sigma(scene.surface_tension) ? 100 * std::pow(support_radius, 3) : 0.1;
    scene.time_step.min = 1e-9;
    scene.time_step.max = 0.01;
    return scene;
}

SceneParticles particles_of(const Scene& scene, Positions places, std::vector<Place> velocities,
                            Positions walls) {
    SceneParticles particles;
    particles.positions = std::move(places);
    particles.velocities = std::move(velocities);
    particles.velocities.resize(particles.positions.size());
    particles.walls = std::move(walls);
    particles.mass = scene.rest_density * std::pow(scene.particle_spacing, scene.dimension);
    return particles;
}

Scene scene_of(const HardCase& hard_case, const Method& method) {
    Scene scene = plain_scene(method, hard_case.support_radius, spacing_of(hard_case));
    if (spacing_ratio(scene) > 4.7) { // no line ships: test all exactly
        scene.surface_tension.surface.k = 0;
        scene.surface_tension.surface.d = 1e6;
    }
    if (hard_case.size() == 1) // so that it does not leave the box around itself
        scene.domain = {{{-10, -10, -10}, {10, 10, 10}}};
    return scene;
}

SceneParticles particles_of(const HardCase& hard_case, const Scene& scene) {
    return particles_of(scene, hard_case.positions, {}, hard_case.boundary);
}

double Outcome::momentum_error() const {
    const Place change{last.momentum[0] - first.momentum[0], last.momentum[1] - first.momentum[1],
                       last.momentum[2] - first.momentum[2]};
    return last.momentum_size == 0 ? 0 : length_of(change) / last.momentum_size;
}

Outcome run_steps(const Scene& scene, const SceneParticles& particles, int steps) {
    return outcome_of([&] { return simulate(scene, particles, 1); }, steps);
}

Outcome run_steps(const Scene& scene, const SceneParticles& particles, const SimulationState& state,
                  int steps) {
    return outcome_of([&] { return simulate(scene, particles, state, 1); }, steps);
}

std::string message_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const InputError& error) {
        return error.what();
    } catch (const Divergence& error) {
        return error.what();
    }
    return "";
}

double distance_of(const Place& a, const Place& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double max_distance(const Positions& a, const Positions& b) {
    double max = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        max = std::max(max, distance_of(a[i], b[i]));
    return max;
}

Ball jittered_ball(int dimension, double radius) {
    Ball ball;
    std::mt19937 generator(5);
    const auto random = [&] { return static_cast<double>(generator()) * 0x1p-31 - 1; };
    const int reach = static_cast<int>(2 * radius);
    for (int x = -reach; x <= reach; ++x)
        for (int y = -reach; y <= reach; ++y)
            for (int z = -reach * (dimension - 2); z <= reach * (dimension - 2); ++z) {
                if (x * x + y * y + z * z > 4 * radius * radius)
                    continue;
                Place place{0.5 * x, 0.5 * y, 0.5 * z};
                Place velocity{};
                for (int axis = 0; axis < dimension; ++axis) {
                    place[axis] += 0.05 * random();
                    velocity[axis] = 0.1 * random();
                }
                ball.places.push_back(place);
                ball.velocities.push_back(velocity);
            }
    return ball;
}

} // namespace meniscus::test
