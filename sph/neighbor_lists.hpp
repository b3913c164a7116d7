// The neighbor lists of a step, built anew from particles in cell order. Each chunk of particles
// writes to a buffer of its own, so that chunks can be made in any order by any thread.
#pragma once

#include "fluid.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Room for lists, kept from step to step.
struct ListBuffers {
    static constexpr std::size_t chunk = 256;
    std::vector<IndexBuffer> buffers;
};

/// For each of `count` places the particles of `cells` closer than a support radius. `far` is the
/// index that fills lanes up. With `self`, places are those of the cells' own particles, and none
/// is its own neighbor.
template <class Real, int Dimension>
void find_lists(const Cells<Real>& cells, const Row<Real>* places, std::size_t count, bool self,
                std::uint32_t far, const ParticleLoop& particle_loop, ListBuffers& memory,
                LaneLists& lists) {
    lists.begin.resize(count);
    lists.count.resize(count);
    const std::size_t chunks = (count + ListBuffers::chunk - 1) / ListBuffers::chunk;
    if (memory.buffers.size() < chunks)
        memory.buffers.resize(chunks);
    particle_loop.loop(
        chunks * ListBuffers::chunk, [&](std::size_t begin, std::size_t end, int /*worker*/) {
            IndexBuffer& found = memory.buffers[begin / ListBuffers::chunk];
            found.clear();
            end = std::min(end, count);
            for (std::size_t i = begin; i < end; ++i) {
                const std::size_t first = found.size;
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
