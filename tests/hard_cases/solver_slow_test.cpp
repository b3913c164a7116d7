// Short steps for a long time.
#include "solver_checks.hpp"

#include <gtest/gtest.h>

namespace meniscus::test {
namespace {

class LongRun : public testing::TestWithParam<std::string_view> {};

TEST_P(LongRun, InShortStepsIsThatInStableOnes) {
    for (const char* flow : {"dam_break", "droplet"}) {
        const Check check = check_long_run(flow, {GetParam(), "meniscus", 2, Precision::float32});
        EXPECT_TRUE(check.passed) << check.hard_case << ", " << check.method << ": " << check.result
                                  << ", largest error " << check.max_error
                                  << "\nexpected: " << check.expected;
    }
}

INSTANTIATE_TEST_SUITE_P(HardCases, LongRun, testing::ValuesIn(solvers),
                         [](const auto& info) { return name_of(info.param); });

} // namespace
} // namespace meniscus::test
