// Files that hold several states, as trajectories do: which of them is read, and how that is said.
// States are counted from 0, through all parts of the file. Without a choice it is the last.
#pragma once

#include <meniscus/data/formats/read_choices.hpp>
#include <meniscus/data/particles/snapshot.hpp>

#include <cstdint>
#include <string>

namespace meniscus {

/// The state to read of a file of so many. Throws InputError where it has none of the number that
/// was chosen.
std::uint64_t frame_to_read(const ReadChoices& choices, std::uint64_t count);

/// Says in notes and provenance which state was read. `place`: what the file calls it, where it
/// does.
void note_frame(Snapshot& snapshot, const ReadChoices& choices, std::uint64_t frame,
                std::uint64_t count, const std::string& place = "");

/// Throws InputError where a state is chosen of a file whose format holds one only.
void expect_no_frame(const ReadChoices& choices);

} // namespace meniscus
