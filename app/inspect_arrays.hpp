// Arrays and positions of a snapshot in words, for `meniscus inspect`.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>

#include <array>
#include <cstddef>
#include <string>

namespace meniscus {

/// The number with five digits.
std::string short_text(double value);

struct Extent {
    std::array<double, 3> min{}; ///< m
    std::array<double, 3> max{};
    std::size_t finite = 0; ///< positions that are
};

Extent extent_of(const Positions& positions);

/// "x 0 to 1 m, y 0 to 2 m"; empty where no position is finite.
std::string extent_text(const Extent& extent, int dimension);

/// How many particles are of each phase; empty where none is stored.
std::string phases_text(const Snapshot& snapshot);

/// Name, type and range of an array and, where it has one component and is not `id`, a histogram.
std::string array_lines(const PointArray& array);

} // namespace meniscus
