#include "divergence.hpp"

#include <meniscus/data/text/text.hpp>

#include <cmath>
#include <limits>

namespace meniscus {
namespace {

std::string diverged_when(const SimulationState& state) {
    return "the simulation diverged at " + rounded_text(state.time, 6) + " s (step " +
           std::to_string(state.steps) + "): ";
}

} // namespace

void report_leap(std::uint32_t particle, double moved, const SimulationState& state) {
    throw Divergence(diverged_when(state) + "particle " + std::to_string(particle) + " moved " +
                     rounded_text(moved, 3) + " support radii in one step of " +
                     rounded_text(state.time_step, 3) +
                     " s, in which it could pass walls and others unseen; take a smaller "
                     "\"time_step\" (\"fixed\", or \"min\" where that holds it up)");
}

void report_divergence(std::uint32_t particle, const Place& place, const SimulationState& state,
                       double density_error, const DensePlace& densest) {
    constexpr double dense = 2; // no pressure solve leaves as much
    const std::string when = diverged_when(state);
    const std::string advice =
        densest.density > dense
            ? "; before this step the fluid around particle " + std::to_string(densest.particle) +
                  " was " + rounded_text(densest.density, 3) +
                  " times as dense as at rest: particles lie in one another there, so start them "
                  "farther apart"
            : "; try a smaller time step, a larger viscosity or a smaller surface-tension "
              "coefficient";
    if (particle == std::numeric_limits<std::uint32_t>::max())
        throw Divergence(when + "the mean density error is " + rounded_text(density_error, 3) +
                         advice);
    const std::string name = "particle " + std::to_string(particle);
    if (!std::isfinite(place[0] * place[0] + place[1] * place[1] + place[2] * place[2]))
        throw Divergence(when + name + " has a position that is not finite" + advice);
    throw Divergence(when + name + " left the domain at (" + rounded_text(place[0], 6) + ", " +
                     rounded_text(place[1], 6) + ", " + rounded_text(place[2], 6) +
                     ") m; if it may go there, give the scene a larger \"domain\"" + advice);
}

} // namespace meniscus
