// Our labels against those of an independent program (50,000 evenly spread directions in double),
// where the folder of shared snapshots is at hand.
#include <meniscus/data/snapshot_files.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

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

class IndependentLabels : public testing::TestWithParam<const char*> {};

TEST_P(IndependentLabels, AgreeOutsideTheErrorOfSampling) {
    const std::string state = GetParam();
    if (!std::filesystem::exists(folder / (state + ".vtk")))
        GTEST_SKIP() << "no shared snapshots here";
    const Snapshot snapshot = read_snapshot(folder / (state + ".vtk"));
    const double support_radius = state.rfind("droplet", 0) == 0 ? 0.12 : 0.08;
    LabelOptions options;
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

INSTANTIATE_TEST_SUITE_P(States, IndependentLabels,
                         testing::Values("boxhole_dfsph_18", "cube_iisph_05", "droplet_iisph_14",
                                         "snake_dfsph_05"),
                         [](const auto& tested) { return std::string(tested.param); });

} // namespace
} // namespace meniscus
