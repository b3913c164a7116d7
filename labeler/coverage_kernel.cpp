// Highway compiles this file once for each instruction set, includes it for that into itself, and
// picks the best one at run time. Every lane does the same products and sums in the same order
// whatever the width, and contraction is off, so the counts agree on all machines.
#include "coverage_kernel.hpp"

#include "coverage.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "coverage_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace meniscus {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<float, kernel_lanes>;
using Vector = hn::Vec<Lanes>;

struct Vectors {
    Vector x, y, z;
};

HWY_INLINE Vector product(const Vectors& a, const Vectors& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

enum class BlockState { inside_a_cap, outside_all_caps, to_be_tested };

/// The caps that meet a block, by their place.
struct NearCaps {
    std::uint32_t* places;
    std::size_t count = 0;
};

/// Tells whether one cap holds the whole block, and collects the caps that meet it.
HWY_INLINE BlockState compare_block(const Direction& center, const Caps& caps, NearCaps& near) {
    const Lanes lanes;
    const Vectors middle{hn::Set(lanes, static_cast<float>(center[0])),
                         hn::Set(lanes, static_cast<float>(center[1])),
                         hn::Set(lanes, static_cast<float>(center[2]))};
    for (std::size_t n = 0; n < caps.x.size(); n += hn::Lanes(lanes)) {
        const Vectors cap{hn::LoadU(lanes, &caps.x[n]), hn::LoadU(lanes, &caps.y[n]),
                          hn::LoadU(lanes, &caps.z[n])};
        const Vector along = product(middle, cap);
        if (!hn::AllFalse(lanes, hn::Gt(along, hn::LoadU(lanes, &caps.inner[n]))))
            return BlockState::inside_a_cap;
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(lanes, hn::Gt(along, hn::LoadU(lanes, &caps.outer[n])), bytes);
        unsigned bits = bytes[0] | (static_cast<unsigned>(bytes[1]) << 8);
        for (; bits != 0; bits &= bits - 1)
            near.places[near.count++] =
                static_cast<std::uint32_t>(n) + static_cast<std::uint32_t>(__builtin_ctz(bits));
    }
    return near.count == 0 ? BlockState::outside_all_caps : BlockState::to_be_tested;
}

/// What float cannot decide: the definition in double.
bool is_covered(const Direction& p, const Caps& caps) {
    for (std::size_t n = 0; n < caps.sorted.size(); ++n) {
        const Direction& x = caps.sorted[n];
        if (p[0] * x[0] + p[1] * x[1] + p[2] * x[2] > caps.threshold_double[n])
            return true;
    }
    return false;
}

/// Uncovered ones among the directions from `begin`, at most one vector of them.
HWY_INLINE std::size_t count_in_vector(const DirectionBlocks& blocks, std::size_t begin,
                                       std::size_t count, const Caps& caps, const NearCaps& near) {
    const Lanes lanes;
    const Vectors direction{hn::LoadU(lanes, &blocks.x[begin]), hn::LoadU(lanes, &blocks.y[begin]),
                            hn::LoadU(lanes, &blocks.z[begin])};
    const Vector error = hn::Set(lanes, static_cast<float>(kernel_float_error));
    auto covered = hn::Not(hn::FirstN(lanes, count));
    auto undecided = hn::FirstN(lanes, 0);
    for (std::size_t n = 0; n < near.count; ++n) {
        const std::uint32_t place = near.places[n];
        const Vectors cap{hn::Set(lanes, caps.x[place]), hn::Set(lanes, caps.y[place]),
                          hn::Set(lanes, caps.z[place])};
        const Vector above =
            hn::Sub(product(direction, cap), hn::Set(lanes, caps.threshold[place]));
        covered = hn::Or(covered, hn::Gt(above, error));
        undecided = hn::Or(undecided, hn::Gt(above, hn::Neg(error)));
        if (hn::AllTrue(lanes, covered))
            return 0;
    }
    std::size_t uncovered = hn::CountTrue(lanes, hn::Not(hn::Or(covered, undecided)));
    const auto doubtful = hn::AndNot(covered, undecided);
    if (HWY_UNLIKELY(!hn::AllFalse(lanes, doubtful))) {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(lanes, doubtful, bytes);
        unsigned bits = bytes[0] | (static_cast<unsigned>(bytes[1]) << 8);
        for (; bits != 0; bits &= bits - 1)
            uncovered += is_covered(blocks.directions[begin + __builtin_ctz(bits)], caps) ? 0 : 1;
    }
    return uncovered;
}

std::size_t count_uncovered(const DirectionBlocks& blocks, const Caps& caps,
                            std::uint32_t* near_places) {
    const std::size_t step = hn::Lanes(Lanes());
    std::size_t uncovered = 0;
    for (std::size_t b = 0; b < blocks.centers.size(); ++b) {
        const std::size_t begin = b * DirectionBlocks::block_size;
        const std::size_t end = std::min(begin + DirectionBlocks::block_size, blocks.size());
        NearCaps near{near_places};
        const BlockState state = compare_block(blocks.centers[b], caps, near);
        if (state == BlockState::outside_all_caps)
            uncovered += end - begin;
        if (state == BlockState::to_be_tested)
            for (std::size_t k = begin; k < end; k += step)
                uncovered += count_in_vector(blocks, k, std::min(step, end - k), caps, near);
    }
    return uncovered;
}

const char* instruction_set() {
    return hwy::TargetName(HWY_TARGET);
}

} // namespace HWY_NAMESPACE
} // namespace meniscus
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace meniscus {

HWY_EXPORT(count_uncovered);
HWY_EXPORT(instruction_set);

std::size_t run_coverage_kernel(const DirectionBlocks& blocks, const Caps& caps) {
    thread_local std::vector<std::uint32_t> near_places;
    near_places.resize(caps.x.size());
    return HWY_DYNAMIC_DISPATCH(count_uncovered)(blocks, caps, near_places.data());
}

const char* coverage_instruction_set() {
    return HWY_DYNAMIC_DISPATCH(instruction_set)();
}

} // namespace meniscus
#endif
