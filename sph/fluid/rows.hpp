// The step works on the neighbors of a particle eight at a time, whatever the instruction set:
// eight lanes are one register with AVX2 and two or four with less, and the order in which numbers
// are added up is the same, so that all give the same bits. Particles are stored as rows of four
// numbers, a place or a velocity and one more, which are fetched row by row and turned into lanes.
#pragma once

#include <meniscus/runtime/simd/vector.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// x, y, z (0 in two dimensions) and whatever a loop needs beside them.
template <class Real>
struct alignas(4 * sizeof(Real)) Row {
    Real x = 0, y = 0, z = 0, w = 0;
};

/// Eight rows, turned.
template <class Real>
struct RowLanes {
    Lanes<Real> x, y, z, w;
};

/// The rows at eight places of an array.
template <class Real>
MENISCUS_INLINE RowLanes<Real> gather_rows(const Row<Real>* rows, const std::uint32_t* index) {
    const auto row = [&](std::uint32_t n) { return load<VectorOf<Real, 4>>(&rows[n].x); };
    // Row n beside row n + 4, so that what follows stays within halves of a register.
    const auto beside = [&](int n) {
        return __builtin_shufflevector(row(index[n]), row(index[n + 4]), 0, 1, 2, 3, 4, 5, 6, 7);
    };
    const Lanes<Real> a = beside(0), b = beside(1), c = beside(2), d = beside(3);
    const Lanes<Real> ab_low = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
    const Lanes<Real> cd_low = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
    const Lanes<Real> ab_high = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    const Lanes<Real> cd_high = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    return {__builtin_shufflevector(ab_low, cd_low, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(ab_low, cd_low, 2, 3, 10, 11, 6, 7, 14, 15),
            __builtin_shufflevector(ab_high, cd_high, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(ab_high, cd_high, 2, 3, 10, 11, 6, 7, 14, 15)};
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
