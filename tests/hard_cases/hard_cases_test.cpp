// Every method on every hard case, a test for each case, dimension and number type.
#include "checks.hpp"

#include <gtest/gtest.h>

namespace meniscus::test {
namespace {

struct Which {
    const HardCase* hard_case;
    bool is_float;
};

std::vector<Which> all_cases() {
    static const std::vector<HardCase> cases[] = {hard_cases(2), hard_cases(3)};
    std::vector<Which> all;
    for (const auto& of_dimension : cases)
        for (const HardCase& hard_case : of_dimension)
            for (const bool is_float : {true, false})
                all.push_back({&hard_case, is_float});
    return all;
}

class EveryMethod : public testing::TestWithParam<Which> {};

TEST_P(EveryMethod, DoesAsExpected) {
    const auto& [hard_case, is_float] = GetParam();
    for (const Check& check :
         is_float ? check_case<float>(*hard_case) : check_case<double>(*hard_case))
        EXPECT_TRUE(check.passed) << check.method << ": " << check.result << ", largest error "
                                  << check.max_error << "\nexpected: " << check.expected;
}

std::string name_of(const testing::TestParamInfo<Which>& info) {
    const HardCase& hard_case = *info.param.hard_case;
    return hard_case.name + "_" + std::to_string(hard_case.dimension) + "D_" +
           (info.param.is_float ? "float" : "double");
}

INSTANTIATE_TEST_SUITE_P(HardCases, EveryMethod, testing::ValuesIn(all_cases()), name_of);

} // namespace
} // namespace meniscus::test
