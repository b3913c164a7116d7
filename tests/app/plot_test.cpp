#include "png.hpp"
#include "report_page.hpp"

#include <cmath>
#include <fstream>
#include <regex>

namespace meniscus {
namespace {

using Point = std::array<double, 2>;

constexpr const char* log_text = "frame,time,steps,kinetic_energy,potential_energy\n"
                                 "0,0.0,10,1.0,4.0\n"
                                 "1,0.5,20,3.0,5.0\n"
                                 "2,1.0,60,nan,6.0\n"
                                 "3,2.0,40,5.0,8.0\n";

constexpr const char* table_text =
    "Words before.\n\n**Methods & more**\n\n"
    "| method | group | ns a particle, 1 thread | error, % | best |\n|---|---|---|---|---|\n"
    "| fast | ours | **10** (9 to 12) | 4 | yes |\n"
    "| exact | ours | 1000 (900 to 1100) | 0 |  |\n"
    "| other's | theirs | 100 | 2 of 9 | yes |\n"
    "| not measured | theirs | - | 1 |  |\n\n"
    "| name | value |\n|---|---|\n| a | 1 |\n";

class Plot : public CommandLine {
protected:
    [[nodiscard]] Path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name) << text;
        return folder / name;
    }

    [[nodiscard]] std::string svg(const Words& words) const {
        succeed(Words{"plot", "-o", folder / "plot.svg", "--quiet"} + words);
        return bytes_of(folder / "plot.svg");
    }

    /// Middles of circles with these words in them, in the order of the file.
    static std::vector<Point> circles(const std::string& svg, const std::string& words = "") {
        static const std::regex form("<circle cx=\"([^\"]*)\" cy=\"([^\"]*)\"[^>]*>");
        std::vector<Point> found;
        for (std::sregex_iterator it(svg.begin(), svg.end(), form), end; it != end; ++it)
            if (it->str().find(words) != std::string::npos)
                found.push_back({std::stod((*it)[1]), std::stod((*it)[2])});
        return found;
    }
};

TEST_F(Plot, ALogOverTime) {
    const Path log = write("dam_log.csv", log_text);
    const std::string drawn = svg({log, "--y", "steps"});
    const auto dots = circles(drawn);
    ASSERT_EQ(dots.size(), 4U);
    // Upward and to the right, in proportion.
    EXPECT_NEAR((dots[3][0] - dots[0][0]) / (dots[1][0] - dots[0][0]), 4, 0.02);
    EXPECT_NEAR((dots[2][1] - dots[0][1]) / (dots[1][1] - dots[0][1]), 5, 0.02);
    EXPECT_LT(dots[2][1], dots[0][1]);
    expect_mentions(drawn, {">time<", ">steps<", "<polyline", "</svg>"});
    // The same bytes once more.
    EXPECT_EQ(svg({log, "--y", "steps"}), drawn);
}

TEST_F(Plot, SeveralColumnsAndSeveralLogs) {
    const Path log = write("dam_log.csv", log_text);
    // Energies where no column is named; the one that is no number in a row is left out there.
    const std::string energies = svg({log});
    expect_mentions(energies, {">kinetic_energy<", ">potential_energy<"});
    EXPECT_EQ(circles(energies, "#0072b2").size(), 3U + 1); // and in the legend
    EXPECT_EQ(circles(energies, "#d55e00").size(), 4U + 1);
    const std::string panels = svg({log, "--y", "steps", "--y", "kinetic_energy"});
    EXPECT_EQ(circles(panels).size(), 4U + 3);
    const Path other = write("drop_log.csv", log_text);
    const std::string both = svg({log, other, "--y", "steps"});
    expect_mentions(both, {">dam_log<", ">drop_log<"});
    EXPECT_EQ(circles(both).size(), 2 * (4U + 1));
}

TEST_F(Plot, ATableWithNamesAtItsPoints) {
    const Path table = write("table.md", table_text);
    const Words words = {table,   "--table",       "1",       "--x",    "ns a particle, 1 thread",
                         "--y",   "error, %",      "--names", "method", "--series",
                         "group", "--logarithmic", "x"};
    const std::string drawn = svg(words);
    expect_mentions(drawn, {">Methods &amp; more<", ">fast<", ">exact<", ">other's<", ">ours<",
                            ">theirs<", ">error, %<", ">1000<"});
    EXPECT_EQ(drawn.find("not measured"), std::string::npos);
    const auto dots = circles(drawn, "r=\"3.5\"");
    ASSERT_EQ(dots.size(), 3U + 2);
    EXPECT_NEAR(dots[2][0] - dots[0][0], dots[1][0] - dots[2][0], 0.2);
    EXPECT_NEAR(dots[2][1], (dots[0][1] + dots[1][1]) / 2, 0.2);
    // Those that are not among the best are rings.
    EXPECT_EQ(circles(drawn, "fill=\"none\"").size(), 1U);
    // Rows below each other.
    const auto rows = circles(svg({table, "--table", "1", "--x", "error, %", "--names", "method"}));
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_NEAR(rows[3][1] - rows[2][1], rows[1][1] - rows[0][1], 0.2);
    EXPECT_GT(rows[1][1], rows[0][1]);
    // A column by which rows are told apart beside each other.
    const std::string panels =
        svg({table, "--table", "1", "--x", "error, %", "--y", "error, %", "--panel", "group"});
    expect_mentions(panels, {">ours<", ">theirs<"});
}

TEST_F(Plot, WhatTheBenchKeeps) {
    const Path json =
        write("tables.json",
              R"({"machine": {}, "tables": [{"name": "speed", "title": "Speed", "columns":
            [{"key": "method", "heading": "method"}, {"key": "time", "heading": "ns a step"}],
            "rows": [{"method": "a", "time": {"median": 1.5, "lower": 1, "upper": 2}},
                     {"method": "b", "time": 3}, {"method": "c", "time": null}]}]})");
    const std::string drawn = svg({json, "--x", "time", "--y", "ns a step", "--names", "method"});
    EXPECT_EQ(circles(drawn).size(), 2U);
    expect_mentions(drawn, {">ns a step<", ">Speed<", ">a<", ">b<"});
}

TEST_F(Plot, AFeaturePlaneCountsAsTheAuditDoes) {
    const Path labelled = label(sample("droplet_iisph_04"), {"--features", "direction_eigenvalue"});
    const Path model = Path(MENISCUS_MODELS) / "splishsplash_d12.json";
    const auto audit = nlohmann::json::parse(
        succeed({"audit", labelled, "--model", model, "--format", "json"}))["total"];
    const std::string drawn = svg({labelled, "--model", model});
    const auto text = [&](const char* key) { return audit[key].dump(); };
    const std::string missed =
        text("false_negatives") + " of " + text("surface") + " surface particles missed";
    const std::string passed = ", " + text("false_positives") + " of ";
    expect_mentions(drawn, {missed.c_str(), passed.c_str(), ">mass_offset<", ">neighbor_count<",
                            "data:image/png;base64,", ">let through<", ">missed<"});
    // One ring for each, and one in the legend.
    EXPECT_EQ(circles(drawn, "#1b1b1b").size(), audit["false_negatives"].get<std::size_t>() + 1);
    // Without a model, the one that fits; it has two lines.
    expect_mentions(svg({labelled}), {">direction_eigenvalue<", "model surface_3d"});
}

TEST_F(Plot, PngHasTheSameColors) {
    const Path log = write("dam_log.csv", log_text);
    succeed({"plot", log, "-o", folder / "plot.png", "--quiet"});
    const Png png(bytes_of(folder / "plot.png"));
    EXPECT_EQ(png.width, 1290U);
    EXPECT_EQ(png.pixels.front(), (Color{255, 255, 255}));
    EXPECT_GT(png.like({0, 114, 178}), 300U);
    EXPECT_GT(png.like({213, 94, 0}), 300U);
    EXPECT_GT(png.like({27, 27, 27}), 300U); // words
}

TEST_F(Plot, RefusesWhatItCannotPlot) {
    const Words plot = {"plot", "-o", folder / "plot.svg"};
    const Path log = write("dam_log.csv", log_text);
    fail(2, plot + Words{log, "--y", "kinetic_enrgy"},
         {"dam_log.csv", "kinetic_enrgy", "did you mean 'kinetic_energy'", "steps"});
    fail(2, plot + Words{log, "--x", "times"}, {"dam_log.csv", "times", "did you mean 'time'"});
    fail(2, plot + Words{log, "--table", "2"}, {"dam_log.csv", "'2'", "there are 1"});
    fail(2, plot + Words{log, "--model", "surface_3d"}, {"--model", "dam_log.csv"});
    fail(2, plot + Words{write("empty.csv", "frame,time,steps\n")}, {"empty.csv", "no rows"});
    fail(2, plot + Words{write("blank.csv", "\n\n")}, {"blank.csv", "empty"});
    fail(2, plot + Words{write("gone.csv", "")}, {"gone.csv", "empty"});
    fail(2, plot + Words{write("short.csv", "frame,time\n1\n")}, {"short.csv", "row 1", "1 cells"});
    fail(2, plot + Words{write("other.log", "Iteration 1: residual 0.5\nIteration 2, done\n")},
         {"other.log", "2 cells"});
    fail(2, plot + Words{write("other.csv", "step,residual\n1,0.5\n")},
         {"other.csv", "--x", "step; residual", "log of a run"});
    fail(2, plot + Words{write("words.csv", "frame,time,steps\n0,0,many\n"), "--y", "steps"},
         {"words.csv", "row 1", "'steps'", "'many'", "no number"});
    fail(2, plot + Words{write("nan.csv", "frame,time,steps\n0,0,nan\n"), "--y", "steps"},
         {"nan.csv", "nothing to plot"});
    fail(2, plot + Words{write("table.md", table_text), "--x", "value", "--y", "value"},
         {"table.md", "--table", "1, 2"});
    fail(2, plot + Words{write("model.json", "{\"k\": 1}"), "--x", "a", "--y", "b"},
         {"model.json", "meniscus_bench"});
    fail(2, plot + Words{write("broken.json", "{\"tables\": [")}, {"broken.json"});
    fail(2, plot + Words{sample("cube_iisph_05")}, {"cube_iisph_05", "meniscus label"});
    const Path labelled = label(sample("droplet_iisph_04"));
    fail(2, plot + Words{labelled, "--y", "steps"}, {"--y", "state"});
    fail(2, plot + Words{labelled, log}, {"one kind"});
    fail(2, plot + Words{labelled, "--model", "surface_2d"}, {"dimension"});
    fail(2, {"plot", log, "-o", folder / "plot.pdf"}, {"plot.pdf", ".png", ".svg"});
    fail(2, {"plot", folder / "missing.csv", "-o", folder / "plot.svg"}, {"missing.csv"});
    fail(2, {"plot", log, "-o", log}, {"dam_log.csv", ".svg"});
}

} // namespace
} // namespace meniscus
