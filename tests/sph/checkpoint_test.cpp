// A checkpoint comes back as it was, or not at all: no damage to its file goes unnoticed.
#include "small_scenes.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/sph/run/checkpoint.hpp>
#include <meniscus/sph/run/run.hpp>

#include "data/test_folder.hpp"

#include <cstring>
#include <functional>
#include <random>

namespace meniscus {
namespace {

class Checkpoints : public TestFolder {
protected:
    static Scene scene() {
        Scene scene = drop_scene(empty_scene(3, "dfsph"), 1.5);
        scene.fluid[0].velocity = {0.3, 0.1, -0.7};
        return scene;
    }

    static Checkpoint some_checkpoint() {
        const auto simulation = start(scene());
        simulation->step(1);
        Checkpoint checkpoint;
        checkpoint.state = simulation->state();
        checkpoint.next_frame = 3;
        checkpoint.usual_step = 0.1;
        checkpoint.since_frame.steps = 7;
        checkpoint.since_frame.time = 1.0 / 3;
        checkpoint.log = "frame,time\n0,0.0\n";
        return checkpoint;
    }

    [[nodiscard]] std::filesystem::path written(const Checkpoint& checkpoint) const {
        write_checkpoint(checkpoint, scene(), scene_text(scene()), folder / "c.vtkhdf");
        return folder / "c.vtkhdf";
    }

    static Checkpoint read(const std::filesystem::path& file) {
        return read_checkpoint(file, scene_text(scene()));
    }

    static bool same(const Checkpoint& a, const Checkpoint& b) {
        return a.state.time == b.state.time && a.state.steps == b.state.steps &&
               a.state.time_step == b.state.time_step && a.state.ids == b.state.ids &&
               a.state.positions == b.state.positions && a.state.velocities == b.state.velocities &&
               a.state.pressures == b.state.pressures &&
               a.state.divergences == b.state.divergences && a.next_frame == b.next_frame &&
               a.usual_step == b.usual_step && a.since_frame.steps == b.since_frame.steps &&
               a.since_frame.time == b.since_frame.time && a.log == b.log;
    }
};

TEST_F(Checkpoints, AreThoseOfALongerSceneToo) {
    const auto file = written(some_checkpoint());
    Scene longer = scene();
    longer.duration *= 2;
    EXPECT_EQ(read_checkpoint(file, scene_text(longer)).duration, scene().duration);
    Scene shorter = scene();
    shorter.duration /= 2;
    expect_mentions(error_of<InputError>([&] { read_checkpoint(file, scene_text(shorter)); }),
                    {"c.vtkhdf", "another scene", "/duration"});
    longer.rest_density *= 2;
    expect_mentions(error_of<InputError>([&] { read_checkpoint(file, scene_text(longer)); }),
                    {"another scene"});
}

TEST_F(Checkpoints, ComeBack) {
    const Checkpoint checkpoint = some_checkpoint();
    EXPECT_TRUE(same(read(written(checkpoint)), checkpoint));
}

TEST_F(Checkpoints, FlippedBitsAreNoticedOrDoNoHarm) {
    const Checkpoint checkpoint = some_checkpoint();
    const auto file = written(checkpoint);
    const std::string bytes = bytes_of(file);
    std::mt19937 random(5);
    int refused = 0;
    for (int n = 0; n < 150; ++n) {
        std::string damaged = bytes;
        damaged[random() % bytes.size()] ^= static_cast<char>(1U << random() % 8);
        write("c.vtkhdf", damaged);
        try { // what HDF5 leaves unused may change
            EXPECT_TRUE(same(read(file), checkpoint)) << n;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("--restart"), std::string::npos)
                << error.what();
            ++refused;
        }
    }
    EXPECT_GT(refused, 50);
}

TEST_F(Checkpoints, AFlippedBitOfASmallArrayIsNoticed) {
    const Checkpoint checkpoint = some_checkpoint(); // arrays below 1 kB have no sum of HDF5's own
    const auto file = written(checkpoint);
    std::string bytes = bytes_of(file);
    std::string velocity(sizeof(double), '\0');
    std::memcpy(velocity.data(), &checkpoint.state.velocities[3][1], sizeof(double));
    for (const std::string& part : {velocity, checkpoint.log, std::string("\"next_frame\":3")}) {
        const std::size_t at = bytes.find(part);
        ASSERT_NE(at, std::string::npos);
        std::string damaged = bytes;
        damaged[at + part.size() - 1] ^= 1;
        write("c.vtkhdf", damaged);
        const std::string message = error_of<InputError>([&] { read(file); });
        expect_mentions(message, {"c.vtkhdf", "damaged", "--restart"});
        if (part == velocity)
            expect_mentions(message, {"SHA-256"});
    }
}

TEST_F(Checkpoints, ThoseOfDeepScenesAreNoCrash) {
    const std::string deep = std::string(200'000, '[') + std::string(200'000, ']');
    write_checkpoint(some_checkpoint(), scene(), deep, folder / "c.vtkhdf");
    expect_mentions(error_of<InputError>([&] { read(folder / "c.vtkhdf"); }),
                    {"c.vtkhdf", "another scene", "cannot be read", "--restart"});
}

TEST_F(Checkpoints, ThoseOfNoRunAreRefused) {
    Scene runs = scene();
    runs.name = "drop";
    runs.frame_interval = 0.01;
    runs.duration = 0.02;
    RunOptions options;
    options.folder = folder;
    options.threads = 1;
    const auto message = [&](const std::function<void(Checkpoint&)>& change) {
        Checkpoint checkpoint;
        checkpoint.state = start(runs)->state();
        checkpoint.log = log_header({});
        change(checkpoint);
        write_checkpoint(checkpoint, runs, scene_text(runs), checkpoint_file(runs, folder));
        return error_of<InputError>([&] { run_scene(runs, options); });
    };
    const std::pair<const char*, std::function<void(Checkpoint&)>> changes[] = {
        {"a time of", [](Checkpoint& at) { at.state.time = -1e9; }},
        {"a time of", [](Checkpoint& at) { at.state.time = 1e9; }},
        {"4 frames", [](Checkpoint& at) { at.next_frame = 4; }},
        {"1000000000000000 frames", [](Checkpoint& at) { at.next_frame = 1'000'000'000'000'000; }},
        {"a time of", [](Checkpoint& at) { at.next_frame = 2; }},
        {"a time step of", [](Checkpoint& at) { at.usual_step = -1; }},
        {"a time step of", [](Checkpoint& at) { at.usual_step = 1e9; }},
        {"sums", [](Checkpoint& at) { at.since_frame.steps = 1; }},
        {"sums", [](Checkpoint& at) { at.since_frame.unconverged_steps = 1; }},
        {"sums", [](Checkpoint& at) { at.since_frame.time = -1; }},
        {"log", [](Checkpoint& at) { at.log = "something else\n"; }},
        {"log", [](Checkpoint& at) { at.log += "0,\x1b[31m\n"; }},
        {"log", [](Checkpoint& at) { at.log += "a row of no frame\n"; }}};
    for (const auto& [part, change] : changes)
        expect_mentions(message(change), {"drop_checkpoint", "damaged", part, "--restart"});
}

} // namespace
} // namespace meniscus
