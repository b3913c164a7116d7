#include "solver_checks.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <unistd.h>

namespace meniscus::test {
namespace {

enum class Fate { goes_on, goes_straight, stays_outside_wall, may_stop, refused, refused_mass };

struct Expectation {
    Fate fate;
    const char* text;
    const char* words = ""; ///< that the message must have
};

Expectation expectation_of(const HardCase& hard_case) {
    const std::string& name = hard_case.name;
    const auto& masses = hard_case.masses;
    if (std::any_of(masses.begin(), masses.end(), [&](double m) { return !(m == masses[0]); }))
        return {Fate::refused_mass,
                "refused as fluid of a scene, with the particle: the step has one mass",
                "has mass"};
    if (name == "no_particle")
        return {Fate::refused, "refused: there is nothing to move", "at least one particle"};
    if (name == "position_nan" || name == "position_infinite")
        return {Fate::refused, "refused, with the particle", "position that is not finite"};
    if (name == "position_beyond_float")
        return {Fate::refused, "refused, with the particle: too far from the others",
                "support radii from the middle"};
    if (name == "far_1e10" || name == "far_1e17")
        return {Fate::refused, "refused, with the particle: double holds no slow motion there",
                "a millionth of a spacing"};
    if (hard_case.refused == Refused::always)
        return {Fate::refused, "refused: not a length in metres", "must be a"};
    if (name == "isolated")
        return {Fate::goes_straight, "keeps its velocity: no force acts on it"};
    if (name.rfind("hundreds", 0) == 0)
        return {Fate::may_stop, "parts them, all finite, or stops and says why: the fluid is a "
                                "hundred times too dense there"};
    if (name == "droplet_at_wall")
        return {Fate::stays_outside_wall, "finite, and no particle in the wall"};
    return {Fate::goes_on, "finite, and momentum stays: no wall is there and no gravity"};
}

/// Of a case whose masses differ, by the way that brings masses in: a snapshot as a scene's fluid.
std::string mass_refusal(const HardCase& hard_case, Scene scene) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("hard_case_" + std::to_string(::getpid()) + ".vtkhdf");
    write_vtkhdf(snapshot_of(hard_case), file);
    scene.fluid = {{SnapshotShape{file, {}}, {}}};
    std::string message = message_of([&] { fill_scene(scene); });
    std::filesystem::remove(file);
    return message;
}

void judge_refusal(const std::string& message, const Expectation& expected, Check& check) {
    check.passed = message.find(expected.words) != std::string::npos;
    check.result = check.passed ? "refused" : message.empty() ? "not refused" : message;
}

/// The largest part of the velocity that was lost or won, and of the way.
double straight_error(const Outcome& outcome, const Place& start, const Place& velocity) {
    Place way = start;
    for (int axis = 0; axis < 3; ++axis)
        way[axis] += outcome.time * velocity[axis];
    return std::max(distance_of(outcome.velocities[0], velocity),
                    distance_of(outcome.places[0], way));
}

void judge_run(const HardCase& hard_case, const Expectation& expected, const Method& method,
               Check& check) {
    const Scene scene = scene_of(hard_case, method);
    SceneParticles particles = particles_of(hard_case, scene);
    const Place velocity{0.3, 0.2, method.dimension == 3 ? 0.1 : 0.0};
    if (expected.fate == Fate::goes_straight)
        particles.velocities[0] = velocity;
    const Outcome outcome = run_steps(scene, particles, 10);
    check.passed = outcome.finite && outcome.refused.empty() && outcome.stopped.empty();
    check.result = outcome.refused + outcome.stopped;
    if (expected.fate == Fate::may_stop) {
        const bool says_why = outcome.stopped.find("as dense as at rest") != std::string::npos;
        check.result = says_why ? "stops: density" : check.passed ? "goes on" : check.result;
        check.passed = check.passed || says_why;
        return;
    }
    if (!check.passed)
        return;
    check.result = "goes on";
    if (expected.fate == Fate::goes_straight) {
        check.max_error = straight_error(outcome, hard_case.positions[0], velocity);
        check.passed = check.max_error < bound_of(method, 1e-7, 1e-15);
    } else if (expected.fate == Fate::stays_outside_wall) {
        for (const Place& place : outcome.places)
            check.passed = check.passed && place[1] > -0.5;
    } else {
        check.max_error = outcome.momentum_error();
        check.passed = check.max_error < bound_of(method, 1e-6, 1e-14);
    }
}

} // namespace

Check check_set(const HardCase& hard_case, const Method& method) {
    const Expectation expected = expectation_of(hard_case);
    Check check{hard_case.name,
                name_of(method.solver) + " " + name_of(method.precision),
                expected.text,
                "",
                0,
                false};
    const Scene scene = scene_of(hard_case, method);
    if (expected.fate == Fate::refused_mass)
        judge_refusal(mass_refusal(hard_case, scene), expected, check);
    else if (expected.fate == Fate::refused)
        judge_refusal(run_steps(scene, particles_of(hard_case, scene), 1).refused, expected, check);
    else
        judge_run(hard_case, expected, method, check);
    return check;
}

} // namespace meniscus::test
