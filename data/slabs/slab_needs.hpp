// What work on a slab of a state needs: particles around it, and memory.
#pragma once

#include <cstdint>

namespace meniscus {

struct SlabNeeds {
    int halo_layers = 1;              ///< layers of cells of the support radius on either side
    std::uint64_t particle_bytes = 0; ///< of memory for each particle, halo included
    std::uint64_t cell_bytes = 0;     ///< for each cell of the neighbor search
};

} // namespace meniscus
