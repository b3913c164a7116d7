// Our labels against those of an independent program (50,000 evenly spread directions in double),
// where the folder of shared snapshots is at hand.
#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <tuple>

namespace meniscus {
namespace {

const std::filesystem::path folder =
    std::filesystem::path(MENISCUS_SHARED_SNAPSHOTS) / "splishsplash";

std::vector<float> independent_fractions(const std::string& state, std::size_t count) {
    std::vector<float> fractions(count);
    std::ifstream stream(folder / "uncovered_fraction" / (state + ".f32"), std::ios::binary);
    stream.read(reinterpret_cast<char*>(fractions.data()),
                static_cast<std::streamsize>(count * sizeof(float)));
    EXPECT_TRUE(stream) << state;
    return fractions;
}

using StateAndMethod = std::tuple<const char*, LabelMethod>;
class IndependentLabels : public testing::TestWithParam<StateAndMethod> {};

TEST_P(IndependentLabels, AgreeOutsideTheErrorOfSampling) {
    const std::string state = std::get<0>(GetParam());
    if (!std::filesystem::exists(folder / (state + ".vtk")))
        GTEST_SKIP() << "no shared snapshots here";
    const Snapshot snapshot = read_snapshot(folder / (state + ".vtk"));
    const double support_radius = state.rfind("droplet", 0) == 0 ? 0.12 : 0.08;
    LabelOptions options;
    options.method = std::get<1>(GetParam());
    options.samples = 50000;
    const auto labels = label_particles(snapshot, support_radius, options);
    const auto expected = independent_fractions(state, snapshot.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
        const double lambda = labels.uncovered_fraction[i];
        // Both are even sequences, far better than random ones: one sample in 50,000 of edge error
        // for each of some fifty caps is generous.
        different += std::abs(lambda - expected[i]) > 1e-3 ? 1 : 0;
        if (std::max<double>(lambda, expected[i]) > 20.0 / 50000) {
            EXPECT_EQ(lambda > 0, expected[i] > 0) << "particle " << i;
        }
    }
    // A neighbor within the band around h counts there and not here.
    EXPECT_LE(different, snapshot.size() / 1000);
}

std::string name_of(const testing::TestParamInfo<StateAndMethod>& info) {
    const bool exact = std::get<1>(info.param) == LabelMethod::exact;
    return std::string(std::get<0>(info.param)) + (exact ? "_exact" : "_monte_carlo");
}

INSTANTIATE_TEST_SUITE_P(
    States, IndependentLabels,
    testing::Combine(testing::Values("boxhole_dfsph_04", "boxhole_dfsph_18", "crown_dfsph_02",
                                     "crown_dfsph_15", "cube_iisph_05", "dam_dfsph_04",
                                     "dam_dfsph_08", "dam_dfsph_14", "droplet_iisph_06",
                                     "droplet_iisph_14", "snake_dfsph_05"),
                     testing::Values(LabelMethod::exact)),
    name_of);
INSTANTIATE_TEST_SUITE_P(SampledStates, IndependentLabels,
                         testing::Combine(testing::Values("boxhole_dfsph_18", "droplet_iisph_14",
                                                          "snake_dfsph_05"),
                                          testing::Values(LabelMethod::monte_carlo)),
                         name_of);

} // namespace
} // namespace meniscus
