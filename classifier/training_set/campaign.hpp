// A training set that need not fit into memory: its states are visited one after the other, as
// often as asked for, and no more of them is kept than what adds up (numbers of particles, a hull,
// counts in bins). Several ranks share the states; what they add up together does not depend on
// how.
#pragma once

#include "labelled_state.hpp"

#include <meniscus/data/ranks/ranks.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

/// What a state says of itself without its particles.
struct StateHead {
    LabelledState state; ///< without particles
    std::size_t particles = 0;
    std::size_t surface = 0; ///< lambda above the label threshold
    std::optional<double> bulk_neighbor_count;
};

/// Gets the place of a state among all, and the state.
using VisitState = std::function<void(std::size_t place, const LabelledState& state)>;

struct Campaign {
    std::vector<StateHead> heads; ///< of all states, on every rank
    /// Calls its argument with each state of this rank, places ascending.
    std::function<void(const VisitState&)> visit;
    /// The states where this process has them all in memory, else null.
    const std::vector<LabelledState>* in_memory = nullptr;
    Ranks* ranks = &one_process();

    /// The heads as states, for what looks at no particle.
    [[nodiscard]] std::vector<LabelledState> states() const;
};

/// Of states in memory, which must outlive it.
Campaign campaign_of(const std::vector<LabelledState>& states, double label_threshold);

/// Of files, which are read anew at every visit, each rank its own: the largest go to those that
/// have least. Throws as read_labelled_state does, on all ranks alike.
Campaign campaign_of(const std::vector<std::filesystem::path>& files, const std::string& scene,
                     const FeaturePair& features, double label_threshold, Ranks& ranks);

} // namespace meniscus
