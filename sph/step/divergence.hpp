// A simulation that diverged, and the messages that say where and what to try.
#pragma once

#include "state.hpp"

#include <stdexcept>

namespace meniscus {

/// The simulation diverged: a value is not finite, density is out of bounds, or a particle left the
/// domain. Names the particle and says what to try.
class Divergence : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A particle and the density around it when the step began, over the rest density.
struct DensePlace {
    std::uint32_t particle = 0;
    double density = 0;
};

/// Throws Divergence for the particle of that id that left the domain or the numbers, or, where no
/// particle did (the largest id there is), for the mean density error. Names the densest place too
/// where particles lie in one another there.
[[noreturn]] void report_divergence(std::uint32_t particle, const Place& place,
                                    const SimulationState& state, double density_error,
                                    const DensePlace& densest);

/// Throws Divergence for the particle of that id that moved so many support radii in one step.
[[noreturn]] void report_leap(std::uint32_t particle, double moved, const SimulationState& state);

} // namespace meniscus
