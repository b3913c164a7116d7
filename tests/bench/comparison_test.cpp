// What every comparison is made of: tables, the best of their rows, times, plots, and the line
// among the detectors, which must be the one of the audit.
#include "detectors/detector_comparison.hpp"
#include "support/page.hpp"
#include "support/plot.hpp"

#include <data/expected_errors.hpp>
#include <data/test_folder.hpp>

#include <meniscus/classifier/model/classify_snapshot.hpp>
#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace meniscus {
namespace {

Table methods() {
    Table table{"methods",
                "Methods",
                {{"method", "method"}, {"time", "ns"}, {"error", "error, %"}, {"kind", "kind"}},
                {}};
    table.rows = {{"fast", RepeatedTime{10, 9, 12}, 5.0, "a"},
                  {"exact", RepeatedTime{1000, 900, 1100}, 0.0, "a"},
                  {"slow and wrong", RepeatedTime{2000, 1900, 2100}, 5.0, "b"},
                  {"equal to fast", RepeatedTime{10, 9, 12}, 5.0, "b"},
                  {"not measured", std::monostate{}, 1.0, "b"}};
    return table;
}

std::vector<std::string> best_of(const Table& table) {
    std::vector<std::string> names;
    for (const auto& row : table.rows)
        if (std::get<std::string>(row.back()) == "yes")
            names.push_back(std::get<std::string>(row[0]));
    return names;
}

TEST(Table, BestAreThoseThatNoOtherBeats) {
    Table table = methods();
    mark_best(table, {"time", "error"});
    EXPECT_EQ(best_of(table), (std::vector<std::string>{"fast", "exact", "equal to fast"}));
}

TEST(Table, BestOfEachGroup) {
    Table table = methods();
    mark_best(table, {"time"}, "kind");
    EXPECT_EQ(best_of(table), (std::vector<std::string>{"fast", "equal to fast"}));
}

TEST(Table, MarkdownHasARowAMethod) {
    const std::string text = markdown(methods());
    EXPECT_EQ(text.substr(0, text.find('\n')), "| method | ns | error, % | kind |");
    EXPECT_NE(text.find("| fast | 10 (9 to 12) | 5 | a |"), std::string::npos) << text;
    EXPECT_NE(text.find("| not measured | - | 1 | b |"), std::string::npos) << text;
}

TEST(Table, PageHasACellForEachFigure) {
    Table table = methods();
    table.title = "a < b & c";
    const std::string page = tables_page("Title", "about <it>", {table});
    for (const char* part :
         {"<title>Title</title>", "<p>about &lt;it&gt;</p>", "<h2>a &lt; b &amp; c</h2>",
          "<th><button>error, %</button></th>", "<td>fast</td><td>10 (9 to 12)</td><td>5</td>"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
}

TEST(Table, JsonKeepsAllDigits) {
    Table table = methods();
    table.rows[0][2] = 1.0 / 3;
    const nlohmann::json json = to_json(table);
    EXPECT_EQ(json["rows"][0]["error"].get<double>(), 1.0 / 3);
    EXPECT_EQ(json["rows"][0]["time"]["upper"].get<double>(), 12);
    EXPECT_TRUE(json["rows"][4]["time"].is_null());
    EXPECT_EQ(json["columns"][2]["heading"], "error, %");
}

TEST(Table, ColumnsSayHowTheirFiguresArePrinted) {
    Table table = table_of("line", "state | k {:.2f} | off, % {:+.1f} | off, % {:.1f} %");
    table.add({"ball", 116.671, 2, Figures{0.25, 3}});
    EXPECT_EQ(markdown(table), "| state | k | off, % | off, % |\n|---|---|---|---|\n"
                               "| ball | 116.67 | +2.0 | 0.2 % / 3.0 % |\n");
    const nlohmann::json row = to_json(table)["rows"][0];
    EXPECT_EQ(row["k"], 116.671);
    EXPECT_EQ(row["off, %"], 2);
    EXPECT_EQ(row["off, % (4)"], nlohmann::json({0.25, 3}));
}

TEST(Table, SmallestOfAColumnIsBoldWhereAskedFor) {
    Table table = titled_table("schemes", "Errors", "scheme | 10 {:.1e} | 30 {:.1e}");
    table.columns[1].bold_min = true;
    table.add({"random", 0.1, 0.01});
    table.add({"halton", 0.05, 0.02});
    table.add({"exact", "", 0});
    EXPECT_EQ(table.before, "\n**Errors**\n\n");
    const std::string text = markdown(table);
    EXPECT_NE(text.find("| random | 1.0e-01 | 1.0e-02 |"), std::string::npos) << text;
    EXPECT_NE(text.find("| halton | **5.0e-02** | 2.0e-02 |"), std::string::npos) << text;
}

TEST(Table, RatiosAreOfNamedMedians) {
    const Table table = ratios_of({{"slow", 3e-3}, {"fast", 2e-3}}, {{"speedup", "slow", "fast"}});
    EXPECT_EQ(markdown(table), "| what | ratio of medians | value |\n|---|---|---|\n"
                               "| speedup | slow / fast | 1.50 |\n");
    EXPECT_THROW(ratios_of({}, {{"speedup", "slow", "fast"}}), std::out_of_range);
}

TEST(Timing, RunsEveryOneAndOrdersItsQuartiles) {
    int first = 0;
    int second = 0;
    TimingOptions options;
    options.repetitions = 5;
    options.min_time = 1e-6;
    const auto times = measure({{[&] { ++first; }}, {[&] { ++second; }, true}}, options);
    ASSERT_EQ(times.size(), 2U);
    EXPECT_GE(first, 5);
    EXPECT_GE(second, 3);
    for (const RepeatedTime& time : times) {
        EXPECT_GT(time.lower, 0);
        EXPECT_LE(time.lower, time.median);
        EXPECT_LE(time.median, time.upper);
    }
}

using Plots = TestFolder;

TEST_F(Plots, ShowEverySeriesAndZeros) {
    Table table = methods();
    mark_best(table, {"time", "error"});
    draw(table, {"methods.svg", "It's a plot", "time", "error", "kind"}, folder);
    const std::string svg = bytes_of(folder / "methods.svg");
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    EXPECT_NE(svg.find(">It's a plot<"), std::string::npos);
    EXPECT_NE(svg.find(">error, %<"), std::string::npos);
    EXPECT_NE(svg.find(">0<"), std::string::npos);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST_F(Plots, OfOneValueAndOfNone) {
    Table table = methods();
    table.rows.resize(1);
    draw(table, {"one.svg", "one", "time", "error", "kind"}, folder);
    EXPECT_NE(bytes_of(folder / "one.svg").find("</svg>"), std::string::npos);
    table.rows.clear();
    draw(table, {"none.svg", "none", "time", "error", "kind"}, folder);
    EXPECT_FALSE(std::filesystem::exists(folder / "none.svg"));
}

TEST_F(Plots, ThatCannotBeWrittenSaySo) {
    const Plot plot{"a.svg", "a", "time", "error", "kind"};
    expect_mentions(error_of<InputError>([&] { draw(methods(), plot, folder / "no"); }), {"a.svg"});
}

Snapshot sample(const std::string& name) {
    return read_snapshot(std::filesystem::path(MENISCUS_SAMPLES) / (name + ".vtkhdf"));
}

TEST(FluidState, IsTheSnapshotWithExactLabels) {
    const Snapshot snapshot = sample("droplet_iisph_06");
    const auto state = fluid_state<double>(snapshot, "droplet");
    const Labels labels = label_particles(snapshot, *snapshot.support_radius, {});
    EXPECT_EQ(state.surface, labels.surface);
    EXPECT_EQ(state.uncovered_fraction, labels.uncovered_fraction);
    // Masses are 0.8 of a full cell in these states, and the fluid is at rest density.
    const double spacing = *snapshot.particle_spacing;
    EXPECT_NEAR(state.particle_volume / (0.8 * spacing * spacing * spacing), 1, 0.05);
}

TEST(FluidState, NeedsParticlesAndARadius) {
    Snapshot snapshot;
    snapshot.support_radius = 1;
    expect_mentions(error_of<InputError>([&] { fluid_state<float>(snapshot, "nothing"); }),
                    {"nothing", "no particle"});
    snapshot.positions = {{0, 0, 0}};
    snapshot.support_radius.reset();
    expect_mentions(error_of<InputError>([&] { fluid_state<float>(snapshot, "one"); }),
                    {"one", "support radius"});
}

template <class Real>
const Detector<Real>& detector(const std::vector<Detector<Real>>& all, const std::string& name) {
    for (const auto& one : all)
        if (one.name == name)
            return one;
    throw std::invalid_argument("no detector " + name);
}

std::vector<std::uint8_t> found_by(const std::string& name, const FluidState<double>& state,
                                   int threads = 1) {
    const auto all = detectors<double>(state.dimension, MENISCUS_MODELS);
    std::vector<std::uint8_t> surface;
    detector(all, name).prepare(state, threads)(surface);
    return surface;
}

TEST(LineDetectors, AreTheModelsOfTheAudit) {
    const Snapshot snapshot = sample("cube_iisph_05");
    const auto state = fluid_state<double>(snapshot, "cube");
    for (const auto& [name, file] :
         {std::pair{"two lines", "surface_3d"}, {"published line, d = 28", "splishsplash_d28"}}) {
        const Model model =
            read_model(std::filesystem::path(MENISCUS_MODELS) / (std::string(file) + ".json"));
        EXPECT_EQ(found_by(name, state), classify_snapshot(snapshot, model, {}).surface) << name;
    }
}

TEST(CoverageDetectors, FindTheDefinition) {
    const auto state = fluid_state<double>(sample("cube_iisph_05"), "cube");
    EXPECT_EQ(found_by("exact test", state), state.surface);
    EXPECT_EQ(found_by("exact test", state, 2), state.surface);
    // The lines' misses are all that is lost where a test follows, and there are no false
    // positives.
    const auto lines = found_by("two lines", state);
    for (const char* name : {"line and exact coverage", "line and 16 samples, verified",
                             "line and 128 samples, verified"}) {
        const auto surface = found_by(name, state);
        for (std::size_t i = 0; i < state.size(); ++i)
            ASSERT_EQ(surface[i], state.surface[i] & lines[i]) << name << ", particle " << i;
    }
    const auto after_first = found_by("line and exact test", state);
    for (std::size_t i = 0; i < state.size(); ++i) {
        ASSERT_LE(after_first[i], state.surface[i]) << i;
        ASSERT_GE(after_first[i], state.surface[i] & lines[i]) << i;
    }
}

TEST(DetectorComparison, CountsErrorsAndFindsTheExactOneWithout) {
    std::vector<FluidState<float>> states;
    states.push_back(fluid_state<float>(sample("cube_iisph_05"), "cube"));
    const auto all = detectors<float>(3, MENISCUS_MODELS);
    std::vector<Detector<float>> some = {detector(all, "two lines"),
                                         detector(all, "published line, d = 12"),
                                         detector(all, "exact test")};
    TimingOptions timing;
    timing.repetitions = 1;
    timing.min_time = 1e-6;
    const Table table = compare_detectors(states, some, 2, timing);
    ASSERT_EQ(table.rows.size(), 3U);
    const auto number = [&](std::size_t row, const char* key) {
        return std::get<double>(table.rows[row][table.column(key)]);
    };
    EXPECT_EQ(number(0, "false_negatives_plain"), 0);
    EXPECT_GT(number(0, "false_positive_rate"), 0);
    EXPECT_GT(number(1, "false_negatives"), number(0, "false_negatives"));
    EXPECT_GT(number(1, "missed_area"), 0);
    for (const char* key : {"false_negatives", "missed_area", "false_positive_rate"})
        EXPECT_EQ(number(2, key), 0);
    EXPECT_EQ(std::get<std::string>(table.rows[2].back()), "yes");
}

} // namespace
} // namespace meniscus
