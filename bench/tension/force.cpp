// How true the surface-tension force is, on clouds with known answers and on real droplets.
#include "support/known_state.hpp"
#include "support/tables.hpp"

#include <meniscus/runtime/math/vector3.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace meniscus {
namespace {

constexpr double sigma = 0.072; // N/m, water in air

using Fluid = FluidState<double>; // in 3D

/// With h / spacing as SPlisHSPlasH has it.
Fluid filled(const std::string& name, const Shape& shape, double jitter = 0,
             Arrangement arrangement = Arrangement::relaxed) {
    CloudOptions options = known_cloud(jitter);
    options.arrangement = arrangement;
    return known_state<double>(name, shape, options).state;
}

Vector3 place_of(const Fluid& fluid, std::size_t i) {
    const double* x = &fluid.positions[3 * i];
    return {x[0], x[1], x[2]};
}

Vector3 center_of(const Fluid& fluid) {
    Vector3 center = {0, 0, 0};
    for (std::size_t i = 0; i < fluid.size(); ++i)
        center = sum(center, scaled(1 / static_cast<double>(fluid.size()), place_of(fluid, i)));
    return center;
}

SurfaceTensionOptions options_with(const Fluid& fluid, std::size_t samples) {
    auto options = completed({}, 3);
    options.surface_tension = sigma;
    options.spacing_ratio = fluid.support_radius / fluid.spacing;
    if (samples == 0)
        options.coverage = CoverageMethod::exact;
    else
        options.samples = samples;
    return options;
}

Cell samples_cell(std::size_t samples) {
    return samples == 0 ? Cell("exact") : Cell(samples);
}

/// One step with those options.
SurfaceTension<double, 3> stepped(const Fluid& fluid, const SurfaceTensionOptions& options) {
    SurfaceTension<double, 3> tension(options);
    tension.step(fluid.view<3>(), fluid.size(), UniformRadius<double>{fluid.support_radius},
                 OpenMpLoop{});
    return tension;
}

double length(const Vector3& vector) {
    return std::sqrt(dot(vector, vector));
}

// --- Young-Laplace ---

/// Mean over the six half balls along the axes of their force along the axis.
double force_on_half(const Fluid& ball, const SurfaceParticles<double, 3>& surface) {
    const Vector3 center = center_of(ball);
    double sum_of_halves = 0;
    for (std::size_t slot = 0; slot < surface.size(); ++slot) {
        const Vector3 arm = difference(place_of(ball, surface.particle[slot]), center);
        for (int axis = 0; axis < 3; ++axis) // inward counts
            sum_of_halves -= surface.force[slot][axis] * (arm[axis] < 0 ? -1 : 1);
    }
    return sum_of_halves / 6;
}

Tables young_laplace(const TableInput&) {
    Table table =
        table_of("young-laplace",
                 "R / h | arrangement | particles | samples | force / (2 pi R sigma) {:.3f}");
    for (const double radius : {5.0, 10.0, 20.0})
        for (const auto& [name, arrangement, jitter] :
             {std::tuple{"relaxed", Arrangement::relaxed, 0.0},
              std::tuple{"relaxed, jitter 0.1", Arrangement::relaxed, 0.1},
              std::tuple{"lattice", Arrangement::lattice, 0.0}}) {
            const Fluid ball = filled(name, sphere(radius), jitter, arrangement);
            for (const std::size_t samples : {32UL, 128UL, 0UL}) {
                const auto tension = stepped(ball, options_with(ball, samples));
                table.add({radius, name, ball.size(), samples_cell(samples),
                           force_on_half(ball, tension.surface()) / (2 * pi * radius * sigma)});
            }
        }
    return {table};
}

// --- exposure weight ---

struct ForceShares {
    double pinholes = 0; ///< of the sum of |force|, on particles less than 2 % uncovered
    double hollow = 0;   ///< on particles whose lambda says h kappa < -1 (eq. 17)
    double total = 0;    ///< sum of |force|
};

ForceShares shares_of(const SurfaceParticles<double, 3>& surface) {
    ForceShares shares;
    for (std::size_t slot = 0; slot < surface.size(); ++slot) {
        if (surface.surface_class[slot] != SurfaceClass::surface)
            continue;
        const double size = length(surface.force[slot]);
        const double lambda = surface.uncovered_fraction[slot];
        shares.total += size;
        shares.pinholes += lambda < 0.02 ? size : 0;
        shares.hollow += curvature_of<3>(lambda, 0.8) < -1 ? size : 0;
    }
    shares.pinholes /= shares.total;
    shares.hollow /= shares.total;
    return shares;
}

/// Every particle a candidate, coverage exact: the whole surface with all its pinholes.
SurfaceTensionOptions whole_surface(const Fluid& fluid, bool paper) {
    auto options = options_with(fluid, 0);
    if (paper) {
        options.curvature = CurvatureForm::closed;
        options.force = ForceForm::paper;
    }
    options.d = 1e6;
    return options;
}

/// `files` are added to clouds.
std::vector<Fluid> with_states(std::vector<Fluid> fluids, const TableInput& input) {
    for (const auto& file : input.files)
        fluids.push_back(read_fluid_state_in_3d<double>(file));
    return fluids;
}

Tables fade(const TableInput& input) {
    const auto fluids = with_states({filled("ball R = 5 h, jitter 0", sphere(5)),
                                     filled("ball R = 5 h, jitter 0.2", sphere(5), 0.2)},
                                    input);
    Table table =
        table_of("fade", "fluid | form | fade {:.2g} | lambda < 0.02 {:.1f} % | h kappa(lambda) < "
                         "-1 {:.1f} % | force / that without fade {:.3f}");
    for (const Fluid& fluid : fluids)
        for (const bool paper : {true, false}) {
            double unfaded = 0;
            for (const double fade : {0.0, 0.1, 1.0 / 3, 2.0 / 3, 1.0}) {
                auto options = whole_surface(fluid, paper);
                options.fade = fade;
                const ForceShares shares = shares_of(stepped(fluid, options).surface());
                if (fade == 0)
                    unfaded = shares.total;
                table.add({fluid.name, paper ? "paper" : "calibrated", fade, 100 * shares.pinholes,
                           100 * shares.hollow, shares.total / unfaded});
            }
        }
    return {table};
}

// --- momentum ---

struct Net {
    double force;  ///< |sum F| / sum |F|
    double torque; ///< |sum r x F| / sum |r| |F|
};

Net net_of(const Fluid& fluid, const SurfaceParticles<double, 3>& surface) {
    const Vector3 center = center_of(fluid);
    Vector3 force = {0, 0, 0};
    Vector3 torque = {0, 0, 0};
    double forces = 0;
    double torques = 0;
    for (std::size_t slot = 0; slot < surface.size(); ++slot) {
        const Vector3 arm = difference(place_of(fluid, surface.particle[slot]), center);
        force = sum(force, surface.force[slot]);
        torque = sum(torque, cross(arm, surface.force[slot]));
        forces += length(surface.force[slot]);
        torques += length(arm) * length(surface.force[slot]);
    }
    return {length(force) / forces, length(torque) / torques};
}

void add_momentum(const Fluid& fluid, Table& table) {
    for (const std::size_t samples : {32UL, 128UL, 512UL, 0UL})
        for (const double more_d : {-12.0, 0.0})
            for (const double share : {0.0, 0.5}) {
                auto options = options_with(fluid, samples);
                options.d += more_d;
                options.covariance_share = share;
                auto tension = stepped(fluid, options);
                const Net before = net_of(fluid, tension.surface());
                tension.balance_momentum<3>(fluid.view<3>(), NoBoundary{},
                                            UniformRadius<double>{fluid.support_radius},
                                            fluid.positions.data(), OpenMpLoop{});
                const Net after = net_of(fluid, tension.surface());
                table.add({fluid.name, samples_cell(samples), options.d, share, before.force,
                           before.torque, after.force, after.torque});
            }
}

Tables momentum(const TableInput& input) {
    Table table =
        table_of("momentum", "fluid | samples | d {:.1f} | PCA share | net force {:.1e} | net "
                             "torque {:.1e} | force, balanced {:.0e} | torque, balanced {:.0e}");
    for (const Fluid& fluid : with_states({filled("ball R = 5 h", sphere(5), 0.1),
                                           filled("stretched 1.5 : 1", ellipsoid({6, 4, 4}), 0.1)},
                                          input))
        add_momentum(fluid, table);
    return {table};
}

} // namespace

TableGroup force_tables() {
    return {"Surface tension",
            {{"young-laplace", "", 0, "force over one half of a filled ball, over 2 pi R sigma",
              young_laplace},
             {"fade", "[SNAPSHOT...]", 0,
              "what the exposure weight does to pinholes, and what it leaves of the force", fade},
             {"momentum", "[SNAPSHOT...]", 0,
              "net force and torque, without the option that removes them and with", momentum}}};
}

} // namespace meniscus
