// Fluid in a tank comes to rest with every pressure solver: it keeps its height and its density,
// and its pressure is the weight of what lies above.
#include "small_scenes.hpp"

namespace meniscus {
namespace {

/// Means over the last steps of a run.
struct MeanState {
    std::vector<double> heights;   ///< of particles away from walls and surface, m
    std::vector<double> pressures; ///< of the same, Pa
    double top = 0;                ///< of the highest particle, m
};

/// -dp/dy by least squares, Pa/m.
double pressure_slope(const MeanState& state) {
    const auto count = static_cast<double>(state.heights.size());
    double height = 0;
    double pressure = 0;
    for (std::size_t i = 0; i < state.heights.size(); ++i) {
        height += state.heights[i] / count;
        pressure += state.pressures[i] / count;
    }
    double squares = 0;
    double products = 0;
    for (std::size_t i = 0; i < state.heights.size(); ++i) {
        squares += std::pow(state.heights[i] - height, 2);
        products += (state.heights[i] - height) * (state.pressures[i] - pressure);
    }
    return -products / squares;
}

/// A tank 14 (in 3D 10) spacings wide, filled to a depth of 12 (10), and sums over looks at it.
struct RestingTank {
    int dimension;
    int width = dimension == 3 ? 10 : 14;
    int depth = dimension == 3 ? 10 : 12;
    Scene scene;
    std::unique_ptr<Simulation> simulation;
    int steps = 0;
    int unconverged = 0;
    double density_error = 0; ///< mean
    std::vector<double> pressure_sums;
    Positions place_sums;
    int looks = 0;

    RestingTank(int its_dimension, Precision precision, std::string_view solver, bool clip)
        : dimension(its_dimension) {
        scene =
            tank_scene(empty_scene(dimension, solver, precision), {width, depth + 4, width}, depth);
        scene.viscosity.kinematic = 0.02;
        scene.pressure.clip_negative = clip;
        simulation = start(scene);
        pressure_sums.resize(simulation->size());
        place_sums.resize(simulation->size());
    }

    void run(double time, double look_from) {
        run_until(*simulation, time, [&](const StepReport& report) {
            ++steps;
            unconverged += report.converged ? 0 : 1;
            density_error += report.density_error;
            if (report.time > look_from)
                look();
        });
        density_error /= steps;
    }

    void look() {
        const Snapshot frame = simulation->snapshot();
        const auto pressures = scalar_values(frame, "pressure");
        for (std::size_t i = 0; i < pressures.size(); ++i) {
            pressure_sums[i] += pressures[i];
            for (int axis = 0; axis < 3; ++axis)
                place_sums[i][axis] += frame.positions[i][axis];
        }
        ++looks;
    }

    /// At least three spacings from walls and surface.
    [[nodiscard]] MeanState mean_state() const {
        MeanState state;
        for (std::size_t i = 0; i < pressure_sums.size(); ++i) {
            Place place = place_sums[i];
            for (double& coordinate : place)
                coordinate /= looks;
            state.top = std::max(state.top, place[1]);
            const double far = 0.1 * (width - 3);
            const bool away = place[0] > 0.3 && place[0] < far && place[1] > 0.3 &&
                              place[1] < 0.1 * (depth - 3) &&
                              (dimension == 2 || (place[2] > 0.3 && place[2] < far));
            if (!away)
                continue;
            state.heights.push_back(place[1]);
            state.pressures.push_back(pressure_sums[i] / looks);
        }
        return state;
    }
};

/// The mean pressure of particles over the weight of what lies above them, at least three spacings
/// below the surface, where is_there(place) says so.
template <class IsThere>
double over_weight(const RestingTank& tank, const IsThere& is_there) {
    const double surface = tank.mean_state().top + 0.05;
    double pressure = 0, weight = 0;
    for (std::size_t i = 0; i < tank.pressure_sums.size(); ++i) {
        Place place = tank.place_sums[i];
        for (double& coordinate : place)
            coordinate /= tank.looks;
        if (surface - place[1] < 0.3 || !is_there(place))
            continue;
        pressure += tank.pressure_sums[i] / tank.looks;
        weight += 1000 * 9.81 * (surface - place[1]);
    }
    return pressure / weight;
}

/// Beside the bottom and beside the sides, away from the corners where both meet.
void expect_weight_at_walls(const RestingTank& tank) {
    const double far = 0.1 * tank.width;
    const auto is_between = [&](double coordinate, double from_wall) {
        return coordinate > from_wall && coordinate < far - from_wall;
    };
    const auto is_beside = [&](const Place& place, double from_wall) {
        return !is_between(place[0], from_wall) ||
               (tank.dimension == 3 && !is_between(place[2], from_wall));
    };
    const double bottom = over_weight(
        tank, [&](const Place& place) { return place[1] < 0.1 && !is_beside(place, 0.2); });
    const double sides = over_weight(
        tank, [&](const Place& place) { return is_beside(place, 0.1) && place[1] > 0.2; });
    EXPECT_NEAR(bottom, 1, 0.08);
    EXPECT_NEAR(sides, 1.04, 0.08);
}

void expect_rest(int dimension, Precision precision, const NamedSolver& solver, bool clip) {
    SCOPED_TRACE(std::string(solver.name) + ", " + std::to_string(dimension) + "D, " +
                 (precision == Precision::float32 ? "float" : "double") +
                 (clip ? ", clipped" : ", not clipped"));
    RestingTank tank(dimension, precision, solver.kind, clip);
    const Balance before = tank.simulation->balance();
    tank.run(3, 2.5);
    const Balance after = tank.simulation->balance();
    const MeanState mean = tank.mean_state();

    const double mass = 1000 * std::pow(0.1, dimension);
    const double scale = mass * static_cast<double>(tank.simulation->size()) * 9.81 * 0.1;
    EXPECT_LT(after.kinetic_energy, 5e-3 * scale);
    EXPECT_LT(after.potential_energy, before.potential_energy);
    if (solver.kind == "wcsph")
        EXPECT_LT(tank.density_error, 0.01);
    else
        EXPECT_LE(tank.density_error, tank.scene.pressure.density_error);
    EXPECT_LE(tank.unconverged, tank.steps / 100);
    // A lattice gives way for what packs closer.
    EXPECT_NEAR(mean.top, 0.1 * tank.depth - 0.05, 0.06);
    EXPECT_NEAR(after.center[1], before.center[1], 0.04);
    EXPECT_NEAR(pressure_slope(mean), 1000 * 9.81, 0.12 * 1000 * 9.81);
    if (clip)
        expect_weight_at_walls(tank);
}

TEST(RestingTank, ComesToRestWithEachSolver) {
    for (const NamedSolver& solver : all_solvers)
        for (const int dimension : {2, 3})
            for (const Precision precision : {Precision::float32, Precision::float64})
                if (dimension == 2 || precision == Precision::float32)
                    expect_rest(dimension, precision, solver, true);
}

TEST(RestingTank, ComesToRestWithPressuresThatPull) {
    for (const NamedSolver& solver : all_solvers)
        if (solver.kind != "pcisph") // pulls on a free surface without end
            expect_rest(2, Precision::float32, solver, false);
}

/// Iterations for pressures diverge where more neighbors couple than the relaxation allows for.
TEST(RestingTank, ComesToRestWithWiderSupports) {
    for (const NamedSolver& solver : all_solvers)
        for (const int dimension : {2, 3})
            for (const double ratio : {2.6, 3.46}) {
                SCOPED_TRACE(std::string(solver.name) + ", h of " + std::to_string(ratio));
                Scene scene = tank_scene(empty_scene(dimension, solver.kind), {10, 12, 10}, 8);
                scene.support_radius = ratio * scene.particle_spacing;
                scene.viscosity.kinematic = 0.02;
                const auto simulation = start(scene);
                const std::size_t count = simulation->size();
                const Balance before = simulation->balance();
                run_until(*simulation, 1.5);
                const Balance after = simulation->balance();
                EXPECT_EQ(simulation->size(), count);
                EXPECT_LT(after.kinetic_energy, 5e-3 * before.potential_energy);
                EXPECT_NEAR(after.center[1], before.center[1], 0.05);
            }
}

/// Viscosity asks for steps that are short beside what gravity and speeds allow.
TEST(RestingTank, StaysAtRestInTheShortStepsOfAThickFluid) {
    for (const NamedSolver& solver : all_solvers) {
        if (solver.kind == "wcsph")
            continue; // takes as much time for a compression as its sound
        SCOPED_TRACE(solver.name);
        Scene scene = tank_scene(empty_scene(2, solver.kind), {10, 14, 1}, 10);
        scene.viscosity.kinematic = 10;
        const auto simulation = start(scene);
        const Balance before = simulation->balance();
        run_until(*simulation, 0.1);
        const Balance after = simulation->balance();
        EXPECT_LT(after.kinetic_energy, 1e-5 * before.potential_energy);
        EXPECT_LT(after.potential_energy, 1.002 * before.potential_energy);
    }
}

} // namespace
} // namespace meniscus
