#include "neighbor_search.hpp"

#include "errors.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <omp.h>
#include <string>

namespace meniscus {
namespace {

using Cell = std::array<std::int64_t, 3>;

constexpr std::uint32_t largest_count = std::numeric_limits<std::uint32_t>::max();

// Beyond these the square of the radius, or what it is made of, leaves the range of double.
constexpr double smallest_radius = 1e-150;
constexpr double largest_radius = 1e150;

} // namespace

/// Particles sorted by the bucket that their cell falls into. With few enough cells a bucket is a
/// cell; otherwise distant cells may share one, which costs a distance test and nothing else.
struct NeighborGrid::Cells {
    double radius_squared = 0;
    std::array<double, 3> origin{};
    double inverse_cell_size = 0;
    Cell cells{1, 1, 1}; ///< number of cells along each axis
    bool direct = true;  ///< a bucket is a cell
    std::uint64_t bucket_mask = 0;
    std::vector<std::uint32_t> bucket_start; ///< size: buckets + 1
    std::vector<std::uint32_t> order;        ///< particle at each sorted place
    Positions positions;                     ///< sorted
    std::vector<std::int64_t> phase;         ///< sorted, or empty
};

namespace {

using Grid = NeighborGrid::Cells;

struct SortedRange {
    std::uint32_t begin;
    std::uint32_t end;
};

/// The places to look at for one particle: at most one range for each of the 27 cells.
struct SearchRanges {
    std::array<SortedRange, 27> ranges;
    int count = 0;
};

Cell cell_of(const Grid& grid, const std::array<double, 3>& position) {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis) {
        // Clamped before it becomes an integer: what is searched around may lie far outside.
        const double scaled = (position[axis] - grid.origin[axis]) * grid.inverse_cell_size;
        const auto last = static_cast<double>(grid.cells[axis] - 1);
        cell[axis] = static_cast<std::int64_t>(std::clamp(scaled, 0.0, last));
    }
    return cell;
}

std::uint64_t bucket_of(const Grid& grid, const Cell& cell) {
    const auto x = static_cast<std::uint64_t>(cell[0]);
    const auto y = static_cast<std::uint64_t>(cell[1]);
    const auto z = static_cast<std::uint64_t>(cell[2]);
    if (grid.direct)
        return x + static_cast<std::uint64_t>(grid.cells[0]) *
                       (y + static_cast<std::uint64_t>(grid.cells[1]) * z);
    // Odd multipliers spread the bits; the high half of the product mixes best.
    const std::uint64_t mixed =
        (x * 0x9e3779b97f4a7c15ULL) ^ (y * 0xc2b2ae3d27d4eb4fULL) ^ (z * 0x165667b19e3779f9ULL);
    return (mixed ^ (mixed >> 32)) & grid.bucket_mask;
}

bool is_valid(const NeighborFilter& filter, std::size_t i) {
    return filter.valid == nullptr || (*filter.valid)[i] != 0;
}

void check_input(const Positions& positions, double radius, const NeighborFilter& filter) {
    if (!(radius > 0) || !std::isfinite(radius))
        throw InputError("support radius must be positive and finite, found " +
                         number_text(radius));
    if (radius < smallest_radius || radius > largest_radius)
        throw InputError("support radius must lie between " + number_text(smallest_radius) +
                         " and " + number_text(largest_radius) + " m, found " +
                         number_text(radius) + "; is it in m?");
    if (positions.size() >= largest_count)
        throw InputError("at most 4294967294 particles can be searched, found " +
                         std::to_string(positions.size()));
    for (std::size_t i = 0; i < positions.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            if (is_valid(filter, i) && !std::isfinite(positions[i][axis]))
                throw InputError("particle " + std::to_string(i) +
                                 " has a position that is not finite");
}

/// Sets origin, cell size and the number of cells from the extent of the valid particles.
void lay_out(Grid& grid, const Positions& positions, double radius, const NeighborFilter& filter) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 3> low{infinity, infinity, infinity};
    std::array<double, 3> high{-infinity, -infinity, -infinity};
    std::size_t count = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!is_valid(filter, i))
            continue;
        ++count;
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], positions[i][axis]);
            high[axis] = std::max(high[axis], positions[i][axis]);
        }
    }
    if (count == 0)
        return;
    double extent = 0;
    for (int axis = 0; axis < 3; ++axis)
        extent = std::max(extent, high[axis] - low[axis]);
    const double radii = extent / radius;
    if (!(radii < 0x1p50))
        throw InputError("the particles span " + rounded_text(radii, 3) +
                         " support radii, more than double precision can resolve; is the support "
                         "radius right?");
    // A little larger than the radius, so that rounding of the cell coordinate never puts two
    // particles closer than the radius two cells apart.
    const double cell_size = radius * (1 + 1e-6 + radii * 0x1p-50);
    grid.origin = low;
    grid.inverse_cell_size = 1 / cell_size;
    double boxes = 1;
    for (int axis = 0; axis < 3; ++axis) {
        grid.cells[axis] = 1 + static_cast<std::int64_t>((high[axis] - low[axis]) / cell_size);
        boxes *= static_cast<double>(grid.cells[axis]);
    }
    // Up to eight cells a particle the direct table is cheap; beyond, two buckets a particle.
    grid.direct = boxes <= 8.0 * static_cast<double>(count) + 64;
    std::uint64_t buckets = 64;
    while (buckets < 2 * count)
        buckets *= 2;
    grid.bucket_mask = buckets - 1;
    grid.bucket_start.assign((grid.direct ? static_cast<std::size_t>(boxes) : buckets) + 1, 0);
}

/// Counting sort of the valid particles by bucket; stable, so the order within a bucket is that of
/// the input.
void sort_particles(Grid& grid, const Positions& positions, const NeighborFilter& filter,
                    int threads) {
    const auto count = static_cast<std::int64_t>(positions.size());
    std::vector<std::uint64_t> bucket(positions.size());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::int64_t i = 0; i < count; ++i)
        if (is_valid(filter, static_cast<std::size_t>(i)))
            bucket[i] = bucket_of(grid, cell_of(grid, positions[i]));
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (is_valid(filter, i))
            ++grid.bucket_start[bucket[i] + 1];
    for (std::size_t b = 1; b < grid.bucket_start.size(); ++b)
        grid.bucket_start[b] += grid.bucket_start[b - 1];
    std::vector<std::uint32_t> next(grid.bucket_start.begin(), grid.bucket_start.end() - 1);
    grid.order.resize(grid.bucket_start.back());
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (is_valid(filter, i))
            grid.order[next[bucket[i]]++] = static_cast<std::uint32_t>(i);
    grid.positions.resize(grid.order.size());
    if (filter.phase != nullptr)
        grid.phase.resize(grid.order.size());
    const auto sorted_count = static_cast<std::int64_t>(grid.order.size());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::int64_t s = 0; s < sorted_count; ++s) {
        grid.positions[s] = positions[grid.order[s]];
        if (filter.phase != nullptr)
            grid.phase[s] = (*filter.phase)[grid.order[s]];
    }
}

void add_range(const Grid& grid, std::uint64_t first_bucket, std::uint64_t last_bucket,
               SearchRanges& search) {
    const SortedRange range{grid.bucket_start[first_bucket], grid.bucket_start[last_bucket + 1]};
    if (range.begin < range.end)
        search.ranges[search.count++] = range;
}

/// The ranges of the cell and the cells around it, each sorted place at most once.
SearchRanges ranges_around(const Grid& grid, const Cell& cell) {
    SearchRanges search;
    Cell low;
    Cell high;
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::max(cell[axis] - 1, std::int64_t{0});
        high[axis] = std::min(cell[axis] + 1, grid.cells[axis] - 1);
    }
    std::array<std::uint64_t, 27> shared;
    int shared_count = 0;
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
        for (std::int64_t y = low[1]; y <= high[1]; ++y) {
            if (grid.direct) { // cells along x lie side by side
                add_range(grid, bucket_of(grid, {low[0], y, z}), bucket_of(grid, {high[0], y, z}),
                          search);
                continue;
            }
            for (std::int64_t x = low[0]; x <= high[0]; ++x)
                shared[shared_count++] = bucket_of(grid, {x, y, z});
        }
    // Two of the cells may share a bucket: look at it once.
    std::sort(shared.begin(), shared.begin() + shared_count);
    const auto* end = std::unique(shared.begin(), shared.begin() + shared_count);
    for (const auto* bucket = shared.begin(); bucket != end; ++bucket)
        add_range(grid, *bucket, *bucket, search);
    return search;
}

int thread_count(int threads) {
    return threads > 0 ? threads : omp_get_max_threads();
}

/// Calls found(s, displacement) with each sorted place closer than the radius to `center`.
template <class Found>
void visit_places(const Grid& grid, const std::array<double, 3>& center, Found&& found) {
    if (grid.order.empty())
        return;
    const SearchRanges search = ranges_around(grid, cell_of(grid, center));
    for (int r = 0; r < search.count; ++r)
        for (std::uint32_t place = search.ranges[r].begin; place < search.ranges[r].end; ++place) {
            std::array<double, 3> displacement;
            double distance_squared = 0;
            for (int axis = 0; axis < 3; ++axis) {
                displacement[axis] = grid.positions[place][axis] - center[axis];
                distance_squared += displacement[axis] * displacement[axis];
            }
            if (distance_squared < grid.radius_squared)
                found(place, displacement);
        }
}

/// The same for the neighbors of the particle at a sorted place: without itself, of its phase.
template <class Found>
void visit_neighbors(const Grid& grid, std::size_t s, Found&& found) {
    visit_places(grid, grid.positions[s],
                 [&](std::uint32_t other, const std::array<double, 3>& displacement) {
                     if (other != s && (grid.phase.empty() || grid.phase[other] == grid.phase[s]))
                         found(other, displacement);
                 });
}

} // namespace

NeighborGrid::NeighborGrid(const Positions& positions, double radius, const NeighborFilter& filter,
                           int threads)
    : cells(std::make_unique<Cells>()) {
    check_input(positions, radius, filter);
    cells->radius_squared = radius * radius;
    lay_out(*cells, positions, radius, filter);
    if (!cells->bucket_start.empty())
        sort_particles(*cells, positions, filter, thread_count(threads));
}

NeighborGrid::NeighborGrid(NeighborGrid&&) noexcept = default;
NeighborGrid& NeighborGrid::operator=(NeighborGrid&&) noexcept = default;
NeighborGrid::~NeighborGrid() = default;

std::size_t NeighborGrid::size() const {
    return cells->order.size();
}

std::uint32_t NeighborGrid::particle(std::size_t place) const {
    return cells->order[place];
}

void NeighborGrid::find(std::size_t place, FoundNeighbors& found) const {
    found.clear();
    visit_neighbors(*cells, place,
                    [&](std::uint32_t other, const std::array<double, 3>& displacement) {
                        found.add(cells->order[other], displacement);
                    });
}

void NeighborGrid::find_around(const std::array<double, 3>& center, FoundNeighbors& found) const {
    found.clear();
    visit_places(*cells, center,
                 [&](std::uint32_t other, const std::array<double, 3>& displacement) {
                     found.add(cells->order[other], displacement);
                 });
}

NeighborLists find_neighbors(const Positions& positions, double radius,
                             const NeighborFilter& filter, int threads) {
    const NeighborGrid sorted(positions, radius, filter, threads);
    const Grid& grid = *sorted.cells;
    NeighborLists lists;
    lists.offsets.assign(positions.size() + 1, 0);
    // Twice the same walk, first to count and then to write: the lists are by far the largest
    // thing in memory, and this way they are there once.
    const auto count = static_cast<std::int64_t>(grid.order.size());
#pragma omp parallel for num_threads(thread_count(threads)) schedule(dynamic, 1024)
    for (std::int64_t s = 0; s < count; ++s) {
        std::size_t found = 0;
        visit_neighbors(grid, static_cast<std::size_t>(s),
                        [&](std::uint32_t, const std::array<double, 3>&) { ++found; });
        lists.offsets[grid.order[s] + 1] = found;
    }
    for (std::size_t i = 0; i < positions.size(); ++i)
        lists.offsets[i + 1] += lists.offsets[i];
    lists.neighbors.resize(lists.offsets.back());
#pragma omp parallel for num_threads(thread_count(threads)) schedule(dynamic, 1024)
    for (std::int64_t s = 0; s < count; ++s) {
        std::size_t place = lists.offsets[grid.order[s]];
        visit_neighbors(grid, static_cast<std::size_t>(s),
                        [&](std::uint32_t neighbor, const std::array<double, 3>&) {
                            lists.neighbors[place++] = grid.order[neighbor];
                        });
    }
    return lists;
}

} // namespace meniscus
