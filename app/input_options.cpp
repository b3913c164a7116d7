#include "input_options.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/hdf5/hdf5_signature.hpp>
#include <meniscus/data/particles/flat_states.hpp>
#include <meniscus/data/particles/nearest_spacing.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/particles/periodic_copies.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/sha256.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/version.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace meniscus {
namespace {

void check_positive(const char* option, const std::optional<double>& value) {
    if (value && !(*value > 0 && std::isfinite(*value)))
        throw InputError(fmt::format("{} must be positive and finite, found {}", option, *value));
}

void check_lengths(const InputOptions& options) {
    check_positive("--support-radius", options.support_radius);
    check_positive("--particle-spacing", options.particle_spacing);
    check_positive("--particle-volume", options.particle_volume);
    check_positive("--particle-radius", options.particle_radius);
}

ReadChoices choices_of(const InputOptions& options) {
    return {options.dimension, options.fluid, options.walls, options.ignored, false, options.frame};
}

/// What was chosen, so that a rerun with other choices is another run.
void set_provenance(Snapshot& snapshot, const InputOptions& options) {
    const std::pair<const char*, const std::vector<std::string>*> all[] = {
        {"fluid", &options.fluid}, {"walls", &options.walls}, {"ignore", &options.ignored}};
    for (const auto& [name, chosen] : all) {
        std::string text;
        for (const std::string& choice : *chosen)
            text += (text.empty() ? "" : ", ") + choice;
        if (!text.empty())
            snapshot.provenance[std::string("chosen_") + name] = text;
    }
}

} // namespace

void add_input_options(CLI::App& verb, InputOptions& options) {
    auto* radius = verb.add_option(
        "--support-radius", options.support_radius,
        "Kernel radius h in m of all particles, where the files do not store it, or in place of "
        "what they store, be it one for each particle");
    verb.add_option("--particle-radius", options.particle_radius,
                    "Particle radius in m, of which the support radius is four (SPlisHSPlasH), in "
                    "place of --support-radius")
        ->excludes(radius);
    const auto add_choice = [&](const char* name, std::vector<std::string>& choices,
                                const char* meaning) {
        verb.add_option(name, choices, meaning)->delimiter(',')->allow_extra_args(false);
    };
    add_choice(
        "--fluid", options.fluid,
        "Particles that are fluid: arrays by their names (PySPH), or point data and a value, "
        "as in Type=3 (default: told by names, or by DualSPHysics' Type)");
    add_choice("--walls", options.walls, "Particles that are walls, which cover, chosen likewise");
    add_choice("--ignore", options.ignored, "Particles that are left out, chosen likewise");
    verb.add_option("--periodic", options.periodic,
                    "Sides of a periodic box in m, as in x=0:1,y=0:2, or its lengths from 0, as in "
                    "1,2,3; particles beyond them cover as boundary particles do (default: as the "
                    "file says)");
    verb.add_option("--particle-spacing", options.particle_spacing,
                    "Initial distance of particles in m, where the files do not store it");
    verb.add_option("--particle-volume", options.particle_volume,
                    "Volume of a particle at rest, m / rho_0, in m^3 (in 2D m^2), where the files "
                    "do not store it (default: measured)");
    verb.add_option("--dimension", options.dimension,
                    "2 or 3, where the files do not store it (default: 2 if all lie in the plane "
                    "xy, xz or yz)")
        ->check(CLI::IsMember({2, 3}));
    verb.add_option("--frame", options.frame,
                    "Which state of files that hold several, such as trajectories, counted from 0; "
                    "outputs get its number behind their name (default: the last)")
        ->check(whole_numbers());
    verb.add_option("--scene", options.scene,
                    "Scene that the states belong to (default: the stored one, else the file's "
                    "name without a trailing frame number)");
}

void set_options(Snapshot& snapshot, const Path& file, const InputOptions& options) {
    check_lengths(options);
    set_provenance(snapshot, options);
    if (options.particle_spacing)
        snapshot.particle_spacing = options.particle_spacing;
    if (options.particle_volume)
        snapshot.particle_volume = options.particle_volume;
    snapshot.scene = options.scene.empty() ? scene_of(snapshot, file) : options.scene;
    if (options.support_radius || options.particle_radius) {
        snapshot.support_radius =
            options.support_radius ? *options.support_radius : 4 * *options.particle_radius;
        snapshot.provenance.erase("support_radius_from");
    }
}

Snapshot read_with_options(const Path& file, const InputOptions& options) {
    check_lengths(options); // before the work
    Snapshot snapshot = read_snapshot(file, choices_of(options));
    set_options(snapshot, file, options);
    return snapshot;
}

Snapshot read_input(const Path& file, const InputOptions& options) {
    Snapshot snapshot = read_with_options(file, options);
    const SupportRadii radii = support_radii(snapshot);
    if (!radii.vary())
        snapshot.support_radius = radii.max;
    check_positive("the stored support radius", snapshot.support_radius);
    return snapshot;
}

Boundary read_boundary(const Path& file) {
    if (file.empty())
        return {};
    ReadChoices choices;
    choices.is_boundary = true;
    Snapshot snapshot = read_snapshot(file, choices);
    Positions& positions = snapshot.boundary.empty() ? snapshot.positions : snapshot.boundary;
    if (positions.empty())
        throw InputError(
            fmt::format("{}: --boundary expects particles, found none", file.string()));
    const bool is_turned = snapshot.dimension_is_stated && snapshot.dimension == 2;
    return {std::move(positions), is_turned, file_hash(file)};
}

void set_boundary(Snapshot& snapshot, const Boundary& boundary) {
    snapshot.provenance.erase("boundary_hash");
    if (boundary.positions.empty())
        return;
    remove_periodic_copies(snapshot);
    snapshot.boundary = boundary.positions;
    if (!boundary.is_turned)
        turn_into_plane(snapshot, snapshot.boundary);
    snapshot.provenance["boundary_hash"] = boundary.hash;
}

std::string support_radius_text(const Snapshot& snapshot) {
    const SupportRadii radii = support_radii(snapshot);
    return radii.vary() ? fmt::format("support radii of {:.4g} to {:.4g} m", radii.min, radii.max)
                        : fmt::format("support radius of {} m", radii.max);
}

void set_periodic(Snapshot& snapshot, const InputOptions& options) {
    if (!options.periodic.empty())
        snapshot.provenance["periodic"] = options.periodic;
    const auto sides = snapshot.provenance.find("periodic");
    if (sides != snapshot.provenance.end())
        add_periodic_copies(snapshot, periodic_box(sides->second), support_radii(snapshot).max);
}

std::string reading_notes(const Snapshot& snapshot) {
    std::string lines;
    const auto from = snapshot.provenance.find("support_radius_from");
    if (from != snapshot.provenance.end())
        lines +=
            fmt::format("    {}: {}\n", support_radius_text(snapshot), printable(from->second));
    for (const std::string& note : snapshot.notes)
        lines += fmt::format("    {}\n", printable(note));
    return lines;
}

std::optional<std::string> support_radius_warning(const Path& file, const Snapshot& snapshot,
                                                  const std::vector<std::uint8_t>& valid,
                                                  const std::vector<std::uint8_t>& surface) {
    constexpr std::ptrdiff_t min_for_doubt = 100;
    const std::string doubt = doubtful_support_radius(snapshot, support_radii(snapshot), valid);
    if (!doubt.empty())
        return fmt::format("{}: {}", file.string(), doubt);
    const auto all = std::count(valid.begin(), valid.end(), 1);
    if (all < min_for_doubt || std::count(surface.begin(), surface.end(), 1) != all)
        return std::nullopt;
    return fmt::format("{}: all {} particles are surface; is the {} right?", file.string(), all,
                       support_radius_text(snapshot));
}

namespace {

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += word + '\n';
    return text;
}

std::string number_of(const std::optional<double>& value) {
    return value ? number_text(*value) : "";
}

} // namespace

std::string request_of(const std::string& verb, const Path& input, const InputOptions& options,
                       const Boundary& boundary, const std::vector<std::string>& others) {
    Sha256 sum;
    const auto add = [&](const std::string& text) {
        const std::string length = std::to_string(text.size()) + ':'; // keeps texts apart
        sum.add(length.data(), length.size());
        sum.add(text.data(), text.size());
    };
    for (const std::string& text :
         {std::string(program_version), verb, file_hash(input), boundary.hash,
          options.scene.empty() ? scene_of({}, input) : options.scene,
          number_of(options.support_radius), number_of(options.particle_spacing),
          number_of(options.particle_volume), number_of(options.particle_radius),
          joined(options.fluid), joined(options.walls), joined(options.ignored),
          std::to_string(options.dimension.value_or(0)), options.periodic,
          options.frame ? std::to_string(*options.frame) : "", joined(others)})
        add(text);
    return sum.text();
}

} // namespace meniscus
