// Many files in one command: what words stand for, files in parallel, reruns, and files at fault.
#include "command.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace meniscus {
namespace {

class Series : public CommandLine {
protected:
    /// Small frames, each another state: in/dam_0.vtkhdf, in/dam_1.vtkhdf, ...
    void make_frames(int count) const {
        std::filesystem::create_directories(folder / "in");
        for (int frame = 0; frame < count; ++frame) {
            Snapshot snapshot = block(4);
            snapshot.time = 0.1 * frame;
            snapshot.positions[21][0] += 0.01 * frame;
            write_vtkhdf(snapshot, folder / ("in/dam_" + std::to_string(frame) + ".vtkhdf"));
        }
    }

    [[nodiscard]] Words label(const std::string& input, const std::string& out = "out") const {
        return {"label", folder / input, "-o", folder / out, "--samples", "50"};
    }

    [[nodiscard]] Words names_in(const std::string& name) const {
        Words names;
        for (const auto& entry : std::filesystem::directory_iterator(folder / name))
            names.push_back(entry.path().filename());
        std::sort(names.begin(), names.end());
        return names;
    }

    /// The frames whose outputs a text names, in its order.
    [[nodiscard]] static Words frames_named(const std::string& text) {
        Words frames;
        for (std::size_t at = text.find("/dam_"); at != std::string::npos;
             at = text.find("/dam_", at + 1))
            frames.push_back(text.substr(at + 5, text.find(".vtkhdf", at) - at - 5));
        return frames;
    }
};

TEST_F(Series, FoldersAreTakenInTheOrderOfTheirNumbers) {
    make_frames(12);
    write_vtkhdf(block(2), folder / "in/dam_checkpoint.vtkhdf");
    write("in/dam_log.csv", "x,y,z\n0,0,0\n");
    write("in/notes.txt", "mine");
    EXPECT_EQ(frames_named(succeed(label("in"))),
              (Words{"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11"}));
}

TEST_F(Series, FoldersOfSeveralKindsAreRefused) {
    make_frames(2);
    write("in/table.csv", "x,y,z\n0,0,0\n1,0,0\n");
    fail(2, label("in"), {"in: ", "1 .csv, 2 .vtkhdf", "*.csv"});
    std::filesystem::create_directory(folder / "empty");
    fail(2, label("empty"), {"empty: ", "no snapshot"});
    fail(2, label("none"), {"none", "no such file"});
}

TEST_F(Series, PatternsThatTheShellLeaves) {
    make_frames(12);
    write_vtkhdf(block(2), folder / "in/dam_checkpoint.vtkhdf");
    write_vtkhdf(block(3), folder / "in/dam_a.vtkhdf");
    const auto frames = [&](const std::string& pattern) {
        std::filesystem::remove_all(folder / "out");
        return frames_named(succeed(label("in/" + pattern)));
    };
    EXPECT_EQ(frames("dam_{}.vtkhdf").size(), 12U);
    EXPECT_EQ(frames("dam_*.vtkhdf").size(), 13U);
    EXPECT_EQ(frames("dam_{2..4}.vtkhdf"), (Words{"2", "3", "4"}));
    EXPECT_EQ(frames("dam_{1:99:5}.vtkhdf"), (Words{"1", "6", "11"}));
    EXPECT_EQ(frames("dam_{0..10..10}.vtkhdf"), (Words{"0", "10"}));
    EXPECT_EQ(frames("dam_?.vtkhdf").size(), 11U);
    EXPECT_EQ(frames("dam_[!0-7a].vtkhdf"), (Words{"8", "9"}));
    EXPECT_EQ(frames("../in/dam_1{}.vtkhdf"), (Words{"10", "11"}));
    fail(2, label("in/dam_{20..30}.vtkhdf"), {"dam_{20..30}.vtkhdf", "no file"});
    fail(2, label("in/dam_{4..2}.vtkhdf"), {"'{4..2}'", "{0..99}"});
    fail(2, label("in/dam_{a}.vtkhdf"), {"'{a}'", "{0:99:10}"});
    fail(2, label("in/dam_{0:9:0}.vtkhdf"), {"'{0:9:0}'"});
    fail(2, label("in/dam_{0.vtkhdf"), {"'{'"});
    // A name that looks like a pattern is that of its file.
    write_vtkhdf(block(3), folder / "in/dam_{0}.vtkhdf");
    expect_mentions(succeed(label("in/dam_{0}.vtkhdf", "braces")), {"27 particles"});
}

TEST_F(Series, AFileThatIsNamedTwiceIsLabelledOnce) {
    make_frames(2);
    const Words twice = label("in") + Words{folder / "in" / "dam_1.vtkhdf"};
    EXPECT_EQ(frames_named(succeed(twice)), (Words{"0", "1"}));
}

TEST_F(Series, ManyFilesGetASummaryAndTheSameBytesAsEachAlone) {
    make_frames(25);
    const std::string printed = succeed(label("in") + Words{"--threads", "3"});
    EXPECT_EQ(frames_named(printed), Words{"0"}) << printed;
    expect_mentions(printed, {"25 files: 25 labelled; 1600 particles, "});
    for (const int frame : {0, 7, 24}) {
        const std::string name = "dam_" + std::to_string(frame) + ".vtkhdf";
        succeed(label("in/" + name, "alone"));
        EXPECT_TRUE(bytes_of(folder / "out" / name) == bytes_of(folder / "alone" / name)) << name;
    }
    expect_mentions(succeed(label("in")), {"25 files: 0 labelled, 25 up to date"});
    std::filesystem::remove(folder / "out" / "dam_3.vtkhdf");
    expect_mentions(succeed(label("in")), {"25 files: 1 labelled, 24 up to date; 64 particles"});
    EXPECT_EQ(succeed(label("in") + Words{"--quiet"}), "");
}

TEST_F(Series, ADamagedFileStopsTheOthersUnlessTold) {
    make_frames(5);
    write("in/dam_1.vtkhdf", bytes_of(folder / "in" / "dam_1.vtkhdf").substr(0, 3000));
    const Outcome stopped = run(program + label("in") + Words{"--threads", "1"});
    EXPECT_EQ(stopped.status, 2);
    expect_one_line(stopped.errors);
    expect_mentions(stopped.errors, {"dam_1.vtkhdf"});
    EXPECT_EQ(names_in("out"), Words{"dam_0.vtkhdf"});
    for (const char* threads : {"1", "2"}) {
        std::filesystem::remove_all(folder / "out");
        const Outcome outcome =
            run(program + label("in") + Words{"--keep-going", "--threads", threads});
        EXPECT_EQ(outcome.status, 2);
        EXPECT_EQ(frames_named(outcome.output), (Words{"0", "2", "3", "4"}));
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 2)
            << outcome.errors;
        expect_mentions(outcome.errors, {"dam_1.vtkhdf", "1 of 5 files could not be labelled"});
        EXPECT_EQ(names_in("out").size(), 5U); // and their series
    }
}

TEST_F(Series, FramesAreListedWithTheirTimes) {
    make_frames(11);
    const auto times = [&] {
        Words listed;
        const auto json = nlohmann::json::parse(bytes_of(folder / "out" / "dam.vtkhdf.series"));
        EXPECT_EQ(json.at("file-series-version"), "1.0");
        for (const auto& entry : json.at("files"))
            listed.push_back(entry.at("name").get<std::string>() + " " + entry.at("time").dump());
        return listed;
    };
    succeed(label("in/dam_{0..1}.vtkhdf"));
    EXPECT_EQ(times(), (Words{"dam_0.vtkhdf 0.0", "dam_1.vtkhdf 0.1"}));
    succeed(label("in/dam_10.vtkhdf"));
    EXPECT_EQ(times(), (Words{"dam_0.vtkhdf 0.0", "dam_1.vtkhdf 0.1", "dam_10.vtkhdf 1.0"}));
    std::filesystem::remove(folder / "out" / "dam_1.vtkhdf");
    succeed(label("in/dam_2.vtkhdf"));
    EXPECT_EQ(times(), (Words{"dam_0.vtkhdf 0.0", "dam_2.vtkhdf 0.2", "dam_10.vtkhdf 1.0"}));
}

TEST_F(Series, AuditAndTrainTakeFoldersToo) {
    make_frames(4);
    succeed(label("in") + Words{"--quiet"});
    const Path model = folder / "model.json";
    succeed({"train", folder / "out", "-o", model, "--quiet"});
    const Words audit = {"audit", folder / "out", "--model", model, "--format", "json"};
    const std::string report = succeed(audit + Words{"--threads", "1"});
    EXPECT_EQ(succeed(audit + Words{"--threads", "2"}), report);
    expect_mentions(report, {"dam_3.vtkhdf"});
    write("out/dam_1.vtkhdf", bytes_of(folder / "out" / "dam_1.vtkhdf").substr(0, 3000));
    fail(2, audit, {"dam_1.vtkhdf"});
    const Outcome outcome = run(program + audit + Words{"--keep-going"});
    EXPECT_EQ(outcome.status, 2);
    expect_mentions(outcome.output, {"dam_3.vtkhdf"});
    expect_mentions(outcome.errors, {"1 of 4 files could not be audited"});
}

TEST_F(Series, ClassifyLeavesFinishedFilesAlone) {
    make_frames(2);
    const Words classify = {"classify", folder / "in",
                            "--model",  Path(MENISCUS_MODELS) / "surface_3d.json",
                            "-o",       folder / "out"};
    expect_mentions(succeed(classify), {"candidates of the line"});
    const Path output = folder / "out" / "dam_1.vtkhdf";
    const std::string bytes = bytes_of(output);
    EXPECT_EQ(succeed(classify), (folder / "out" / "dam_0.vtkhdf").string() + ": up to date\n" +
                                     output.string() + ": up to date\n");
    for (const Words& other : {Words{"--paper"}, Words{"--balance-momentum"},
                               Words{"--surface-tension", "2"}, Words{"--scene", "other"}}) {
        EXPECT_EQ(succeed(classify + other).find("up to date"), std::string::npos) << other[0];
        EXPECT_FALSE(bytes_of(output) == bytes) << other[0];
    }
    succeed(classify);
    EXPECT_TRUE(bytes_of(output) == bytes);
}

} // namespace
} // namespace meniscus
