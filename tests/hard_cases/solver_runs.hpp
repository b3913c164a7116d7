// Hard cases as scenes, and what a run of some steps makes of them. Velocities and times belong to
// the support radius: all scales are one and the same flow.
#pragma once

#include "cases.hpp"

#include <meniscus/sph/step/simulation.hpp>

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus::test {

/// What takes a step.
struct Method {
    std::string_view solver = "dfsph";
    std::string_view tension = "meniscus";
    int dimension = 3;
    Precision precision = Precision::float32;
};

inline constexpr std::array<std::string_view, 4> solvers = {"wcsph", "pcisph", "iisph", "dfsph"};
inline constexpr std::array<std::string_view, 6> tensions = {
    "meniscus", "becker_2007", "huber_2015", "akinci_2013", "he_2014", "color_field"};
inline constexpr std::array<Precision, 2> precisions = {Precision::float32, Precision::float64};

/// Of a solver or a model of surface tension, for tables and names of tests.
std::string name_of(std::string_view method);
std::string name_of(Precision precision);

/// `in_float` in single, `in_double` in double precision.
double bound_of(const Method& method, double in_float, double in_double);

/// A scene without gravity and viscosity of that support radius and spacing (m), in which a
/// capillary wave of the spacing's length takes a good second.
Scene plain_scene(const Method& method, double support_radius, double spacing);

/// The particles with masses of rest_density spacing^D; velocities 0 where none are given.
SceneParticles particles_of(const Scene& scene, Positions places,
                            std::vector<Place> velocities = {}, Positions walls = {});

/// The scene and the particles of a hard case.
Scene scene_of(const HardCase& hard_case, const Method& method);
SceneParticles particles_of(const HardCase& hard_case, const Scene& scene);

/// What came of a run. Places and velocities are those of the last good step, in the order of ids.
struct Outcome {
    std::string refused; ///< message of an InputError, or empty
    std::string stopped; ///< message of a Divergence, or empty
    Balance first;
    Balance last;
    Positions places;
    std::vector<Place> velocities;
    double time = 0;          ///< simulated, s
    double density_error = 0; ///< largest that a step left
    bool finite = true;       ///< of all places and velocities

    /// How far momentum went off, over the sum of |m v| at the end; 0 where nothing moves.
    [[nodiscard]] double momentum_error() const;
};

Outcome run_steps(const Scene& scene, const SceneParticles& particles, int steps);

/// Goes on from a state.
Outcome run_steps(const Scene& scene, const SceneParticles& particles, const SimulationState& state,
                  int steps);

/// The message of the exception that `work` throws, or "": InputError or Divergence.
std::string message_of(const std::function<void()>& work);

double distance_of(const Place& a, const Place& b);

/// The largest distance of two lists of places, in m.
double max_distance(const Positions& a, const Positions& b);

/// A jittered ball of a lattice with about 30 neighbors a particle inside, h being 1, that rests at
/// its density, and velocities of up to 0.1 h/s along each axis.
struct Ball {
    Positions places;
    std::vector<Place> velocities;
};
Ball jittered_ball(int dimension, double radius);

} // namespace meniscus::test
