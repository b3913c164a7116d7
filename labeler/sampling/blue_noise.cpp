// Blue noise: directions that keep their distance from each other without forming a lattice. The
// sphere is cut into as many cells of equal area as there are directions, in rows of equal latitude
// (after Leopardi 2006, "A partition of the unit sphere into regions of equal area and small
// diameter"), and each cell gets one random point: jittered sampling, which is even on the large
// scale. Then points that are too close push each other apart for a few steps, which makes it even
// on the small one; more steps would freeze it into a lattice. On the circle cells are arcs.
// One table serves all particles. It is made for one number of directions: the first half of it is
// not even. The cost is linear in that number, ten neighbor searches among the directions.
#include "detail/sampling_schemes.hpp"

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/runtime/math/angles.hpp>
#include <meniscus/runtime/math/random_directions.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

constexpr int steps = 10;
/// How much of what two points lack in distance each gives in one step. With up to six neighbors
/// all pushing, half would overshoot.
constexpr double give = 0.25;

/// The largest distance that so many points can keep from each other where they are many: that of
/// the hexagonal lattice, on the circle that of equal arcs.
double full_spacing(int dimension, double count) {
    return dimension == 2 ? 2 * pi / count : std::sqrt(8 * pi / (std::sqrt(3.0) * count));
}

/// One random point in each of directions.size() cells of equal area.
void fill_jittered(int dimension, std::uint64_t seed, std::vector<Direction>& directions) {
    const auto count = static_cast<double>(directions.size());
    // Rows as high as cells are wide.
    const std::int64_t rows =
        dimension == 2 ? 1 : std::max(1L, std::lround(std::sqrt(pi * count) / 2));
    const std::uint64_t key = mix_bits(seed);
    std::size_t begin = 0;
    for (std::int64_t row = 1; row <= rows; ++row) {
        const double half_turn = 0.5 * static_cast<double>(row) / static_cast<double>(rows);
        const double height = direction_from_square(2, 0, half_turn)[0];
        const auto end = static_cast<std::size_t>(std::lround((1 - height) / 2 * count));
        const auto width = static_cast<double>(end - begin);
        for (std::size_t k = begin; k < end; ++k) {
            const double along = random_fraction(mix_bits(key + 2 * k));
            const double around = random_fraction(mix_bits(key + 2 * k + 1));
            const double u = (static_cast<double>(begin) + along * width) / count;
            const double v = (static_cast<double>(k - begin) + around) / width;
            directions[k] = direction_from_square(dimension, u, v);
        }
        begin = end;
    }
}

/// Where a point goes that its neighbors closer than `reach` push away, back on the sphere.
Direction pushed(const std::vector<Direction>& directions, std::size_t i,
                 const NeighborLists& lists, double reach) {
    Direction result = directions[i];
    for (std::size_t n = lists.offsets[i]; n < lists.offsets[i + 1]; ++n) {
        const Direction& other = directions[lists.neighbors[n]];
        Direction away;
        double square = 0;
        for (int axis = 0; axis < 3; ++axis) {
            away[axis] = directions[i][axis] - other[axis];
            square += away[axis] * away[axis];
        }
        if (square == 0) // in one place: no direction to go
            continue;
        const double share = give * (reach / std::sqrt(square) - 1);
        for (int axis = 0; axis < 3; ++axis)
            result[axis] += share * away[axis];
    }
    const double length =
        std::sqrt(result[0] * result[0] + result[1] * result[1] + result[2] * result[2]);
    for (double& coordinate : result)
        coordinate /= length;
    return result;
}

void fill_blue_noise(int dimension, std::uint64_t seed, std::uint64_t /*particle*/,
                     std::vector<Direction>& directions) {
    fill_jittered(dimension, seed, directions);
    const double reach = full_spacing(dimension, static_cast<double>(directions.size()));
    std::vector<Direction> moved(directions.size());
    for (int step = 0; step < steps; ++step) {
        const NeighborLists lists = find_neighbors(directions, reach);
        for (std::size_t i = 0; i < directions.size(); ++i)
            moved[i] = pushed(directions, i, lists, reach);
        directions.swap(moved);
    }
}

} // namespace

SchemeRow blue_noise_row() {
    return row_of({"blue-noise", false, fill_blue_noise});
}

} // namespace meniscus
