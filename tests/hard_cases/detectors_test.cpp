// Every detector of `meniscus bench` on every hard case: other people's methods need not be right
// there, but they end, and say 0 or 1.
#include "cases.hpp"

#include "detectors/detector.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace meniscus::test {
namespace {

template <class Real>
void expect_classes(int dimension) {
    const auto all = detectors<Real>(dimension, MENISCUS_MODELS);
    for (const HardCase& hard_case : hard_cases(dimension)) {
        if (hard_case.is_refused<Real>() || hard_case.size() == 0)
            continue;
        const auto state = fluid_state<Real>(snapshot_of(hard_case), hard_case.name);
        for (const auto& detector : all) {
            SCOPED_TRACE(hard_case.name + ", " + detector.name);
            std::vector<std::uint8_t> surface(hard_case.size(), 7);
            detector.prepare(state, 1)(surface);
            ASSERT_EQ(surface.size(), hard_case.size());
            EXPECT_TRUE(std::all_of(surface.begin(), surface.end(),
                                    [](std::uint8_t one) { return one <= 1; }));
        }
    }
}

TEST(DetectorsOnHardCases, EndWithClassesIn2D) {
    expect_classes<float>(2);
    expect_classes<double>(2);
}

TEST(DetectorsOnHardCases, EndWithClassesIn3D) {
    expect_classes<float>(3);
    expect_classes<double>(3);
}

} // namespace
} // namespace meniscus::test
