// Particles in cells of the size of the support radius, numbered along x first: the neighbors of a
// particle lie in at most nine (in 2D three) runs of three cells, each of which is one stretch of
// the sorted particles, so that eight candidates at a time are read and compared without a jump.
// Lengths are in support radii.
#pragma once

#include "rows.hpp"

#include <meniscus/runtime/neighbors/parallel_loop.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Where cells lie. Larger than a support radius where particles are so scattered that the table of
/// cells would outgrow them.
template <class Real>
struct CellLayout {
    std::array<Real, 3> low{};
    Real inverse_size = 1;
    std::array<std::int32_t, 3> count{1, 1, 1};

    [[nodiscard]] std::size_t cells() const {
        return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) *
               static_cast<std::size_t>(count[2]);
    }
    [[nodiscard]] std::int32_t along(int axis, Real coordinate) const {
        const Real cell = (coordinate - low[axis]) * inverse_size;
        // Clamped before it becomes an integer: what is searched around may lie outside.
        return static_cast<std::int32_t>(
            std::min(std::max(cell, Real(0)), static_cast<Real>(count[axis] - 1)));
    }
    [[nodiscard]] std::size_t index(std::int32_t x, std::int32_t y, std::int32_t z) const {
        return static_cast<std::size_t>(x) +
               static_cast<std::size_t>(count[0]) *
                   (static_cast<std::size_t>(y) +
                    static_cast<std::size_t>(count[1]) * static_cast<std::size_t>(z));
    }
    [[nodiscard]] std::size_t cell_of(const Row<Real>& place) const {
        return index(along(0, place.x), along(1, place.y), along(2, place.z));
    }
};

/// Of what one worker saw; apart from those of others.
template <class Real>
struct alignas(64) WorkerBounds {
    static constexpr Real infinity = std::numeric_limits<Real>::infinity();
    std::array<Real, 3> low{infinity, infinity, infinity};
    std::array<Real, 3> high{-infinity, -infinity, -infinity};
};

/// The box around the places of particles [0, count), and a table of at most 4 cells a particle.
template <class Real, class Loop>
CellLayout<Real> lay_out_cells(const Row<Real>* places, std::size_t count, const Loop& loop) {
    std::vector<WorkerBounds<Real>> bounds(static_cast<std::size_t>(loop.workers()));
    loop(count, [&](std::size_t begin, std::size_t end, int worker) {
        WorkerBounds<Real>& all = bounds[static_cast<std::size_t>(worker)];
        for (std::size_t i = begin; i < end; ++i) {
            const std::array<Real, 3> place = {places[i].x, places[i].y, places[i].z};
            for (int axis = 0; axis < 3; ++axis) {
                all.low[axis] = std::min(all.low[axis], place[axis]);
                all.high[axis] = std::max(all.high[axis], place[axis]);
            }
        }
    });
    for (const WorkerBounds<Real>& one : bounds)
        for (int axis = 0; axis < 3; ++axis) {
            bounds[0].low[axis] = std::min(bounds[0].low[axis], one.low[axis]);
            bounds[0].high[axis] = std::max(bounds[0].high[axis], one.high[axis]);
        }
    CellLayout<Real> layout;
    if (count == 0)
        return layout;
    layout.low = bounds[0].low;
    const double max_cells = 4.0 * static_cast<double>(count) + 64;
    // A little more than a radius, so that rounding puts no two neighbors two cells apart.
    for (double size = 1.0001;; size *= 1.25) {
        double cells = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const double extent = static_cast<double>(bounds[0].high[axis]) -
                                  static_cast<double>(bounds[0].low[axis]);
            const double along = std::floor(extent / size) + 1;
            cells *= along;
            layout.count[axis] = static_cast<std::int32_t>(std::min(along, 1e9));
        }
        layout.inverse_size = static_cast<Real>(1 / size);
        if (cells <= max_cells)
            return layout;
    }
}

/// Sorted particles by cell: those of cell c are start[c] to start[c + 1] - 1. Coordinates lie
/// apart and are followed by eight of which none is near, to be read beyond the end.
template <class Real>
struct Cells {
    CellLayout<Real> layout;
    std::vector<std::uint32_t> start;
    std::vector<Real> x, y, z;

    void take_coordinates(const Row<Real>* places, std::size_t count) {
        for (auto* values : {&x, &y, &z})
            values->resize(count + lane_count);
        for (std::size_t i = 0; i < count; ++i) {
            x[i] = places[i].x;
            y[i] = places[i].y;
            z[i] = places[i].z;
        }
        for (auto* values : {&x, &y, &z})
            std::fill(values->begin() + static_cast<std::ptrdiff_t>(count), values->end(), Real(0));
    }
};

/// Counting sort: fills `order` with the particles cell by cell, within a cell in the order that
/// they came in, and `cells.start`.
template <class Real, class Loop>
void sort_into_cells(const Row<Real>* places, std::size_t count, const Loop& loop,
                     std::vector<std::uint32_t>& cell_of, Cells<Real>& cells,
                     std::vector<std::uint32_t>& order) {
    cells.layout = lay_out_cells(places, count, loop);
    cell_of.resize(count);
    loop(count, [&](std::size_t begin, std::size_t end, int /*worker*/) {
        for (std::size_t i = begin; i < end; ++i)
            cell_of[i] = static_cast<std::uint32_t>(cells.layout.cell_of(places[i]));
    });
    cells.start.assign(cells.layout.cells() + 2, 0);
    // One entry ahead: what counts first becomes where to write next, and ends as the start.
    for (std::size_t i = 0; i < count; ++i)
        ++cells.start[cell_of[i] + 2];
    for (std::size_t c = 2; c < cells.start.size(); ++c)
        cells.start[c] += cells.start[c - 1];
    order.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        order[cells.start[cell_of[i] + 1]++] = static_cast<std::uint32_t>(i);
    cells.start.pop_back();
}

namespace cells_of {

/// For each set of lanes their numbers, first to last.
struct LaneTable {
    alignas(32) std::uint32_t lanes[256][lane_count];
    constexpr LaneTable() : lanes{} {
        for (unsigned bits = 0; bits < 256; ++bits) {
            int found = 0;
            for (unsigned lane = 0; lane < lane_count; ++lane)
                if ((bits >> lane & 1U) != 0)
                    lanes[bits][found++] = lane;
        }
    }
};
inline constexpr LaneTable lane_table{};

/// Appends first + each set lane; writes eight entries whatever their number.
MENISCUS_INLINE std::uint32_t* append(unsigned bits, std::uint32_t first, std::uint32_t* to) {
    using Words = std::uint32_t __attribute__((vector_size(32)));
    Words found;
    std::memcpy(&found, lane_table.lanes[bits], sizeof found);
    found += first;
    std::memcpy(to, &found, sizeof found);
    return to + __builtin_popcount(bits);
}

} // namespace cells_of

/// For each cell whether there is a particle in it or next to it.
template <class Real>
std::vector<std::uint8_t> occupied_surroundings(const Cells<Real>& cells) {
    const auto& layout = cells.layout;
    const auto [nx, ny, nz] = layout.count;
    std::vector<std::uint8_t> occupied(layout.cells(), 0);
    for (std::int32_t z = 0; z < nz; ++z)
        for (std::int32_t y = 0; y < ny; ++y)
            for (std::int32_t x = 0; x < nx; ++x)
                for (std::int32_t c = std::max(z - 1, 0); c <= std::min(z + 1, nz - 1); ++c)
                    for (std::int32_t b = std::max(y - 1, 0); b <= std::min(y + 1, ny - 1); ++b)
                        if (cells.start[layout.index(std::max(x - 1, 0), b, c)] !=
                            cells.start[layout.index(std::min(x + 1, nx - 1), b, c) + 1])
                            occupied[layout.index(x, y, z)] = 1;
    return occupied;
}

/// Neighbors one after another, with room to write beyond the last.
struct IndexBuffer {
    std::vector<std::uint32_t> values;
    std::size_t size = 0;

    void clear() { size = 0; }
    /// Where to write at most so many, and eight more.
    std::uint32_t* room(std::size_t max) {
        if (values.size() < size + max + lane_count)
            values.resize(2 * (size + max + lane_count));
        return values.data() + size;
    }
};

/// Appends the sorted particles closer than 1 to a place, but `self`, in their order.
template <class Real, int Dimension>
void find_around(const Cells<Real>& cells, const Row<Real>& place, std::uint32_t self,
                 IndexBuffer& found) {
    const auto& layout = cells.layout;
    const std::int32_t cx = layout.along(0, place.x);
    const std::int32_t cy = layout.along(1, place.y);
    const std::int32_t cz = layout.along(2, place.z);
    const std::int32_t x_first = std::max(cx - 1, 0);
    const std::int32_t x_last = std::min(cx + 1, layout.count[0] - 1);
    for (std::int32_t z = std::max(cz - 1, 0); z <= std::min(cz + 1, layout.count[2] - 1); ++z)
        for (std::int32_t y = std::max(cy - 1, 0); y <= std::min(cy + 1, layout.count[1] - 1);
             ++y) {
            const std::uint32_t begin = cells.start[layout.index(x_first, y, z)];
            const std::uint32_t end = cells.start[layout.index(x_last, y, z) + 1];
            std::uint32_t* to = found.room(end - begin);
            for (std::uint32_t j = begin; j < end; j += lane_count) {
                const Lanes<Real> dx = load<Lanes<Real>>(&cells.x[j]) - place.x;
                const Lanes<Real> dy = load<Lanes<Real>>(&cells.y[j]) - place.y;
                Lanes<Real> squared = dx * dx + dy * dy;
                if constexpr (Dimension == 3) {
                    const Lanes<Real> dz = load<Lanes<Real>>(&cells.z[j]) - place.z;
                    squared += dz * dz;
                }
                unsigned bits = bits_below(squared, all_lanes<Lanes<Real>>(1));
                bits &= end - j < lane_count ? (1U << (end - j)) - 1 : 255U;
                bits &= self - j < lane_count ? ~(1U << (self - j)) : ~0U;
                to = cells_of::append(bits, j, to);
            }
            found.size = static_cast<std::size_t>(to - found.values.data());
        }
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
