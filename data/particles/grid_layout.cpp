#include "grid_layout.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>

namespace meniscus {

void ParticleExtent::add(const std::array<double, 3>& position) {
    ++count;
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], position[axis]);
        high[axis] = std::max(high[axis], position[axis]);
    }
}

GridLayout grid_layout(double radius, const ParticleExtent& extent) {
    GridLayout layout;
    layout.radius = radius;
    if (extent.count == 0)
        return layout;
    double size = 0;
    for (int axis = 0; axis < 3; ++axis)
        size = std::max(size, extent.high[axis] - extent.low[axis]);
    const double radii = size / radius;
    if (!(radii < 0x1p50))
        throw InputError("the particles span " + rounded_text(radii, 3) +
                         " support radii, more than double precision can resolve; is the support "
                         "radius right?");
    // A little larger than the radius, so that rounding of the cell coordinate never puts two
    // particles closer than the radius two cells apart.
    const double cell_size = radius * (1 + 1e-6 + radii * 0x1p-50);
    layout.origin = extent.low;
    layout.inverse_cell_size = 1 / cell_size;
    double boxes = 1;
    for (int axis = 0; axis < 3; ++axis) {
        layout.cells[axis] =
            1 + static_cast<std::int64_t>((extent.high[axis] - extent.low[axis]) / cell_size);
        boxes *= static_cast<double>(layout.cells[axis]);
    }
    // Up to eight cells a particle the direct table is cheap; beyond, two buckets a particle.
    layout.direct = boxes <= 8.0 * static_cast<double>(extent.count) + 64;
    std::uint64_t buckets = 64;
    while (buckets < 2 * extent.count)
        buckets *= 2;
    layout.bucket_mask = buckets - 1;
    return layout;
}

std::int64_t layer_of(const GridLayout& layout, const std::array<double, 3>& position, int axis) {
    const auto last = static_cast<double>(layout.cells[axis] - 1);
    return static_cast<std::int64_t>(
        std::clamp(scaled_coordinate(layout, position, axis), 0.0, last));
}

} // namespace meniscus
