// Plans of studies, runs that are kept, and results that are compared.
#include "framework/run_study.hpp"
#include "framework/run_tables.hpp"
#include "framework/scene_runs.hpp"
#include "framework/spread.hpp"
#include "studies.hpp"

#include "data/test_folder.hpp"

#include <meniscus/data/text/errors.hpp>

#include <cmath>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

const char* const some_study = R"({
  "title": "Some",
  "small": {"axes": [
    {"name": "drop", "values": [{"name": "2D", "set": ["a=1"], "numbers": {"size": 2}},
                                {"name": "3D", "set": ["a=2"], "numbers": {"size": 3}}]},
    {"name": "solver", "values": [{"name": "one, fast"}, {"name": "two", "set": ["b=3"]}]}
  ]},
  "paper": {"axes": [{"name": "drop", "values": [{"name": "3D"}]}]},
  "compared": {"value": 0.5}
})";

int measured = 0; ///< runs
double offset = 0;

Json measure(const StudyRun& run, const Workplace& place) {
    if (place.stop())
        throw Stopped{};
    ++measured;
    return {{"value", run.numbers.at("size") + offset}, {"time", 1.5}};
}

std::vector<Table> tables(const Json& result, const Json&) {
    return {table_of_runs("some", result, "drop | solver", "value {:.1f}")};
}

class Studies : public TestFolder {
protected:
    Study study = {"some", "a test", measure, tables};
    StudyOptions options;

    void SetUp() override {
        TestFolder::SetUp();
        write("study.json", some_study);
        options.work = folder / "work";
        options.size = "small";
        std::filesystem::create_directories(options.work);
        measured = 0;
        offset = 0;
    }
    StudyPlan plan() { return read_plan(folder, "small", "scenes"); }
    std::string error_of_plan(const std::string& text) {
        write("study.json", text);
        return error_of<InputError>([&] { plan(); });
    }
};

TEST_F(Studies, RunEachCombinationOfTheirAxes) {
    const StudyPlan read = plan();
    ASSERT_EQ(read.runs.size(), 4U);
    EXPECT_EQ(read.runs[1].name, "2D_two");
    EXPECT_EQ(read.runs[1].changes, (std::vector<std::string>{"a=1", "b=3"}));
    EXPECT_EQ(read.runs[2].name, "3D_one_fast");
    EXPECT_EQ(read.runs[2].numbers.at("size"), 3);
    EXPECT_EQ(read_plan(folder, "paper", "scenes").runs.size(), 1U);
}

TEST_F(Studies, NameScenesThatShipAndFilesBesideThem) {
    Json json = Json::parse(some_study);
    json["small"]["axes"][0]["values"][0]["scene"] = "../other/drop.json";
    json["small"]["axes"][0]["values"][1]["scene"] = "dam_break";
    write("study.json", json.dump());
    const StudyPlan read = plan();
    EXPECT_EQ(read.runs[0].scene, folder / "../other/drop.json");
    EXPECT_EQ(read.runs[2].scene, "scenes/dam_break.json");
}

TEST_F(Studies, NameWhatIsWrong) {
    expect_mentions(error_of_plan("{}"), {"study.json", "'small'"});
    Json json = Json::parse(some_study);
    json["small"]["axes"][0]["values"][0]["sett"] = 1;
    expect_mentions(error_of_plan(json.dump()), {"study.json", "sett", "'set'"});
    json = Json::parse(some_study);
    json["small"]["axes"][0]["values"][1]["name"] = "2D";
    expect_mentions(error_of_plan(json.dump()), {"study.json", "axes"});
}

TEST_F(Studies, GoOnWithTheRunsThatAreMissing) {
    int asked = 0;
    options.stop = [&] { return ++asked > 3; };
    EXPECT_THROW(run_study(study, plan(), options), Stopped);
    EXPECT_EQ(measured, 3);
    options.stop = [] { return false; };
    const Json result = run_study(study, plan(), options);
    EXPECT_EQ(measured, 4);
    EXPECT_EQ(result["runs"].size(), 4U);
    offset = 7; // what is kept stays
    EXPECT_EQ(run_study(study, plan(), options)["runs"], result["runs"]);
    Json other = Json::parse(some_study);
    other["small"]["axes"][0]["values"][0]["numbers"]["size"] = 5;
    write("study.json", other.dump());
    EXPECT_EQ(run_study(study, plan(), options)["runs"][0]["figures"]["value"], 12);
    EXPECT_EQ(measured, 6); // the two of other settings
}

TEST_F(Studies, DifferWhereAComparedFigureDoes) {
    const Json before = run_study(study, plan(), options);
    EXPECT_TRUE(differences(before, before, plan()).empty());
    Json now = before;
    now["runs"][1]["figures"]["value"] = 2.4;
    now["runs"][1]["figures"]["time"] = 100;
    EXPECT_TRUE(differences(now, before, plan()).empty());
    now["runs"][1]["figures"]["value"] = 2.6;
    now["runs"][2]["figures"] = {{"failure", "diverged"}};
    now["runs"].erase(3);
    const auto lines = differences(now, before, plan());
    ASSERT_EQ(lines.size(), 3U);
    expect_mentions(lines[0], {"2D_two", "value", "2.6"});
    expect_mentions(lines[1], {"3D_one_fast", "failed"});
    expect_mentions(lines[2], {"3D_two"});
}

TEST_F(Studies, ShowFailuresInTheirTables) {
    Json result = run_study(study, plan(), options);
    result["runs"][0]["figures"] = {{"failure", "diverged at 0.1 s; the last good frame is 3"}};
    const std::string text = markdown(study.tables(result, {})[0]);
    EXPECT_NE(text.find("| 2D | one, fast | diverged at 0.1 s |"), std::string::npos) << text;
    EXPECT_NE(text.find("| 3D | two | 3.0 |"), std::string::npos) << text;
}

TEST_F(Studies, HaveTheirStatesDrawn) {
    study.measure = [](const StudyRun&, const Workplace& place) -> Json {
        place.draw("frame.vtkhdf");
        return {{"value", 1}};
    };
    run_study(study, plan(), options); // nobody draws
    std::vector<std::string> drawn;
    options.work = folder / "other";
    std::filesystem::create_directories(options.work);
    options.draw = [&](const auto& frame, const auto& picture, const std::string& title) {
        EXPECT_EQ(frame, "frame.vtkhdf");
        drawn.push_back(picture.filename().string() + ": " + title);
    };
    run_study(study, plan(), options);
    ASSERT_EQ(drawn.size(), 4U);
    EXPECT_EQ(drawn[0], "2D_one_fast.png: drop 2D, solver one, fast");
    EXPECT_EQ(picture_file(plan().runs[0], options.work), options.work / "2D_one_fast.png");
}

TEST_F(Studies, PutRunsTogetherThatDifferInTheirSeed) {
    const auto run = [](const char* way, const char* seed, const Json& figures) -> Json {
        return {{"labels", {{"way", way}, {"seed", seed}}}, {"figures", figures}};
    };
    const Json result = {
        {"runs",
         {run("a", "0", {{"value", 1.0}}), run("a", "1", {{"value", 4.0}}),
          run("a", "2", {{"failure", "diverged"}}), run("b", "0", Json::object())}}};
    const auto all = by_seeds(result, {"way"});
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].values("value"), (std::vector<double>{1, 4}));
    const std::string text = markdown(table_of_spread("some", result, "way", "value {:.1f}"));
    EXPECT_NE(text.find("| a | 2 of 3 | 2.5 / 1.0 / 4.0 |"), std::string::npos) << text;
    EXPECT_NE(text.find("| b | 1 of 1 | - |"), std::string::npos) << text;
}

TEST(Spread, ASeedMovesTheLastBodyByAThousandthOfASpacing) {
    Scene scene;
    scene.particle_spacing = 0.1;
    scene.fluid = {{BoxShape{{0, 0, 0}, {1, 1, 1}, {}}, {}},
                   {SphereShape{{1, 2, 3}, {1, 1, 1}}, {}}};
    const auto center = [&](double seed) {
        return std::get<SphereShape>(disturbed(scene, seed).fluid[1].shape).center;
    };
    EXPECT_EQ(center(0), (Place{1, 2, 3}));
    EXPECT_NEAR(std::hypot(center(1)[0] - 1, center(1)[2] - 3), 1e-4, 1e-15);
    EXPECT_EQ(center(1)[1], 2);
    EXPECT_NE(center(1), center(2));
    EXPECT_EQ(std::get<BoxShape>(disturbed(scene, 1).fluid[0].shape).low, (Place{0, 0, 0}));
}

TEST(ShippedStudies, HavePlansReferencesAndScenes) {
    for (const Study& study : all_studies()) {
        const std::filesystem::path folder =
            std::filesystem::path(MENISCUS_VALIDATION) / study.name;
        for (const char* size : {"small", "paper"})
            for (const StudyRun& run : read_plan(folder, size, MENISCUS_SCENES).runs)
                if (!run.scene.empty()) {
                    EXPECT_NO_THROW(scene_of(run)) << study.name << " " << run.name;
                }
        const auto file = folder / "reference.json";
        const Json reference =
            parse_json(text_of_file(file, "a reference"), file.string(), "a reference");
        for (const auto& [name, number] : reference.at("numbers").items())
            EXPECT_FALSE(number.at("source").get<std::string>().empty()) << name;
    }
}

TEST(ShippedStudies, NameNoFileOfTheMachineThatRanThem) {
    for (const auto& folder : std::filesystem::directory_iterator(MENISCUS_VALIDATION))
        for (const char* size : {"small.json", "paper.json"}) {
            const auto file = folder.path() / size;
            if (std::filesystem::exists(file)) {
                EXPECT_EQ(text_of_file(file, "a result").find(".vtkhdf"), std::string::npos)
                    << file;
            }
        }
}

} // namespace
} // namespace meniscus
