// Surface tension in a whole solver, small enough to read: weakly compressible SPH in the plane,
// with a drag that brings it to rest. A drop that begins as an ellipse, twice as long as it is
// wide, must become a circle, and must not move away: the force has no sum.
#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/runtime/math/cubic_spline.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

using Vector = std::array<double, 2>;

constexpr double spacing = 0.05;     // m
constexpr double h = 2 * spacing;    // support radius, m
constexpr double rest_density = 1e3; // kg/m^2
constexpr double mass = rest_density * spacing * spacing;
constexpr double sigma = 50;      // N/m
constexpr double sound_speed = 6; // m/s
constexpr double drag = 2;        // 1/s
constexpr double time_step = 0.2 * h / sound_speed;
constexpr int steps = 1200; // 4 s

struct Drop {
    meniscus::Positions positions; // z stays 0, as the neighbor search has it
    std::vector<Vector> velocities;
    std::vector<double> pressures; // over density squared
};

Drop ellipse(double half_length, double half_width) {
    Drop drop;
    const int columns = static_cast<int>(half_length / spacing);
    const int rows = static_cast<int>(half_width / spacing);
    for (int column = -columns; column <= columns; ++column)
        for (int row = -rows; row <= rows; ++row) {
            const double x = spacing * column;
            const double y = spacing * row;
            if (std::hypot(x / half_length, y / half_width) <= 1)
                drop.positions.push_back({x, y, 0});
        }
    drop.velocities.resize(drop.positions.size());
    drop.pressures.resize(drop.positions.size());
    return drop;
}

constexpr double kernel_scale = meniscus::cubic_spline_scale<2> / (h * h);

/// The kernel's slope by distance, over the distance.
double slope_over(double distance) {
    const meniscus::CubicSplinePieces<double, double> pieces(distance / h);
    return pieces.slope(meniscus::cubic_spline_scale<2>) / (h * h * h * distance);
}

using View = meniscus::CsrNeighborhood<double, 2, 3>;

/// Calls visit(j, x_j - x_i, distance) for the neighbors of i.
template <class Visit>
void for_neighbors(const View& view, std::size_t i, const Visit& visit) {
    view(i, [&](std::size_t j, const auto& step, double /*mass*/) {
        visit(j, step, std::hypot(step[0], step[1]));
    });
}

void find_pressures(const View& view, Drop& drop) {
    for (std::size_t i = 0; i < drop.positions.size(); ++i) {
        double density = mass * kernel_scale;
        for_neighbors(view, i, [&](std::size_t /*j*/, const auto& /*step*/, double distance) {
            density += mass * kernel_scale * meniscus::cubic_spline(distance / h);
        });
        const double pressure = sound_speed * sound_speed * (density - rest_density);
        drop.pressures[i] = std::max(pressure, 0.0) / (density * density);
    }
}

/// Accelerations by pressure.
std::vector<Vector> accelerations(const View& view, const Drop& drop) {
    std::vector<Vector> made(drop.positions.size());
    for (std::size_t i = 0; i < drop.positions.size(); ++i)
        for_neighbors(view, i, [&](std::size_t j, const auto& step, double distance) {
            const double push =
                mass * (drop.pressures[i] + drop.pressures[j]) * slope_over(distance);
            for (int axis = 0; axis < 2; ++axis)
                made[i][axis] += push * step[axis];
        });
    return made;
}

void advance(Drop& drop, meniscus::SurfaceTension<double, 2>& tension) {
    const std::size_t count = drop.positions.size();
    const meniscus::NeighborLists lists = meniscus::find_neighbors(drop.positions, h, {}, 1);
    const View view{drop.positions[0].data(), nullptr, lists.offsets.data(),
                    lists.neighbors.data()};
    find_pressures(view, drop);
    std::vector<Vector> acceleration = accelerations(view, drop);

    // All that surface tension takes.
    const meniscus::UniformRadius<double> radius{h};
    const meniscus::SerialLoop loop;
    tension.step(view, count, radius, loop);
    tension.balance_momentum<3>(view, meniscus::NoBoundary{}, radius, view.positions, loop);
    const auto& surface = tension.surface();
    for (std::size_t slot = 0; slot < surface.size(); ++slot)
        for (int axis = 0; axis < 2; ++axis)
            acceleration[surface.particle[slot]][axis] += surface.force[slot][axis] / mass;

    for (std::size_t i = 0; i < count; ++i)
        for (int axis = 0; axis < 2; ++axis) {
            drop.velocities[i][axis] +=
                time_step * (acceleration[i][axis] - drag * drop.velocities[i][axis]);
            drop.positions[i][axis] += time_step * drop.velocities[i][axis];
        }
}

/// Length over width of the ellipse with these second moments, and how far its middle lies off the
/// origin.
std::array<double, 2> shape(const Drop& drop) {
    const auto count = static_cast<double>(drop.positions.size());
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (const auto& place : drop.positions) {
        x += place[0] / count;
        y += place[1] / count;
    }
    for (const auto& place : drop.positions) {
        xx += (place[0] - x) * (place[0] - x);
        xy += (place[0] - x) * (place[1] - y);
        yy += (place[1] - y) * (place[1] - y);
    }
    const double middle = (xx + yy) / 2;
    const double off = std::hypot((xx - yy) / 2, xy);
    return {std::sqrt((middle + off) / (middle - off)), std::hypot(x, y)};
}

} // namespace

int main() { // NOLINT(bugprone-exception-escape): what is thrown ends the example
    meniscus::SurfaceTensionOptions options;
    options.surface_tension = sigma;
    options.spacing_ratio = h / spacing;
    meniscus::SurfaceTension<double, 2> tension(options); // once: it keeps its memory

    Drop drop = ellipse(0.7, 0.35);
    const auto [ratio_before, off_before] = shape(drop);
    for (int step = 0; step < steps; ++step)
        advance(drop, tension);
    const auto [ratio, off] = shape(drop);
    std::printf("%zu particles: length over width %.3f, then %.3f; moved by %.1e m\n",
                drop.positions.size(), ratio_before, ratio, std::abs(off - off_before));
    return std::abs(ratio - 1) < 0.1 && std::abs(off - off_before) < 1e-9 ? 0 : 1;
}
