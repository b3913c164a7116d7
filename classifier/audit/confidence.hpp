// How far false-negative rates on a few snapshots can be trusted for snapshots not seen. Particles
// of one snapshot are neighbors of each other and fail together, so snapshots are what counts as
// independent. Both bounds are one-sided, hold for every number of snapshots and every distribution
// of rates, and agree where nothing was missed: 1 - 0.05^(1/n), about 3/n. docs/training.md derives
// them.
#pragma once

#include <cstddef>
#include <vector>

namespace meniscus {

/// Upper bound, at the given confidence in (0, 1), of the probability that a snapshot has a false
/// negative at all, when `with_misses` of `snapshots` have one (Clopper and Pearson 1934). 1 where
/// there are no snapshots.
double upper_bound_of_probability(std::size_t with_misses, std::size_t snapshots,
                                  double confidence);

/// Upper bound, at the given confidence in (0, 1), of the expected false-negative rate of a
/// snapshot, from the rates r_i in [0, 1] of n independent ones:
/// 1 - ((1 - confidence) prod_i (1 - r_i))^(1/n). 1 where there are none.
double upper_bound_of_mean_rate(const std::vector<double>& rates, double confidence);

} // namespace meniscus
