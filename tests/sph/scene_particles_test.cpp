#include <meniscus/sph/scene/scene.hpp>

#include "data/test_folder.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/text/errors.hpp>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace meniscus {
namespace {

Scene scene_with(std::vector<FluidBody> fluid, int dimension = 3) {
    Scene scene;
    scene.name = "some";
    scene.dimension = dimension;
    scene.particle_spacing = 0.1;
    scene.support_radius = 0.2;
    scene.fluid = std::move(fluid);
    return scene;
}

std::string error_from(const Scene& scene) {
    return error_of<InputError>([&] { fill_scene(scene); });
}

TEST(SceneParticles, LatticeStartsAtItsFirstPlace) {
    const SceneParticles particles =
        fill_scene(scene_with({{LatticeShape{{1, 2, 3}, {2, 3, 4}}, {0, -1, 0}}}));
    ASSERT_EQ(particles.positions.size(), 24U);
    EXPECT_EQ(particles.positions.front(), (Place{1, 2, 3}));
    EXPECT_NEAR(particles.positions.back()[0], 1.1, 1e-12);
    EXPECT_NEAR(particles.positions.back()[1], 2.2, 1e-12);
    EXPECT_NEAR(particles.positions.back()[2], 3.3, 1e-12);
    EXPECT_EQ(particles.velocities, std::vector<Place>(24, {0, -1, 0}));
    EXPECT_TRUE(particles.walls.empty());
}

TEST(SceneParticles, BoxHoldsParticlesInTheMiddleOfItsCells) {
    const Scene scene = scene_with({{BoxShape{{0, 0, 0}, {0.3, 0.25, 0.1}, {}}, {}}});
    const SceneParticles particles = fill_scene(scene);
    ASSERT_EQ(particles.positions.size(), 6U); // 3 x 2 x 1, although 0.3 / 0.1 is below 3
    EXPECT_EQ(particles.positions.front(), (Place{0.05, 0.05, 0.05}));
    EXPECT_NEAR(particles.positions.back()[1], 0.15, 1e-12);
}

TEST(SceneParticles, BodiesThatOverlapAreRefusedWhateverTheirLattices) {
    const BoxShape box{{0, 0, 0}, {1, 1, 1}, {}};
    for (const double shift : {0.02, 0.05, 0.03}) {
        SCOPED_TRACE(shift);
        const BoxShape other{{0.5 + shift, 0.5 + shift, 0.5 + shift}, {1.5, 1.5, 1.5}, {}};
        expect_mentions(error_from(scene_with({{box, {}}, {other, {}}})),
                        {"scene 'some'", "fluid[0]", "fluid[1]", "spacings apart", "move them"});
    }
    const BoxShape beside{{1, 0.03, 0.02}, {2, 1, 1}, {}};
    EXPECT_NO_THROW(fill_scene(scene_with({{box, {}}, {beside, {}}})));
    const SphereShape disk{{0.5, 0.5, 0}, {0.3, 0.3, 0}};
    expect_mentions(error_from(scene_with({{box, {}}, {disk, {}}}, 2)), {"fluid[0]", "fluid[1]"});
}

TEST(SceneParticles, FluidInAWallIsRefused) {
    Scene scene = scene_with({{BoxShape{{0.05, 0.05, 0.05}, {1.05, 1.05, 1.05}, {}}, {}}});
    scene.walls = {BoxShape{{0, 0, 0}, {1.1, 2, 1.1}, {"+y"}}};
    EXPECT_NO_THROW(fill_scene(scene));
    scene.walls.push_back(SphereShape{{0.5, 0.5, 0.5}, {0.2, 0.2, 0.2}});
    expect_mentions(error_from(scene), {"fluid[0]", "walls[1]", "spacings apart", "in the wall"});
}

TEST(SceneParticles, WallsHaveTheirContactAngles) {
    Scene scene = scene_with({{BoxShape{{0.05, 0.05, 0.05}, {1.05, 1.05, 1.05}, {}}, {}}});
    scene.walls = {BoxShape{{0, 0, 0}, {1.1, 2, 1.1}, {"+y"}}, BoxShape{{3, 0, 0}, {4, 1, 1}, {}}};
    scene.walls[1].contact_angle = 60;
    const SceneParticles particles = fill_scene(scene);
    ASSERT_EQ(particles.wall_contact_angles.size(), particles.walls.size());
    EXPECT_EQ(particles.wall_contact_angles.front(), 90);
    EXPECT_EQ(particles.wall_contact_angles.back(), 60);
}

TEST(SceneParticles, BallHasAParticleAtItsCenter) {
    const auto count = [](const Place& axes, int dimension) {
        const SceneParticles particles =
            fill_scene(scene_with({{SphereShape{{1, 1, 0}, axes}, {}}}, dimension));
        std::size_t at_center = 0;
        for (const Place& place : particles.positions)
            at_center += std::hypot(place[0] - 1, place[1] - 1, place[2]) < 1e-12;
        EXPECT_EQ(at_center, 1U);
        return particles.positions.size();
    };
    EXPECT_EQ(count({0.05, 0.05, 0.05}, 3), 1U);
    EXPECT_EQ(count({0.1, 0.1, 0.1}, 3), 7U);
    EXPECT_EQ(count({0.1, 0.2, 0.1}, 3), 9U);
    EXPECT_EQ(count({0.15, 0.15, 0.15}, 3), 19U);
    EXPECT_EQ(count({0.1, 0.1, 0}, 2), 5U);
}

TEST(SceneParticles, MassIsThatOfACellTimesItsShare) {
    Scene scene = scene_with({{LatticeShape{}, {}}});
    scene.rest_density = 800;
    scene.volume_share = 0.5;
    EXPECT_NEAR(fill_scene(scene).mass, 0.4, 1e-12);
    scene.dimension = 2;
    EXPECT_NEAR(fill_scene(scene).mass, 4, 1e-12);
}

TEST(SceneParticles, BodiesThatOverlapAreNamed) {
    FluidBody box{BoxShape{{0, 0, 0}, {0.3, 0.3, 0.3}, {}}, {}};
    FluidBody far{BoxShape{{5, 0, 0}, {5.3, 0.3, 0.3}, {}}, {}};
    expect_mentions(error_from(scene_with({far, box, box})),
                    {"'some'", "particles 27 of fluid[1] and 54 of fluid[2]", "overlap"});
    FluidBody beside{BoxShape{{0.3, 0, 0}, {0.6, 0.3, 0.3}, {}}, {}};
    EXPECT_EQ(fill_scene(scene_with({box, beside})).positions.size(), 54U);
}

TEST(SceneParticles, RefusesScenesWithoutFluidOrWithTooMuch) {
    expect_mentions(error_from(scene_with({})), {"'some'", "no fluid"});
    expect_mentions(error_from(scene_with({{BoxShape{{0, 0, 0}, {1, 1, 0.05}, {}}, {}}})),
                    {"fluid[0]", "no particle"});
    expect_mentions(error_from(scene_with({{BoxShape{{0, 0, 0}, {1e9, 1e9, 0.05}, {}}, {}}})),
                    {"fluid[0]", "no particle"});
    expect_mentions(error_from(scene_with({{BoxShape{{0, 0, 0}, {1e9, 1e9, 1e9}, {}}, {}}})),
                    {"fluid[0]", "1e+30", "particle_spacing"});
    expect_mentions(error_from(scene_with({{SphereShape{{}, {1e3, 1e3, 1e3}}, {}}})),
                    {"fluid[0]", "particles"});
    Scene walls = scene_with({{LatticeShape{}, {}}});
    walls.walls = {BoxShape{{0, 0, 0}, {1e5, 1e5, 1e5}, {}}};
    expect_mentions(error_from(walls), {"walls[0]", "wall particles"});
}

TEST(SceneParticles, WallsOfAllKinds) {
    Scene scene = scene_with({{LatticeShape{}, {}}});
    scene.walls = {BoxShape{{-1, -1, -1}, {1, 1, 1}, {"+y"}}};
    const std::size_t open_box = fill_scene(scene).walls.size();
    EXPECT_EQ(open_box, 21U * 21 * 21 - 19U * 19 * 19 - 19U * 19);
    scene.walls.emplace_back(SphereShape{{0, 0, 0}, {0.5, 0.5, 0.5}});
    const SceneParticles particles = fill_scene(scene);
    EXPECT_GT(particles.walls.size(), open_box + 200);
    for (std::size_t w = open_box; w < particles.walls.size(); ++w)
        EXPECT_NEAR(std::hypot(particles.walls[w][0], particles.walls[w][1], particles.walls[w][2]),
                    0.5, 1e-12);
}

TEST(SceneParticles, DomainIsAroundFluidAndWalls) {
    Scene scene = scene_with({{LatticeShape{{0, 0, 0}, {2, 1, 1}}, {}}});
    const auto [low, high] = scene_domain(scene, fill_scene(scene));
    EXPECT_NEAR(low[1], -0.1, 1e-12);
    EXPECT_NEAR(high[0], 0.2, 1e-12);
    scene.walls = {BoxShape{{-1, -2, -1}, {1, 2, 1}, {}}};
    const auto walled = scene_domain(scene, fill_scene(scene));
    EXPECT_EQ(walled[0], (Place{-5, -6, -5}));
    EXPECT_EQ(walled[1], (Place{5, 6, 5}));
    scene.domain = {Place{-3, -3, -3}, Place{3, 3, 3}};
    EXPECT_EQ(scene_domain(scene, fill_scene(scene)), *scene.domain);
    scene.domain = {Place{-3, -3, -3}, Place{0.05, 3, 3}};
    expect_mentions(error_from(scene), {"particle 1", "outside the domain", "x = 0.1"});
}

TEST(SceneParticles, DomainInThePlaneStaysThere) {
    const Scene scene = scene_with({{LatticeShape{{0, 0, 0}, {5, 3, 1}}, {}}}, 2);
    const auto [low, high] = scene_domain(scene, fill_scene(scene));
    EXPECT_EQ(low[2], 0);
    EXPECT_EQ(high[2], 0);
    EXPECT_NEAR(low[1], -0.4, 1e-12);
}

class SceneFiles : public TestFolder {
protected:
    Scene with_snapshot(const Snapshot& snapshot) const {
        write_vtkhdf(snapshot, folder / "state.vtkhdf");
        return scene_with({{SnapshotShape{folder / "state.vtkhdf", {0, 10, 0}}, {1, 0, 0}}});
    }
    static Snapshot two_particles() {
        Snapshot snapshot;
        snapshot.positions = {{1, 2, 3}, {4, 5, 6}};
        set_array(snapshot, {"velocity", 3, std::vector<double>{0, 0, 0, 7, 8, 9}});
        return snapshot;
    }
};

TEST_F(SceneFiles, SnapshotGivesPositionsAndVelocities) {
    const SceneParticles particles = fill_scene(with_snapshot(two_particles()));
    EXPECT_EQ(particles.positions, (Positions{{1, 12, 3}, {4, 15, 6}}));
    EXPECT_EQ(particles.velocities, (std::vector<Place>{{1, 0, 0}, {8, 8, 9}}));
    Snapshot still;
    still.positions = {{1, 2, 3}};
    EXPECT_EQ(fill_scene(with_snapshot(still)).velocities, (std::vector<Place>{{1, 0, 0}}));
}

TEST_F(SceneFiles, NamesWhatIsWrongWithASnapshot) {
    Snapshot snapshot = two_particles();
    snapshot.positions[1][0] = std::numeric_limits<double>::quiet_NaN();
    expect_mentions(error_from(with_snapshot(snapshot)),
                    {"fluid[0]", "state.vtkhdf", "particle 1", "not finite"});
    snapshot = two_particles();
    set_array(snapshot, {"velocity", 1, std::vector<double>{0, 0}});
    expect_mentions(error_from(with_snapshot(snapshot)), {"state.vtkhdf", "velocity", "3 comp"});
    snapshot = two_particles();
    snapshot.dimension = 2;
    snapshot.positions = {{1, 2, 0}, {4, 5, 0}};
    expect_mentions(error_from(with_snapshot(snapshot)), {"state.vtkhdf", "2 dimensions"});
    std::filesystem::remove(folder / "state.vtkhdf");
    expect_mentions(error_from(scene_with({{SnapshotShape{folder / "state.vtkhdf", {}}, {}}})),
                    {"fluid[0]", "state.vtkhdf"});
}

TEST_F(SceneFiles, MeshIsScaledThenMoved) {
    write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 1 2 3 4\n");
    Scene scene = scene_with({{LatticeShape{}, {}}});
    scene.walls = {MeshShape{folder / "square.obj", 2, {10, 3, 0}}};
    const Positions walls = fill_scene(scene).walls;
    EXPECT_GT(walls.size(), 400U);
    Place low = walls[0];
    Place high = walls[0];
    for (const Place& place : walls)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], place[axis]);
            high[axis] = std::max(high[axis], place[axis]);
        }
    EXPECT_EQ(low, (Place{10, 3, 0}));
    EXPECT_EQ(high, (Place{12, 3, 2}));
    write("square.obj", "v 0 0 0\nf 1 2 3\n");
    expect_mentions(error_from(scene), {"walls[0]", "square.obj", "line 2"});
}

} // namespace
} // namespace meniscus
