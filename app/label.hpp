// The work of `meniscus label`, which the demo runs too.
#pragma once

#include "command_line.hpp"

#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/labeler/labeler.hpp>

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
    std::optional<int> dimension; ///< 2 or 3
    std::string periodic;         ///< sides of the box; empty: as the file says
    std::string scene;
};

/// Adds the options above to a verb.
void add_input_options(CLI::App& verb, InputOptions& options);

/// Reads a snapshot of any format and completes it with the options. The support radius is that of
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

/// Warns on standard error of a support radius that fits the particles ill, or else where all of
/// them are surface. Returns whether it did.
bool warn_of_support_radius(const Path& file, const Snapshot& snapshot,
                            const std::vector<std::uint8_t>& valid,
                            const std::vector<std::uint8_t>& surface);

/// What an earlier run left at `output`, told by its point data `array`; nothing where there is no
/// file. Throws InputError where something else is there: that is not ours to overwrite.
std::optional<Snapshot> earlier_output(const Path& output, const char* array);

struct LabelCommand {
    InputsAndFolder files;
    InputOptions input;
    LabelOptions label;
    Path boundary;            ///< file of boundary particles; empty: those of the input itself
    bool no_boundary = false; ///< boundary particles do not cover
    std::optional<std::filesystem::path> report; ///< page to write
    bool quiet = false;
};

/// Labels each input into its output, leaving out those that are there already, made from the same
/// input with the same options. Returns the outputs.
std::vector<Path> run_label(const LabelCommand& command);

} // namespace meniscus
