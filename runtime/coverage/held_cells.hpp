// A quick proof that a particle is covered: every cell of the sphere (coverage_cells.hpp) is held
// by one cap. It comes after sampling and uses what sampling has at hand, caps in float, tested
// against many directions at a time. What 128 cells leave open, 512 smaller ones mostly settle; the
// few particles that remain are for the exact test.
#pragma once

#include "detail/coverage_cells.hpp"
#include "sampled_coverage.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// One serves all callers.
struct HeldCells {
    CellDirections<128> coarse;
    CellDirections<512> fine;
};

namespace held_cells {

/// Changes the limits of caps to those beyond which a direction's whole cell is held; never, where
/// the cap is smaller than a cell. With a margin far above float rounding.
template <std::size_t Count>
void hold_limits(const CellDirections<Count>& cells, const SampledCaps& caps,
                 std::vector<float>& limits) {
    const auto cosine = static_cast<float>(cells.cos_sin_radius[0]);
    const auto sine = static_cast<float>(cells.cos_sin_radius[1]);
    limits.resize(caps.x.size());
    for (std::size_t n = 0; n < caps.count; n += wide_float_count) {
        const WideFloat x = load<WideFloat>(&caps.x[n]);
        const WideFloat y = load<WideFloat>(&caps.y[n]);
        const WideFloat z = load<WideFloat>(&caps.z[n]);
        const WideFloat limit = load<WideFloat>(&caps.limit[n]);
        const WideFloat squared = x * x + y * y + z * z;
        const WideFloat aside = square_root(larger(squared - limit * limit, WideFloat{}));
        const WideFloat holds =
            limit * cosine + aside * sine + static_cast<float>(coverage_cells::float_error);
        const WideFloat never = WideFloat{} + 4;
        store(limit * sine < aside * cosine ? holds : never, &limits[n]);
    }
}

template <std::size_t Count>
MENISCUS_INLINE bool are_held(const CellDirections<Count>& cells, const SampledCaps& caps,
                              std::vector<float>& limits) {
    using namespace sampled_coverage;
    hold_limits(cells, caps, limits);
    for (std::size_t k = 0; k < Count; k += samples_at_once)
        if (!SampleVectors<3>(&cells.x[k], &cells.y[k], &cells.z[k])
                 .are_covered(caps, limits.data()))
            return false;
    return true;
}

} // namespace held_cells

/// True where the particle is surely covered. `limits` is working memory.
inline bool is_surely_covered(const HeldCells& cells, const SampledCaps& caps,
                              std::vector<float>& limits) {
    return held_cells::are_held(cells.coarse, caps, limits) ||
           held_cells::are_held(cells.fine, caps, limits);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
