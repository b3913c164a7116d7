// Drops that start as boxes on a wall and find their contact angle. Without gravity: the angle of
// the circle (sphere) through the surface, how fast they still are, and what energy did. With
// gravity: height and width beside those of the exact profile.
#include "capillary_shapes.hpp"
#include "support/tables.hpp"
#include "watched_run.hpp"

#include <meniscus/data/particles/particle_arrays.hpp>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

constexpr double sigma = 0.072;
constexpr double degree = 3.14159265358979323846 / 180;

/// Water of which a box lies on a wall at y = 0.
Scene drop_on_wall(int dimension, double contact_angle) {
    Scene scene;
    scene.name = "drop_on_wall";
    scene.dimension = dimension;
    const double spacing = scene.particle_spacing = dimension == 2 ? 1e-4 : 2e-4;
    scene.support_radius = 2 * spacing;
    const double half = dimension == 2 ? 1.6e-3 : 1.4e-3;
    const double height = dimension == 2 ? 1.6e-3 : 1.4e-3;
    const double depth = dimension == 3 ? half : 0;
    scene.fluid = {
        {BoxShape{{-half, spacing / 2, -depth}, {half, spacing / 2 + height, depth}, {}}, {}}};
    const double side = dimension == 2 ? 10e-3 : 6e-3;
    const double deep = dimension == 3 ? side : 0;
    scene.walls = {BoxShape{{-side, 0, -deep}, {side, 6e-3, deep}, {"+y"}}};
    scene.viscosity.kinematic = dimension == 2 ? 1e-4 : 2e-4;
    scene.surface_tension.model = "meniscus";
    scene.surface_tension.coefficient = sigma;
    scene.surface_tension.surface.contact_angle = contact_angle;
    scene.surface_tension.surface.ambient_pressure = default_ambient_pressure(true);
    scene.time_step.max = default_max_time_step(spacing);
    scene.duration = dimension == 2 ? 0.06 : 0.02;
    scene.frame_interval = scene.duration;
    return scene;
}

struct Cap {
    double angle;  ///< degrees
    double radius; ///< m
};

/// The circle or sphere through the surface particles, half a spacing outside of them, cut by the
/// plane half a spacing in front of the wall particles.
Cap fitted_cap(const Snapshot& frame) {
    const std::vector<double> classes = scalar_values(frame, "surface_class");
    const int dimension = frame.dimension;
    const double spacing = frame.particle_spacing.value_or(0);
    std::vector<std::array<double, 3>> places;
    for (std::size_t i = 0; i < frame.size(); ++i)
        if (classes[i] == 2)
            places.push_back(frame.positions[i]);
    Eigen::MatrixXd matrix(places.size(), dimension + 1);
    Eigen::VectorXd squares(places.size());
    for (std::size_t n = 0; n < places.size(); ++n) {
        double square = 0;
        for (int axis = 0; axis < dimension; ++axis) {
            const double x = places[n][axis] / spacing;
            matrix(static_cast<Eigen::Index>(n), axis) = 2 * x;
            square += x * x;
        }
        matrix(static_cast<Eigen::Index>(n), dimension) = 1;
        squares(static_cast<Eigen::Index>(n)) = square;
    }
    const Eigen::VectorXd fit = matrix.colPivHouseholderQr().solve(squares);
    const double radius = std::sqrt(fit(dimension) + fit.head(dimension).squaredNorm()) + 0.5;
    const double cosine = std::clamp((0.5 - fit(1)) / radius, -1.0, 1.0);
    return {std::acos(cosine) / degree, radius * spacing};
}

/// A run to its end: the last state, and the largest speed there.
struct LastState {
    RunSummary run;
    Snapshot frame;
    double speed = 0;
};

LastState run_to_end(const Scene& scene) {
    LastState last;
    last.run = watch_run(scene, [&](const Simulation& simulation, const StepReport& report) {
        if (report.time < scene.duration * (1 - 1e-9))
            return;
        last.frame = simulation.snapshot();
        last.speed = simulation.balance().max_speed;
    });
    return last;
}

Tables contact_angles(const TableInput& /*input*/) {
    Table table = table_of(
        "contact-angles",
        "dimensions | contact angle | found, degrees {:.1f} | speed at the end over the capillary "
        "one, % {:.1f} | largest rise of energy, % {:.2f} | particles");
    for (const int dimension : {2, 3})
        for (const double angle : {30.0, 60.0, 90.0, 120.0, 150.0}) {
            const Scene scene = drop_on_wall(dimension, angle);
            const auto [run, last, speed] = run_to_end(scene);
            if (!run.failure.empty()) {
                table.add({dimension, angle, run.failure});
                continue;
            }
            const Cap cap = fitted_cap(last);
            const double capillary = std::sqrt(sigma / (scene.rest_density * cap.radius));
            table.add({dimension, angle, cap.angle, 100 * speed / capillary,
                       100 * run.energy_rise / run.first_energy, run.particles});
        }
    return {table};
}

/// In 2D: half a disc of `radius` spacings as a box on a wall at y = 0, under that gravity.
Scene drop_in_gravity(double contact_angle, double bond_number) {
    Scene scene = drop_on_wall(2, contact_angle);
    scene.name = "drop_in_gravity";
    constexpr double radius = 16, pi = 180 * degree;
    const double spacing = scene.particle_spacing;
    const double half = std::round(radius * std::sqrt(pi / 2));
    const double height = std::round(pi * radius * radius / (4 * half));
    scene.fluid = {{BoxShape{{-half * spacing, spacing / 2, 0},
                             {half * spacing, spacing / 2 + height * spacing, 0},
                             {}},
                    {}}};
    const double length = radius * spacing;
    scene.gravity = {0, -bond_number * sigma / (scene.rest_density * length * length), 0};
    scene.duration = 0.08;
    scene.frame_interval = scene.duration;
    return scene;
}

Tables drops_in_gravity(const TableInput& /*input*/) {
    Table table = table_of(
        "drops-in-gravity",
        "contact angle | Bond number | exact height, spacings {:.2f} | found {:.2f} | off, % "
        "{:.1f} "
        "| exact half width, spacings {:.2f} | found half width {:.2f} | half width off, % {:.1f} "
        "| "
        "speed at the end over the capillary one, % {:.1f} | largest rise of energy, % {:.2f}");
    for (const double angle : {60.0, 90.0, 120.0})
        for (const double bond_number : {0.1, 1.0, 5.0}) {
            const Scene scene = drop_in_gravity(angle, bond_number);
            const auto [run, last, speed] = run_to_end(scene);
            if (!run.failure.empty()) {
                table.add({angle, bond_number, run.failure});
                continue;
            }
            const double spacing = scene.particle_spacing;
            double top = 0, left = 0, right = 0;
            for (const Place& place : last.positions) {
                top = std::max(top, place[1]);
                left = std::min(left, place[0]);
                right = std::max(right, place[0]);
            }
            // The fluid ends half a spacing beyond its particles, the wall half a spacing above
            // its.
            const double height = top / spacing;
            const double half_width = (right - left) / (2 * spacing) + 0.5;
            const double capillary_length =
                std::sqrt(sigma / (scene.rest_density * -scene.gravity[1])) / spacing;
            const SessileDrop exact = sessile_drop(2, angle * degree, capillary_length,
                                                   static_cast<double>(run.particles));
            const double capillary =
                std::sqrt(sigma / (scene.rest_density * exact.max_radius * spacing));
            table.add({angle, bond_number, exact.height, height, 100 * (height / exact.height - 1),
                       exact.max_radius, half_width, 100 * (half_width / exact.max_radius - 1),
                       100 * speed / capillary, 100 * run.energy_rise / run.first_energy});
        }
    return {table};
}

} // namespace

TableGroup contact_angle_tables() {
    return {"Fluid at walls",
            {{"contact-angles", "", 0, "drops on a wall and their contact angles", contact_angles},
             {"drops-in-gravity", "", 0, "drops on a wall under gravity beside exact profiles",
              drops_in_gravity}}};
}

} // namespace meniscus
