#include "command.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace meniscus {
namespace {

class Bench : public CommandLine {
protected:
    /// Measures as little as can be, and returns what the report says.
    [[nodiscard]] nlohmann::json measure(const Words& words) const {
        const std::string printed = succeed(
            Words{"bench", "-o", folder / "out", "--repetitions", "1", "--threads", "1"} + words);
        nlohmann::json report =
            nlohmann::json::parse(bytes_of(folder / "out" / "speed_against_error.json"));
        for (const auto& table : report["tables"])
            expect_mentions(printed, {table["title"].get<std::string>().c_str()});
        return report;
    }

    [[nodiscard]] bool exists(const std::string& name) const {
        return std::filesystem::exists(folder / "out" / name);
    }
};

const nlohmann::json& row_of(const nlohmann::json& table, const std::string& key,
                             const std::string& value) {
    for (const auto& row : table["rows"])
        if (row[key] == value)
            return row;
    ADD_FAILURE() << "no row with " << key << " " << value;
    return table["rows"][0];
}

TEST_F(Bench, DetectorsAndFeatures) {
    const auto report = measure({save(block(9), "block.vtkhdf"), sample("cube_iisph_05"),
                                 "--tables", "detectors,features"});
    EXPECT_EQ(report["states"][0]["name"], "block");
    EXPECT_EQ(report["states"][0]["particles"], 729);
    EXPECT_EQ(report["threads"], 1);
    EXPECT_GE(report["machine"]["cores"].get<int>(), 1);
    EXPECT_FALSE(report["machine"]["compiler"].get<std::string>().empty());
    ASSERT_EQ(report["tables"].size(), 3U);
    const auto& detectors = report["tables"][0];
    EXPECT_EQ(detectors["name"], "detectors_3d");
    const auto& exact = row_of(detectors, "detector", "exact test");
    EXPECT_EQ(exact["false_negatives"], 0);
    EXPECT_EQ(exact["false_positive_rate"], 0);
    EXPECT_EQ(row_of(detectors, "best", "yes")["best"], "yes");
    EXPECT_GT(row_of(detectors, "group", "visibility")["time"]["median"].get<double>(), 0);
    for (const char* file :
         {"detectors_3d.md", "detectors_3d_missed.svg", "detectors_3d_false_positives.svg",
          "features_3d.md", "features_3d.svg", "features_3d_2_percent.md"})
        EXPECT_TRUE(exists(file)) << file;
    const std::string text = bytes_of(folder / "out" / "detectors_3d.md");
    EXPECT_EQ(text.rfind("| detector |", 0), 0U) << text;
    expect_mentions(text, {"](detectors_3d_missed.svg)"});
}

TEST_F(Bench, InTwoDimensions) {
    const auto report = measure({"--tables", "detectors", save(block(20, 2), "square.vtkhdf")});
    EXPECT_EQ(report["tables"][0]["name"], "detectors_2d");
    EXPECT_TRUE(exists("detectors_2d_missed.svg"));
}

TEST_F(Bench, ShiftedLines) {
    const auto report = measure({save(block(4), "block.vtkhdf"), "--tables", "line"});
    EXPECT_EQ(report["tables"][0]["name"], "line_shift");
    EXPECT_TRUE(exists("line_shift_false_negatives.svg"));
}

TEST_F(Bench, QuietPrintsNothing) {
    EXPECT_EQ(succeed({"bench", save(block(4), "block.vtkhdf"), "-o", folder / "out", "--tables",
                       "detectors", "--repetitions", "1", "--threads", "1", "--quiet"}),
              "");
    EXPECT_TRUE(exists("speed_against_error.json"));
}

TEST_F(Bench, ReportIsOnePageWithTablesAndPlots) {
    const Json result = measure(
        {save(block(4), "block.vtkhdf"), "--tables", "line", "--report", folder / "page.html"});
    EXPECT_FALSE(result.empty());
    const std::string page = bytes_of(folder / "page.html");
    EXPECT_EQ(page.rfind("<!doctype html>", 0), 0U);
    expect_mentions(page, {"<h1>Speed against error</h1>", "<th><button>d</button></th>", "<svg",
                           "1 states, 64 particles", "</html>"});
    EXPECT_EQ(page.find("http"), page.find("http://www.w3.org/2000/svg")); // asks no network
    EXPECT_EQ(page.find("src="), std::string::npos);
    fail(2,
         {"bench", folder / "block.vtkhdf", "-o", folder / "out", "--report",
          folder / "block.vtkhdf"},
         {"block.vtkhdf"});
}

TEST_F(Bench, BadInputIsNamed) {
    Snapshot snapshot = block(3);
    snapshot.support_radius.reset();
    const Words bench = {"bench", "-o", folder / "out"};
    fail(2, bench + Words{save(snapshot, "unknown_radius.vtkhdf")},
         {"unknown_radius", "support radius", "--support-radius"});
    snapshot = block(3);
    snapshot.positions[5][1] = NAN;
    fail(2, bench + Words{save(snapshot, "hole.vtkhdf")}, {"hole.vtkhdf", "particle 5", "finite"});
    snapshot = block(3);
    snapshot.positions[5][1] = 1e300;
    fail(2, bench + Words{save(snapshot, "far.vtkhdf")}, {"far.vtkhdf", "far from the origin"});
    fail(2, bench + Words{folder / "missing.vtkhdf"}, {"missing.vtkhdf"});
    fail(2, bench + Words{"--tables", "everything"}, {"--tables", "everything"});
    fail(2, bench + Words{"--repetitions", "0"}, {"--repetitions", "0"});
}

} // namespace
} // namespace meniscus
