// Where names stand beside the points that they name: as near as can be without covering another
// name or a point.
#pragma once

#include "drawing.hpp"

#include <string>
#include <vector>

namespace meniscus {

struct NamedPoint {
    DrawingPoint place;
    std::string name;      ///< may be empty: a point that names should leave free
    bool is_needed = true; ///< or left out where it finds no room
};

struct NamePlace {
    Lettering lettering;
    bool is_far = false; ///< so far that a line should lead to the point
};

struct DrawingFrame {
    DrawingPoint low; ///< upper left
    DrawingPoint high;
};

/// One place for each point, in their order; where all is full, the least covered one, or an empty
/// name. The earlier points have the first choice.
std::vector<NamePlace> name_places(const std::vector<NamedPoint>& points,
                                   const DrawingFrame& frame);

} // namespace meniscus
