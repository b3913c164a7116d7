// What happens to particles that leave the domain of a scene: as many as `leaving` of the scene
// allows are taken out, more are an error of the run (divergence.hpp).
#pragma once

#include "state.hpp"

#include <meniscus/sph/scene/scene.hpp>

#include <array>

namespace meniscus {

/// Two corners of a box, m; a scene in 2D has no bounds along z.
using Domain = std::array<Place, 2>;

/// False for coordinates that are not finite, too.
bool is_in_domain(const Place& place, const Domain& domain, int dimension);

/// How many of so many particles may leave.
std::size_t max_removed(Leaving leaving, std::size_t first_count);

/// Takes the particles that have left out of the state; the others keep their order.
void remove_outside(const Domain& domain, int dimension, SimulationState& state);

} // namespace meniscus
