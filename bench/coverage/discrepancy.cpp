#include "discrepancy.hpp"

#include <meniscus/runtime/math/angles.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace meniscus {
namespace {

std::vector<Direction> random_centers(std::size_t count) {
    std::vector<Direction> centers(count);
    sampling_scheme("random").fill(3, 0x63617073, 0, centers); // a seed that no study has
    return centers;
}

/// Over the caps around one center.
double cap_discrepancy_around(const Direction& center, const std::vector<Direction>& directions) {
    constexpr int heights = 1000;
    std::vector<std::size_t> slices(heights);
    for (const Direction& p : directions) {
        const double along = p[0] * center[0] + p[1] * center[1] + p[2] * center[2];
        ++slices[std::clamp(static_cast<int>((along + 1) / 2 * heights), 0, heights - 1)];
    }
    double max = 0;
    std::size_t below = 0;
    for (int height = 0; height < heights; ++height) {
        below += slices[height];
        const double share = static_cast<double>(below) / static_cast<double>(directions.size());
        max = std::max(max, std::abs(share - (height + 1.0) / heights));
    }
    return max;
}

} // namespace

double star_discrepancy(const std::vector<Direction>& directions) {
    std::vector<double> turns;
    for (const Direction& p : directions) {
        const double turn = std::atan2(p[1], p[0]) / (2 * pi);
        turns.push_back(turn < 0 ? turn + 1 : turn);
    }
    std::sort(turns.begin(), turns.end());
    const auto count = static_cast<double>(turns.size());
    double max = 0;
    for (std::size_t k = 0; k < turns.size(); ++k)
        max = std::max({max, static_cast<double>(k + 1) / count - turns[k],
                        turns[k] - static_cast<double>(k) / count});
    return max;
}

double cap_discrepancy(const std::vector<Direction>& directions) {
    static const std::vector<Direction> centers = random_centers(1000);
    double max = 0;
#pragma omp parallel for schedule(static) reduction(max : max)
    for (const Direction& center : centers)
        max = std::max(max, cap_discrepancy_around(center, directions));
    return max;
}

double mean_cap_discrepancy(const std::vector<Direction>& directions) {
    std::vector<double> sums(directions.size()); // of distances to earlier ones
#pragma omp parallel for schedule(dynamic, 64)
    for (std::size_t i = 0; i < directions.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            double square = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const double difference = directions[i][axis] - directions[j][axis];
                square += difference * difference;
            }
            sums[i] += std::sqrt(square);
        }
    const auto count = static_cast<double>(directions.size());
    const double mean = 2 * std::accumulate(sums.begin(), sums.end(), 0.0) / (count * count);
    // 4/3 is the mean distance of two points of the sphere.
    return std::sqrt(std::max(0.0, (4.0 / 3 - mean) / 8));
}

} // namespace meniscus
