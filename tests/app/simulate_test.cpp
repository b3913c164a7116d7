// Runs small scenes with the real command: what is written, that it does not depend on threads, and
// that a run that is ended in any way goes on as if it had not been.
#include "command.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <numeric>
#include <random>
#include <sstream>
#include <unistd.h>

namespace meniscus {
namespace {

using Json = nlohmann::json;

class Simulate : public CommandLine {
protected:
    /// A block of 216 particles that begins to flow out over the floor of a small tank.
    [[nodiscard]] static Json tank() {
        return Json::parse(R"({
            "name": "tank",
            "particle_spacing": 0.1,
            "volume_share": 0.8,
            "duration": 0.1,
            "frame_interval": 0.02,
            "fluid": [{"lattice": {"first": [0.05, 0.05, 0.05], "count": [6, 6, 6]}}],
            "walls": [{"box": {"low": [-0.05, -0.05, -0.05], "high": [1.05, 1.05, 0.65],
                               "open": ["+y"]}}],
            "gravity": [0, -9.81, 0],
            "pressure": {"solver": "dfsph"},
            "viscosity": {"kinematic": 0.01},
            "surface_tension": {"model": "meniscus", "coefficient": 1},
            "time_step": {"max": 0.003},
            "variants": {
                "long": {"duration": 1},
                "flat": {"particle_spacing": 0.2, "fluid": [
                    {"lattice": {"first": [0.1, 0.1, 0.1], "count": [3, 3, 3]}}]}
            }
        })");
    }

    [[nodiscard]] Path save_scene(const Json& json) const {
        return write(json["name"].get<std::string>() + ".json", json.dump());
    }

    /// The words that simulate a scene into a folder below the test's, on one thread.
    [[nodiscard]] Words simulate(const Path& scene, const std::string& out,
                                 const Words& more = {}) const {
        return Words{"simulate", scene, "-o", folder / out, "--threads", "1"} + more;
    }

    [[nodiscard]] Words files_in(const std::string& out) const {
        Words names;
        for (const auto& entry : std::filesystem::directory_iterator(folder / out))
            names.push_back(entry.path().filename());
        std::sort(names.begin(), names.end());
        return names;
    }

    void expect_same_files(const std::string& one, const std::string& other) const {
        EXPECT_EQ(files_in(one), files_in(other));
        for (const std::string& name : files_in(one))
            EXPECT_TRUE(bytes_of(folder / one / name) == bytes_of(folder / other / name))
                << name << " differs between " << one << " and " << other;
    }

    /// The log's cells, row by row, the names of the columns first.
    [[nodiscard]] std::vector<Words> log(const Path& file) const {
        std::istringstream lines(bytes_of(file));
        std::vector<Words> rows;
        for (std::string line; std::getline(lines, line);) {
            std::istringstream cells(line);
            rows.emplace_back();
            for (std::string cell; std::getline(cells, cell, ',');)
                rows.back().push_back(cell);
        }
        return rows;
    }

    /// A column of the log as numbers.
    [[nodiscard]] std::vector<double> column(const Path& file, const std::string& name) const {
        const auto rows = log(file);
        const auto at = std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin();
        std::vector<double> numbers;
        for (std::size_t row = 1; row < rows.size(); ++row)
            numbers.push_back(std::stod(rows[row].at(at)));
        return numbers;
    }

    /// The step sizes since the last frame are not logged; the last one is in the checkpoint.
    [[nodiscard]] double last_step(const std::string& checkpoint) const {
        return Json::parse(read_vtkhdf(folder / checkpoint).provenance.at("run"))["time_step"];
    }
};

TEST_F(Simulate, WritesFramesAndALog) {
    const Path scene = save_scene(tank());
    const std::string said = succeed(simulate(scene, "out"));
    expect_mentions(said, {"tank", "216 particles", "6 frames", "0.1 s"});
    EXPECT_EQ(files_in("out"),
              (Words{"tank.vtkhdf.series", "tank_0000.vtkhdf", "tank_0001.vtkhdf",
                     "tank_0002.vtkhdf", "tank_0003.vtkhdf", "tank_0004.vtkhdf", "tank_0005.vtkhdf",
                     "tank_checkpoint.vtkhdf", "tank_files.txt", "tank_log.csv"}));
    const Path log_file = folder / "out" / "tank_log.csv";
    const std::vector<double> times = column(log_file, "time");
    ASSERT_EQ(times.size(), 6U);
    for (int frame = 0; frame < 6; ++frame) {
        const Snapshot snapshot =
            read_vtkhdf(folder / "out" / ("tank_000" + std::to_string(frame) + ".vtkhdf"));
        EXPECT_EQ(snapshot.time, frame == 5 ? 0.1 : frame * 0.02);
        EXPECT_EQ(snapshot.time, times[frame]);
        EXPECT_EQ(snapshot.scene, "tank");
        EXPECT_EQ(snapshot.size(), 216U);
        EXPECT_FALSE(snapshot.boundary.empty());
        EXPECT_EQ(snapshot.support_radius, 0.2);
        EXPECT_EQ(Json::parse(snapshot.provenance.at("scene_text"))["duration"], 0.1);
        EXPECT_NE(find_array(snapshot, "density"), nullptr);
        EXPECT_NE(find_array(snapshot, "surface_class"), nullptr);
    }
    for (const Words& row : log(log_file))
        EXPECT_EQ(row.size(), log(log_file)[0].size());
}

/// What the project is for, from end to end: a flow of our own, its exact labels, and the shipped
/// line, which misses nothing.
TEST_F(Simulate, ShippedLineMissesNothingOfAFlow) {
    succeed(simulate(save_scene(tank()), "tank", {"--duration", "0.3"}));
    succeed(simulate(Path(MENISCUS_SCENES) / "dam_break_2d.json", "dam",
                     {"--variant", "square", "--set", "particle_spacing=0.05", "--duration", "0.4",
                      "--set", "frame_interval=0.1"}));
    for (const auto& [out, frames, model, threshold] :
         {std::tuple{"tank", "tank", "surface_3d.json", "0.02"},
          std::tuple{"dam", "dam_break_2d", "surface_2d.json", "0"}}) {
        Words inputs;
        for (const std::string& name : files_in(out))
            if (name.rfind(frames + std::string("_0"), 0) == 0)
                inputs.push_back(folder / out / name);
        const Path labels = folder / (out + std::string("_labels"));
        succeed(Words{"label", "-o", labels, "--quiet"} + inputs);
        Words labelled;
        for (const auto& entry : std::filesystem::directory_iterator(labels))
            labelled.push_back(entry.path());
        const Outcome audit =
            run(program +
                Words{"audit", "--model", Path(MENISCUS_MODELS) / model, "--label-threshold",
                      threshold, "--format", "json", "--max-false-negatives", "0"} +
                labelled);
        EXPECT_EQ(audit.status, 0) << audit.output << audit.errors;
        const Json total = Json::parse(audit.output)["total"];
        EXPECT_GT(total["surface"], 200) << out;
        EXPECT_EQ(total["false_negatives_float"], 0) << out;
        EXPECT_LT(total["false_positive_rate"], 0.7) << out;
    }
}

TEST_F(Simulate, LogAgreesWithFrames) {
    succeed(simulate(save_scene(tank()), "out"));
    const Path log_file = folder / "out" / "tank_log.csv";
    const Snapshot last = read_vtkhdf(folder / "out" / "tank_0005.vtkhdf");
    const auto velocities = as_doubles(*find_array(last, "velocity"));
    const double mass = scalar_values(last, "mass")[0];
    double momentum_size = 0;
    double height = 0;
    double max = 0;
    for (std::size_t i = 0; i < last.size(); ++i) {
        const double speed =
            std::hypot(velocities[3 * i], velocities[3 * i + 1], velocities[3 * i + 2]);
        momentum_size += mass * speed;
        max = std::max(max, speed);
        height += last.positions[i][1] / 216;
    }
    EXPECT_NEAR(mass, 0.8, 1e-6);
    EXPECT_NEAR(column(log_file, "momentum_size").back(), momentum_size, 1e-5 * momentum_size);
    EXPECT_NEAR(column(log_file, "max_speed").back(), max, 1e-5 * max);
    EXPECT_NEAR(column(log_file, "center_y").back(), height, 1e-9);
    EXPECT_NEAR(column(log_file, "potential_energy").back(), 216 * mass * 9.81 * height, 1e-2);
    const auto classes = scalar_values(last, "surface_class");
    EXPECT_EQ(column(log_file, "surface_particles").back(),
              std::count(classes.begin(), classes.end(), 2));
    // Until the block touches the far wall, it falls, and flows.
    EXPECT_LT(column(log_file, "center_y").back(), column(log_file, "center_y").front());
    EXPECT_GT(column(log_file, "mean_pressure_iterations").back(), 0);
}

TEST_F(Simulate, FramesAreSnapshotsForTheOtherVerbs) {
    succeed(simulate(save_scene(tank()), "out", {"--quiet"}));
    const Snapshot labelled = read_vtkhdf(label(folder / "out" / "tank_0003.vtkhdf"));
    EXPECT_NE(find_array(labelled, "uncovered_fraction"), nullptr);
    EXPECT_EQ(labelled.scene, "tank");
}

TEST_F(Simulate, FramesOpenWithVtk) {
    succeed(simulate(save_scene(tank()), "out", {"--quiet"}));
    const std::string script = R"(
import sys
from vtkmodules.vtkIOHDF import vtkHDFReader
for name in sys.argv[1:]:
    reader = vtkHDFReader()
    reader.SetFileName(name)
    reader.Update()
    grid = reader.GetOutput()
    print(grid.GetNumberOfPoints(), grid.GetPointData().HasArray("velocity"),
          grid.GetFieldData().GetArray("time").GetValue(0)))";
    const Outcome outcome =
        run({MENISCUS_VTK_PYTHON, "-c", script, folder / "out" / "tank_0000.vtkhdf",
             folder / "out" / "tank_0005.vtkhdf", folder / "out" / "tank_checkpoint.vtkhdf"});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    expect_mentions(outcome.output, {"216 1 0.0\n", "216 1 0.1\n"});
}

TEST_F(Simulate, GivesTheSameBytesWhateverTheThreads) {
    const Path scene = save_scene(tank());
    for (const std::string solver : {"dfsph", "iisph", "pcisph"})
        for (const std::string threads : {"1", "2", "3"}) {
            const Outcome outcome =
                run(program + Words{"simulate", scene, "-o", folder / (solver + threads),
                                    "--threads", threads, "--set", "pressure.solver=" + solver,
                                    "--duration", "0.06"});
            EXPECT_EQ(outcome.status, 0) << outcome.errors;
            expect_same_files(solver + "1", solver + threads);
        }
}

TEST_F(Simulate, FramesAreMetByStepsThatAreNotTiny) {
    Json json = tank();
    json["frame_interval"] = 0.0205; // with steps of 3 ms that would leave one of 2.5 ms
    json["duration"] = 0.1;
    json["time_step"] = {{"fixed", 0.003}};
    succeed(simulate(save_scene(json), "cut"));
    const auto times = column(folder / "cut" / "tank_log.csv", "time");
    EXPECT_EQ(times, (std::vector<double>{0, 0.0205, 2 * 0.0205, 3 * 0.0205, 4 * 0.0205, 0.1}));
    const auto steps = column(folder / "cut" / "tank_log.csv", "steps");
    EXPECT_EQ(steps, (std::vector<double>{0, 7, 7, 7, 7, 6}));
    // 18 ms at last: six whole steps, and no further one of some 1e-17 s.
    EXPECT_NEAR(last_step("cut/tank_checkpoint.vtkhdf"), 0.003, 1e-12);

    json["frame_interval"] = 0.0101; // three steps of 3 ms would leave 1.1 ms: two of 2.05 ms
    json["duration"] = 0.0101;
    succeed(simulate(save_scene(json), "halved"));
    EXPECT_EQ(column(folder / "halved" / "tank_log.csv", "steps").back(), 4);
    EXPECT_NEAR(last_step("halved/tank_checkpoint.vtkhdf"), 0.00205, 1e-12);

    json["frame_interval"] = 0.001; // a frame for each part of a step
    json["duration"] = 0.01;
    succeed(simulate(save_scene(json), "short"));
    const auto short_steps = column(folder / "short" / "tank_log.csv", "steps");
    EXPECT_EQ(short_steps, (std::vector<double>{0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}));
}

TEST_F(Simulate, GoesOnAfterKillsAsIfThereWereNone) {
    const Path scene = save_scene(tank());
    std::mt19937 generator(2020);
    std::uniform_int_distribution<useconds_t> moment(10'000, 80'000);
    for (const std::string solver : {"dfsph", "iisph", "pcisph", "wcsph"}) {
        Words options = {"--set", "pressure.solver=" + solver, "--duration", "0.5"};
        if (solver == "wcsph")
            options = options + Words{"--set", "pressure.sound_speed=30"};
        succeed(simulate(scene, solver + "_undisturbed", options));
        const std::string out = solver + "_killed";
        options = options + Words{"--checkpoint-interval", "0.005"};
        int kills = 0;
        for (int attempt = 0; attempt < 15; ++attempt) {
            const pid_t process = start(program + simulate(scene, out, options));
            usleep(moment(generator));
            kill(process, SIGKILL);
            const Outcome outcome = finish(process);
            EXPECT_EQ(outcome.errors, "");
            kills += outcome.status == 128 + SIGKILL ? 1 : 0;
        }
        EXPECT_GT(kills, 1);
        succeed(simulate(scene, out, options));
        expect_same_files(solver + "_undisturbed", out);
    }
}

TEST_F(Simulate, AnInterruptLeavesACheckpoint) {
    const Path scene = save_scene(tank());
    const Words options = {"--set", "duration=1"};
    succeed(simulate(scene, "undisturbed", options));
    for (const int signal : {SIGINT, SIGTERM}) {
        const std::string out = "interrupted_" + std::to_string(signal);
        const pid_t process = start(program + simulate(scene, out, options));
        while (!std::filesystem::exists(folder / out / "tank_0004.vtkhdf"))
            usleep(1000);
        kill(process, signal);
        const Outcome outcome = finish(process);
        EXPECT_EQ(outcome.status, 130);
        EXPECT_EQ(outcome.errors, "meniscus: interrupted\n");
        EXPECT_GE(read_vtkhdf(folder / out / "tank_checkpoint.vtkhdf").time.value_or(0), 0.08);
        EXPECT_FALSE(std::filesystem::exists(folder / out / "tank_0050.vtkhdf"));
        expect_mentions(succeed(simulate(scene, out, options)), {"from 0."});
        expect_same_files("undisturbed", out);
    }
}

TEST_F(Simulate, AFinishedRunIsLeftAlone) {
    const Path scene = save_scene(tank());
    succeed(simulate(scene, "out"));
    const auto written = std::filesystem::last_write_time(folder / "out" / "tank_log.csv");
    expect_mentions(succeed(simulate(scene, "out")), {"finished already", "6 frames", "--restart"});
    EXPECT_EQ(std::filesystem::last_write_time(folder / "out" / "tank_log.csv"), written);
}

TEST_F(Simulate, AnotherSceneDoesNotGoOn) {
    const Path scene = save_scene(tank());
    succeed(simulate(scene, "out"));
    fail(2, simulate(scene, "out", {"--duration", "0.04"}),
         {"tank_checkpoint.vtkhdf", "/duration", "0.1", "0.04", "--restart"});
    fail(2, simulate(scene, "out", {"--variant", "flat"}), {"another scene", "--restart"});
    succeed(simulate(scene, "out", {"--duration", "0.04", "--restart"}));
    succeed(simulate(scene, "fresh", {"--duration", "0.04"}));
    expect_same_files("out", "fresh"); // nothing of the longer run stayed
}

TEST_F(Simulate, DamagedCheckpointsAreRefused) {
    const Path scene = save_scene(tank());
    succeed(simulate(scene, "out", {"--duration", "0.02"}));
    const Path checkpoint = folder / "out" / "tank_checkpoint.vtkhdf";
    const std::string bytes = bytes_of(checkpoint);
    const Words again = simulate(scene, "out", {"--duration", "0.02"});
    for (const std::string& damaged :
         {std::string(), std::string("no HDF5 at all"), bytes.substr(0, bytes.size() / 2),
          bytes.substr(0, bytes.size() - 1), bytes_of(folder / "out" / "tank_0001.vtkhdf")}) {
        write("out/tank_checkpoint.vtkhdf", damaged);
        fail(2, again, {"tank_checkpoint.vtkhdf", "--restart"});
    }
    Snapshot changed = read_vtkhdf(write("whole.vtkhdf", bytes));
    std::get<std::vector<double>>(changed.point_data[1].values)[5] = NAN;
    write_vtkhdf(changed, checkpoint);
    fail(2, again, {"tank_checkpoint.vtkhdf", "SHA-256", "--restart"});
    changed = read_vtkhdf(folder / "whole.vtkhdf");
    changed.provenance["program"] = "meniscus 0.0";
    write_vtkhdf(changed, checkpoint);
    fail(2, again, {"tank_checkpoint.vtkhdf", "meniscus 0.0", "--restart"});
    changed = read_vtkhdf(folder / "whole.vtkhdf");
    changed.provenance["log"].back() = ' ';
    write_vtkhdf(changed, checkpoint);
    fail(2, again, {"tank_checkpoint.vtkhdf", "SHA-256", "--restart"});
    succeed(again + Words{"--restart"});
    EXPECT_TRUE(bytes_of(checkpoint) == bytes);
}

TEST_F(Simulate, FramesWithoutACheckpointAreNotWrittenOver) {
    const Path scene = save_scene(tank());
    succeed(simulate(scene, "out", {"--duration", "0.02"}));
    std::filesystem::remove(folder / "out" / "tank_checkpoint.vtkhdf");
    fail(2, simulate(scene, "out"), {"tank_0000.vtkhdf", "no checkpoint", "--restart"});
}

TEST_F(Simulate, RestartRemovesOnlyItsOwn) {
    const Path scene = save_scene(tank());
    std::filesystem::create_directory(folder / "out");
    for (const char* name : {"tank_000.vtkhdf", "tank_0001.vtk", "tank_0001b.vtkhdf",
                             "other_tank_0001.vtkhdf", "tank_notes.txt"})
        write(std::string("out/") + name, "mine");
    const Words before = files_in("out");
    succeed(simulate(scene, "out", {"--duration", "0.02", "--restart"}));
    for (const std::string& name : before)
        EXPECT_EQ(bytes_of(folder / "out" / name), "mine") << name;
}

TEST_F(Simulate, ADivergingRunSaysWhereAndKeepsItsFrames) {
    Json json = tank();
    json["pressure"] = {{"solver", "wcsph"}, {"sound_speed", 20}};
    json["time_step"] = {{"fixed", 0.04}};
    json["duration"] = 1;
    const Outcome outcome = run(program + simulate(save_scene(json), "out"));
    EXPECT_EQ(outcome.status, 3);
    expect_mentions(outcome.errors, {"warning", "fixed time step, 0.04 s, is longer than 0.004 s"});
    Words frames;
    for (const std::string& name : files_in("out"))
        if (name.rfind("tank_0", 0) == 0)
            frames.push_back(name);
    expect_mentions(outcome.errors, {"diverged", " s (step", "particle", "smaller time step",
                                     (folder / "out" / frames.back()).c_str()});
    EXPECT_EQ(log(folder / "out" / "tank_log.csv").size(), frames.size() + 1);
    EXPECT_EQ(read_vtkhdf(folder / "out" / frames.back()).size(), 216U);
}

TEST_F(Simulate, WrongScenesAndOptionsAreNamed) {
    const Path scene = save_scene(tank());
    fail(2, simulate(folder / "none.json", "out"), {"none.json"});
    fail(2, simulate(write("text.json", "no scene"), "out"), {"text.json"});
    fail(2, simulate(scene, "out", {"--variant", "lon"}), {"'lon'", "'long'", "flat"});
    fail(2, simulate(scene, "out", {"--set", "pressure.solver=dfsp"}),
         {"pressure.solver", "dfsp", "did you mean 'dfsph'"});
    fail(2, simulate(scene, "out", {"--set", "presure.solver=dfsph"}),
         {"'presure'", "did you mean 'pressure'"});
    fail(2, simulate(scene, "out", {"--set", "pressure=null"}), {"'pressure'", "missing"});
    for (const char* change : {"duration", "=1", ".duration=1", "pressure..solver=iisph"})
        fail(2, simulate(scene, "out", {"--set", change}), {change, "key=value"});
    for (const char* duration : {"0", "-1", "soon", "nan", "1e999"})
        fail(2, simulate(scene, "out", {"--duration", duration}), {"'duration'"});
    fail(2, simulate(scene, "out", {"--checkpoint-interval", "-1"}), {"--checkpoint-interval"});
    fail(2, {"simulate", scene, "-o", folder / "out", "--threads", "-1"}, {"--threads"});
    fail(2, {"simulate", scene}, {"--output"});
}

TEST_F(Simulate, ChangesAreThoseOfTheScene) {
    const Path scene = save_scene(tank());
    Json json = tank();
    json["duration"] = 0.04;
    json["pressure"]["solver"] = "iisph";
    json["gravity"] = {0, -1, 0};
    json.erase("surface_tension");
    std::filesystem::create_directory(folder / "changed");
    const Path changed = write("changed/tank.json", json.dump());
    succeed(simulate(changed, "by_file"));
    succeed(simulate(scene, "by_option",
                     {"--set", "pressure.solver=iisph", "--set", "gravity=[0, -1, 0]", "--set",
                      "surface_tension=null", "--duration", "0.04"}));
    expect_same_files("by_file", "by_option");
}

TEST_F(Simulate, AnotherMethodLeavesOutWhatItDoesNotRead) {
    Json json = tank();
    json["pressure"]["divergence_error"] = 0.001;
    json["surface_tension"]["samples"] = 64;
    json["duration"] = 0.02;
    const Path scene = save_scene(json);
    expect_mentions(succeed(simulate(scene, "iisph", {"--set", "pressure.solver=iisph"})),
                    {"pressure.divergence_error is left out", "solver iisph"});
    fail(2,
         simulate(scene, "no",
                  {"--set", "pressure.solver=iisph", "--set", "pressure.divergence_error=0.01"}),
         {"divergence_error", "iisph"});
    fail(2, simulate(scene, "no", {"--set", "pressure.solver=wcsph"}),
         {"wcsph", "--set pressure.sound_speed=VALUE"});
    // A coefficient is one of its model.
    const Words akinci = {"--set", "surface_tension.model=akinci_2013"};
    fail(2, simulate(scene, "no", akinci),
         {"meniscus (sigma in N/m)", "akinci_2013", "--set surface_tension.coefficient=VALUE"});
    expect_mentions(succeed(simulate(scene, "akinci",
                                     akinci + Words{"--set", "surface_tension.coefficient=1"})),
                    {"surface_tension.samples is left out", "akinci_2013"});
    const Path frame = folder / "akinci" / "tank_0001.vtkhdf";
    expect_mentions(read_vtkhdf(frame).provenance.at("scene_text"), {"akinci_2013"});
}

TEST_F(Simulate, ScenesThatShipHaveNames) {
    fail(2, simulate("dam_brake", "no"), {"dam_brake", "did you mean 'dam_break'?", "drop_2d"});
    fail(2, simulate("drop_2d", "no", {"--variant", "none"}), {"drop_2d.json", "no variant"});
    for (const char* solver : {"iisph", "pcisph"})
        fail(2,
             simulate("dam_break", "no",
                      {"--set", std::string("pressure.solver=") + solver, "--duration", "-1"}),
             {"'duration'"}); // and not the solver
}

TEST_F(Simulate, TakesAModelFile) {
    const Path models = MENISCUS_MODELS;
    std::filesystem::copy(models / "surface_3d.json", folder / "line.json");
    Json json = tank();
    succeed(simulate(save_scene(json), "shipped"));
    json["name"] = "own";
    json["surface_tension"]["model_file"] = "line.json"; // beside the scene
    const Path scene = save_scene(json);
    succeed(simulate(scene, "own"));
    EXPECT_EQ(read_vtkhdf(folder / "own" / "own_0005.vtkhdf").positions,
              read_vtkhdf(folder / "shipped" / "tank_0005.vtkhdf").positions);
    const auto refused = [&](const Words& changes, std::initializer_list<const char*> mentions) {
        fail(2, simulate(scene, "no", changes), mentions);
    };
    const auto model = [](const Path& file) {
        return Words{"--set", "surface_tension.model_file=" + file.string()};
    };
    refused(model(models / "surface_2d.json"), {"surface_2d.json", "2D", "'own'"});
    refused(model(models / "surface_3d_wide.json"),
            {"surface_3d_wide.json", "h / particle spacing"});
    refused(model("none.json"), {"none.json"});
    refused({"--set", "surface_tension.boundary_weight=1"}, {"boundary_weight", "model_file"});
}

TEST_F(Simulate, QuietSaysNothing) {
    EXPECT_EQ(succeed(simulate(save_scene(tank()), "out", {"--quiet"})), "");
}

TEST_F(Simulate, ProgressIsShownOnATerminal) {
    if (run({"script", "-qec", "true", "/dev/null"}).status != 0)
        GTEST_SKIP() << "this machine has no terminals to open (no /dev/pts)";
    const Path scene = save_scene(tank());
    const auto on_terminal = [&](const Words& more) {
        std::string words;
        for (const std::string& word : program + simulate(scene, "out", more))
            words += "'" + word + "' ";
        return run({"script", "-qec", words, "/dev/null"});
    };
    const Outcome shown = on_terminal({"--duration", "0.06"});
    EXPECT_EQ(shown.status, 0) << shown.output;
    expect_mentions(shown.output, {" / 0.06 s (", "step ", "iterations", "4 frames"});
    EXPECT_EQ(on_terminal({"--duration", "0.06", "--quiet", "--restart"}).output, "");
}

TEST_F(Simulate, ProfileHasTheStages) {
    const Path scene = save_scene(tank());
    const Path profile = folder / "profile.json";
    succeed(simulate(scene, "out", {"--profile", profile}));
    const Json json = Json::parse(bytes_of(profile));
    double steps = 0;
    for (const double count : column(folder / "out" / "tank_log.csv", "steps"))
        steps += count;
    EXPECT_EQ(json["steps"], steps);
    EXPECT_EQ(json["particles"], 216);
    EXPECT_EQ(json["threads"], 1);
    EXPECT_NEAR(json["simulated_seconds"], 0.1, 1e-9);
    double sum = 0;
    for (const char* stage : {"sort", "neighbors", "density", "surface_tension", "viscosity",
                              "divergence", "pressure", "motion"}) {
        EXPECT_GT(json["mean_milliseconds"][stage], 0) << stage;
        sum += json["mean_milliseconds"][stage].get<double>();
    }
    EXPECT_GE(json["mean_milliseconds"]["total"], sum);
    fail(2, simulate(scene, "other", {"--profile", folder / "none" / "p.json"}), {"none"});
}

} // namespace
} // namespace meniscus
