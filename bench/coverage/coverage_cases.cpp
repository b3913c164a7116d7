#include "coverage_cases.hpp"

#include "support/fluid_state.hpp"

#include <meniscus/labeler/exact/exact_labels.hpp>
#include <meniscus/labeler/labeler.hpp>
#include <meniscus/runtime/math/random_directions.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace meniscus {
namespace {

/// Particle numbers in random order.
std::vector<std::size_t> shuffled(std::size_t count) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [](std::size_t a, std::size_t b) { return mix_bits(a) < mix_bits(b); });
    return order;
}

std::vector<CoverageCase> cases_of(const Positions& positions, double support_radius, int dimension,
                                   std::size_t max) {
    const auto lists = find_neighbors(positions, support_radius);
    const CsrNeighborhood<double, 3> view{positions[0].data(), nullptr, lists.offsets.data(),
                                          lists.neighbors.data()};
    const auto range = neighbor_range<double>(support_radius, case_radius_ratio);
    const auto exact = exact_labels();
    std::vector<CoverageCase> cases;
    for (const std::size_t i : shuffled(positions.size())) {
        if (cases.size() == max)
            break;
        CoverageCase found;
        view(i, [&](std::size_t, const Direction& x, double) {
            if (range.contains(squared_length<double, 3>(x)))
                found.displacements.push_back(
                    {x[0] / support_radius, x[1] / support_radius, x[2] / support_radius});
        });
        found.uncovered_fraction =
            exact->uncovered_fraction(dimension, found.displacements, case_radius_ratio);
        if (found.uncovered_fraction > zero_uncovered_fraction)
            cases.push_back(std::move(found));
    }
    return cases;
}

} // namespace

std::vector<CoverageCase> cases_of_files(const std::vector<std::filesystem::path>& files,
                                         std::size_t per_file) {
    std::vector<CoverageCase> cases;
    for (const auto& file : files) {
        const Snapshot snapshot = read_snapshot_in_3d(file);
        for (auto& found : cases_of(snapshot.positions, *snapshot.support_radius, 3, per_file))
            cases.push_back(std::move(found));
    }
    return cases;
}

std::vector<CoverageCase> cases_of_a_disc() {
    constexpr int radius = 100;      // in particle spacings
    constexpr double scatter = 0.25; // the same, along each axis
    Positions positions;
    std::uint64_t drawn = 0;
    for (int x = -radius; x <= radius; ++x)
        for (int y = -radius; y <= radius; ++y)
            if (x * x + y * y < radius * radius) {
                const double move_x = scatter * (2 * random_fraction(mix_bits(drawn++)) - 1);
                const double move_y = scatter * (2 * random_fraction(mix_bits(drawn++)) - 1);
                positions.push_back({x + move_x, y + move_y, 0});
            }
    return cases_of(positions, 2, 2, positions.size());
}

} // namespace meniscus
