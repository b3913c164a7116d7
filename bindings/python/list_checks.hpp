// Neighbor lists that came from Python: does every index point to a particle? A solver in C++ is
// trusted with that, but here a wrong one must not read memory that is not the arrays'.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace meniscus {

/// Lists in compressed rows, with the sizes that their arrays have.
struct ListArrays {
    const void* offsets; ///< rows + 1 of 64 bits or, not wide, of 32
    bool wide;           ///< of the offsets
    std::size_t rows;
    const std::uint32_t* indices;
    std::size_t entries;   ///< of the indices
    std::size_t particles; ///< that indices may name
};

/// Throws InputError, naming the array with the prefix in front and its first wrong entry, where
/// offsets fall or end beyond the indices, or an index is that of no particle.
void check_lists_exist(const ListArrays& lists, const std::string& prefix);

} // namespace meniscus
