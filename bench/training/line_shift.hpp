// What the constant d of the classifier's line does (2020 paper, figures 2 and 4): shifted up, the
// line has more candidates, misses fewer of the surface, and the step that follows takes longer.
// With the slope that was published with SPlisHSPlasH and with this project's own, on a hyperbolic
// paraboloid and on the double droplet.
#pragma once

#include "support/table.hpp"
#include "support/timing.hpp"

#include <filesystem>
#include <vector>

namespace meniscus {

struct LineShiftOptions {
    std::filesystem::path double_droplet;  ///< a state of it, in 3D
    std::filesystem::path published_model; ///< any with the published slope, in configs/models
    double paraboloid_width = 12;          ///< in support radii; its rim, 2 of them, is not counted
    /// Beside the one that each slope came with.
    std::vector<double> d = {0, 4, 8, 12, 13, 16, 20, 24, 28, 32, 35, 36, 40};
    int threads = 2; ///< of the parallel times
    TimingOptions timing;
};

/// A row for each state, slope and d. Columns: state, line, k, d; `candidates` (that pass the
/// line), `false_negatives` and, of those, `false_negatives_plain` (more than 2 % uncovered),
/// and `false_positives`, against exact labels; `missed_area` (percent of the summed lambda of all
/// surface particles that is on those missed); time_classify and time (of the whole
/// surface-tension step with this project's options, classification included), ns a particle of the
/// state on one thread, and time_classify_parallel and time_parallel on `threads` threads. Throws
/// as read_snapshot(), fluid_state() and read_model() do, and InputError where file or model are in
/// 2D.
Table line_shift(const LineShiftOptions& options);

} // namespace meniscus
