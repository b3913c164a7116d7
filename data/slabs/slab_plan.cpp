#include "detail/slab_plan.hpp"

#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

namespace meniscus {
namespace {

constexpr std::int64_t max_bins = 1 << 16;
constexpr std::size_t max_slabs = 2000;

std::int64_t layer_count(const LayerCounts& counts) {
    return counts.layout.cells[counts.axis];
}

/// The slab of bins from `first` up to `end`.
Slab slab_of(const LayerCounts& counts, std::size_t first, std::size_t end) {
    return {static_cast<std::int64_t>(first) * counts.layers_a_bin,
            std::min(static_cast<std::int64_t>(end) * counts.layers_a_bin, layer_count(counts))};
}

std::uint64_t bytes_of(const LayerCounts& counts, const SlabNeeds& needs, std::size_t first,
                       std::size_t end) {
    const std::size_t halo = static_cast<std::size_t>(needs.halo_layers); // bins have one or more
    const std::size_t from = first - std::min(first, halo);
    const std::size_t to = std::min(end + halo, counts.bins.size());
    const auto begin = counts.bins.begin();
    const std::uint64_t particles =
        std::accumulate(begin + static_cast<std::ptrdiff_t>(from),
                        begin + static_cast<std::ptrdiff_t>(to), std::uint64_t{0});
    if (!counts.layout.direct)
        return particles * (needs.particle_bytes + 3 * needs.cell_bytes);
    std::uint64_t cells =
        static_cast<std::uint64_t>(to - from) * static_cast<std::uint64_t>(counts.layers_a_bin);
    for (int axis = 0; axis < 3; ++axis)
        if (axis != counts.axis)
            cells *= static_cast<std::uint64_t>(counts.layout.cells[axis]);
    return particles * needs.particle_bytes + cells * needs.cell_bytes;
}

/// Where slabs end: so many of them with about as many particles each, none of them empty.
std::vector<std::size_t> ends_of(const LayerCounts& counts, std::size_t slabs) {
    const double all = static_cast<double>(
        std::accumulate(counts.bins.begin(), counts.bins.end(), std::uint64_t{0}));
    std::vector<std::size_t> ends;
    std::uint64_t so_far = 0;
    for (std::size_t bin = 0; bin < counts.bins.size(); ++bin) {
        so_far += counts.bins[bin];
        const double share =
            all * static_cast<double>(ends.size() + 1) / static_cast<double>(slabs);
        if (static_cast<double>(so_far) >= share && ends.size() + 1 < slabs && counts.bins[bin] > 0)
            ends.push_back(bin + 1);
    }
    if (ends.empty() || ends.back() < counts.bins.size())
        ends.push_back(counts.bins.size());
    return ends;
}

/// The largest of what slabs with these ends take.
std::uint64_t largest(const LayerCounts& counts, const SlabNeeds& needs,
                      const std::vector<std::size_t>& ends) {
    std::uint64_t most = 0;
    std::size_t first = 0;
    for (const std::size_t end : ends) {
        most = std::max(most, bytes_of(counts, needs, first, end));
        first = end;
    }
    return most;
}

} // namespace

LayerCounts::LayerCounts(const GridLayout& whole) : layout(whole) {
    // The last of several: files that were filled in a lattice's order have it outermost, so that
    // shares of their rows and slabs are much the same.
    for (int other = 1; other < 3; ++other)
        if (whole.cells[other] >= whole.cells[axis])
            axis = other;
    layers_a_bin = (whole.cells[axis] + max_bins - 1) / max_bins;
    bins.resize(static_cast<std::size_t>((whole.cells[axis] + layers_a_bin - 1) / layers_a_bin));
}

void LayerCounts::add(const std::array<double, 3>& position) {
    ++bins[static_cast<std::size_t>(layer_of(layout, position, axis) / layers_a_bin)];
}

std::vector<Slab> plan_slabs(const LayerCounts& counts, const SlabNeeds& needs,
                             std::uint64_t memory, int ranks) {
    const auto step = static_cast<std::size_t>(ranks);
    const std::size_t most = std::min(max_slabs, counts.bins.size() + step);
    std::vector<std::size_t> ends;
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    for (std::size_t slabs = step; slabs <= std::max(most, step); slabs += step) {
        ends = ends_of(counts, slabs);
        const std::uint64_t needed = largest(counts, needs, ends);
        least = std::min(least, needed);
        if (needed > memory)
            continue;
        std::vector<Slab> plan;
        std::size_t first = 0;
        for (const std::size_t end : ends) {
            plan.push_back(slab_of(counts, first, end));
            first = end;
        }
        return plan;
    }
    throw InputError("the thinnest slabs take " + std::to_string((least >> 20) + 1) +
                     " MiB beside what the program itself does, and --memory leaves " +
                     std::to_string(memory >> 20) + " MiB; give at least the difference more");
}

} // namespace meniscus
