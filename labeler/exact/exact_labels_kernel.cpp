// Exact coverage for the labeler, compiled for each instruction set.
#include "exact_labels.hpp"

#include <meniscus/runtime/simd/begin_kernel.hpp>

#include <meniscus/runtime/coverage/exact_coverage.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

class ExactLabelsKernel final : public ExactLabels {
public:
    double uncovered_fraction(int dimension, const std::vector<Direction>& displacements,
                              double radius_ratio) override {
        fill(dimension, displacements, radius_ratio);
        return dimension == 2 ? uncovered_part<2>(cells, coverage).fraction
                              : uncovered_part<3>(cells, coverage).fraction;
    }

    bool is_uncovered(int dimension, const std::vector<Direction>& displacements,
                      double radius_ratio) override {
        fill(dimension, displacements, radius_ratio);
        return dimension == 2 ? meniscus::is_uncovered<2>(cells, coverage)
                              : meniscus::is_uncovered<3>(cells, coverage);
    }

private:
    void fill(int dimension, const std::vector<Direction>& displacements, double radius_ratio) {
        coverage.caps.clear();
        for (const Direction& x : displacements)
            if (dimension == 2)
                add_cap<2>(coverage.caps, x, 1, radius_ratio);
            else
                add_cap<3>(coverage.caps, x, 1, radius_ratio);
    }

    CoverageCells cells;
    ExactCoverage coverage;
};

} // namespace MENISCUS_INSTRUCTION_SET

std::unique_ptr<ExactLabels> exact_labels(MENISCUS_KERNEL_SET) {
    return std::unique_ptr<ExactLabels>(new ExactLabelsKernel);
}

} // namespace meniscus

#include <meniscus/runtime/simd/end_kernel.hpp>
