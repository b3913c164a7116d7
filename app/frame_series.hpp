// Frames as ParaView's file series: beside them a JSON file that names each with its time, which
// opens as an animation in seconds rather than in numbers of files.
#pragma once

#include "command_line.hpp"

#include <vector>

namespace meniscus {

/// Writes FOLDER/<name>.vtkhdf.series for those of the files that are frames of one name, as
/// dam_7.vtkhdf is of dam, two at least: each with the time that it stores or else its number, in
/// the order of their numbers, together with frames that an earlier one lists and that are still
/// there. Files that are missing are left out. Throws as write_whole does.
void write_frame_series(const std::vector<Path>& files);

} // namespace meniscus
