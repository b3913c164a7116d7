#include "data/test_folder.hpp"
#include "labelled_snapshots.hpp"

#include <meniscus/classifier/audit/audit.hpp>
#include <meniscus/classifier/audit/confidence.hpp>
#include <meniscus/classifier/objectives/trainer.hpp>
#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/text/errors.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace meniscus {
namespace {

using test::chain;
using test::chain_between_walls;
using test::chain_model;

AuditRow audited(const Snapshot& snapshot, const Model& model, double label_threshold) {
    return audit_state(model, snapshot, labelled_state(snapshot, "chain.vtkhdf"), label_threshold);
}

TEST(Audit, MatchesTheExampleWorkedOutByHand) {
    const AuditRow row = audited(chain(), chain_model(), 0);
    EXPECT_EQ(row.particles, 6U);
    EXPECT_EQ(row.surface_particles, 4U);
    EXPECT_EQ(row.false_negatives, 2U);
    EXPECT_EQ(row.false_positives, 1U);
    EXPECT_EQ(row.false_negatives_float, 2U);
    EXPECT_EQ(row.false_positives_float, 1U);
    EXPECT_EQ(row.uncovered_false_positives, 0U);
    EXPECT_EQ(row.features_differ, 0U);
    EXPECT_DOUBLE_EQ(false_positive_rate(row), 1.0 / 6);
    EXPECT_DOUBLE_EQ(false_positive_rate_interior(row), 1.0 / 2);
    EXPECT_DOUBLE_EQ(false_negative_rate(row), 2.0 / 4);
    EXPECT_DOUBLE_EQ(missed_area_fraction(row), 0.015 / 1.315);
    EXPECT_EQ(row.bands[0].particles, 1U); // exactly 0.5 % belongs to the lower band
    EXPECT_EQ(row.bands[0].missed, 1U);
    EXPECT_EQ(row.bands[1].particles, 1U);
    EXPECT_EQ(row.bands[1].missed, 1U);
    EXPECT_EQ(row.bands[2].particles, 2U);
    EXPECT_EQ(row.bands[2].missed, 0U);
    EXPECT_EQ(row.unseen_rates, std::vector<double>{0.5});
}

TEST(Audit, LabelThresholdMovesParticlesBetweenTheClasses) {
    const AuditRow row = audited(chain(), chain_model(), 0.35);
    EXPECT_EQ(row.surface_particles, 1U);
    EXPECT_EQ(row.false_negatives, 0U);
    EXPECT_EQ(row.false_positives, 2U);
    EXPECT_EQ(row.uncovered_false_positives, 1U); // lambda 0.3 stays, 0 goes
    EXPECT_EQ(row.bands[0].missed, 1U);           // bands do not depend on it
}

TEST(Audit, PhasesDoNotSeeEachOther) {
    Snapshot snapshot = chain();
    // The first three particles, and the next two: 1 2 1 | 1 1 neighbors.
    set_array(snapshot, {"phase", 1, std::vector<std::int32_t>{0, 0, 0, 1, 1, 0, 0}});
    const AuditRow row = audited(snapshot, chain_model(), 0);
    EXPECT_EQ(row.false_negatives, 1U);
    EXPECT_EQ(row.false_positives, 2U);
    EXPECT_EQ(row.features_differ, 2U);
}

TEST(Audit, MassesWeighTheOffset) {
    Snapshot snapshot = chain();
    // Particle 1 has neighbors at -0.5 and 0.5: its offset is 0.5 (9 - 1) / 10 = 0.4.
    set_array(snapshot, {"mass", 1, std::vector<double>{1, 1, 9, 1, 1, 1, 1}});
    Model model = chain_model();
    model.line = {10, -1.9}; // 2 <= 10 * 0.4 - 1.9
    EXPECT_EQ(audited(snapshot, model, 0).bands[0].missed, 0U);
    model.line.d = -2.1;
    EXPECT_EQ(audited(snapshot, model, 0).bands[0].missed, 1U);
}

TEST(Audit, CountsTheBoundaryWhereTheModelDoes) {
    Model model = chain_model();
    model.boundary_weight = test::weight_of_one;
    AuditRow row = audited(chain_between_walls(), model, 0);
    EXPECT_EQ(row.features_differ, 0U);
    EXPECT_EQ(row.false_negatives, 3U); // both ends of the row have two neighbors now
    EXPECT_EQ(row.false_negatives_float, 3U);
    EXPECT_EQ(row.false_positives, 0U);
    EXPECT_EQ(row.false_positives_float, 0U);
    Snapshot bare = chain_between_walls();
    bare.boundary.clear();
    EXPECT_EQ(audited(bare, model, 0).features_differ, 2U);
    // A boundary that does not count changes nothing.
    Snapshot ignored = chain();
    ignored.boundary = chain_between_walls().boundary;
    row = audited(ignored, chain_model(), 0);
    EXPECT_EQ(row.features_differ, 0U);
    EXPECT_EQ(row.false_negatives, 2U);
}

TEST(Audit, BoundaryParticlesHaveTheMeanMassOfTheNeighbors) {
    Snapshot snapshot = chain_between_walls();
    // Particle 4 stands between a neighbor of mass 7 and a boundary particle that stands for three
    // of them: an offset of 0.5 (21 - 7) / 28 = 0.25, and four neighbors.
    set_array(snapshot, {"mass", 1, std::vector<double>{1, 1, 1, 7, 1, 13, 500}});
    snapshot.particle_volume = *snapshot.particle_volume / 3;
    Model model = chain_model();
    model.boundary_weight = test::weight_of_one;
    for (const double below : {0.1, -0.1}) {
        model.line = {100, -21 + below}; // 4 <= 100 * 0.25 - 21 + below
        const AuditRow row = audited(snapshot, model, 0);
        EXPECT_EQ(row.false_positives, below > 0 ? 1U : 0U);
        EXPECT_EQ(row.false_positives_float, below > 0 ? 1U : 0U);
    }
}

TEST(Audit, FloatAndDoubleAreCountedApart) {
    Model model = chain_model();
    model.line = {0, 2 - 1e-9}; // in float that is 2
    const AuditRow row = audited(chain(), model, 0);
    EXPECT_EQ(row.false_negatives, 2U);
    EXPECT_EQ(row.false_negatives_float, 0U);
    EXPECT_EQ(row.false_positives, 1U);
    EXPECT_EQ(row.false_positives_float, 2U);
}

TEST(Audit, RefusesModelsOfAnotherKind) {
    Model model = chain_model();
    model.dimension = 2;
    EXPECT_THROW(audited(chain(), model, 0), InputError);
    model = chain_model();
    model.radius_ratio = 0.7;
    EXPECT_THROW(audited(chain(), model, 0), InputError);
    EXPECT_THROW(audited(chain_between_walls(), chain_model(), 0), InputError);
    model = chain_model();
    model.boundary_weight = test::weight_of_one;
    EXPECT_NO_THROW(audited(chain(), model, 0)); // which has no boundary to count
    EXPECT_THROW(audited(chain(), chain_model(), 1), InputError);
}

class AuditFiles : public TestFolder {
protected:
    std::filesystem::path stored(const std::string& name, const Snapshot& snapshot) const {
        write_vtkhdf(snapshot, folder / name);
        return folder / name;
    }
};

TEST_F(AuditFiles, AreGroupedByScene) {
    Snapshot other = chain();
    other.scene = "other";
    const std::vector<std::filesystem::path> files = {
        stored("a.vtkhdf", chain()), stored("b.vtkhdf", other), stored("c.vtkhdf", chain())};
    const AuditReport report = audit(chain_model(), files, {});
    ASSERT_EQ(report.scenes.size(), 2U);
    EXPECT_EQ(report.scenes[0].scene, "chain");
    EXPECT_EQ(report.scenes[0].files, (std::vector<std::string>{"a.vtkhdf", "c.vtkhdf"}));
    EXPECT_EQ(report.scenes[0].false_negatives, 4U);
    EXPECT_EQ(report.total.particles, 18U);
    EXPECT_EQ(report.total.bands[2].particles, 6U);
    EXPECT_TRUE(report.warnings.empty());
    AuditOptions options;
    options.scene = "one";
    EXPECT_EQ(audit(chain_model(), files, options).scenes.size(), 1U);
    EXPECT_THROW(audit(chain_model(), {}, {}), InputError);
}

TEST_F(AuditFiles, TrainedOnOnesGiveNoConfidence) {
    const auto trained = stored("a.vtkhdf", chain());
    Snapshot unseen = chain();
    unseen.time = 2;
    const auto other = stored("b.vtkhdf", unseen);
    const Model model = train({read_labelled_state(trained, "")}, {});
    AuditReport report = audit(model, {trained}, {});
    EXPECT_EQ(report.total.files_trained_on, 1U);
    EXPECT_FALSE(false_negative_rate_upper_95(report.total));
    EXPECT_NE(to_table(report).find("were trained on: their"), std::string::npos);
    report = audit(model, {trained, other}, {});
    EXPECT_EQ(report.total.files_trained_on, 1U);
    EXPECT_EQ(report.total.unseen_rates, std::vector<double>{0});
    EXPECT_NEAR(*false_negative_rate_upper_95(report.total), 0.95, 1e-12);
    EXPECT_NEAR(*snapshot_with_misses_upper_95(report.total), 0.95, 1e-12);
}

TEST_F(AuditFiles, WarningsNameRangeAndValue) {
    Model model = chain_model();
    model.spacing_ratio = Range{2.5, 3};
    Snapshot stale = chain();
    set_array(stale, {"neighbor_count", 1, std::vector<std::uint32_t>{1, 2, 2, 2, 1, 0, 9}});
    EXPECT_EQ(audit(model, {stored("a.vtkhdf", stale)}, {}).warnings.size(), 1U);
    set_array(stale, {"neighbor_count", 1, std::vector<std::uint32_t>{1, 2, 2, 3, 1, 0, 0}});
    const auto warnings = audit(model, {stored("a.vtkhdf", stale)}, {}).warnings;
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_NE(warnings[0].find("neighbor counts of 1 particles"), std::string::npos);
    EXPECT_NE(warnings[1].find("is 2 in a.vtkhdf and was 2.5 to 3"), std::string::npos);
}

AuditReport example_report() {
    AuditReport report;
    report.model = chain_model();
    AuditRow row = audited(chain(), chain_model(), 0);
    row.scene = "a \"strange\", name";
    report.scenes = {row};
    report.total = row;
    report.total.scene = "all";
    return report;
}

TEST(AuditFormats, JsonHasTheContract) {
    const auto json = nlohmann::json::parse(to_json(example_report()));
    EXPECT_EQ(json["model"]["k"], 1.0);
    const auto& scene = json["scenes"][0];
    EXPECT_EQ(scene["scene"], "a \"strange\", name");
    EXPECT_EQ(scene["files"][0], "chain.vtkhdf");
    EXPECT_EQ(scene["particles"], 6);
    EXPECT_EQ(scene["surface"], 4);
    EXPECT_EQ(scene["false_negatives"], 2);
    EXPECT_EQ(scene["false_positives"], 1);
    EXPECT_EQ(scene["false_positive_rate"], 1.0 / 6);
    EXPECT_EQ(scene["false_positive_rate_interior"], 0.5);
    EXPECT_EQ(scene["bands"].size(), 3U);
    EXPECT_EQ(scene["bands"][0]["upper"], 0.005);
    EXPECT_EQ(scene["bands"][0]["missed"], 1);
    EXPECT_EQ(scene["unseen"]["snapshots"], 1);
    EXPECT_EQ(json["total"]["scene"], "all");
}

TEST(AuditFormats, CsvHasAsManyCellsAsItsHeader) {
    AuditReport report = example_report();
    report.scenes[0].scene = "plain";
    std::istringstream lines(to_csv(report));
    std::string line;
    std::vector<std::ptrdiff_t> commas;
    while (std::getline(lines, line))
        commas.push_back(std::count(line.begin(), line.end(), ','));
    ASSERT_EQ(commas.size(), 3U);
    EXPECT_EQ(commas[0], commas[1]);
    EXPECT_EQ(commas[0], commas[2]);
    EXPECT_NE(to_csv(example_report()).find("\n\"a \"\"strange\"\", name\",1,0,6,4,2,2,1,1,0,0.5,"),
              std::string::npos);
}

TEST(AuditFormats, TableIsAligned) {
    std::istringstream lines(to_table(example_report()));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line.find("surface where y <= 1 x + 1 ("), 0U) << line;
    std::getline(lines, line);
    std::getline(lines, line);
    const std::size_t width = line.size();
    for (int row = 0; row < 2; ++row) {
        std::getline(lines, line);
        EXPECT_EQ(line.size(), width) << line;
    }
}

} // namespace
} // namespace meniscus
