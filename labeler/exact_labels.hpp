// Exact coverage for the labeler: runtime/exact_coverage.hpp, compiled for several instruction sets
// (exact_labels_*.cpp), of which the best is picked at run time. All give the same bits.
#pragma once

#include "directions.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace meniscus {

/// What the neighbors of one particle leave uncovered; working memory for one thread.
class ExactLabels {
public:
    virtual ~ExactLabels() = default;

    /// lambda of a sphere (in two dimensions circle) of radius 1 with neighbors' spheres of radius
    /// `radius_ratio` at `displacements` (in units of the support radius).
    virtual double uncovered_fraction(int dimension, const std::vector<Direction>& displacements,
                                      double radius_ratio) = 0;

    /// True where that is more than zero_uncovered_fraction.
    virtual bool is_uncovered(int dimension, const std::vector<Direction>& displacements,
                              double radius_ratio) = 0;
};

/// The one for this machine.
std::unique_ptr<ExactLabels> exact_labels();

/// Those for each instruction set; for the tests. Empty where this machine lacks it.
std::unique_ptr<ExactLabels> exact_labels_baseline();
std::unique_ptr<ExactLabels> exact_labels_avx2();
std::unique_ptr<ExactLabels> exact_labels_avx512();

} // namespace meniscus
