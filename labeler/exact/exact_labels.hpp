// Exact coverage for the labeler: runtime/coverage/exact_coverage.hpp, compiled for several
// instruction sets (exact_labels_kernel.cpp), of which the widest is picked at run time. All give
// the same bits.
#pragma once

#include <meniscus/labeler/sampling/directions.hpp>
#include <meniscus/runtime/simd/dispatch.hpp>

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

/// The one for the widest instruction set of this machine, up to `widest`.
std::unique_ptr<ExactLabels> exact_labels(InstructionSet widest = widest_instruction_set);
std::unique_ptr<ExactLabels> exact_labels(CompiledFor<InstructionSet::baseline>);
std::unique_ptr<ExactLabels> exact_labels(CompiledFor<InstructionSet::avx2>);
std::unique_ptr<ExactLabels> exact_labels(CompiledFor<InstructionSet::avx512>);

} // namespace meniscus
