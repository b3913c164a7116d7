#include "neighbor_search.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/data/threads/threads.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace meniscus {
namespace {

using Cell = std::array<std::int64_t, 3>;

constexpr std::uint32_t max_count = std::numeric_limits<std::uint32_t>::max();

// Beyond these the square of the radius, or what it is made of, leaves the range of double.
constexpr double min_radius = 1e-150;
constexpr double max_radius = 1e150;

} // namespace

/// Particles sorted by the bucket that their cell falls into. With few enough cells a bucket is a
/// cell; otherwise distant cells may share one, which costs a distance test and nothing else.
struct NeighborGrid::Cells {
    GridLayout layout;   ///< its radius is the largest of the particles
    Cell first{0, 0, 0}; ///< of the cells that the particles lie in
    Cell cells{1, 1, 1}; ///< how many there are along each axis
    /// Of a part of a state, the shared buckets that hold particles, sorted; else empty: all.
    std::vector<std::uint64_t> occupied;
    /// Where to look among these: the first one whose bucket, so many bits shorter, is not less.
    std::vector<std::uint32_t> occupied_from;
    int occupied_shift = 0;
    std::vector<std::uint32_t> bucket_start; ///< size: buckets + 1
    std::vector<std::uint32_t> order;        ///< particle at each sorted place
    Positions positions;                     ///< sorted
    std::vector<std::int64_t> phase;         ///< sorted, or empty
    std::vector<double> radii;               ///< sorted, or empty where all are `radius`
};

/// A grid for all particles, or where radii vary, one for each factor of two. The places of a grid
/// follow on those of the one before it.
struct NeighborGrid::Levels {
    std::vector<Cells> grids;
    std::vector<std::size_t> first_place; ///< of each grid
    std::size_t size = 0;                 ///< places of all
};

namespace {

using Grid = NeighborGrid::Cells;
using Levels = NeighborGrid::Levels;

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
        const double scaled = scaled_coordinate(grid.layout, position, axis);
        const auto first = static_cast<double>(grid.first[axis]);
        const auto last = static_cast<double>(grid.first[axis] + grid.cells[axis] - 1);
        cell[axis] = static_cast<std::int64_t>(std::clamp(scaled, first, last));
    }
    return cell;
}

std::uint64_t bucket_of(const Grid& grid, const Cell& cell) {
    if (grid.layout.direct)
        return static_cast<std::uint64_t>(
            cell[0] - grid.first[0] +
            grid.cells[0] * (cell[1] - grid.first[1] + grid.cells[1] * (cell[2] - grid.first[2])));
    const auto x = static_cast<std::uint64_t>(cell[0]);
    const auto y = static_cast<std::uint64_t>(cell[1]);
    const auto z = static_cast<std::uint64_t>(cell[2]);
    // Odd multipliers spread the bits; the high half of the product mixes best.
    const std::uint64_t mixed =
        (x * 0x9e3779b97f4a7c15ULL) ^ (y * 0xc2b2ae3d27d4eb4fULL) ^ (z * 0x165667b19e3779f9ULL);
    return (mixed ^ (mixed >> 32)) & grid.layout.bucket_mask;
}

bool is_valid(const NeighborFilter& filter, std::size_t i) {
    return filter.valid == nullptr || (*filter.valid)[i] != 0;
}

void check_radius(double radius, const std::string& subject) {
    if (!(radius > 0) || !std::isfinite(radius))
        throw InputError(subject + " must be positive and finite, found " + number_text(radius));
    if (radius < min_radius || radius > max_radius)
        throw InputError(subject + " must lie between " + number_text(min_radius) + " and " +
                         number_text(max_radius) + " m, found " + number_text(radius) +
                         "; is it in m?");
}

void check_each_radius(const std::vector<double>& radii, std::size_t particles,
                       const NeighborFilter& filter) {
    if (radii.size() != particles)
        throw InputError("expected one support radius for each of " + std::to_string(particles) +
                         " particles, found " + std::to_string(radii.size()));
    std::optional<std::size_t> min;
    std::optional<std::size_t> max;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        if (!is_valid(filter, i))
            continue;
        check_radius(radii[i], "support radius of particle " + std::to_string(i));
        if (!min || radii[i] < radii[*min])
            min = i;
        if (!max || radii[i] > radii[*max])
            max = i;
    }
    if (min && radii[*max] / radii[*min] > max_radius_range)
        throw InputError("support radii range from " + rounded_text(radii[*min], 3) +
                         " m (particle " + std::to_string(*min) + ") to " +
                         rounded_text(radii[*max], 3) + " m (particle " + std::to_string(*max) +
                         "), expected at most a factor of " + rounded_text(max_radius_range, 4) +
                         "; are they all in m? --support-radius gives one for all");
}

void check_input(const Positions& positions, const SupportRadii& radii,
                 const NeighborFilter& filter) {
    if (radii.vary())
        check_each_radius(radii.each, positions.size(), filter);
    else
        check_radius(radii.max, "support radius");
    if (positions.size() >= max_count)
        throw InputError("at most 4294967294 particles can be searched, found " +
                         std::to_string(positions.size()));
    for (std::size_t i = 0; i < positions.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            if (is_valid(filter, i) && !std::isfinite(positions[i][axis]))
                throw InputError("particle " + std::to_string(i) +
                                 " has a position that is not finite");
}

/// The extent of the valid particles.
ParticleExtent extent_of(const Positions& positions, const NeighborFilter& filter) {
    ParticleExtent extent;
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (is_valid(filter, i))
            extent.add(positions[i]);
    return extent;
}

std::size_t cell_count(const Grid& grid) {
    return static_cast<std::size_t>(grid.cells[0] * grid.cells[1] * grid.cells[2]);
}

/// As many buckets as the layout has, for all particles of a state.
void make_room(Grid& grid, const GridLayout& layout) {
    grid.layout = layout;
    grid.cells = layout.cells;
    if (layout.inverse_cell_size == 0) // no particle
        return;
    grid.bucket_start.assign((layout.direct ? cell_count(grid) : layout.bucket_mask + 1) + 1, 0);
}

/// Makes a table by which a bucket is found among the occupied ones without a search: as they are
/// spread evenly, each entry stands for a few.
void index_occupied(Grid& grid) {
    while ((grid.layout.bucket_mask >> grid.occupied_shift) > grid.occupied.size())
        ++grid.occupied_shift;
    const std::size_t entries = (grid.layout.bucket_mask >> grid.occupied_shift) + 2;
    grid.occupied_from.resize(entries);
    std::size_t slot = 0;
    for (std::size_t entry = 0; entry < entries; ++entry) {
        while (slot < grid.occupied.size() && (grid.occupied[slot] >> grid.occupied_shift) < entry)
            ++slot;
        grid.occupied_from[entry] = static_cast<std::uint32_t>(slot);
    }
}

/// Only as many as a part of the state needs: numbered otherwise, but in the same order.
void make_room_for_part(Grid& grid, const GridLayout& layout, const Positions& positions,
                        const NeighborFilter& filter) {
    grid.layout = layout;
    grid.cells = layout.cells;
    const ParticleExtent extent = extent_of(positions, filter);
    if (extent.count == 0)
        return;
    const Cell low = cell_of(grid, extent.low);
    const Cell high = cell_of(grid, extent.high);
    grid.first = low;
    for (int axis = 0; axis < 3; ++axis)
        grid.cells[axis] = high[axis] - low[axis] + 1;
    if (layout.direct) {
        grid.bucket_start.assign(cell_count(grid) + 1, 0);
        return;
    }
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (is_valid(filter, i))
            grid.occupied.push_back(bucket_of(grid, cell_of(grid, positions[i])));
    std::sort(grid.occupied.begin(), grid.occupied.end());
    grid.occupied.erase(std::unique(grid.occupied.begin(), grid.occupied.end()),
                        grid.occupied.end());
    grid.bucket_start.assign(grid.occupied.size() + 1, 0);
    index_occupied(grid);
}

/// The number of buckets that hold particles and come before this one.
std::size_t first_slot(const Grid& grid, std::uint64_t bucket) {
    if (grid.occupied.empty())
        return bucket;
    std::size_t slot = grid.occupied_from[bucket >> grid.occupied_shift];
    while (slot < grid.occupied.size() && grid.occupied[slot] < bucket)
        ++slot;
    return slot;
}

/// The places of all from one bucket to another.
SortedRange range_of(const Grid& grid, std::uint64_t first_bucket, std::uint64_t last_bucket) {
    return {grid.bucket_start[first_slot(grid, first_bucket)],
            grid.bucket_start[first_slot(grid, last_bucket + 1)]};
}

/// Counting sort of the valid particles by bucket; stable, so the order within a bucket is that of
/// the input.
void sort_particles(Grid& grid, const Positions& positions, const NeighborFilter& filter,
                    int threads) {
    const auto loop = loop_over(threads, 4096);
    std::vector<std::uint64_t> bucket(positions.size());
    loop(positions.size(), [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t i = begin; i < end; ++i)
            if (is_valid(filter, i))
                bucket[i] = first_slot(grid, bucket_of(grid, cell_of(grid, positions[i])));
    });
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
    loop(grid.order.size(), [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t s = begin; s < end; ++s) {
            grid.positions[s] = positions[grid.order[s]];
            if (filter.phase != nullptr)
                grid.phase[s] = (*filter.phase)[grid.order[s]];
        }
    });
}

void add_range(const Grid& grid, std::uint64_t first_bucket, std::uint64_t last_bucket,
               SearchRanges& search) {
    const SortedRange range = range_of(grid, first_bucket, last_bucket);
    if (range.begin < range.end)
        search.ranges[search.count++] = range;
}

/// The ranges of the cell and the cells around it, each sorted place at most once.
SearchRanges ranges_around(const Grid& grid, const Cell& cell) {
    SearchRanges search;
    Cell low;
    Cell high;
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::max(cell[axis] - 1, grid.first[axis]);
        high[axis] = std::min(cell[axis] + 1, grid.first[axis] + grid.cells[axis] - 1);
    }
    std::array<std::uint64_t, 27> shared;
    int shared_count = 0;
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
        for (std::int64_t y = low[1]; y <= high[1]; ++y) {
            if (grid.layout.direct) { // cells along x lie side by side
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

/// The same for all cells within `radius` of a position; one range for each row of cells that lie
/// side by side.
std::vector<SortedRange> ranges_within(const Grid& grid, const std::array<double, 3>& center,
                                       double radius) {
    Cell low = {};
    Cell high = {};
    double boxes = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = radius * (1 + 1e-6); // more than what distances are rounded by
        auto corner = center;
        corner[axis] = center[axis] - reach;
        low[axis] = cell_of(grid, corner)[axis];
        corner[axis] = center[axis] + reach;
        high[axis] = cell_of(grid, corner)[axis];
        boxes *= static_cast<double>(high[axis] - low[axis] + 1);
    }
    if (boxes > static_cast<double>(grid.order.size())) // rather look at every particle
        return {{0, static_cast<std::uint32_t>(grid.order.size())}};
    std::vector<std::array<std::uint64_t, 2>> buckets; // first and last
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
        for (std::int64_t y = low[1]; y <= high[1]; ++y) {
            if (grid.layout.direct)
                buckets.push_back(
                    {bucket_of(grid, {low[0], y, z}), bucket_of(grid, {high[0], y, z})});
            for (std::int64_t x = low[0]; x <= high[0] && !grid.layout.direct; ++x)
                buckets.push_back({bucket_of(grid, {x, y, z}), bucket_of(grid, {x, y, z})});
        }
    std::sort(buckets.begin(), buckets.end()); // two cells may share one
    buckets.erase(std::unique(buckets.begin(), buckets.end()), buckets.end());
    std::vector<SortedRange> ranges;
    for (const auto& [first, last] : buckets)
        if (const SortedRange range = range_of(grid, first, last); range.begin < range.end)
            ranges.push_back(range);
    return ranges;
}

/// The grid that a place belongs to.
std::size_t level_of(const Levels& levels, std::size_t place) {
    std::size_t level = levels.grids.size() - 1;
    while (levels.first_place[level] > place)
        --level;
    return level;
}

std::uint32_t particle_at(const Levels& levels, std::size_t place) {
    const std::size_t level = level_of(levels, place);
    return levels.grids[level].order[place - levels.first_place[level]];
}

/// Calls visit(range) with ranges of places that hold, each once, all particles closer than
/// `radius`, however large that is, to `center`.
template <class Visit>
void visit_ranges(const Grid& grid, const std::array<double, 3>& center, double radius,
                  Visit&& visit) {
    if (grid.order.empty())
        return;
    if (radius <= grid.layout.radius) {
        const SearchRanges search = ranges_around(grid, cell_of(grid, center));
        for (int r = 0; r < search.count; ++r)
            visit(search.ranges[r]);
        return;
    }
    for (const SortedRange& range : ranges_within(grid, center, radius))
        visit(range);
}

/// Calls found(s, displacement, distance squared) with each sorted place closer than `radius` to
/// `center`.
template <class Found>
void visit_places(const Grid& grid, const std::array<double, 3>& center, double radius,
                  Found&& found) {
    const double radius_squared = radius * radius;
    visit_ranges(grid, center, radius, [&](const SortedRange& range) {
        for (std::uint32_t place = range.begin; place < range.end; ++place) {
            std::array<double, 3> displacement;
            double distance_squared = 0;
            for (int axis = 0; axis < 3; ++axis) {
                displacement[axis] = grid.positions[place][axis] - center[axis];
                distance_squared += displacement[axis] * displacement[axis];
            }
            if (distance_squared < radius_squared)
                found(place, displacement, distance_squared);
        }
    });
}

bool is_closer_than_mean(double distance_squared, double radius, double other_radius) {
    const double mean = (radius + other_radius) / 2;
    return distance_squared < mean * mean;
}

/// Calls found(particle, displacement) with each neighbor of the particle at a place of a grid:
/// other than itself, of its phase.
template <class Found>
void visit_neighbors(const Levels& levels, std::size_t place, Found&& found) {
    const std::size_t level = level_of(levels, place);
    const Grid& own = levels.grids[level];
    const std::size_t s = place - levels.first_place[level];
    const double own_radius = own.radii.empty() ? own.layout.radius : own.radii[s];
    for (const Grid& grid : levels.grids) {
        const std::size_t self = &grid == &own ? s : grid.order.size();
        const double* radii = grid.radii.empty() ? nullptr : grid.radii.data();
        visit_places(grid, own.positions[s], (own_radius + grid.layout.radius) / 2,
                     [&](std::uint32_t other, const std::array<double, 3>& displacement,
                         double distance_squared) {
                         if (other != self &&
                             (grid.phase.empty() || grid.phase[other] == own.phase[s]) &&
                             (radii == nullptr ||
                              is_closer_than_mean(distance_squared, own_radius, radii[other])))
                             found(grid.order[other], displacement);
                     });
    }
}

/// Adds a grid of the particles that the filter leaves, whose largest radius is `radius`.
void add_level(Levels& levels, const Positions& positions, const SupportRadii& radii, double radius,
               const NeighborFilter& filter, int threads) {
    Grid& grid = levels.grids.emplace_back();
    make_room(grid, grid_layout(radius, extent_of(positions, filter)));
    if (!grid.bucket_start.empty())
        sort_particles(grid, positions, filter, threads);
    if (radii.vary())
        for (const std::uint32_t particle : grid.order)
            grid.radii.push_back(radii.each[particle]);
    levels.first_place.push_back(levels.size);
    levels.size += grid.order.size();
}

/// Sorts particles of varying radii into levels, each for a factor of two.
void add_levels(Levels& levels, const Positions& positions, const SupportRadii& radii,
                const NeighborFilter& filter, int threads) {
    constexpr int max_levels = 10; // 2^10 exceeds max_radius_range
    std::array<double, max_levels> max{};
    std::vector<std::uint8_t> in_level(positions.size());
    double min = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (is_valid(filter, i))
            min = std::min(min, radii.each[i]);
    const auto level_of_radius = [&](std::size_t i) { return std::ilogb(radii.each[i] / min); };
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (is_valid(filter, i)) {
            double& radius = max[level_of_radius(i)];
            radius = std::max(radius, radii.each[i]);
        }
    for (int level = 0; level < max_levels; ++level) {
        if (max[level] == 0)
            continue;
        for (std::size_t i = 0; i < positions.size(); ++i)
            in_level[i] =
                static_cast<std::uint8_t>(is_valid(filter, i) && level_of_radius(i) == level);
        add_level(levels, positions, radii, max[level], {&in_level, filter.phase}, threads);
    }
}

/// Refuses radii that reach over so many particles that the search would seem to hang; by a sample,
/// since counting for all of them takes long as well.
void check_comparisons(const Levels& levels) {
    constexpr std::size_t max = 100000;
    if (levels.size <= max) // not even all pairs are too many
        return;
    const std::size_t step = levels.size / 4096 + 1;
    std::size_t comparisons = 0;
    std::size_t sampled = 0;
    for (std::size_t place = 0; place < levels.size; place += step, ++sampled) {
        const std::size_t level = level_of(levels, place);
        const Grid& own = levels.grids[level];
        const std::size_t s = place - levels.first_place[level];
        for (const Grid& grid : levels.grids)
            visit_ranges(grid, own.positions[s], (own.radii[s] + grid.layout.radius) / 2,
                         [&](const SortedRange& range) { comparisons += range.end - range.begin; });
    }
    if (comparisons / sampled > max)
        throw InputError("support radii up to " +
                         rounded_text(levels.grids.back().layout.radius, 3) + " m reach over " +
                         std::to_string(comparisons / sampled) +
                         " particles on average, expected at most " + std::to_string(max) +
                         "; are they all in m? --support-radius gives one for all");
}

} // namespace

NeighborGrid::NeighborGrid(const Positions& positions, const SupportRadii& radii,
                           const NeighborFilter& filter, int threads)
    : levels(std::make_unique<Levels>()) {
    check_input(positions, radii, filter);
    if (radii.vary()) {
        add_levels(*levels, positions, radii, filter, threads);
        check_comparisons(*levels);
    } else {
        add_level(*levels, positions, radii, radii.max, filter, threads);
    }
}

NeighborGrid::NeighborGrid(const Positions& positions, const GridLayout& whole,
                           const NeighborFilter& filter, int threads)
    : levels(std::make_unique<Levels>()) {
    check_input(positions, whole.radius, filter);
    Grid& grid = levels->grids.emplace_back();
    make_room_for_part(grid, whole, positions, filter);
    if (!grid.bucket_start.empty())
        sort_particles(grid, positions, filter, threads);
    levels->first_place.push_back(0);
    levels->size = grid.order.size();
}

NeighborGrid::NeighborGrid(NeighborGrid&&) noexcept = default;
NeighborGrid& NeighborGrid::operator=(NeighborGrid&&) noexcept = default;
NeighborGrid::~NeighborGrid() = default;

std::size_t NeighborGrid::size() const {
    return levels->size;
}

std::uint32_t NeighborGrid::particle(std::size_t place) const {
    return particle_at(*levels, place);
}

void NeighborGrid::find(std::size_t place, FoundNeighbors& found) const {
    found.clear();
    visit_neighbors(*levels, place,
                    [&](std::uint32_t other, const std::array<double, 3>& displacement) {
                        found.add(other, displacement);
                    });
}

void NeighborGrid::find_around(const std::array<double, 3>& center, double radius,
                               FoundNeighbors& found) const {
    found.clear();
    for (const Grid& grid : levels->grids)
        visit_places(grid, center, radius,
                     [&](std::uint32_t other, const std::array<double, 3>& displacement, double) {
                         found.add(grid.order[other], displacement);
                     });
}

namespace {

/// As visit_neighbors, for lists: of what lies in a crowd in one place, only so many.
template <class Found>
void visit_listed(const Levels& levels, std::size_t place, std::size_t max_crowd, Found&& found) {
    const std::size_t level = level_of(levels, place);
    const Grid& own = levels.grids[level];
    const std::size_t s = place - levels.first_place[level];
    const double near = crowd_radius * (own.radii.empty() ? own.layout.radius : own.radii[s]);
    std::size_t crowd = 0;
    visit_neighbors(levels, place,
                    [&](std::uint32_t other, const std::array<double, 3>& displacement) {
                        double distance_squared = 0;
                        for (const double x : displacement)
                            distance_squared += x * x;
                        if (distance_squared >= near * near || ++crowd <= max_crowd)
                            found(other);
                    });
}

/// How many visit_listed() finds.
std::size_t listed(const Levels& levels, std::size_t place, std::size_t max_crowd) {
    std::size_t count = 0;
    visit_listed(levels, place, max_crowd, [&](std::uint32_t) { ++count; });
    return count;
}

/// Refuses what most likely comes of a wrong unit, since lists of nearly all pairs outgrow any
/// memory.
void check_listed(std::size_t listed, std::size_t particles, std::size_t max,
                  const SupportRadii& radii) {
    if (listed > max * particles)
        throw InputError("a support radius of " + rounded_text(radii.max, 4) + " m gives " +
                         std::to_string(listed / particles) +
                         " neighbors a particle on average, expected at most " +
                         std::to_string(max_listed_neighbors) +
                         "; is it in m, as the positions are?");
}

/// The same by a sample, since to count all of them takes long as well. Only what is far beyond
/// the limit is refused, which no sample hides.
void check_sample(const Levels& levels, std::size_t max_crowd, const SupportRadii& radii) {
    constexpr std::size_t sample = 256;
    const std::size_t step = levels.size / sample + 1;
    std::size_t found = 0;
    std::size_t sampled = 0;
    for (std::size_t place = 0; place < levels.size; place += step, ++sampled)
        found += listed(levels, place, max_crowd);
    check_listed(found, sampled, 4 * max_listed_neighbors, radii);
}

} // namespace

/// The lists of so many particles, those of a grid, with no more than `max_crowd` in one place.
NeighborLists list_neighbors(const NeighborGrid& sorted, std::size_t particles,
                             const SupportRadii& radii, std::size_t max_crowd, int threads) {
    const Levels& levels = *sorted.levels;
    NeighborLists lists;
    check_sample(levels, max_crowd, radii);
    lists.offsets.assign(particles + 1, 0);
    // Twice the same walk, first to count and then to write: the lists are by far the largest
    // thing in memory, and this way they are there once.
    const auto loop = loop_over(threads, 1024);
    loop(levels.size, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t s = begin; s < end; ++s)
            lists.offsets[particle_at(levels, s) + 1] = listed(levels, s, max_crowd);
    });
    for (std::size_t i = 0; i < particles; ++i)
        lists.offsets[i + 1] += lists.offsets[i];
    check_listed(lists.offsets.back(), levels.size, max_listed_neighbors, radii);
    lists.neighbors.resize(lists.offsets.back());
    loop(levels.size, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t s = begin; s < end; ++s) {
            std::size_t place = lists.offsets[particle_at(levels, s)];
            visit_listed(levels, s, max_crowd,
                         [&](std::uint32_t neighbor) { lists.neighbors[place++] = neighbor; });
        }
    });
    return lists;
}

NeighborLists find_neighbors(const Positions& positions, const SupportRadii& radii,
                             const NeighborFilter& filter, int threads) {
    return list_neighbors(NeighborGrid(positions, radii, filter, threads), positions.size(), radii,
                          filter.max_crowd, threads);
}

NeighborLists find_neighbors(const Positions& positions, const GridLayout& whole,
                             const NeighborFilter& filter, int threads) {
    return list_neighbors(NeighborGrid(positions, whole, filter, threads), positions.size(),
                          whole.radius, filter.max_crowd, threads);
}

} // namespace meniscus
