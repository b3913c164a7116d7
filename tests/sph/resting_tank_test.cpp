// Fluid in a tank comes to rest with every pressure solver, keeps its height and its density, and
// its pressure is the weight of what lies above.
#include "small_scenes.hpp"

#include <meniscus/data/snapshot.hpp>

namespace meniscus {
namespace {

/// Pressure as a straight line over depth, by least squares, below the uppermost layers.
struct PressureLine {
    double slope = 0;      ///< Pa/m
    double off = 0;        ///< root mean square of what is off the line, Pa
    double largest = 0;    ///< pressure, Pa
};

PressureLine pressure_line(const std::vector<double>& heights,
                           const std::vector<double>& pressures) {
    const double n = static_cast<double>(heights.size());
    double y = 0, p = 0, yy = 0, yp = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        y += heights[i] / n;
        p += pressures[i] / n;
    }
    for (std::size_t i = 0; i < heights.size(); ++i) {
        yy += (heights[i] - y) * (heights[i] - y);
        yp += (heights[i] - y) * (pressures[i] - p);
    }
    PressureLine line;
    line.slope = -yp / yy;
    double squares = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        squares += std::pow(pressures[i] - p + line.slope * (heights[i] - y), 2);
        line.largest = std::max(line.largest, pressures[i]);
    }
    line.off = std::sqrt(squares / n);
    return line;
}

void rest(int dimension, Precision precision, const NamedSolver& solver, bool clip) {
    Scene scene = tank_scene(empty_scene(dimension, solver.kind, precision), {8, 12, 8}, 8);
    scene.viscosity.kinematic = 0.01;
    scene.pressure.clip_negative = clip;
    const auto simulation = start(scene);
    const double mass = 1000 * std::pow(0.1, dimension);
    double mean_error = 0, largest_error = 0; int steps = 0, unconv = 0; double its=0;
    std::vector<double> sums(simulation->size()), heights(simulation->size());
    int frames = 0;
    run_until(*simulation, 3, [&](const StepReport& r) {
        mean_error += r.density_error; largest_error = std::max(largest_error, r.density_error);
        ++steps; unconv += !r.converged; its += r.pressure_iterations + r.divergence_iterations;
        if (r.time < 2.5) return;
        const auto frame = simulation->snapshot();
        const auto p = scalar_values(frame, "pressure");
        ++frames;
        for (std::size_t i = 0; i < p.size(); ++i) {
            sums[i] += p[i];
            heights[i] += frame.positions[i][1];
        }
    });
    double top = 0;
    std::vector<double> inner, inner_h;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const auto p = places_by_id(*simulation)[i];
        if (p[0] > 0.25 && p[0] < 0.55 && (dimension == 2 || (p[2] > 0.25 && p[2] < 0.55)) && p[1] > 0.25 && p[1] < 0.6) { inner.push_back(sums[i] / frames); inner_h.push_back(heights[i] / frames); }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) { sums[i] /= frames; heights[i] /= frames; top = std::max(top, heights[i]); }
    const auto line = pressure_line(inner_h, inner);
    const Balance b = simulation->balance();
    printf("%s %dD %s clip %d: steps %d its %.1f unconv %d  KE/(m g dx) %.2e speed %.3e  err mean %.2e max %.2e top %.3f center %.4f  slope/rho g %.4f off %.2f %% of %.0f\n", solver.name, dimension,
        precision == Precision::float32 ? "f" : "d", clip, steps, its / steps, unconv, b.kinetic_energy / (mass * sums.size() * 9.81 * 0.1), b.largest_speed, mean_error / steps, largest_error, top, b.center[1],
        line.slope / 9810, 100 * line.off / line.largest, line.largest);
}

TEST(RestingTank, Explore) {
    for (const auto& solver : all_solvers)
        for (int dimension : {2, 3})
            for (auto precision : {Precision::float32, Precision::float64})
                for (bool clip : {true, false})
                    try {
                rest(dimension, precision, solver, clip);
                    } catch (const std::exception& e) { printf("%s %dD clip %d: %s\n", solver.name, dimension, clip, e.what()); }
}

} // namespace
} // namespace meniscus
