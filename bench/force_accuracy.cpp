// How true the surface-tension force is, on clouds with known answers and on real droplets.
//   young_laplace  force over one half of a filled ball, over 2 pi R sigma
//   fade           what the exposure weight does to pinholes, and what it leaves of the force
//   momentum       net force and torque of droplets, without the option that removes them and with
// Usage: force_accuracy TABLE [SNAPSHOT...]
#include <meniscus/data/clouds.hpp>
#include <meniscus/data/neighbor_search.hpp>
#include <meniscus/data/snapshot_files.hpp>
#include <meniscus/runtime/surface_tension.hpp>

#include <cmath>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace meniscus {
namespace {

constexpr double sigma = 0.072; // N/m, water in air

/// Particles as a solver holds them, in 3D.
struct Fluid {
    std::string name;
    std::vector<double> positions;
    NeighborLists lists;
    double support_radius;
    double spacing;
    Vector3 center = {0, 0, 0};

    Fluid(std::string its_name, const Positions& places, double h, double s)
        : name(std::move(its_name)), lists(find_neighbors(places, h)), support_radius(h),
          spacing(s) {
        for (const auto& place : places) {
            positions.insert(positions.end(), place.begin(), place.end());
            center = sum(center, scaled(1 / static_cast<double>(places.size()), place));
        }
    }

    [[nodiscard]] std::size_t size() const { return positions.size() / 3; }
    [[nodiscard]] Vector3 arm(std::size_t i) const {
        const double* x = &positions[3 * i];
        return difference({x[0], x[1], x[2]}, center);
    }
    [[nodiscard]] CsrNeighborhood<double, 3> view() const {
        return {positions.data(), nullptr, lists.offsets.data(), lists.neighbors.data()};
    }
};

/// In support radii, h / spacing as SPlisHSPlasH has it.
Fluid filled(const std::string& name, const Shape& shape, Arrangement arrangement,
             double jitter = 0, std::uint64_t seed = 1) {
    CloudOptions options;
    options.support_radius = 1;
    options.spacing = 0.5;
    options.arrangement = arrangement;
    options.jitter = jitter;
    options.seed = seed;
    return {name, fill(shape, options).positions, 1, 0.5};
}

Fluid real_state(const std::string& file) {
    const Snapshot snapshot = read_snapshot(file);
    if (!snapshot.support_radius || snapshot.dimension != 3)
        throw std::runtime_error(file + " must be in 3D and store its support radius");
    const std::string stem = file.substr(file.rfind('/') + 1);
    return {stem.substr(0, stem.find('.')), snapshot.positions, *snapshot.support_radius,
            snapshot.particle_spacing.value_or(*snapshot.support_radius / 2)};
}

SurfaceTensionOptions options_with(const Fluid& fluid, std::size_t samples) {
    auto options = shipped_options<3>();
    options.force.surface_tension = sigma;
    options.force.spacing_ratio = fluid.support_radius / fluid.spacing;
    if (samples == 0)
        options.exposure.method = CoverageMethod::exact;
    else
        options.samples = samples;
    return options;
}

std::string samples_name(std::size_t samples) {
    return samples == 0 ? "exact" : std::to_string(samples);
}

/// One step with those options.
SurfaceTension<double, 3> stepped(const Fluid& fluid, const SurfaceTensionOptions& options) {
    SurfaceTension<double, 3> tension(options);
    tension.step(fluid.view(), fluid.size(), UniformRadius<double>{fluid.support_radius},
                 OpenMpLoop{});
    return tension;
}

double length(const Vector3& vector) {
    return std::sqrt(dot(vector, vector));
}

// --- Young-Laplace ---

/// Mean over the six half balls along the axes of their force along the axis.
double force_on_half(const Fluid& ball, const SurfaceParticles<double, 3>& surface) {
    double sum_of_halves = 0;
    for (std::size_t slot = 0; slot < surface.size(); ++slot) {
        const Vector3 arm = ball.arm(surface.particle[slot]);
        for (int axis = 0; axis < 3; ++axis) // inward counts
            sum_of_halves -= surface.force[slot][axis] * (arm[axis] < 0 ? -1 : 1);
    }
    return sum_of_halves / 6;
}

void print_young_laplace() {
    fmt::print("| R / h | arrangement | particles | samples | force / (2 pi R sigma) |\n"
               "|---|---|---|---|---|\n");
    for (const double radius : {5.0, 10.0, 20.0})
        for (const auto& [name, arrangement, jitter] :
             {std::tuple{"relaxed", Arrangement::relaxed, 0.0},
              std::tuple{"relaxed, jitter 0.1", Arrangement::relaxed, 0.1},
              std::tuple{"lattice", Arrangement::lattice, 0.0}}) {
            const Fluid ball = filled(name, sphere(radius), arrangement, jitter);
            for (const std::size_t samples : {32UL, 128UL, 0UL}) {
                const auto tension = stepped(ball, options_with(ball, samples));
                fmt::print("| {:g} | {} | {} | {} | {:.3f} |\n", radius, name, ball.size(),
                           samples_name(samples),
                           force_on_half(ball, tension.surface()) / (2 * pi * radius * sigma));
            }
        }
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
        options.force.form = ForceForm::paper;
    }
    options.d = 1e6;
    return options;
}

void print_fade(const std::vector<std::string>& files) {
    std::vector<Fluid> fluids;
    for (const double jitter : {0.0, 0.2})
        fluids.push_back(filled(fmt::format("ball R = 5 h, jitter {:g}", jitter), sphere(5),
                                Arrangement::relaxed, jitter));
    for (const std::string& file : files)
        fluids.push_back(real_state(file));
    fmt::print(
        "| fluid | form | fade | lambda < 0.02 | h kappa(lambda) < -1 | force / that without "
        "fade |\n|---|---|---|---|---|---|\n");
    for (const Fluid& fluid : fluids)
        for (const bool paper : {true, false}) {
            double unfaded = 0;
            for (const double fade : {0.0, 0.1, 1.0 / 3, 2.0 / 3, 1.0}) {
                auto options = whole_surface(fluid, paper);
                options.exposure.fade = fade;
                const ForceShares shares = shares_of(stepped(fluid, options).surface());
                if (fade == 0)
                    unfaded = shares.total;
                fmt::print("| {} | {} | {:.2g} | {:.1f} % | {:.1f} % | {:.3f} |\n", fluid.name,
                           paper ? "paper" : "calibrated", fade, 100 * shares.pinholes,
                           100 * shares.hollow, shares.total / unfaded);
            }
        }
}

// --- momentum ---

struct Net {
    double force;  ///< |sum F| / sum |F|
    double torque; ///< |sum r x F| / sum |r| |F|
};

Net net_of(const Fluid& fluid, const SurfaceParticles<double, 3>& surface) {
    Vector3 force = {0, 0, 0};
    Vector3 torque = {0, 0, 0};
    double forces = 0;
    double torques = 0;
    for (std::size_t slot = 0; slot < surface.size(); ++slot) {
        const Vector3 arm = fluid.arm(surface.particle[slot]);
        force = sum(force, surface.force[slot]);
        torque = sum(torque, cross(arm, surface.force[slot]));
        forces += length(surface.force[slot]);
        torques += length(arm) * length(surface.force[slot]);
    }
    return {length(force) / forces, length(torque) / torques};
}

void print_momentum_of(const Fluid& fluid) {
    for (const std::size_t samples : {32UL, 128UL, 512UL, 0UL})
        for (const double more_d : {-12.0, 0.0})
            for (const double share : {0.0, 0.5}) {
                auto options = options_with(fluid, samples);
                options.d += more_d;
                options.covariance_share = share;
                auto tension = stepped(fluid, options);
                const Net before = net_of(fluid, tension.surface());
                tension.balance_momentum<3>(fluid.view(), NoBoundary{},
                                            UniformRadius<double>{fluid.support_radius},
                                            fluid.positions.data(), OpenMpLoop{});
                const Net after = net_of(fluid, tension.surface());
                fmt::print("| {} | {} | {:.1f} | {:g} | {:.1e} | {:.1e} | {:.0e} | {:.0e} |\n",
                           fluid.name, samples_name(samples), options.d, share, before.force,
                           before.torque, after.force, after.torque);
            }
}

void print_momentum(const std::vector<std::string>& files) {
    fmt::print("| fluid | samples | d | PCA share | net force | net torque | force, balanced | "
               "torque, balanced |\n|---|---|---|---|---|---|---|---|\n");
    print_momentum_of(filled("ball R = 5 h", sphere(5), Arrangement::relaxed, 0.1));
    print_momentum_of(filled("stretched 1.5 : 1", ellipsoid({6, 4, 4}), Arrangement::relaxed, 0.1));
    for (const std::string& file : files)
        print_momentum_of(real_state(file));
}

void print(const std::string& table, const std::vector<std::string>& files) {
    if (table == "young_laplace")
        print_young_laplace();
    else if (table == "fade")
        print_fade(files);
    else if (table == "momentum")
        print_momentum(files);
    else
        throw std::runtime_error("unknown table '" + table +
                                 "'; there are young_laplace, fade and momentum");
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        if (argument_count < 2)
            throw std::runtime_error("usage: force_accuracy TABLE [SNAPSHOT...]");
        meniscus::print(arguments[1], {arguments + 2, arguments + argument_count});
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "force_accuracy: %s\n", error.what());
        return 1;
    }
}
