// Each solver on each hard case, a test for each case and dimension.
#include "solver_checks.hpp"

#include <gtest/gtest.h>

namespace meniscus::test {
namespace {

void expect_passed(const Check& check) {
    EXPECT_TRUE(check.passed) << check.hard_case << ", " << check.method << ": " << check.result
                              << ", largest error " << check.max_error
                              << "\nexpected: " << check.expected;
}

void expect_passed(const std::vector<Check>& checks) {
    EXPECT_FALSE(checks.empty());
    for (const Check& check : checks)
        expect_passed(check);
}

const std::vector<HardCase>& all_cases() {
    static const std::vector<HardCase> all = [] {
        std::vector<HardCase> cases = hard_cases(2);
        for (const HardCase& hard_case : hard_cases(3))
            cases.push_back(hard_case);
        return cases;
    }();
    return all;
}

class EverySolver : public testing::TestWithParam<const HardCase*> {};

TEST_P(EverySolver, DoesAsExpected) {
    const HardCase& hard_case = *GetParam();
    for (const Precision precision : precisions)
        for (const std::string_view solver : solvers)
            expect_passed(
                check_set(hard_case, {solver, "meniscus", hard_case.dimension, precision}));
}

std::vector<const HardCase*> pointers_to_cases() {
    std::vector<const HardCase*> pointers;
    for (const HardCase& hard_case : all_cases())
        pointers.push_back(&hard_case);
    return pointers;
}

INSTANTIATE_TEST_SUITE_P(HardCases, EverySolver, testing::ValuesIn(pointers_to_cases()),
                         [](const auto& info) {
                             return info.param->name + "_" + std::to_string(info.param->dimension) +
                                    "D";
                         });

TEST(HardMotion, IsAsExpectedWithEverySolver) {
    for (const int dimension : {2, 3})
        for (const Precision precision : precisions)
            for (const std::string_view solver : solvers)
                expect_passed(check_motion({solver, "meniscus", dimension, precision}));
}

TEST(HardMotion, IsAsExpectedWithEveryRivalModel) {
    for (const int dimension : {2, 3})
        for (const Precision precision : precisions)
            for (const std::string_view tension : tensions)
                if (tension != "meniscus")
                    expect_passed(check_motion({"dfsph", tension, dimension, precision}));
}

class StepLengths : public testing::TestWithParam<std::string_view> {};

TEST_P(StepLengths, FromTheStableOneDownToAHundredThousandthGiveTheSameFlow) {
    for (const char* flow : {"dam_break", "droplet"})
        for (const int dimension : {2, 3})
            for (const Precision precision : precisions)
                expect_passed(
                    check_step_lengths(flow, {GetParam(), "meniscus", dimension, precision}));
}

INSTANTIATE_TEST_SUITE_P(HardCases, StepLengths, testing::ValuesIn(solvers),
                         [](const auto& info) { return name_of(info.param); });

TEST(HardRefusals, SayWhatIsWrong) {
    expect_passed(check_refusals());
}

} // namespace
} // namespace meniscus::test
