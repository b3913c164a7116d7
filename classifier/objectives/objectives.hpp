// The list of objectives. They differ in how they find the slope of a line; all end with the shift
// (shift.hpp). A new one is a file and a row.
#pragma once

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/classifier/training_set/campaign.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace meniscus {

struct Objective {
    const char* name;
    const char* meaning; ///< for the help of options
    bool any_features;   ///< not only those of the paper
    /// The line for states of one kind; `seed` is of what draws. Throws InputError where the states
    /// hold no line, FailureError where a fit fails.
    Line (*fit)(const std::vector<LabelledState>& states, double label_threshold,
                std::uint64_t seed);
    /// The same line for a campaign that is not in memory; null where all must be.
    Line (*fit_campaign)(const Campaign& campaign, double label_threshold) = nullptr;
};

const std::vector<Objective>& objectives();

/// Throws InputError, naming all there are, where there is none of that name.
const Objective& objective_named(const std::string& name);

} // namespace meniscus
