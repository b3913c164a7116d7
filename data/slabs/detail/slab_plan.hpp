// Which layers of cells each slab holds: as many particles each as can be, none with more than the
// memory holds.
#pragma once

#include <meniscus/data/particles/grid_layout.hpp>
#include <meniscus/data/slabs/slab_needs.hpp>

#include <cstdint>
#include <vector>

namespace meniscus {

/// Layers from `first` up to `end`; the halo is so many layers before and after.
struct Slab {
    std::int64_t first = 0;
    std::int64_t end = 0;
};

/// Particles by their layers along the axis that has most; several layers are counted together
/// where there are very many.
struct LayerCounts {
    GridLayout layout;
    int axis = 0;
    std::int64_t layers_a_bin = 1;
    std::vector<std::uint64_t> bins;

    explicit LayerCounts(const GridLayout& whole);
    void add(const std::array<double, 3>& position);
};

/// Slabs from the first layer to the last, a multiple of `ranks` of them where there are layers
/// enough. Throws InputError, saying how much is needed, where one layer with its halo takes more
/// than `memory` bytes.
std::vector<Slab> plan_slabs(const LayerCounts& counts, const SlabNeeds& needs,
                             std::uint64_t memory, int ranks);

} // namespace meniscus
