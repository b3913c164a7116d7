// The support radii of a set of particles: one for all, or one for each. Where they vary, a pair is
// measured in the mean of its two (runtime/neighbors/support_radius.hpp says why).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meniscus {

struct SupportRadii {
    double min;               ///< m
    double max;               ///< m; the radius where one serves all
    std::vector<double> each; ///< m, one a particle; empty where one serves all

    /// One for all. Not explicit, since a single number is what most states have.
    SupportRadii(double radius) : min(radius), max(radius) {}

    /// One a particle; where those whose `valid` is not 0 (empty: all) have the same, it serves
    /// all. Nothing is checked: the neighbor search does, and names the particle.
    explicit SupportRadii(std::vector<double> radii, const std::vector<std::uint8_t>& valid = {});

    [[nodiscard]] bool vary() const { return !each.empty(); }
    [[nodiscard]] double of(std::size_t particle) const { return vary() ? each[particle] : max; }
};

} // namespace meniscus
