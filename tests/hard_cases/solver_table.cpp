// Prints what the solvers make of hard cases, as the Markdown of docs/hard_cases.md: a row a case
// and result, and the worst of the largest errors. Exits with 1 where one did not do as expected.
#include "solver_checks.hpp"
#include "support/table.hpp"

#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cstdio>
#include <set>

namespace meniscus::test {
namespace {

struct Row {
    Check check; ///< the first one, with the largest of their errors
    std::vector<std::string> methods;
};

/// Checks of one case, expectation and result in one row.
void add_to(std::vector<Row>& rows, const Check& check) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& other) {
        return other.check.hard_case == check.hard_case && other.check.expected == check.expected &&
               other.check.result == check.result && other.check.passed == check.passed;
    });
    if (row == rows.end()) {
        rows.push_back({check, {check.method}});
        return;
    }
    row->check.max_error = std::max(row->check.max_error, check.max_error);
    row->methods.push_back(check.method);
}

/// The methods, or that all of the case went this way.
std::string methods_text(const Row& row, const std::vector<Row>& rows) {
    const auto of_case = std::count_if(rows.begin(), rows.end(), [&](const Row& other) {
        return other.check.hard_case == row.check.hard_case;
    });
    if (of_case == 1)
        return row.methods.size() == 1 ? row.methods[0] : "all";
    std::string text;
    for (const std::string& method : std::set<std::string>(row.methods.begin(), row.methods.end()))
        text += (text.empty() ? "" : "; ") + method;
    return text;
}

/// Prints the rows and returns whether all passed.
bool print_rows(const std::vector<Row>& rows) {
    Table table =
        table_of("hard-cases-solvers",
                 "case | method | expected, and why | result | largest error | as expected");
    bool passed = true;
    for (const Row& row : rows) {
        const Check& check = row.check;
        table.add({check.hard_case, methods_text(row, rows), check.expected, check.result,
                   check.max_error == 0 ? "0" : rounded_text(check.max_error, 1),
                   check.passed ? "yes" : "**no**"});
        passed = passed && check.passed;
    }
    std::puts(markdown(table).c_str());
    return passed;
}

bool print_sets() {
    std::vector<Row> rows;
    for (const int dimension : {2, 3})
        for (const HardCase& hard_case : hard_cases(dimension))
            for (const Precision precision : precisions)
                for (const std::string_view solver : solvers) {
                    Check check = check_set(hard_case, {solver, "meniscus", dimension, precision});
                    check.method += " " + std::to_string(dimension) + "D";
                    add_to(rows, check);
                }
    // Those that are in three dimensions alone come last so far.
    std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        return a.check.hard_case < b.check.hard_case;
    });
    std::puts("Ten steps of each particle set under our surface tension, in 2D and 3D, float and "
              "double; errors are of momentum over the sum of \\|m v\\|, of the isolated particle "
              "those of its velocity and place:\n");
    return print_rows(rows);
}

bool print_motion() {
    std::vector<Row> rows;
    for (const int dimension : {2, 3})
        for (const Precision precision : precisions)
            for (const std::string_view solver : solvers)
                for (const std::string_view tension : tensions)
                    if (tension == "meniscus" || solver == "dfsph")
                        for (Check check : check_motion({solver, tension, dimension, precision})) {
                            check.hard_case += ", " + name_of(precision);
                            check.method = name_of(solver) + " " + name_of(tension) + " " +
                                           std::to_string(dimension) + "D";
                            add_to(rows, check);
                        }
    std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        return a.check.hard_case < b.check.hard_case;
    });
    std::puts("Motion; errors are of momentum, distances in h, the density that is left, or the "
              "share of the speed that is missing:\n");
    return print_rows(rows);
}

bool print_steps() {
    std::vector<Row> rows;
    for (const char* flow : {"dam_break", "droplet"})
        for (const std::string_view solver : solvers)
            for (const Check& check :
                 check_step_lengths(flow, {solver, "meniscus", 3, Precision::float32}))
                add_to(rows, check);
    std::puts("Shares of the stable step, a hundred steps each from 0.3 s on; errors are the rise "
              "of energy over kinetic and surface energy (below 0: falls), and the distance in "
              "spacings over the share:\n");
    return print_rows(rows);
}

bool print_refusals() {
    std::vector<Row> rows;
    for (const Check& check : check_refusals())
        add_to(rows, check);
    std::puts("What must be said:\n");
    return print_rows(rows);
}

} // namespace
} // namespace meniscus::test

int main() {
    using namespace meniscus::test;
    const bool sets = print_sets();
    const bool motion = print_motion();
    const bool steps = print_steps();
    const bool refusals = print_refusals();
    return sets && motion && steps && refusals ? 0 : 1;
}
