#include "exact_labels.hpp"

namespace meniscus {
namespace {

const CoverageCells& cells() {
    static const CoverageCells all;
    return all;
}

// The tests of cells are inlined here, and the compiler takes as many caps at a time as the
// instruction set allows. None of them contracts products and sums, so all give the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MENISCUS_FOR_EACH_INSTRUCTION_SET                                                          \
    __attribute__((target_clones("default", "avx2", "arch=skylake-avx512")))
#else
#define MENISCUS_FOR_EACH_INSTRUCTION_SET
#endif

MENISCUS_FOR_EACH_INSTRUCTION_SET
UncoveredPart part_of_sphere(const CoverageCells& all, ExactCoverage& coverage) {
    return uncovered_part<3>(all, coverage);
}

MENISCUS_FOR_EACH_INSTRUCTION_SET
bool is_sphere_uncovered(const CoverageCells& all, ExactCoverage& coverage) {
    return is_uncovered<3>(all, coverage);
}

} // namespace

UncoveredPart exact_uncovered_part(int dimension, ExactCoverage& coverage) {
    return dimension == 2 ? uncovered_part<2>(cells(), coverage)
                          : part_of_sphere(cells(), coverage);
}

bool is_exactly_uncovered(int dimension, ExactCoverage& coverage) {
    return dimension == 2 ? is_uncovered<2>(cells(), coverage)
                          : is_sphere_uncovered(cells(), coverage);
}

} // namespace meniscus
