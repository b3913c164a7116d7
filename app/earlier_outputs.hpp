// What stands at an output's name before a verb writes there: the same already, an older version of
// it, the output of another input, or something that is not ours.
#pragma once

#include "command_line.hpp"

#include <meniscus/data/particles/snapshot.hpp>

#include <optional>
#include <string>

namespace meniscus {

/// Whether the output is there already, made for this request (request_of() in input_options.hpp).
/// It is told by the bytes of the file, since a process that opens it with HDF5 takes twenty times
/// as long: a digest stands in the file that was made for it and nowhere else, and the file's
/// beginning says whether its end is there. Damage in between is for whoever reads it to notice.
bool is_up_to_date(const Path& output, const std::string& request);

/// What an earlier run left at `output`: its provenance and names of arrays, without particles;
/// nothing where there is no file. Throws InputError where something else than a snapshot with the
/// point data `array` is there: that is not ours to overwrite.
std::optional<Snapshot> earlier_output(const Path& output, const char* array);

/// Says in the provenance what the snapshot is made from: SHA-256 of the input, and the end of its
/// path, by which a changed input is told from another one.
void set_input_provenance(Snapshot& snapshot, const Path& input);

/// Throws InputError where an earlier output was made from another input than `snapshot` is.
void check_made_from_same(const Path& output, const std::optional<Snapshot>& earlier,
                          const Snapshot& snapshot);

} // namespace meniscus
