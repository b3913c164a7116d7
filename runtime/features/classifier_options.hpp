// What a classifier has beside its first line, as plain data: no function and no instruction set,
// so that it may pass between files that are compiled for different ones.
#pragma once

#include <cstddef>

namespace meniscus {

/// A line in the plane of any two features, by their places in features/list.hpp, for the
/// candidates that a first line lets through: they stay where y <= k x + d, or, where surface lies
/// above, y >= k x + d.
struct SecondLine {
    bool is_there = false;
    std::size_t x = 0;
    std::size_t y = 0;
    double k = 0;
    double d = 0;
    bool above = false;
};

} // namespace meniscus
