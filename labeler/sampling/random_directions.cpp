// Run-time random directions: each particle draws its own, independent and evenly distributed, from
// a stream keyed by seed and particle (2020 paper, section 3.2: the plain Monte Carlo scheme).
#include "detail/sampling_schemes.hpp"

#include <meniscus/runtime/math/random_directions.hpp>

namespace meniscus {
namespace {

void fill_random(int dimension, std::uint64_t seed, std::uint64_t particle,
                 std::vector<Direction>& directions) {
    RandomDirections random(seed, particle);
    for (Direction& direction : directions)
        if (dimension == 2) {
            const auto [x, y] = random.next<2>();
            direction = {x, y, 0};
        } else {
            direction = random.next<3>();
        }
}

} // namespace

SchemeRow random_row() {
    return row_of({"random", true, fill_random});
}

} // namespace meniscus
