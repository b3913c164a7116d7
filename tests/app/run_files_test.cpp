// What becomes of files: a run writes over and removes what its own record lists and nothing else,
// notices what was lost, and is alone in its folder.
#include "command.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <unistd.h>

namespace meniscus {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class RunFiles : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        scene = write("tank.json", tank().dump());
    }

    /// A small block that falls for three frames.
    [[nodiscard]] static Json tank() {
        return Json::parse(R"({
            "name": "tank", "particle_spacing": 0.1, "duration": 0.04, "frame_interval": 0.02,
            "fluid": [{"lattice": {"first": [0, 0, 0], "count": [4, 4, 4]}}],
            "gravity": [0, -9.81, 0], "pressure": {"solver": "dfsph"},
            "time_step": {"max": 0.005}})");
    }

    /// The same from a snapshot.
    [[nodiscard]] Path tank_from(const Path& snapshot) const {
        Json json = tank();
        json["fluid"] = {{{"snapshot", {{"file", snapshot.string()}}}}};
        return write("next.json", json.dump());
    }

    [[nodiscard]] Words simulate(const Words& more = {}) const {
        return Words{"simulate", scene, "-o", out, "--threads", "1"} + more;
    }

    [[nodiscard]] Words simulate(const Path& other, const Words& more) const {
        return Words{"simulate", other, "-o", out, "--threads", "1"} + more;
    }

    [[nodiscard]] Path frame(int number) const {
        return out / ("tank_000" + std::to_string(number) + ".vtkhdf");
    }

    const Path out = folder / "out";
    Path scene;
};

TEST_F(RunFiles, NoOutputOfARunIsItsInput) {
    succeed(simulate());
    const std::string bytes = bytes_of(frame(2));
    fs::create_directory_symlink(out, folder / "link");
    fs::create_symlink(frame(2), folder / "linked.vtkhdf");
    fs::create_hard_link(frame(2), folder / "same.vtkhdf");
    for (const Path& name :
         {frame(2), folder / "link" / "tank_0002.vtkhdf", out / ".." / "out" / "tank_0002.vtkhdf",
          folder / "linked.vtkhdf", folder / "same.vtkhdf"}) {
        const Path next = tank_from(name);
        fail(2, simulate(next, {}), {name.c_str(), "would overwrite", "-o"});
        fail(2, simulate(next, {"--restart"}), {name.c_str(), "would overwrite", "-o"});
    }
    EXPECT_TRUE(bytes_of(frame(2)) == bytes);
    for (const Path& file : {out / "tank_log.csv", out / "tank_checkpoint.vtkhdf",
                             out / "tank_files.txt", frame(1), folder / "link" / "tank_log.csv"})
        fail(2, simulate({"--restart", "--profile", file}), {file.c_str(), "--profile"});
    fail(2, simulate({"--profile", scene}), {"tank.json", "overwrite"});
    // Another name, or frames that the run does not come to, are in nobody's way.
    fs::rename(frame(2), out / "tank_0007.vtkhdf");
    succeed(simulate(tank_from(out / "tank_0007.vtkhdf"), {"--restart"}));
    EXPECT_TRUE(bytes_of(out / "tank_0007.vtkhdf") == bytes);
}

TEST_F(RunFiles, RestartRemovesNoFrameThatTheSceneStartsFrom) {
    succeed(simulate());
    const std::string bytes = bytes_of(frame(2));
    Json shorter = Json::parse(bytes_of(tank_from(frame(2))));
    shorter["duration"] = 0.02; // writes no frame of that number
    const Path next = write("next.json", shorter.dump());
    fail(2, simulate(next, {"--restart"}), {"tank_0002.vtkhdf", "--restart would remove it"});
    EXPECT_EQ(bytes_of(frame(2)), bytes);
}

TEST_F(RunFiles, RestartRemovesWhatTheRecordLists) {
    succeed(simulate({"--duration", "0.06"}));
    const Path theirs = write("out/tank_20200613.vtkhdf", "mine");
    succeed(simulate({"--restart"}));
    EXPECT_EQ(bytes_of(theirs), "mine");
    EXPECT_FALSE(fs::exists(frame(3)));
    const std::string bytes = bytes_of(frame(1));
    write("out/tank_0001.vtkhdf", bytes.substr(0, 100)); // damaged, but still of the run
    succeed(simulate({"--restart"}));
    EXPECT_TRUE(bytes_of(frame(1)) == bytes);
    const Path replaced = save(block(3), "out/tank_0001.vtkhdf"); // whole, and of somebody else
    fail(2, simulate({"--restart"}), {"tank_0001.vtkhdf", "not what the run wrote"});
    EXPECT_EQ(read_vtkhdf(replaced).size(), 27U);
    EXPECT_TRUE(fs::exists(frame(2)));
}

TEST_F(RunFiles, WhatNoRecordListsIsInTheWay) {
    fs::create_directory(out);
    for (const char* name : {"tank_0001.vtkhdf", "tank_log.csv", "tank_checkpoint.vtkhdf"}) {
        const Path file = write(std::string("out/") + name, "mine");
        fail(2, simulate({"--restart"}), {name, "move it away"});
        if (std::string(name) != "tank_checkpoint.vtkhdf")
            fail(2, simulate(), {name, "move it away"});
        EXPECT_EQ(bytes_of(file), "mine");
        fs::remove(file);
    }
    write("out/tank_files.txt", "notes of mine\n");
    fail(2, simulate({"--restart"}), {"tank_files.txt", "no record", "notes of mine"});
}

TEST_F(RunFiles, OneRunAtATimeIsAtWork) {
    const Words longer =
        simulate({"--duration", "100", "--checkpoint-interval", "0", "--set", "gravity=[0,0,0]"});
    const pid_t first = start(program + longer);
    while (!fs::exists(frame(1)))
        usleep(1000);
    for (const Words& more : {Words{}, {"--restart"}, {"--set", "gravity=[0,-5,0]"}}) {
        const Path said = folder / "said";
        const std::string words = "\"$@\" 2> " + said.string();
        const pid_t second = start(Words{"sh", "-c", words, "sh"} + program + longer + more);
        EXPECT_EQ(finish(second).status, 3);
        expect_mentions(bytes_of(said), {"tank_files.txt", "another run", "-o"});
    }
    kill(first, SIGKILL);
    finish(first);
    succeed(simulate({"--duration", "0.02", "--restart"})); // its lock went with it
    EXPECT_EQ(read_vtkhdf(out / "tank_checkpoint.vtkhdf").time, 0.02);
    EXPECT_FALSE(fs::exists(frame(2)));
}

TEST_F(RunFiles, LossIsNoticedWhenARunGoesOn) {
    succeed(simulate());
    const fs::path whole = folder / "whole";
    fs::copy(out, whole, fs::copy_options::recursive);
    const auto restored = [&] {
        fs::remove_all(out);
        fs::copy(whole, out, fs::copy_options::recursive);
    };
    std::string flipped = bytes_of(frame(1));
    flipped[flipped.size() / 2] ^= 1;
    const std::pair<const char*, std::string> damages[] = {
        {"tank_0001.vtkhdf", ""},
        {"tank_0001.vtkhdf", bytes_of(frame(1)).substr(0, 100)},
        {"tank_0001.vtkhdf", flipped},
        {"tank_log.csv", ""},
        {"tank_log.csv", "frame,time\n"}};
    bool goes_on = false; // a finished run, or one that is to be longer
    for (const auto& [name, bytes] : damages) {
        const Words more = goes_on ? Words{"--duration", "0.06"} : Words{};
        goes_on = !goes_on;
        restored();
        fs::remove(out / name);
        if (!bytes.empty())
            write(std::string("out/") + name, bytes);
        fail(2, simulate(more), {name, "--accept-loss", "--restart"});
        succeed(simulate(more + Words{"--accept-loss"}));
        succeed(simulate(more)); // accepted once and for all
        EXPECT_EQ(bytes_of(out / "tank_log.csv").rfind(bytes_of(whole / "tank_log.csv"), 0), 0U);
    }
    restored();
    for (const int number : {0, 1, 2})
        fs::remove(frame(number));
    fs::remove(out / "tank_log.csv");
    fail(2, simulate(), {"tank_0000.vtkhdf: is missing, tank_0001.vtkhdf is missing", "1 more"});
    succeed(simulate({"--restart"}));
    EXPECT_TRUE(bytes_of(frame(1)) == bytes_of(whole / "tank_0001.vtkhdf"));
}

TEST_F(RunFiles, ALongerDurationGoesOn) {
    succeed(simulate({"--duration", "0.02"}));
    expect_mentions(succeed(simulate({"--duration", "0.06"})), {"from 0.02 s on", "4 frames"});
    const Path other = folder / "other";
    succeed({"simulate", scene, "-o", other, "--threads", "1", "--duration", "0.06"});
    EXPECT_EQ(bytes_of(out / "tank_log.csv"), bytes_of(other / "tank_log.csv"));
    EXPECT_TRUE(bytes_of(frame(3)) == bytes_of(other / "tank_0003.vtkhdf"));
    fail(2, simulate({"--duration", "0.02"}), {"another scene", "/duration", "0.06"});
    fail(2, simulate({"--duration", "0.08", "--set", "gravity=[0,-5,0]"}), {"another scene"});
    succeed(simulate({"--duration", "0.05", "--restart"}));
    fail(2, simulate({"--duration", "0.08"}), {"ended at 0.05 s", "--restart"});
}

/// A floor of one triangle, some four million wall particles.
Path save_floor(const Path& folder) {
    std::ofstream(folder / "floor.obj") << "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n";
    Json json = {{"name", "floor"},
                 {"particle_spacing", 0.001},
                 {"duration", 0.001},
                 {"frame_interval", 0.001},
                 {"fluid", {{{"lattice", {{"first", {0, 0, 1}}, {"count", {2, 2, 2}}}}}}},
                 {"pressure", {{"solver", "dfsph"}}},
                 {"walls", {{{"mesh", {{"file", "floor.obj"}}}}}}};
    std::ofstream(folder / "floor.json") << json.dump();
    return folder / "floor.json";
}

TEST_F(RunFiles, AnInterruptIsHeardWhileASceneIsFilled) {
    const pid_t process = start(program + simulate(save_floor(folder), {}));
    while (!fs::exists(out))
        usleep(1000);
    usleep(100'000); // into the middle of what takes seconds
    kill(process, SIGINT);
    const Outcome outcome = finish(process);
    EXPECT_EQ(outcome.status, 130);
    EXPECT_EQ(outcome.errors, "meniscus: interrupted\n");
    EXPECT_TRUE(fs::is_empty(out));
}

TEST_F(RunFiles, ASceneThatDoesNotFitIsRefusedBeforehand) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the address sanitizer itself needs more than the limit";
#endif
    const Words limited = {"sh", "-c", "ulimit -v 1000000 && exec \"$@\"", "sh"};
    fail_as(3, limited + program + simulate(save_floor(folder), {}),
            {"'floor'", "8 fluid and 4.09e+06 wall particles", "1.02 GB", "particle_spacing"});
    const Words huge = {"--set", "particle_spacing=0.00001", "--set",
                        R"(fluid=[{"box": {"low": [0, 0, 0], "high": [1, 1, 1]}}])"};
    fail(2, simulate(scene, huge), {"fluid[0]", "1e+15", "5e+08"});
    const Words dense = {"--set", "support_radius=1", "--set",
                         R"(fluid=[{"lattice": {"first": [0, 0, 0], "count": [13, 13, 13]}}])"};
    fail(2, simulate(scene, dense), {"'support_radius'", "0.6", "found 1"});
}

} // namespace
} // namespace meniscus
