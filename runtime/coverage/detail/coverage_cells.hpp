// Most particles need no arc to tell whether they are covered. 128 directions stand for cells of
// the sphere: all that is closer to one than the covering radius of the set. A cap that holds a
// direction with that much to spare holds the whole cell; where every cell is held, the particle is
// surely covered. Where all caps miss a direction, it is surely uncovered. Directions are tested in
// float, and margins far wider than its rounding make both answers certain. The rest is for
// exact_coverage.hpp, which then need only look at the caps that meet a cell not held.
#pragma once

#include "../../math/angles.hpp"
#include "covering_caps.hpp"

#include <array>
#include <cstdint>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// `Count` directions evenly spread over the sphere. One serves all callers.
template <std::size_t Count>
struct CellDirections {
    static_assert(Count == 128 || Count == 512);
    static constexpr std::size_t count = Count;
    /// The farthest that any point of the sphere is from the nearest direction, rad, rounded up (a
    /// test computes it).
    static constexpr double covering_radius = Count == 128 ? 0.2336 : 0.1168;

    std::array<float, count> x, y, z;
    std::array<double, 2> cos_sin_radius; ///< cosine and sine of the covering radius

    /// A Fibonacci lattice, set back from the poles so that they are covered as well as the rest.
    CellDirections() : cos_sin_radius(cosine_and_sine_of_turn(covering_radius / (2 * pi))) {
        const double golden_turn = (3 - std::sqrt(5.0)) / 2;
        for (std::size_t k = 0; k < count; ++k) {
            const double height = 1 - 2 * (static_cast<double>(k) + 0.33) / (count - 0.34);
            const double radius = std::sqrt(1 - height * height);
            const double turns = golden_turn * static_cast<double>(k);
            const auto [cosine, sine] = cosine_and_sine_of_turn(turns - std::floor(turns));
            x[k] = static_cast<float>(radius * cosine);
            y[k] = static_cast<float>(radius * sine);
            z[k] = static_cast<float>(height);
        }
    }
};

using CoverageCells = CellDirections<128>;

/// What the cells tell of a particle.
enum class Settled { covered, uncovered, undecided };

/// Caps as cells are tested against them, in float, padded to whole chunks with caps that hold
/// nothing. Reused from particle to particle.
struct CellTests {
    static constexpr std::size_t chunk = 16;

    std::vector<float> x, y, z;
    std::vector<float> holds_cell;     ///< product of direction and middle beyond which it does
    std::vector<float> misses;         ///< below which the cap misses the direction
    std::vector<float> meets_cell;     ///< beyond which the cap meets the cell
    std::vector<std::int32_t> is_near; ///< not 0 for caps that meet a cell not held

    /// Room for so many caps.
    void reserve(std::size_t capacity) {
        for (auto* values : {&x, &y, &z, &holds_cell, &misses, &meets_cell})
            values->reserve(capacity + chunk);
        is_near.reserve(capacity + chunk);
    }
};

namespace coverage_cells {

/// Far above the error of a float product of unit vectors, about 4e-7.
inline constexpr double float_error = 1e-6;

/// What lies around a direction that all caps miss by this angle is 1.2e-9 of the sphere, above the
/// bound of exact_coverage.hpp.
inline constexpr double missing_margin = 7e-5;

MENISCUS_INLINE void prepare(const CoverageCells& cells, const CoveringCaps& caps,
                             CellTests& tests) {
    const auto [cos_reach, sin_reach] = cells.cos_sin_radius;
    const std::size_t count = caps.size();
    const std::size_t padded = (count + CellTests::chunk - 1) / CellTests::chunk * CellTests::chunk;
    for (auto* values : {&tests.x, &tests.y, &tests.z})
        values->assign(padded, 0);
    for (auto* values : {&tests.holds_cell, &tests.misses, &tests.meets_cell})
        values->assign(padded, 2);
    tests.is_near.assign(padded, 0);
    for (std::size_t n = 0; n < count; ++n) {
        const double cosine = caps.cosine[n];
        const double sine = caps.sine[n];
        const double holds = cosine * cos_reach + sine * sin_reach + float_error;
        tests.x[n] = static_cast<float>(caps.x[n]);
        tests.y[n] = static_cast<float>(caps.y[n]);
        tests.z[n] = static_cast<float>(caps.z[n]);
        tests.holds_cell[n] = cosine < cos_reach ? static_cast<float>(holds) : 2.0F;
        tests.misses[n] = static_cast<float>(cosine - missing_margin * sine - float_error);
        tests.meets_cell[n] =
            static_cast<float>(cosine * cos_reach - sine * sin_reach - float_error);
    }
}

/// Product of direction k with the middle of cap n.
MENISCUS_INLINE float product(const CoverageCells& cells, std::size_t k, const CellTests& tests,
                              std::size_t n) {
    return cells.x[k] * tests.x[n] + cells.y[k] * tests.y[n] + cells.z[k] * tests.z[n];
}

/// True where one of a chunk of caps holds cell k.
MENISCUS_INLINE bool holds(const CoverageCells& cells, std::size_t k, const CellTests& tests,
                           std::size_t begin) {
    std::int32_t any = 0;
    for (std::size_t n = begin; n < begin + CellTests::chunk; ++n)
        any |= product(cells, k, tests, n) > tests.holds_cell[n] ? -1 : 0;
    return any != 0;
}

/// Marks the caps that meet cell k; true where all miss its direction.
MENISCUS_INLINE bool mark_open_cell(const CoverageCells& cells, std::size_t k, CellTests& tests) {
    std::int32_t any = 0;
    for (std::size_t n = 0; n < tests.x.size(); ++n) {
        const float along = product(cells, k, tests, n);
        tests.is_near[n] |= along > tests.meets_cell[n] ? -1 : 0;
        any |= along > tests.misses[n] ? -1 : 0;
    }
    return any == 0;
}

} // namespace coverage_cells

/// Settles what cells can tell. Where the particle is not covered, tests.is_near says which caps
/// the boundary of the uncovered part can belong to, unless `to_the_end` is false: then it ends
/// with the first direction that is uncovered.
MENISCUS_INLINE Settled settle(const CoverageCells& cells, const CoveringCaps& caps,
                               CellTests& tests, bool to_the_end) {
    using namespace coverage_cells;
    prepare(cells, caps, tests);
    const std::size_t padded = tests.x.size();
    Settled settled = Settled::covered;
    std::size_t begin = 0; // the chunk that held the last cell often holds the next one too
    for (std::size_t k = 0; k < CoverageCells::count; ++k) {
        bool held = false;
        for (std::size_t looked = 0; looked < padded && !held; looked += CellTests::chunk) {
            held = holds(cells, k, tests, begin);
            if (!held)
                begin = begin + CellTests::chunk == padded ? 0 : begin + CellTests::chunk;
        }
        if (held)
            continue;
        if (mark_open_cell(cells, k, tests))
            settled = Settled::uncovered;
        else if (settled == Settled::covered)
            settled = Settled::undecided;
        if (settled == Settled::uncovered && !to_the_end)
            break;
    }
    return settled;
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
