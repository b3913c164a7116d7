#include "label.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <cmath>
#include <fmt/format.h>

namespace meniscus {
namespace {

void check_positive(const char* option, const std::optional<double>& value) {
    if (value && !(*value > 0 && std::isfinite(*value)))
        throw InputError(fmt::format("{} must be positive and finite, found {}", option, *value));
}

/// Two-dimensional states lie in a plane of constant z.
void check_is_flat(const Positions& positions) {
    std::optional<double> z;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!std::isfinite(positions[i][2]))
            continue;
        if (positions[i][2] != z.value_or(positions[i][2]))
            throw InputError(fmt::format("--dimension 2, but particle {} has z = {} and others "
                                         "before it {}; leave the option out",
                                         i, positions[i][2], *z));
        z = positions[i][2];
    }
}

} // namespace

void add_input_options(CLI::App& verb, InputOptions& options) {
    verb.add_option("--support-radius", options.support_radius,
                    "Kernel radius h in m of all particles, where the files do not store it "
                    "(SPlisHSPlasH: 4 particle radii) or in place of what they store, be it one "
                    "for each particle");
    verb.add_option("--particle-spacing", options.particle_spacing,
                    "Initial distance of particles in m, where the files do not store it");
    verb.add_option("--particle-volume", options.particle_volume,
                    "Volume of a particle at rest, m / rho_0, in m^3 (in 2D m^2), where the files "
                    "do not store it (default: measured)");
    verb.add_option("--dimension", options.dimension,
                    "2 or 3, where the files do not store it (default: 2 if all z are equal)")
        ->check(CLI::IsMember({2, 3}));
    verb.add_option("--scene", options.scene,
                    "Scene that the states belong to (default: the stored one, else the file's "
                    "name without a trailing frame number)");
}

Snapshot read_input(const Path& file, const InputOptions& options) {
    check_positive("--support-radius", options.support_radius);
    check_positive("--particle-spacing", options.particle_spacing);
    check_positive("--particle-volume", options.particle_volume);
    Snapshot snapshot = read_snapshot(file);
    if (options.particle_spacing)
        snapshot.particle_spacing = options.particle_spacing;
    if (options.particle_volume)
        snapshot.particle_volume = options.particle_volume;
    if (options.dimension)
        snapshot.dimension = *options.dimension;
    if (options.dimension == 2)
        check_is_flat(snapshot.positions);
    snapshot.scene = options.scene.empty() ? scene_of(snapshot, file) : options.scene;
    if (options.support_radius) {
        snapshot.support_radius = options.support_radius;
        snapshot.provenance.erase("support_radius_from");
    }
    const SupportRadii radii = support_radii(snapshot);
    if (!radii.vary())
        snapshot.support_radius = radii.max;
    check_positive("the stored support radius", snapshot.support_radius);
    return snapshot;
}

Boundary read_boundary(const Path& file) {
    if (file.empty())
        return {};
    Snapshot snapshot = read_snapshot(file);
    Positions& positions = snapshot.boundary.empty() ? snapshot.positions : snapshot.boundary;
    if (positions.empty())
        throw InputError(
            fmt::format("{}: --boundary expects particles, found none", file.string()));
    return {std::move(positions), file_hash(file)};
}

void set_boundary(Snapshot& snapshot, const Boundary& boundary) {
    snapshot.provenance.erase("boundary_hash");
    if (boundary.positions.empty())
        return;
    snapshot.boundary = boundary.positions;
    snapshot.provenance["boundary_hash"] = boundary.hash;
}

std::string support_radius_text(const Snapshot& snapshot) {
    const SupportRadii radii = support_radii(snapshot);
    return radii.vary() ? fmt::format("support radii of {:.4g} to {:.4g} m", radii.min, radii.max)
                        : fmt::format("support radius of {} m", radii.max);
}

std::string support_radius_note(const Snapshot& snapshot) {
    const auto from = snapshot.provenance.find("support_radius_from");
    if (from == snapshot.provenance.end())
        return {};
    return fmt::format("    {}: {}\n", support_radius_text(snapshot), from->second);
}

} // namespace meniscus
