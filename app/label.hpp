// The work of `meniscus label`, which the demo runs too.
#pragma once

#include "command_line.hpp"
#include "input_options.hpp"

#include <meniscus/labeler/labeler.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

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
