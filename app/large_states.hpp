// States that are too large for the memory that a verb may take: read in rows, and written as they
// are fetched.
#pragma once

#include "command_line.hpp"
#include "input_options.hpp"

#include <meniscus/data/slabs/state_in_slabs.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace meniscus {

/// Adds --memory to a verb, in bytes; `meaning` goes on where its help says what is limited.
void add_memory_option(CLI::App& verb, std::uint64_t& memory, const std::string& meaning);

/// A state that does not fit, completed with the command's options.
struct LargeState {
    Path file;
    RowsOfState state;
};

/// What decides whether and how a state is read in rows.
struct LargeStateOptions {
    std::string verb;         ///< for messages
    std::uint64_t memory = 0; ///< bytes; 0: no limit
    InputOptions input;
    bool no_boundary = false; ///< boundary particles do not cover
    std::string obstacle;     ///< what the verb itself cannot do in parts; empty: nothing
};

/// Bytes that the work on a state of that outline takes in one pass.
using MemoryInOnePass = std::function<std::uint64_t(const Snapshot& outline)>;

/// The state where to work on it in one pass takes more than the memory; nothing where it fits.
/// Throws InputError where it does not and cannot be read in rows, saying why and how much it
/// takes.
std::optional<LargeState> large_state(const Path& input, const Boundary& boundary,
                                      const LargeStateOptions& options,
                                      const MemoryInOnePass& needed);

/// Adds the copies beyond the sides of a periodic box, where options or file have one, as
/// set_periodic does. Collective; throws likewise, on all ranks alike.
void set_periodic(LargeState& large, const InputOptions& options, Ranks& ranks);

/// Rows of an array of a frame, which is empty there; nothing for one of the input's own.
using FoundValues = std::function<std::optional<ArrayValues>(
    const PointArray& array, std::uint64_t first, std::uint64_t count)>;

/// Writes the state with what was found of it: `frame` has all that is written but particles. The
/// rows are asked for of this rank's share (row_results.hpp). Collective; throws as write_vtkhdf
/// does, on all ranks alike. Returns the bytes that this rank sent to others.
std::uint64_t write_large(const LargeState& large, const Snapshot& frame, const FoundValues& found,
                          const Path& output, Ranks& ranks);

/// How the work was done, in a line for standard output. Collective.
struct SlabFigures {
    std::uint64_t slabs = 0;
    std::uint64_t halo = 0; ///< of this rank
    std::uint64_t sent = 0; ///< bytes, by this rank
};
std::string slab_line(const SlabFigures& figures, Ranks& ranks);

} // namespace meniscus
