// The work of `meniscus label`, which the demo runs too.
#pragma once

#include "command_line.hpp"
#include "input_options.hpp"

#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

/// What an earlier run left at `output`: its provenance and names of arrays, without particles;
/// nothing where there is no file. Throws InputError where something else than a snapshot with the
/// point data `array` is there: that is not ours to overwrite.
std::optional<Snapshot> earlier_output(const Path& output, const char* array);

/// Whether that is what is asked for again.
bool is_up_to_date(const std::optional<Snapshot>& earlier, const std::string& request);

/// Says in the provenance what the snapshot is made from: SHA-256 of the input, and the end of its
/// path, by which a changed input is told from another one.
void set_input_provenance(Snapshot& snapshot, const Path& input);

/// Throws InputError where an earlier output was made from another input than `snapshot` is.
void check_made_from_same(const Path& output, const std::optional<Snapshot>& earlier,
                          const Snapshot& snapshot);

struct LabelCommand {
    InputsAndFolder files;
    InputOptions input;
    LabelOptions label;
    Path boundary;            ///< file of boundary particles; empty: those of the input itself
    bool no_boundary = false; ///< boundary particles do not cover
    std::optional<std::filesystem::path> report; ///< page to write
    bool quiet = false;
    bool keep_going = false;  ///< a file that is at fault stops no other
    std::uint64_t memory = 0; ///< bytes; states that take more are labelled in slabs; 0: no limit
};

/// Labels each input into its output, leaving out those that are there already, made from the same
/// input with the same options. Returns the outputs. Throws as for_each_file does.
std::vector<Path> run_label(const LabelCommand& asked);

} // namespace meniscus
