// The rounding table of docs/hard_cases.md for the arithmetic that this program was built with: how
// many labels it changes, and how near to the limits they lie. Arguments: the name of the
// arithmetic, and the folder with the samples.
#include "rounding_fluids.hpp"
#include "support/table.hpp"

#include <cstdio>

namespace {

using namespace meniscus::test;

template <class Real>
void add_row(const std::string& arithmetic, const char* samples, meniscus::Table& table) {
    LabelChanges changes;
    const auto add = [&](const HardCase& fluid) { add_changes<Real>(fluid, changes); };
    for_hard_cases(add);
    for_random_fluids(2000, add);
    for_samples(samples, ~std::size_t{0}, add);
    table.add({(sizeof(Real) == 4 ? "float, " : "double, ") + arithmetic, changes.particles,
               changes.by_coverage, changes.farthest_lambda, changes.by_line,
               changes.farthest_from_line, changes.max_lambda_error, changes.outside});
}

} // namespace

int main(int count, char** arguments) {
    if (count != 3) {
        std::fputs("usage: rounding_table ARITHMETIC SAMPLES\n", stderr);
        return 2;
    }
    meniscus::Table table = meniscus::table_of(
        "rounding",
        "arithmetic | particles | changed by coverage | lambda up to {:.1g} | changed by the line "
        "| from the line up to {:.1g} | largest error of lambda {:.1g} | outside");
    add_row<float>(arguments[1], arguments[2], table);
    add_row<double>(arguments[1], arguments[2], table);
    std::fputs(markdown(table).c_str(), stdout);
    return 0;
}
