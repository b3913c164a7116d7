// A slab of a state with the particles around it: what they take over from the whole, so that each
// finds the same neighbors in the same order.
#pragma once

#include <meniscus/data/particles/grid_layout.hpp>

#include <cstdint>
#include <vector>

namespace meniscus {

struct PartOfState {
    GridLayout layout;                  ///< of the whole state
    std::vector<std::uint8_t> own;      ///< 0: is there for its neighbors alone
    std::vector<std::uint64_t> numbers; ///< of the particles in the whole, ascending
    bool is_first = false;              ///< of the state's slabs
};

} // namespace meniscus
