// Included once by each exact_labels_*.cpp, inside the region that it compiles for its instruction
// set. Everything of the standard library has been included before that region begins: what the
// linker shares between files must run on every machine.
#include <meniscus/runtime/exact_coverage.hpp>

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

inline std::unique_ptr<ExactLabels> make_exact_labels() {
    return std::unique_ptr<ExactLabels>(new ExactLabelsKernel);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
