// Times of whole passes as times of a particle.
#pragma once

#include "comparison/table.hpp"

namespace meniscus {

/// Seconds for so many particles, in `unit`s (s) for one.
inline RepeatedTime per_particle(const RepeatedTime& seconds, double unit, std::size_t particles) {
    const double scale = 1 / (unit * static_cast<double>(particles));
    return {scale * seconds.median, scale * seconds.lower, scale * seconds.upper};
}

} // namespace meniscus
