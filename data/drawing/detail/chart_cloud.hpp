// Very many points as cells: each shows the mean color of its points, the stronger the more there
// are.
#pragma once

#include <meniscus/data/drawing/name_places.hpp>

#include <vector>

namespace meniscus {

struct Cloud {
    Color color = ink;
    std::vector<DrawingPoint> places = {};
};

/// Points outside the frame are left out.
Mosaic mosaic_of(const std::vector<Cloud>& clouds, const DrawingFrame& frame);

} // namespace meniscus
