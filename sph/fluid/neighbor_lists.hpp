// The neighbor lists of a step, built anew from particles in cell order. Each part of the particles
// writes to a buffer of its own, so that they can be made in any order by any thread.
#pragma once

#include "fluid.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Room for lists, kept from step to step: one for each part of the particles.
using ListBuffers = std::vector<IndexBuffer>;

/// For each of `count` places the particles of `cells` closer than a support radius. `far` is the
/// index that fills lanes up. With `self`, places are those of the cells' own particles, and none
/// is its own neighbor. `occupied` (occupied_surroundings()) spares the search where there is
/// nothing.
template <class Real, int Dimension>
void find_lists(const Cells<Real>& cells, const Row<Real>* places, std::size_t count, bool self,
                std::uint32_t far, const ParticleLoop& particle_loop, ListBuffers& memory,
                LaneLists& lists, const std::vector<std::uint8_t>* occupied = nullptr) {
    lists.begin.resize(count);
    lists.count.resize(count);
    const std::size_t parts = (count + ParticleLoop::part_size - 1) / ParticleLoop::part_size;
    if (memory.size() < parts)
        memory.resize(parts);
    particle_loop.each_part(count, [&](std::size_t part, std::size_t begin, std::size_t end) {
        IndexBuffer& found = memory[part];
        found.clear();
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t first = found.size;
            if (occupied == nullptr || (*occupied)[cells.layout.cell_of(places[i])] != 0)
                find_around<Real, Dimension>(cells, places[i],
                                             self ? static_cast<std::uint32_t>(i)
                                                  : std::numeric_limits<std::uint32_t>::max(),
                                             found);
            lists.count[i] = static_cast<std::uint32_t>(found.size - first);
            const std::size_t fill = lists.padded_count(i) - lists.count[i];
            std::uint32_t* to = found.room(fill);
            std::fill(to, to + lane_count, far);
            found.size += fill;
        }
        // Only now does the buffer stay where it is.
        const std::uint32_t* list = found.values.data();
        for (std::size_t i = begin; i < end; ++i) {
            lists.begin[i] = list;
            list += lists.padded_count(i);
        }
    });
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
