// The scenes that ship: each reads and fills in each of its sizes, with the particles that
// docs/scenes.md says.
#include <meniscus/sph/scene/scene.hpp>

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/neighbor_search.hpp>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace meniscus {
namespace {

const std::filesystem::path scenes = MENISCUS_SCENES;
const std::filesystem::path snapshots = MENISCUS_SHARED_SNAPSHOTS;

/// Fluid particles by scene and variant. Those of "paper" and the like follow from the papers.
const std::map<std::string, std::map<std::string, std::size_t>> fluid_counts{
    {"box_with_hole", {{"", 3136}, {"paper", 22 * 24 * 22}}},
    {"crown_splash", {{"", 7751}, {"paper", 144967}, {"huber", 634800 + 26961}}},
    {"dam_break", {{"", 13 * 22 * 11}, {"paper", 26136}, {"splishsplash", 26136}}},
    {"dam_break_2d", {{"", 25 * 50}, {"square", 25 * 25}, {"paper", 100 * 200}}},
    {"dam_break_with_obstacle", {{"", 13 * 22 * 11}, {"paper", 26136}}},
    {"double_dam_break", {{"", 3960}, {"paper", 31680}}},
    {"double_droplet", {{"", 2 * 12 * 12 * 12}, {"paper", 10115}, {"splishsplash", 8192}}},
    {"drop_2d", {{"", 1600}, {"paper", 6400}}},
    {"drop_formation", {{"", 16 * 16 * 16}, {"paper", 30 * 30 * 30}}},
    {"fluid_over_sphere", {{"", 5120}, {"paper", 40960}}},
    {"hyperbolic_paraboloid", {{"", 3872}, {"paper", 34425}}},
    {"resting_tank", {{"", 2560}, {"paper", 20480}}},
    {"water_glass", {{"", 4608}, {"paper", 399900}}}};

std::vector<std::filesystem::path> scene_files() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(scenes))
        if (entry.path().extension() == ".json")
            files.push_back(entry.path());
    return files;
}

class ShippedScene : public ::testing::TestWithParam<std::filesystem::path> {};

/// The distance of a fluid particle from the walls, at most half a spacing.
double distance_from_walls(const Scene& scene, const SceneParticles& particles) {
    double min = scene.particle_spacing / 2;
    if (particles.walls.empty())
        return min;
    const NeighborGrid walls(particles.walls, min);
    FoundNeighbors found;
    for (const Place& place : particles.positions) {
        walls.find_around(place, min, found);
        for (const Place& d : found.displacements)
            min = std::min(min, std::hypot(d[0], d[1], d[2]));
    }
    return min;
}

TEST_P(ShippedScene, ReadsAndFillsInAllItsSizes) {
    const auto counts = fluid_counts.find(GetParam().stem().string());
    ASSERT_NE(counts, fluid_counts.end()) << GetParam();
    std::vector<std::string> variants = scene_variants(GetParam());
    variants.insert(variants.begin(), "");
    EXPECT_EQ(variants.size(), counts->second.size());
    for (const std::string& variant : variants) {
        const Scene scene = read_scene(GetParam(), variant);
        EXPECT_EQ(scene.name, GetParam().stem());
        const SceneParticles particles = fill_scene(scene);
        EXPECT_EQ(particles.positions.size(), counts->second.at(variant)) << variant;
        EXPECT_EQ(particles.velocities.size(), particles.positions.size());
        EXPECT_EQ(distance_from_walls(scene, particles), scene.particle_spacing / 2) << variant;
        const auto [low, high] = scene_domain(scene, particles);
        for (int axis = 0; axis < scene.dimension; ++axis)
            EXPECT_LT(low[axis], high[axis]);
    }
}

TEST_P(ShippedScene, SizesDifferInText) {
    std::set<std::string> texts{scene_text(read_scene(GetParam(), ""))};
    for (const std::string& variant : scene_variants(GetParam()))
        EXPECT_TRUE(texts.insert(scene_text(read_scene(GetParam(), variant))).second) << variant;
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScene, ::testing::ValuesIn(scene_files()),
                         [](const auto& info) { return info.param.stem().string(); });

TEST(ShippedScenes, AreAllThere) {
    EXPECT_EQ(scene_files().size(), fluid_counts.size());
}

TEST(ShippedScenes, GlassHasTheParticlesOfThePaper) {
    Scene scene = read_scene(scenes / "water_glass.json", "paper");
    scene.walls.erase(scene.walls.begin() + 1, scene.walls.end());
    EXPECT_NEAR(double(fill_scene(scene).walls.size()), 200000, 2000);
}

/// The first states are those that SPlisHSPlasH wrote, which had gone one step of 1 ms.
void expect_starts_as(const char* scene_name, const char* state) {
    if (!std::filesystem::exists(snapshots / "splishsplash" / state))
        GTEST_SKIP() << "no snapshots of other solvers here";
    Positions expected = read_snapshot(snapshots / "splishsplash" / state).positions;
    const Scene scene = read_scene(scenes / (std::string(scene_name) + ".json"), "splishsplash");
    Positions found = fill_scene(scene).positions;
    ASSERT_EQ(found.size(), expected.size());
    const auto nearest = [&](const Place& place) { // lattice index, so that rounding sorts nothing
        std::array<long, 3> index{};
        for (int axis = 0; axis < 3; ++axis)
            index[axis] = std::lround(100 * place[axis]);
        return index;
    };
    const auto by_index = [&](const Place& a, const Place& b) { return nearest(a) < nearest(b); };
    std::sort(expected.begin(), expected.end(), by_index);
    std::sort(found.begin(), found.end(), by_index);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            ASSERT_NEAR(found[i][axis], expected[i][axis], 1e-4);
}

TEST(ShippedScenes, DamBreakStartsAsSplishsplashs) {
    expect_starts_as("dam_break", "dam_dfsph_01.vtk");
}

TEST(ShippedScenes, DoubleDropletStartsAsSplishsplashs) {
    expect_starts_as("double_droplet", "droplet_iisph_01.vtk");
}

} // namespace
} // namespace meniscus
