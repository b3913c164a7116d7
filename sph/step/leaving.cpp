#include "leaving.hpp"

#include <algorithm>

namespace meniscus {

bool is_in_domain(const Place& place, const Domain& domain, int dimension) {
    for (int axis = 0; axis < dimension; ++axis)
        if (!(place[axis] >= domain[0][axis] && place[axis] <= domain[1][axis]))
            return false;
    return true;
}

std::size_t max_removed(Leaving leaving, std::size_t first_count) {
    switch (leaving) {
    case Leaving::stop:
        return 0;
    case Leaving::remove:
        return first_count - 1;
    default:
        return std::max<std::size_t>(first_count / 100, 1);
    }
}

void remove_outside(const Domain& domain, int dimension, SimulationState& state) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
        if (!is_in_domain(state.positions[i], domain, dimension))
            continue;
        if (kept != i) {
            state.ids[kept] = state.ids[i];
            state.positions[kept] = state.positions[i];
            state.velocities[kept] = state.velocities[i];
            state.pressures[kept] = state.pressures[i];
            state.divergences[kept] = state.divergences[i];
        }
        ++kept;
    }
    state.ids.resize(kept);
    state.positions.resize(kept);
    state.velocities.resize(kept);
    state.pressures.resize(kept);
    state.divergences.resize(kept);
}

} // namespace meniscus
