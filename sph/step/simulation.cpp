#include "simulation.hpp"

#include "step.hpp"

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/data/threads/threads.hpp>
#include <meniscus/runtime/math/angles.hpp>
#include <meniscus/runtime/surface/shipped_classifier.hpp>
#include <meniscus/sph/scene/methods.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace meniscus {
namespace {

double squared_length_of(const Place& vector) {
    return vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2];
}

SimulationState first_state(const Scene& scene, const SceneParticles& particles) {
    const std::size_t count = particles.positions.size();
    SimulationState state;
    state.positions = particles.positions;
    state.velocities = particles.velocities;
    state.ids.resize(count);
    std::iota(state.ids.begin(), state.ids.end(), 0U);
    state.pressures.assign(count, 0);
    state.divergences.assign(count, 0);
    if (scene.dimension == 2)
        for (std::size_t i = 0; i < count; ++i)
            state.positions[i][2] = state.velocities[i][2] = 0;
    return state;
}

void check_finite(const Place& vector, const char* whose, std::size_t number, const char* what) {
    for (const double coordinate : vector)
        if (!std::isfinite(coordinate))
            throw InputError(whose + std::to_string(number) + " has a " + what +
                             " that is not finite");
}

void check_state(const SimulationState& state, std::size_t first_count) {
    const std::size_t count = state.positions.size();
    if (count >= std::numeric_limits<std::uint32_t>::max() - 8)
        throw InputError("too many particles for one simulation: " + std::to_string(count));
    if (state.ids.size() != count || state.velocities.size() != count ||
        state.pressures.size() != count || state.divergences.size() != count)
        throw InputError("the arrays of the state to start from differ in length");
    if (count == 0)
        throw InputError("a simulation needs at least one particle, found none");
    if (!std::isfinite(state.time) || !std::isfinite(state.time_step) || state.time_step < 0)
        throw InputError("the time of the state to start from is not a number of seconds");
    std::vector<std::uint8_t> seen(first_count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        if (state.ids[i] >= first_count || seen[state.ids[i]]++ != 0)
            throw InputError("particle " + std::to_string(i) + " has the id " +
                             std::to_string(state.ids[i]) +
                             ", expected each number below the number of particles once");
        check_finite(state.positions[i], "particle ", state.ids[i], "position");
        check_finite(state.velocities[i], "particle ", state.ids[i], "velocity");
        if (!std::isfinite(state.pressures[i]) || !std::isfinite(state.divergences[i]))
            throw InputError("particle " + std::to_string(state.ids[i]) +
                             " has a solver's pressure that is not finite");
    }
}

void expect(bool holds, const std::string& what, double found) {
    if (!holds)
        throw InputError("a scene's " + what + ", found " + number_text(found));
}

void expect_positive(double value, const char* what) {
    expect(std::isfinite(value) && value > 0, std::string(what) + " must be a positive number",
           value);
}

void check_time_step(const TimeStepOptions& options) {
    if (options.fixed) {
        expect_positive(*options.fixed, "fixed time step");
        return;
    }
    expect_positive(options.courant_factor, "courant_factor");
    expect_positive(options.min, "smallest time step");
    expect(options.max >= options.min && std::isfinite(options.max),
           "largest time step must be a number and at least the smallest", options.max);
}

/// Numbers that have no default must have been set.
void check_pressure(const PressureOptions& options) {
    const auto& solver = pressure_solvers()[pressure_solver_place(options.solver)];
    for (const PressureKey& key : pressure_keys) {
        const auto* number = std::get_if<double PressureOptions::*>(&key.option);
        if (number == nullptr || has_default(key) || !reads_key(solver, key.name))
            continue;
        std::string words = key.name;
        std::replace(words.begin(), words.end(), '_', ' ');
        expect_positive(options.*(*number), words.c_str());
    }
}

/// What finds the surface must know the scene's support radius.
void check_classifier(const Scene& scene) {
    if (!knows_surface(scene.surface_tension))
        return;
    SurfaceTensionOptions options = scene.surface_tension.surface;
    expect(scene.surface_tension.model_file.empty() || !takes_shipped_line(options),
           "the model file of a scene must be read before it runs (use_model_file)", options.k);
    if (!takes_shipped_line(options))
        return;
    options.spacing_ratio = spacing_ratio(scene);
    try {
        set_shipped_classifier(options, scene.dimension);
    } catch (const std::invalid_argument& error) {
        throw InputError(std::string(error.what()) +
                         ", as surface_tension.k and .d or surface_tension.model_file");
    }
}

/// Refuses a support radius that reaches over more particles than lists are to hold; few particles
/// never have so many neighbors.
void check_neighbor_count(const Scene& scene, const SceneParticles& particles) {
    const double h = spacing_ratio(scene);
    const double in_ball = scene.dimension == 2 ? pi * h * h : 4 * pi / 3 * h * h * h;
    const auto most = static_cast<double>(max_listed_neighbors);
    if (std::min(in_ball, static_cast<double>(particles.positions.size())) > most)
        throw InputError("a support radius of " + rounded_text(scene.support_radius, 4) +
                         " m gives " + rounded_text(in_ball, 3) +
                         " neighbors a particle, expected at most " + rounded_text(most, 4) +
                         "; make support_radius smaller");
}

/// What read_scene() refuses in a file, for scenes that a program made: numbers that would spoil
/// the whole fluid.
void check_numbers(const Scene& scene, const SceneParticles& particles) {
    expect(scene.dimension == 2 || scene.dimension == 3, "dimension must be 2 or 3",
           scene.dimension);
    expect_positive(scene.particle_spacing, "particle spacing");
    expect(scene.support_radius >= 1e-30 && scene.support_radius <= 1e30,
           "support radius must be a number of metres from 1e-30 to 1e30", scene.support_radius);
    const double ratio = scene.support_radius / scene.particle_spacing;
    expect(ratio >= 1 && ratio <= 100, "support radius must be 1 to 100 spacings", ratio);
    check_neighbor_count(scene, particles);
    expect_positive(scene.rest_density, "rest density");
    expect_positive(particles.mass, "mass of a particle");
    for (const double acceleration : scene.gravity)
        expect(std::isfinite(acceleration), "gravity must be finite", acceleration);
    const ViscosityOptions& viscosity = scene.viscosity;
    expect(std::isfinite(viscosity.kinematic) && viscosity.kinematic >= 0,
           "kinematic viscosity must be finite and not negative", viscosity.kinematic);
    expect(viscosity.xsph >= 0 && viscosity.xsph <= 1, "xsph must be 0 to 1", viscosity.xsph);
    expect(std::isfinite(scene.surface_tension.coefficient),
           "coefficient of surface tension must be finite", scene.surface_tension.coefficient);
    check_classifier(scene);
    check_pressure(scene.pressure);
    check_time_step(scene.time_step);
}

/// How far from the middle of the domain, in support radii, places keep three digits of one.
double farthest_of(const Scene& scene) {
    return scene.precision == Precision::float32 ? 1e4 : 1e6;
}

std::string precision_advice(const Scene& scene) {
    return scene.precision == Precision::float32 ? "or set \"precision\" to \"double\""
                                                 : "what belongs to one fluid lies closer together";
}

void check_domain_size(const Scene& scene) {
    if (!scene.domain)
        return;
    const auto& [low, high] = *scene.domain;
    for (int axis = 0; axis < scene.dimension; ++axis) {
        const double reach = (high[axis] / 2 - low[axis] / 2) / scene.support_radius;
        if (!(reach > 0 && reach <= farthest_of(scene)))
            throw InputError(std::string("the domain reaches ") + number_text(reach) +
                             " support radii from its middle along " + "xyz"[axis] +
                             ", expected more than 0 and at most " +
                             number_text(farthest_of(scene)) + ": make it smaller, " +
                             precision_advice(scene));
    }
}

/// Throws InputError for a place so far out that the step's numbers would tell it from its
/// neighbors no more. `what` and `number` name its particle.
void check_distance(const Place& place, const Scene& scene, const std::array<Place, 2>& domain,
                    const char* what, std::size_t number) {
    const double farthest = farthest_of(scene);
    for (int axis = 0; axis < scene.dimension; ++axis) {
        const double middle = domain[0][axis] / 2 + domain[1][axis] / 2;
        if (std::abs(place[axis] - middle) > farthest * scene.support_radius)
            throw InputError(what + std::to_string(number) + " is at " + "xyz"[axis] + " = " +
                             number_text(place[axis]) + " m, more than " + number_text(farthest) +
                             " support radii from the middle of the domain; bring it closer, " +
                             precision_advice(scene));
    }
}

void check_places(const SimulationState& state, const Scene& scene,
                  const SceneParticles& particles) {
    for (std::size_t b = 0; b < particles.walls.size(); ++b)
        check_finite(particles.walls[b], "wall particle ", b, "position");
    check_domain_size(scene);
    const std::array<Place, 2> domain = scene_domain(scene, particles);
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
        check_distance(state.positions[i], scene, domain, "particle ", state.ids[i]);
        check_resolution(state.positions[i], scene, "particle ", state.ids[i]);
    }
    for (std::size_t b = 0; b < particles.walls.size(); ++b) {
        check_distance(particles.walls[b], scene, domain, "wall particle ", b);
        check_resolution(particles.walls[b], scene, "wall particle ", b);
    }
}

/// Values in the order of ids, some of which may be missing.
template <class Value>
std::vector<Value> by_id(const std::vector<std::uint32_t>& ids, const std::vector<Value>& values) {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> place_of;
    for (std::uint32_t i = 0; i < ids.size(); ++i) {
        if (ids[i] >= place_of.size())
            place_of.resize(ids[i] + 1, none);
        place_of[ids[i]] = i;
    }
    std::vector<Value> sorted;
    sorted.reserve(values.size());
    for (const std::uint32_t i : place_of)
        if (i != none)
            sorted.push_back(values[i]);
    return sorted;
}

template <class Value>
std::vector<Value> flat(const std::vector<Place>& places) {
    std::vector<Value> values;
    values.reserve(3 * places.size());
    for (const Place& place : places)
        for (const double coordinate : place)
            values.push_back(static_cast<Value>(coordinate));
    return values;
}

class RunningSimulation : public Simulation {
public:
    RunningSimulation(const Scene& its_scene, const SceneParticles& particles,
                      SimulationState its_state, int threads)
        : scene(its_scene), mass(particles.mass), walls(particles.walls),
          now(std::move(its_state)) {
        check_numbers(scene, particles);
        check_state(now, particles.positions.size());
        check_places(now, scene, particles);
        finds_surface = knows_surface(scene.surface_tension);
        stepper = make_step(scene, particles, threads);
        if (now.steps == 0)
            part_compressed();
    }

    StepReport step(double longest) override {
        if (diverged)
            throw Divergence("the simulation diverged in an earlier step and cannot go on");
        found.reset();
        diverged = true;
        const StepReport report = stepper->advance(now, longest);
        diverged = false;
        return report;
    }

    [[nodiscard]] std::size_t parted() const override { return compressed_at_start; }
    [[nodiscard]] std::size_t size() const override { return now.positions.size(); }
    [[nodiscard]] double time() const override { return now.time; }
    [[nodiscard]] SimulationState state() const override { return now; }

    [[nodiscard]] Balance balance() const override {
        Balance sums;
        sums.particles = size();
        for (std::size_t i = 0; i < size(); ++i) {
            const Place& velocity = now.velocities[i];
            const Place& place = now.positions[i];
            const double squared = squared_length_of(velocity);
            sums.kinetic_energy += mass * squared / 2;
            sums.momentum_size += mass * std::sqrt(squared);
            sums.max_speed = std::max(sums.max_speed, std::sqrt(squared));
            sums.mean_speed += std::sqrt(squared) / static_cast<double>(size());
            for (int axis = 0; axis < 3; ++axis) {
                sums.potential_energy -= mass * scene.gravity[axis] * place[axis];
                sums.momentum[axis] += mass * velocity[axis];
                sums.center[axis] += place[axis] / static_cast<double>(size());
            }
        }
        if (finds_surface && !diverged) {
            const SurfaceResults& surface = results().surface;
            sums.surface_area = surface.area;
            sums.surface_particles = static_cast<std::size_t>(
                std::count(surface.surface_class.begin(), surface.surface_class.end(), 2));
        }
        return sums;
    }

    [[nodiscard]] Snapshot snapshot() const override {
        Snapshot frame;
        frame.dimension = scene.dimension;
        frame.position_precision = Precision::float64;
        frame.positions = by_id(now.ids, now.positions);
        frame.boundary = walls;
        frame.support_radius = scene.support_radius;
        frame.particle_spacing = scene.particle_spacing;
        frame.particle_volume = particle_volume(scene);
        frame.time = now.time;
        frame.scene = scene.name;
        std::vector<std::int64_t> ids(now.ids.begin(), now.ids.end());
        std::sort(ids.begin(), ids.end());
        set_array(frame, {"id", 1, ids});
        set_array(frame, {"velocity", 3, flat<float>(by_id(now.ids, now.velocities))});
        set_array(frame, {"mass", 1, std::vector<float>(size(), static_cast<float>(mass))});
        if (!diverged)
            add_results(frame);
        return frame;
    }

private:
    Scene scene;
    double mass;
    Positions walls;
    SimulationState now;
    std::unique_ptr<Step> stepper;
    std::size_t compressed_at_start = 0;
    bool finds_surface = false;
    bool diverged = false;
    mutable std::optional<StepResults> found; ///< of the state as it is, once it was looked at

    /// A state in which nothing has to move stays as it is, in its order, too.
    void part_compressed() {
        SimulationState parted_state = now;
        compressed_at_start = stepper->part_compressed(parted_state);
        if (compressed_at_start > 0)
            now = std::move(parted_state);
    }

    /// In the order of ids.
    [[nodiscard]] const StepResults& results() const {
        if (!found) {
            SimulationState sorted = now; // a checkpoint must not tell who looked
            found = stepper->evaluate(sorted);
            found->density = by_id(sorted.ids, found->density);
            found->pressure = by_id(sorted.ids, found->pressure);
            SurfaceResults& surface = found->surface;
            if (finds_surface) {
                surface.surface_class = by_id(sorted.ids, surface.surface_class);
                surface.curvature = by_id(sorted.ids, surface.curvature);
                surface.normal = by_id(sorted.ids, surface.normal);
            }
        }
        return *found;
    }

    void add_results(Snapshot& frame) const {
        const auto add = [&](const char* name, const std::vector<double>& values) {
            set_array(frame, {name, 1, std::vector<float>(values.begin(), values.end())});
        };
        add("density", results().density);
        add("pressure", results().pressure);
        if (!finds_surface)
            return;
        const SurfaceResults& surface = results().surface;
        set_array(frame, {"surface_class", 1, stored_classes(surface.surface_class)});
        add("mean_curvature", surface.curvature);
        set_array(frame, {"normal", 3, flat<float>(surface.normal)});
    }
};

} // namespace

std::unique_ptr<Simulation> simulate(const Scene& scene, const SceneParticles& particles,
                                     int threads) {
    return simulate(scene, particles, first_state(scene, particles), threads);
}

std::unique_ptr<Simulation> simulate(const Scene& scene, const SceneParticles& particles,
                                     const SimulationState& state, int threads) {
    return std::make_unique<RunningSimulation>(scene, particles, state, thread_count(threads));
}

std::unique_ptr<Step> make_step(const Scene& scene, const SceneParticles& particles, int threads,
                                InstructionSet widest) {
    return with_instruction_set(
        widest, [&](auto set) { return make_step(set, scene, particles, threads); });
}

} // namespace meniscus
