// Walls keep out whatever flies at them: single particles at any speed, from any direction, into
// faces, edges and corners, at walls of every kind, and a block of fluid thrown into a corner.
#include "small_scenes.hpp"

#include "data/test_folder.hpp"

namespace meniscus {
namespace {

/// Unit vectors to the faces, edges and corners of a cube, and some between (in 2D of a square).
std::vector<Place> directions(int dimension) {
    std::vector<Place> all;
    for (const double x : {-1.0, -0.3, 0.0, 1.0})
        for (const double y : {-1.0, 0.0, 0.7, 1.0})
            for (const double z : {-1.0, 0.0, 0.2, 1.0}) {
                const double length = std::hypot(x, y, z);
                if (length > 0 && (dimension == 3 || z == 0))
                    all.push_back({x / length, y / length, z / length});
            }
    return all;
}

/// Shoots a particle from the origin in each direction and expects `inside` to hold for it until it
/// would have gone 12 spacings, once with steps after the CFL condition and once with fixed ones
/// of half a spacing.
template <class Inside>
void expect_kept(const Scene& scene, const Inside& inside) {
    SceneParticles particles = fill_scene(scene);
    particles.positions = {{0, 0, 0}};
    for (const double speed : {0.5, 1000.0})
        for (const bool fixed : {false, true})
            for (const Place& direction : directions(scene.dimension)) {
                Scene shot = scene;
                shot.time_step.min = 1e-9;
                if (fixed)
                    shot.time_step.fixed = 0.5 * scene.particle_spacing / speed;
                particles.velocities = {{}};
                for (int axis = 0; axis < 3; ++axis)
                    particles.velocities[0][axis] = speed * direction[axis];
                const auto simulation = simulate(shot, particles, 1);
                while (simulation->time() < 1.2 / speed) {
                    simulation->step(1);
                    const Place place = simulation->state().positions[0];
                    ASSERT_TRUE(inside(place))
                        << "at " << place[0] << ' ' << place[1] << ' ' << place[2] << ", speed "
                        << speed << " along " << direction[0] << ' ' << direction[1] << ' '
                        << direction[2] << (fixed ? ", fixed steps" : "");
                }
            }
}

Scene around_origin(int dimension, std::string_view solver) {
    Scene scene = drop_scene(empty_scene(dimension, solver), 1);
    scene.domain = {{{-1000, -1000, -1000}, {1000, 1000, 1000}}};
    return scene;
}

TEST(Walls, OfABoxKeepParticles) {
    for (const auto& [solver, name] : all_solvers)
        for (const int dimension : {2, 3}) {
            SCOPED_TRACE(name);
            Scene scene = around_origin(dimension, solver);
            BoxShape box;
            for (int axis = 0; axis < dimension; ++axis) {
                box.low[axis] = -0.5;
                box.high[axis] = 0.5;
            }
            scene.walls = {box};
            expect_kept(scene, [](const Place& place) {
                return std::abs(place[0]) < 0.5 && std::abs(place[1]) < 0.5 &&
                       std::abs(place[2]) < 0.5;
            });
        }
}

TEST(Walls, OfABallKeepParticles) {
    for (const int dimension : {2, 3}) {
        Scene scene = around_origin(dimension, "dfsph");
        SphereShape ball;
        for (int axis = 0; axis < dimension; ++axis)
            ball.half_axes[axis] = 0.5;
        scene.walls = {ball};
        expect_kept(scene, [](const Place& place) {
            return std::hypot(place[0], place[1], place[2]) < 0.5;
        });
    }
}

using Files = TestFolder;

TEST_F(Files, WallsOfAMeshKeepParticles) {
    Scene scene = around_origin(3, "dfsph");
    MeshShape mesh;
    mesh.file = write("octahedron.obj", "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
                                        "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\n"
                                        "f 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n");
    mesh.scale = 0.8;
    scene.walls = {mesh};
    expect_kept(scene, [](const Place& place) {
        return std::abs(place[0]) + std::abs(place[1]) + std::abs(place[2]) < 0.8;
    });
}

TEST(Walls, HoldAParticleInTheCornerOfABox) {
    for (const auto& [solver, name] : all_solvers)
        for (const int dimension : {2, 3}) {
            SCOPED_TRACE(name);
            Scene scene = around_origin(dimension, solver);
            BoxShape box;
            for (int axis = 0; axis < dimension; ++axis)
                box.high[axis] = 1;
            scene.walls = {box};
            scene.gravity = {-9.81, -9.81, dimension == 3 ? -9.81 : 0};
            std::get<SphereShape>(scene.fluid[0].shape).center = {0.5, 0.5,
                                                                  dimension == 3 ? 0.5 : 0};
            SceneParticles particles = fill_scene(scene);
            particles.positions = {{0.3, 0.3, dimension == 3 ? 0.3 : 0}};
            particles.velocities = {{}};
            const auto simulation = simulate(scene, particles, 1);
            run_until(*simulation, 2);
            const Place place = simulation->state().positions[0];
            for (int axis = 0; axis < dimension; ++axis) {
                EXPECT_GT(place[axis], 0);
                EXPECT_LT(place[axis], 0.3);
            }
            EXPECT_LT(simulation->balance().max_speed, 0.1);
        }
}

TEST(Walls, KeepABlockThatIsThrownIntoACorner) {
    for (const auto& [solver, name] : all_solvers)
        for (const int dimension : {2, 3}) {
            SCOPED_TRACE(name);
            Scene scene = around_origin(dimension, solver);
            BoxShape box;
            for (int axis = 0; axis < dimension; ++axis)
                box.high[axis] = 1.4;
            scene.walls = {box};
            BoxShape block = box_of(scene, {6, 6, 6}, {0.4, 0.4, dimension == 3 ? 0.4 : 0});
            scene.fluid = {{block, {-20, -20, dimension == 3 ? -20.0 : 0}}};
            scene.pressure.sound_speed = 300;
            if (solver == "pcisph") // at 1 it throws particles out of corners
                scene.time_step.courant_factor = 0.25;
            const auto simulation = start(scene);
            run_until(*simulation, 0.1);
            for (const Place& place : places_by_id(*simulation))
                for (int axis = 0; axis < dimension; ++axis) {
                    ASSERT_GT(place[axis], 0);
                    ASSERT_LT(place[axis], 1.4);
                }
        }
}

} // namespace
} // namespace meniscus
