// Counts uncovered directions, as many at a time as the instruction set has lanes of float. Every
// lane does the same products and sums in the same order whatever the width, and contraction is
// off, so the counts agree on all machines.
#include "detail/coverage_kernel.hpp"

#include <meniscus/runtime/simd/begin_kernel.hpp>

#include <meniscus/runtime/simd/vector.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

struct WideDirections {
    WideFloat x, y, z;
};

MENISCUS_INLINE WideFloat product(const WideDirections& a, const WideDirections& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

enum class BlockState { inside_a_cap, outside_all_caps, to_be_tested };

/// The caps that meet a block, by their place.
struct NearCaps {
    std::uint32_t* places;
    std::size_t count;
};

/// Tells whether one cap holds the whole block, and collects the caps that meet it.
MENISCUS_INLINE BlockState compare_block(const Direction& center, const Caps& caps,
                                         NearCaps& near) {
    const WideDirections middle{all_lanes<WideFloat>(static_cast<float>(center[0])),
                                all_lanes<WideFloat>(static_cast<float>(center[1])),
                                all_lanes<WideFloat>(static_cast<float>(center[2]))};
    for (std::size_t n = 0; n < caps.x.size(); n += wide_float_count) {
        const WideDirections cap{load<WideFloat>(&caps.x[n]), load<WideFloat>(&caps.y[n]),
                                 load<WideFloat>(&caps.z[n])};
        const WideFloat along = product(middle, cap);
        if (bits_below(load<WideFloat>(&caps.inner[n]), along) != 0)
            return BlockState::inside_a_cap;
        unsigned bits = bits_below(load<WideFloat>(&caps.outer[n]), along);
        for (; bits != 0; bits &= bits - 1)
            near.places[near.count++] =
                static_cast<std::uint32_t>(n) + static_cast<std::uint32_t>(__builtin_ctz(bits));
    }
    return near.count == 0 ? BlockState::outside_all_caps : BlockState::to_be_tested;
}

/// What float cannot decide: the definition in double.
inline bool is_covered(const Direction& p, const Caps& caps) {
    for (std::size_t n = 0; n < caps.sorted.size(); ++n) {
        const Direction& x = caps.sorted[n];
        if (p[0] * x[0] + p[1] * x[1] + p[2] * x[2] > caps.threshold_double[n])
            return true;
    }
    return false;
}

/// Uncovered ones among the directions from `begin`, at most one vector of them.
MENISCUS_INLINE std::size_t count_in_vector(const DirectionBlocks& blocks, std::size_t begin,
                                            std::size_t count, const Caps& caps,
                                            const NearCaps& near) {
    constexpr auto error = static_cast<float>(kernel_float_error);
    constexpr unsigned all = (1U << wide_float_count) - 1;
    const unsigned past_the_end = count < wide_float_count ? all & (all << count) : 0;
    const WideDirections direction{load<WideFloat>(&blocks.x[begin]),
                                   load<WideFloat>(&blocks.y[begin]),
                                   load<WideFloat>(&blocks.z[begin])};
    WideFloat highest = all_lanes<WideFloat>(-4); // product above a cap's threshold
    unsigned covered = past_the_end;
    for (std::size_t n = 0; n < near.count; ++n) {
        const std::uint32_t place = near.places[n];
        const WideDirections cap{all_lanes<WideFloat>(caps.x[place]),
                                 all_lanes<WideFloat>(caps.y[place]),
                                 all_lanes<WideFloat>(caps.z[place])};
        highest = larger(highest, product(direction, cap) - caps.threshold[place]);
        covered = bits_below(all_lanes<WideFloat>(error), highest) | past_the_end;
        if (covered == all)
            return 0;
    }
    unsigned doubtful = bits_below(all_lanes<WideFloat>(-error), highest) & ~covered;
    std::size_t uncovered =
        wide_float_count - static_cast<std::size_t>(__builtin_popcount(covered | doubtful));
    for (; doubtful != 0; doubtful &= doubtful - 1)
        uncovered +=
            is_covered(blocks.directions[begin + static_cast<std::size_t>(__builtin_ctz(doubtful))],
                       caps)
                ? 0
                : 1;
    return uncovered;
}

} // namespace MENISCUS_INSTRUCTION_SET

std::size_t count_uncovered_by_kernel(MENISCUS_KERNEL_SET, const DirectionBlocks& blocks,
                                      const Caps& caps, std::uint32_t* near_places) {
    std::size_t uncovered = 0;
    for (std::size_t b = 0; b < blocks.centers.size(); ++b) {
        const std::size_t begin = b * DirectionBlocks::block_size;
        const std::size_t end = std::min(begin + DirectionBlocks::block_size, blocks.size());
        NearCaps near{near_places, 0};
        const BlockState state = compare_block(blocks.centers[b], caps, near);
        if (state == BlockState::outside_all_caps)
            uncovered += end - begin;
        if (state == BlockState::to_be_tested)
            for (std::size_t k = begin; k < end; k += wide_float_count)
                uncovered +=
                    count_in_vector(blocks, k, std::min(wide_float_count, end - k), caps, near);
    }
    return uncovered;
}

} // namespace meniscus

#include <meniscus/runtime/simd/end_kernel.hpp>
