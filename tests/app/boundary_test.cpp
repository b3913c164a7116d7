#include "command.hpp"

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/data/formats/snapshot_files.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace meniscus {
namespace {

/// A block on a floor, labelled by both rules, and a model of each.
class Boundary : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        succeed({"train", without, "-o", ignores, "--quiet"});
        succeed({"train", with, "-o", counts, "--quiet"});
    }

    [[nodiscard]] static Snapshot floor() {
        Snapshot layers;
        for (const auto& position : block(8).positions)
            if (position[2] < 1)
                layers.positions.push_back({position[0], position[1], position[2] - 1});
        return layers;
    }

    [[nodiscard]] Path labelled(const std::string& name, const Words& options) const {
        std::filesystem::create_directories(folder);
        return label(save(block(8), name),
                     Words{"--boundary", save(floor(), "floor.vtkhdf")} + options);
    }

    [[nodiscard]] std::vector<double> classes(const Path& input, const Path& model,
                                              const Words& options) const {
        succeed(Words{"classify", input, "--model", model, "-o", folder / "out", "--overwrite",
                      "--quiet"} +
                options);
        return scalar_values(read_vtkhdf(folder / "out" / input.filename()), "predicted_surface");
    }

    const Path without = labelled("without.vtkhdf", {"--boundary-weight", "0"});
    const Path with = labelled("with.vtkhdf", {});
    const Path ignores = folder / "ignores.json";
    const Path counts = folder / "counts.json";
};

TEST_F(Boundary, CountsInTheFeaturesByOption) {
    const Snapshot covers = read_vtkhdf(without);
    const Snapshot counted = read_vtkhdf(with);
    EXPECT_EQ(covers.provenance.at("boundary_weight"), "0.0");
    EXPECT_EQ(counted.provenance.at("boundary_weight"), "0.85");
    EXPECT_EQ(scalar_values(covers, "uncovered_fraction"),
              scalar_values(counted, "uncovered_fraction"));
    const auto few = scalar_values(covers, "neighbor_count");
    const auto many = scalar_values(counted, "neighbor_count");
    for (std::size_t i = 0; i < covers.size(); ++i) {
        const double height = covers.positions[i][2]; // over a floor whose top is at -0.5
        EXPECT_EQ(many[i] > few[i], height < 0.5) << i;
    }
}

TEST_F(Boundary, RulesAreNotUpToDateWithEachOther) {
    const Words again = {"label",      folder / "with.vtkhdf",  "-o",        folder / "labelled",
                         "--boundary", folder / "floor.vtkhdf", "--samples", "500"};
    EXPECT_NE(succeed(again + Words{"--boundary-weight", "0.85"}).find("up to date"),
              std::string::npos);
    EXPECT_NE(succeed(again).find("up to date"), std::string::npos); // the default
    EXPECT_EQ(succeed(again + Words{"--boundary-weight", "0"}).find("up to date"),
              std::string::npos);
    EXPECT_NE(succeed(again + Words{"--boundary-weight", "0.85"}).find("cover and count"),
              std::string::npos);
    // Where there are none, the rule holds all the same.
    const Path bare = label(save(block(5), "bare.vtkhdf"), {});
    EXPECT_EQ(read_vtkhdf(bare).provenance.at("boundary_weight"), "0.85");
}

TEST_F(Boundary, OneModelIsOfOneRule) {
    EXPECT_EQ(read_model(ignores).boundary_weight, 0);
    EXPECT_EQ(read_model(counts).boundary_weight, 0.85);
    fail(2, {"train", without, with, "-o", folder / "both.json"},
         {"without.vtkhdf", "boundary weight 0 ", "with.vtkhdf with 0.85"});
    fail(2, {"train", with, "-o", folder / "kept.json", "--keep-k", ignores},
         {"ignores.json", "with.vtkhdf", "--boundary-weight 0"});
    auto json = nlohmann::ordered_json::parse(bytes_of(counts));
    json["boundary_weight"] = "some";
    fail(2, {"audit", with, "--model", write("free.json", json.dump())},
         {"free.json", "'boundary_weight'", "some", "a number from 0.0 to 10.0"});
    succeed({"export", counts, "-o", folder / "counts.hpp", "--quiet"});
    EXPECT_NE(bytes_of(folder / "counts.hpp")
                  .find("; boundary particles count by 0.85 of their volume.\n"),
              std::string::npos);
}

TEST_F(Boundary, AuditCountsItAndRefusesTheOtherRule) {
    succeed({"audit", with, "--model", counts, "--max-false-negatives", "0"});
    succeed({"audit", without, "--model", ignores, "--max-false-negatives", "0"});
    fail(2, {"audit", with, "--model", ignores}, {"ignores.json", "with.vtkhdf"});
    fail(2, {"audit", without, "--model", counts}, {"counts.json", "without.vtkhdf"});
}

TEST_F(Boundary, ClassifyCountsWhatTheAuditCounts) {
    const Path bare = folder / "with.vtkhdf"; // the input, without labels and boundary
    const auto given = classes(bare, counts, {"--boundary", folder / "floor.vtkhdf"});
    EXPECT_EQ(given, classes(with, counts, {})); // which holds its boundary
    const auto report =
        nlohmann::json::parse(succeed({"audit", with, "--model", counts, "--format", "json"}));
    const auto& total = report["total"];
    EXPECT_EQ(std::count(given.begin(), given.end(), 1), total["surface"].get<int>() -
                                                             total["false_negatives"].get<int>() +
                                                             total["false_positives"].get<int>());
    EXPECT_EQ(read_vtkhdf(folder / "out" / "with.vtkhdf").boundary, floor().positions);
    fail(2, {"classify", bare, "--model", counts, "-o", folder / "out", "--boundary", "none.vtk"},
         {"none.vtk"});
}

TEST_F(Boundary, PlaysNoPartInTheClassesOfAModelThatIgnoresIt) {
    const Path bare = folder / "with.vtkhdf";
    EXPECT_EQ(classes(bare, ignores, {}),
              classes(bare, ignores, {"--boundary", folder / "floor.vtkhdf"}));
}

} // namespace
} // namespace meniscus
