// Surface detectors side by side on the same states: false negatives and false positives of each,
// against exact labels, beside its time.
#pragma once

#include "detector.hpp"
#include "support/timing.hpp"

namespace meniscus {

/// Columns: detector, group, false_negatives, false_negatives_plain (those with more than 2
/// % of the sphere uncovered, the threshold that the shipped line is trained with), missed_area
/// (percent of the uncovered area of all surface particles), false_positive_rate (percent of all
/// particles, mean over scenes), time (ns a particle, one thread), time_parallel (on `threads`
/// threads, where the method uses them), source, and best, of those with less time (one thread),
/// false negatives and false positives. States must all be of the same dimension; the neighbor
/// lists are given and not part of the time.
Table compare_detectors(const std::vector<FluidState<float>>& states,
                        const std::vector<Detector<float>>& all, int threads,
                        const TimingOptions& timing);

} // namespace meniscus
