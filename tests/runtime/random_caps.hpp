// Random neighborhoods for the tests of coverage: neighbors between the two radii, all around or
// cut off by a plane so that part of the sphere stays open, loose or crowded.
#pragma once

#include <meniscus/runtime/coverage/exact_coverage.hpp>

#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace meniscus {

using Displacements = std::vector<Vector3>;

constexpr double test_radius_ratio = 0.8;

inline Vector3 random_direction(std::mt19937_64& generator, int dimension) {
    std::normal_distribution<double> normal;
    Vector3 direction{normal(generator), normal(generator), dimension == 2 ? 0 : normal(generator)};
    return scaled(1 / std::sqrt(dot(direction, direction)), direction);
}

inline Displacements random_neighborhood(std::mt19937_64& generator, int dimension,
                                         double radius_ratio = test_radius_ratio) {
    std::uniform_real_distribution<double> uniform;
    std::uniform_int_distribution<int> few(0, 60);
    Displacements neighbors;
    const double cut = 2.5 * uniform(generator) - 0.3;
    const double closest = 1 - radius_ratio + 1e-4;
    for (int n = few(generator); n > 0;) {
        const double fraction = uniform(generator);
        const double distance =
            closest + (1 - closest) * (dimension == 2 ? std::sqrt(fraction) : std::cbrt(fraction));
        const Vector3 x = scaled(distance, random_direction(generator, dimension));
        if (x[0] < cut || uniform(generator) < 0.02) {
            neighbors.push_back(x);
            --n;
        }
    }
    return neighbors;
}

inline const CoverageCells& test_cells() {
    static const CoverageCells cells;
    return cells;
}

template <int Dimension>
void fill_caps(ExactCoverage& coverage, const Displacements& neighbors,
               double radius_ratio = test_radius_ratio) {
    coverage.caps.clear();
    for (const Vector3& x : neighbors)
        add_cap<Dimension>(coverage.caps, x, 1, radius_ratio);
}

template <int Dimension = 3>
UncoveredPart uncovered(const Displacements& neighbors, double radius_ratio = test_radius_ratio) {
    static ExactCoverage coverage;
    fill_caps<Dimension>(coverage, neighbors, radius_ratio);
    const UncoveredPart part = uncovered_part<Dimension>(test_cells(), coverage);
    fill_caps<Dimension>(coverage, neighbors, radius_ratio);
    EXPECT_EQ((is_uncovered<Dimension>(test_cells(), coverage)),
              part.fraction > zero_uncovered_fraction);
    return part;
}

} // namespace meniscus
