// A chart as a drawing: axes with round numbers, points, names that keep clear of each other, and
// one legend below.
#pragma once

#include "chart.hpp"
#include "drawing.hpp"

namespace meniscus {

/// Coordinates must be finite, and each panel must have a point.
Drawing draw_chart(const Chart& chart);

} // namespace meniscus
