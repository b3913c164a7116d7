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

    /// At least three spacings from walls and surface: walls push with what the particle beside
    /// them has for pressure, once where a fluid would push with both sides', so that theirs is
    /// larger.
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
