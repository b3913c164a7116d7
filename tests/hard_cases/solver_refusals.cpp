#include "solver_checks.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <unistd.h>

namespace meniscus::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A scene of two particles half a support radius apart, for a check to spoil.
struct Subject {
    Scene scene = plain_scene({}, 1, 0.5);
    SceneParticles particles = particles_of(scene, {{0, 0, 0}, {0.5, 0, 0}});

    void run() const {
        const auto simulation = simulate(scene, particles, 1);
        for (int step = 0; step < 10; ++step)
            simulation->step(1);
    }
};

/// What is spoilt must end with a message that has these words.
Check check_message(const std::string& name, const std::string& expected,
                    const std::vector<std::string>& words, const std::function<void()>& work) {
    Check check{name, "", expected, message_of(work), 0, true};
    for (const std::string& word : words)
        check.passed = check.passed && check.result.find(word) != std::string::npos;
    if (check.result.empty()) {
        check.result = "goes on";
        check.passed = false;
    }
    return check;
}

template <class Spoil>
Check check_spoilt(const std::string& name, const std::string& expected,
                   const std::vector<std::string>& words, const Spoil& spoil) {
    return check_message(name, expected, words, [&] {
        Subject subject;
        spoil(subject);
        subject.run();
    });
}

/// A snapshot as the fluid of a scene.
template <class Spoil>
Check check_snapshot(const std::string& name, const std::string& expected,
                     const std::vector<std::string>& words, const Spoil& spoil) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("refusal_" + std::to_string(::getpid()) + ".vtkhdf");
    Snapshot snapshot;
    snapshot.positions = {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}};
    spoil(snapshot);
    write_vtkhdf(snapshot, file);
    Check check = check_message(name, expected, words, [&] {
        Scene scene = plain_scene({}, 1, 0.5);
        scene.fluid = {{SnapshotShape{file, {}}, {}}};
        fill_scene(scene);
    });
    std::filesystem::remove(file);
    const std::size_t at = check.result.find(file.string()); // a name that changes
    if (at != std::string::npos)
        check.result.replace(at, file.string().size(), "state.vtkhdf");
    return check;
}

void add_bad_numbers(std::vector<Check>& checks) {
    for (const double bad : {nan, infinity})
        checks.push_back(
            check_spoilt(bad == infinity ? "velocity_infinite" : "velocity_nan",
                         "refused, with the particle", {"particle 1", "velocity", "not finite"},
                         [&](Subject& subject) { subject.particles.velocities[1][2] = bad; }));
    checks.push_back(check_spoilt("wall_nan", "refused, with the wall particle",
                                  {"wall particle 0", "not finite"}, [](Subject& subject) {
                                      subject.particles.walls = {{0, nan, 0}};
                                  }));
    checks.push_back(check_spoilt("mass_of_particles_nan", "refused: all densities would be nan",
                                  {"mass", "nan"},
                                  [](Subject& subject) { subject.particles.mass = nan; }));
    checks.push_back(check_spoilt("gravity_nan", "refused: all velocities would be nan",
                                  {"gravity", "nan"},
                                  [](Subject& subject) { subject.scene.gravity[1] = nan; }));
    checks.push_back(check_spoilt("step_of_zero", "refused: time would stand still",
                                  {"time step", "positive"},
                                  [](Subject& subject) { subject.scene.time_step.fixed = 0; }));
    checks.push_back(check_spoilt("no_sound_speed", "refused: WCSPH would have no pressure at all",
                                  {"sound speed"}, [](Subject& subject) {
                                      subject.scene.pressure.solver = "wcsph";
                                      subject.scene.pressure.sound_speed = 0;
                                  }));
    checks.push_back(check_spoilt("million_spacings_in_h",
                                  "refused: everything would be a neighbor", {"1 to 100 spacings"},
                                  [](Subject& subject) { subject.scene.particle_spacing = 1e-6; }));
}

void add_unknown_line(std::vector<Check>& checks) {
    checks.push_back(
        check_spoilt("wide_support_without_line",
                     "refused: the lines that ship would find no surface, and no tension would act",
                     {"spacing_ratio is 5,", "surface_tension.k", "model_file"},
                     [](Subject& subject) { subject.scene.particle_spacing = 0.2; }));
}

void add_far_places(std::vector<Check>& checks) {
    checks.push_back(
        check_spoilt("domain_beyond_float", "refused: float tells places apart by 0.06 h out there",
                     {"domain reaches", "double"}, [](Subject& subject) {
                         subject.scene.domain = {{{-1e6, -1e6, -1e6}, {1e6, 1e6, 1e6}}};
                     }));
    checks.push_back(
        check_spoilt("particles_apart_beyond_float", "refused, with the particle: the same",
                     {"particle ", "double"},
                     [](Subject& subject) { subject.particles.positions[1][0] = 1e5; }));
    checks.push_back(check_message("scene_beyond_double",
                                   "refused: places there are 1e-7 m apart, a tenth of the spacing",
                                   {"particle 0", "closer to the origin"}, [] {
                                       Scene scene = plain_scene({}, 2e-6, 1e-6);
                                       scene.fluid = {{LatticeShape{{1e9, 0, 0}, {3, 1, 1}}, {}}};
                                       fill_scene(scene);
                                   }));
    checks.push_back(check_snapshot("snapshot_beyond_float",
                                    "refused: the file's numbers round the spacing off",
                                    {"particle 0", "single precision"}, [](Snapshot& snapshot) {
                                        for (Place& place : snapshot.positions)
                                            place[0] += 1e6;
                                        snapshot.position_precision = Precision::float32;
                                    }));
}

void add_fluids_unlike(std::vector<Check>& checks) {
    checks.push_back(check_snapshot(
        "snapshot_of_two_masses", "refused, with the particle: the step has one mass",
        {"particle 2", "mass"}, [](Snapshot& snapshot) {
            set_array(snapshot, {"mass", 1, std::vector<double>{1, 1, 1000}});
        }));
    checks.push_back(check_snapshot(
        "snapshot_of_two_phases", "refused, with the particle: the step has one fluid",
        {"particle 1", "phase"}, [](Snapshot& snapshot) {
            set_array(snapshot, {"phase", 1, std::vector<std::int32_t>{0, 1, 1}});
        }));
}

void add_leaps(std::vector<Check>& checks) {
    const auto throw_particle = [](Subject& subject) {
        subject.scene.domain = {{{-1000, -1000, -1000}, {1000, 1000, 1000}}};
        subject.particles.velocities[1] = {0, 0, 1000};
    };
    checks.push_back(check_spoilt("fixed_step_too_long",
                                  "stops, with the particle: it could pass a wall unseen",
                                  {"particle 1 moved 10", "in one step"}, [&](Subject& subject) {
                                      throw_particle(subject);
                                      subject.scene.time_step.fixed = 0.01;
                                  }));
    checks.push_back(check_spoilt(
        "smallest_step_too_long", "stops: the same, where time_step.smallest holds the step up",
        {"particle 1 moved 10", "min"}, [&](Subject& subject) {
            throw_particle(subject);
            subject.scene.time_step.min = subject.scene.time_step.max = 0.01;
        }));
    checks.push_back(check_spoilt("velocity_beyond_float",
                                  "stops: places around it are no numbers any more",
                                  {"a position that is not finite"}, [](Subject& subject) {
                                      subject.particles.velocities[1] = {0, 0, 1e300};
                                  }));
    checks.push_back(check_spoilt(
        "three_hundred_in_one_place", "stops and says where the fluid is too dense",
        {"as dense as at rest"}, [](Subject& subject) {
            subject.particles = particles_of(subject.scene, Positions(300, {0.1, 0.2, 0.3}));
        }));
}

} // namespace

std::vector<Check> check_refusals() {
    std::vector<Check> checks;
    add_bad_numbers(checks);
    add_unknown_line(checks);
    add_far_places(checks);
    add_fluids_unlike(checks);
    add_leaps(checks);
    return checks;
}

} // namespace meniscus::test
