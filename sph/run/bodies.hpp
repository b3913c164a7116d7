// The connected bodies of a fluid: particles are of one body where a chain of neighbors, each
// closer than the support radius to the next, leads from one to the other. A droplet has come loose
// where it is a body of its own.
#pragma once

#include <meniscus/sph/scene/scene.hpp>

#include <cstddef>

namespace meniscus {

/// All bodies, and the one of most particles (of equal ones that of the first particle).
struct Bodies {
    std::size_t count = 0;
    std::size_t largest = 0; ///< particles
    double radius = 0;       ///< farthest particle from the center of mass, m
    /// Root of the largest over the smallest second moment about the center of mass, in two
    /// dimensions of those in the plane; 0 where the smallest is.
    double aspect = 0;
    double top = 0; ///< highest particle, y in m
};

/// Throws as find_neighbors() does (data/particles/neighbor_search.hpp).
Bodies find_bodies(const Positions& positions, double support_radius, int dimension);

} // namespace meniscus
