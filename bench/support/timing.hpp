// Times of what is compared: repeated runs of all methods, interleaved, so that a busy moment of
// the machine meets them all alike; medians with quartiles. All times of bench/ are measured here,
// but for those that a simulation takes of its own stages.
#pragma once

#include "table.hpp"

#include <functional>
#include <map>

namespace meniscus {

/// One thing to be timed.
struct Timed {
    std::function<void()> run;
    bool is_slow = false;  ///< three repetitions in place of the usual number
    std::string name = {}; ///< for those that are told apart by names
};

struct TimingOptions {
    int repetitions = 9;
    double min_time = 0.02; ///< s; a repetition runs as often as it takes to last so long
};

/// Wall time of one run of each, in s.
std::vector<RepeatedTime> measure(const std::vector<Timed>& all, const TimingOptions& options);

/// Seconds for so many particles, in `unit`s (s) for one.
RepeatedTime per_particle(const RepeatedTime& seconds, double unit, std::size_t particles);

/// Medians by name, in s.
using Medians = std::map<std::string, double>;
Medians measure_by_name(const std::vector<Timed>& all, const TimingOptions& options);

/// One named time over another.
struct Ratio {
    std::string what;
    std::string over;
    std::string under;
};

/// Columns: what, ratio of medians ("over / under"), value. All times that are named must be there.
Table ratios_of(const Medians& medians, const std::vector<Ratio>& ratios);

/// What the figures belong to: {"processor", "cores", "caches", "compiler", "build",
/// "vectors_of_labels"}.
nlohmann::json machine();

} // namespace meniscus
