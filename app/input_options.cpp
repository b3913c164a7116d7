#include "label.hpp"

#include <meniscus/data/errors.hpp>
#include <meniscus/data/snapshot_files.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace meniscus {
namespace {

void check_positive(const char* option, const std::optional<double>& value) {
    if (value && !(*value > 0 && std::isfinite(*value)))
        throw InputError(fmt::format("{} must be positive and finite, found {}", option, *value));
}

/// The value that all particles of the file share, where it stores one for each.
std::optional<double> constant_support_radius(const Snapshot& snapshot) {
    if (find_array(snapshot, "support_radius") == nullptr || snapshot.size() == 0)
        return {};
    auto radii = scalar_values(snapshot, "support_radius");
    for (std::size_t i = 0; i < radii.size(); ++i)
        if (!std::isfinite(radii[i]))
            throw InputError(fmt::format("particle {} has support radius {}", i, radii[i]));
    const auto [smallest, largest] = std::minmax_element(radii.begin(), radii.end());
    if (*smallest == *largest)
        return radii[0];
    const auto range = fmt::format("{:.4g} to {:.4g} m", *smallest, *largest);
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    throw InputError(
        fmt::format("its particles have support radii from {}; radii that vary are not "
                    "supported, give one with --support-radius (their median is {:.4g})",
                    range, *middle));
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
                    "Kernel radius h in m, where the files do not store it (SPlisHSPlasH: 4 "
                    "particle radii)");
    verb.add_option("--particle-spacing", options.particle_spacing,
                    "Initial distance of particles in m, where the files do not store it");
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
    Snapshot snapshot = read_snapshot(file);
    if (options.particle_spacing)
        snapshot.particle_spacing = options.particle_spacing;
    if (options.dimension)
        snapshot.dimension = *options.dimension;
    if (options.dimension == 2)
        check_is_flat(snapshot.positions);
    snapshot.scene = options.scene.empty() ? scene_of(snapshot, file) : options.scene;
    if (options.support_radius) {
        snapshot.support_radius = options.support_radius;
        snapshot.provenance.erase("support_radius_from");
    }
    if (!snapshot.support_radius)
        snapshot.support_radius = constant_support_radius(snapshot);
    if (!snapshot.support_radius)
        throw InputError(fmt::format("{}: no support radius is stored; give the kernel radius h in "
                                     "m with --support-radius",
                                     file.string()));
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

std::string support_radius_note(const Snapshot& snapshot) {
    const auto from = snapshot.provenance.find("support_radius_from");
    if (from == snapshot.provenance.end())
        return {};
    return fmt::format("    support radius {} m: {}\n", *snapshot.support_radius, from->second);
}

} // namespace meniscus
