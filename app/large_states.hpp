// States that are too large for the memory that a verb may take: read in rows, and written as they
// are fetched.
#pragma once

#include "command_line.hpp"
#include "input_options.hpp"

#include <meniscus/labeler/slabs/label_in_slabs.hpp>

#include <cstdint>
#include <optional>

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
    std::uint64_t memory = 0; ///< bytes; 0: no limit
    InputOptions input;
    bool no_boundary = false; ///< boundary particles do not cover
};

/// The state where to label it in one pass takes more than the memory; nothing where it fits.
/// Throws InputError where it does not and cannot be read in rows, saying why and how much it
/// takes.
std::optional<LargeState> large_state(const Path& input, const Boundary& boundary,
                                      const LargeStateOptions& options, const LabelOptions& label);

/// Writes the state with its labels. Collective; throws as write_vtkhdf does, on all ranks alike.
/// Returns the bytes that this rank sent to others.
std::uint64_t write_large(const LargeState& large, const LabelsInFile& labels,
                          const LabelOptions& options, const Path& output, Ranks& ranks);

} // namespace meniscus
