// Times of what is compared: repeated runs of all methods, interleaved, so that a busy moment of
// the machine meets them all alike; medians with quartiles.
#pragma once

#include "comparison/table.hpp"

#include <functional>

namespace meniscus {

/// One thing to be timed.
struct Timed {
    std::function<void()> run;
    bool is_slow = false; ///< three repetitions in place of the usual number
};

struct TimingOptions {
    int repetitions = 9;
    double least_time = 0.02; ///< s; a repetition runs as often as it takes to last so long
};

/// Wall time of one run of each, in s.
std::vector<RepeatedTime> measure(const std::vector<Timed>& all, const TimingOptions& options);

/// What the figures belong to: {"processor", "cores", "caches", "compiler", "build",
/// "vectors_of_labels"}.
nlohmann::json machine();

} // namespace meniscus
