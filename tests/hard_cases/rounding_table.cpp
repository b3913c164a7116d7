// Rows of the rounding table in docs/hard_cases.md: how many labels the arithmetic that this
// program was built with changes, and how near to the limits they lie. Arguments: the name of the
// arithmetic, and the folder with the samples.
#include "hard_cases/rounding_fluids.hpp"

#include <cstdio>

namespace {

using namespace meniscus::test;

template <class Real>
void print_row(const char* arithmetic, const char* samples) {
    LabelChanges changes;
    const auto add = [&](const HardCase& fluid) { add_changes<Real>(fluid, changes); };
    for_hard_cases(add);
    for_random_fluids(2000, add);
    for_samples(samples, ~std::size_t{0}, add);
    std::printf("| %s, %s | %zu | %zu | %.1g | %zu | %.1g | %.1g | %zu |\n",
                sizeof(Real) == 4 ? "float" : "double", arithmetic, changes.particles,
                changes.by_coverage, changes.farthest_lambda, changes.by_line,
                changes.farthest_from_line, changes.largest_lambda_error, changes.outside);
}

} // namespace

int main(int count, char** arguments) {
    if (count != 3) {
        std::fputs("usage: rounding_table ARITHMETIC SAMPLES\n", stderr);
        return 2;
    }
    print_row<float>(arguments[1], arguments[2]);
    print_row<double>(arguments[1], arguments[2]);
    return 0;
}
