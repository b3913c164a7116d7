// The table of docs/hard_cases.md: one row a case, with what is expected and why, what all methods
// made of it, and how far off the exact methods were. Exits with 1 where one did not do as
// expected.
#include "checks.hpp"
#include "support/table.hpp"

#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cstdio>
#include <map>
#include <regex>

namespace {

using namespace meniscus;
using namespace meniscus::test;

/// What is said of a case of the same name in both dimensions and number types.
struct Row {
    std::string expected;
    std::vector<std::string> sizes;   ///< particles, of each dimension
    std::vector<std::string> results; ///< each once
    double error_in_float = -1;       ///< of lambda, exact methods; negative: none
    double error_in_double = -1;
    bool passed = true;
};

bool is_exact(const Check& check) {
    return check.method.rfind("exact", 0) == 0 || check.method == "candidates, exact verification";
}

/// A refusal without what differs from case to case.
std::string refusal(const std::string& message) {
    const std::string told =
        std::regex_replace(message, std::regex("\\d+ of \\d+ particles"), "particles");
    return told.substr(0, told.find(", the first is"));
}

/// What of a check is worth a word in the table.
std::string remark(const Check& check, const std::string& where) {
    if (!check.passed)
        return "**" + check.method + " (" + where + "): " + check.result + "**";
    if (check.method == "features and line" && !check.result.empty())
        return check.result + " (" + where.substr(0, 2) + ")";
    if (check.method != "exact labels")
        return {};
    return check.result.rfind("refused", 0) == 0 ? refusal(check.result) : check.result;
}

void add_checks(const std::vector<Check>& checks, const std::string& where, double& error,
                Row& row) {
    for (const Check& check : checks) {
        row.passed = row.passed && check.passed;
        const std::string text = remark(check, where);
        if (!text.empty() &&
            std::find(row.results.begin(), row.results.end(), text) == row.results.end())
            row.results.push_back(text);
        if (is_exact(check) && check.result.rfind("refused", 0) != 0)
            error = std::max(error, check.max_error);
    }
}

std::string joined(const std::vector<std::string>& texts, const char* between) {
    std::string all;
    for (const std::string& text : texts)
        all += (all.empty() ? "" : between) + text;
    return all;
}

std::string error_text(double error) {
    return error < 0 ? "" : error == 0 ? "0" : rounded_text(error, 1);
}

} // namespace

int main() {
    std::vector<std::string> order;
    std::map<std::string, Row> rows;
    for (const int dimension : {2, 3})
        for (const HardCase& hard_case : hard_cases(dimension)) {
            if (rows.count(hard_case.name) == 0)
                order.push_back(hard_case.name);
            Row& row = rows[hard_case.name];
            const std::string where = std::to_string(dimension) + "D";
            row.expected = hard_case.why;
            row.sizes.push_back(std::to_string(hard_case.size()));
            add_checks(check_case<float>(hard_case), where + ", float", row.error_in_float, row);
            add_checks(check_case<double>(hard_case), where + ", double", row.error_in_double, row);
        }
    Table table = table_of("hard-cases", "case | particles (2D, 3D) | expected, and why | result | "
                                         "largest error of lambda: float | double");
    bool passed = true;
    for (const std::string& name : order) {
        const Row& row = rows[name];
        passed = passed && row.passed;
        table.add({name, joined(row.sizes, ", "), row.expected, joined(row.results, "; "),
                   error_text(row.error_in_float), error_text(row.error_in_double)});
    }
    std::fputs(markdown(table).c_str(), stdout);
    return passed ? 0 : 1;
}
