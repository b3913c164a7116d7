// What the user says of inputs, and how they are read and recognized with it.
#pragma once

#include "command_line.hpp"

#include <meniscus/data/particles/snapshot.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

/// What the user says of the inputs where the files do not.
struct InputOptions {
    std::optional<double> support_radius;   ///< m
    std::optional<double> particle_spacing; ///< m
    std::optional<double> particle_volume;  ///< at rest, m^3 (in 2D m^2)
    std::optional<double> particle_radius;  ///< m, of which the support radius is four
    std::vector<std::string> fluid;         ///< arrays, or point data and a value ("Type=3")
    std::vector<std::string> walls;
    std::vector<std::string> ignored;
    std::optional<int> dimension;       ///< 2 or 3
    std::optional<std::uint64_t> frame; ///< of a file that holds several, from 0
    std::string periodic;               ///< sides of the box; empty: as the file says
    std::string scene;
};

/// Adds the options above to a verb.
void add_input_options(CLI::App& verb, InputOptions& options);

/// Reads a snapshot of any format and completes it with the options. Throws InputError where a
/// number of theirs is not positive and finite, and as read_snapshot does.
Snapshot read_with_options(const Path& file, const InputOptions& options);

/// Completes a snapshot of that file with the options: lengths, volume, scene, choices. Throws as
/// read_with_options does.
void set_options(Snapshot& snapshot, const Path& file, const InputOptions& options);

/// As read_with_options, for a verb that needs a support radius. It is that of
/// the options, else the stored one, else that of a `support_radius` array; where its values
/// differ, the snapshot has no radius for all and support_radii() has them. Throws InputError where
/// there is none, or where a number for all is not positive and finite.
Snapshot read_input(const Path& file, const InputOptions& options);

/// Boundary particles from a file of their own.
struct Boundary {
    Positions positions;    ///< none where no file is given
    bool is_turned = false; ///< a flat state in x and y, as we write it
    std::string hash;       ///< SHA-256 of the file
};

/// Reads the boundary of all inputs; none where `file` is empty. Where the file holds a fluid and a
/// boundary beside it, the boundary is meant. Throws InputError where there is no particle.
Boundary read_boundary(const Path& file);

/// Replaces the snapshot's boundary by one that is not empty, and says in the provenance where it
/// comes from.
void set_boundary(Snapshot& snapshot, const Boundary& boundary);

/// The snapshot's support radius, or the range of its radii, in words.
std::string support_radius_text(const Snapshot& snapshot);

/// Adds the copies of a periodic box, of the options or else of the file. To be called once the
/// boundary is set. Throws InputError as add_periodic_copies does.
void set_periodic(Snapshot& snapshot, const InputOptions& options);

/// Lines to print on what the reader had to choose, leave out, or take for something else.
std::string reading_notes(const Snapshot& snapshot);

/// A warning, or nothing, of a support radius that fits the particles ill, or else where all of
/// them are surface.
std::optional<std::string> support_radius_warning(const Path& file, const Snapshot& snapshot,
                                                  const std::vector<std::uint8_t>& valid,
                                                  const std::vector<std::uint8_t>& surface);

/// A digest of all that decides what a verb writes for an input: its bytes, those of the boundary,
/// the options, and the program's version. `others`: what the verb has besides InputOptions, each
/// with its name. Written as provenance `request`, so that a rerun knows its own work without
/// reading a particle.
std::string request_of(const std::string& verb, const Path& input, const InputOptions& options,
                       const Boundary& boundary, const std::vector<std::string>& others);

} // namespace meniscus
