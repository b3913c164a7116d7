// The cases themselves, and what the labeler says of them.
#include "cases.hpp"

#include <meniscus/labeler/labeler.hpp>

#include <gtest/gtest.h>
#include <set>

namespace meniscus::test {
namespace {

TEST(HardCases, AreWellFormed) {
    for (const int dimension : {2, 3}) {
        std::set<std::string> names;
        for (const HardCase& hard_case : hard_cases(dimension)) {
            EXPECT_TRUE(names.insert(hard_case.name).second) << hard_case.name;
            EXPECT_EQ(hard_case.dimension, dimension);
            EXPECT_EQ(hard_case.expected.size(), hard_case.size()) << hard_case.name;
            EXPECT_FALSE(hard_case.why.empty()) << hard_case.name;
            for (const auto& position : hard_case.positions)
                ASSERT_TRUE(dimension == 3 || position[2] == 0) << hard_case.name;
        }
    }
}

TEST(HardCases, HaveTheLabelsExpected) {
    for (const int dimension : {2, 3})
        for (const HardCase& hard_case : hard_cases(dimension)) {
            if (hard_case.refused == Refused::always)
                continue;
            const Labels labels =
                label_particles(snapshot_of(hard_case), hard_case.support_radius, {});
            for (std::size_t i = 0; i < hard_case.size(); ++i)
                if (hard_case.expected[i] != Expected::either) {
                    ASSERT_EQ(labels.surface[i] != 0, hard_case.expected[i] == Expected::surface)
                        << hard_case.name << ' ' << dimension << ", particle " << i;
                }
        }
}

} // namespace
} // namespace meniscus::test
