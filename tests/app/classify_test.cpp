#include "command.hpp"

#include <meniscus/classifier/model.hpp>
#include <meniscus/data/snapshot_files.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace meniscus {
namespace {

class Classify : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        Model by_hand;
        by_hand.line = {60, 20};
        by_hand.objective = "by hand";
        write("model.json", model_to_json(by_hand));
    }

    const Path model = folder / "model.json";
    const Path out = folder / "out";
};

TEST_F(Classify, FindsWhatTheAuditCounts) {
    const Path input = sample("droplet_iisph_04");
    expect_mentions(succeed({"classify", input, "--model", model, "-o", out}),
                    {"droplet_iisph_04.vtkhdf: 8192 particles in 3D", "surface"});
    const Snapshot classified = read_vtkhdf(out / input.filename());
    EXPECT_EQ(classified.positions, read_vtkhdf(input).positions);
    EXPECT_EQ(classified.provenance.at("input_hash"), file_hash(input));
    EXPECT_EQ(classified.provenance.at("model_hash"), file_hash(model));
    const auto classes = scalar_values(classified, "predicted_surface");
    const auto report = nlohmann::json::parse(
        succeed({"audit", label(input), "--model", model, "--format", "json"}));
    const auto& total = report["total"];
    EXPECT_EQ(std::count(classes.begin(), classes.end(), 1),
              total["surface"].get<int>() - total["false_negatives"].get<int>() +
                  total["false_positives"].get<int>());
}

TEST_F(Classify, SupportRadiusOfEachParticle) {
    Snapshot snapshot = read_vtkhdf(sample("droplet_iisph_04"));
    const double h = *snapshot.support_radius;
    std::vector<float> radii;
    for (const auto& position : snapshot.positions)
        radii.push_back(static_cast<float>(position[0] < 0 ? h : 1.1 * h));
    set_array(snapshot, {"support_radius", 1, radii});
    snapshot.support_radius.reset();
    const Path input = save(snapshot, "droplet.vtkhdf");
    succeed({"classify", input, "--model", model, "-o", out});
    const Snapshot classified = read_vtkhdf(out / "droplet.vtkhdf");
    EXPECT_FALSE(classified.support_radius);
    EXPECT_EQ(scalar_values(classified, "support_radius"),
              scalar_values(snapshot, "support_radius"));
    const auto classes = scalar_values(classified, "predicted_surface");
    const auto report = nlohmann::json::parse(
        succeed({"audit", label(input), "--model", model, "--format", "json"}));
    const auto& total = report["total"];
    EXPECT_EQ(std::count(classes.begin(), classes.end(), 1),
              total["surface"].get<int>() - total["false_negatives"].get<int>() +
                  total["false_positives"].get<int>());
    EXPECT_TRUE(report["warnings"].empty()) << report["warnings"];
    fail(2, {"train", label(input), "-o", folder / "trained.json"},
         {"droplet.vtkhdf", "support radii of their own"});
}

TEST_F(Classify, SameBytesWhateverTheThreads) {
    std::string first;
    for (const char* threads : {"1", "1", "2", "8"}) {
        std::filesystem::remove_all(out);
        EXPECT_EQ(succeed({"classify", sample("cube_iisph_05"), "--model", model, "-o", out,
                           "--threads", threads, "--quiet"}),
                  "");
        const std::string bytes = bytes_of(out / "cube_iisph_05.vtkhdf");
        if (first.empty())
            first = bytes;
        EXPECT_NE(first, "");
        EXPECT_TRUE(bytes == first) << "threads: " << threads;
    }
}

TEST_F(Classify, InvalidParticlesAreLeftOutOnRequest) {
    Snapshot snapshot = block(5);
    snapshot.positions[62][1] = std::numeric_limits<double>::quiet_NaN();
    const Words words = {"classify", save(snapshot, "hole.vtkhdf"), "--model", model, "-o", out};
    fail(2, words, {"hole.vtkhdf", "1 of 125", "particle 62", "--skip-invalid"});
    succeed(words + Words{"--skip-invalid"});
    const Snapshot classified = read_vtkhdf(out / "hole.vtkhdf");
    const auto valid = scalar_values(classified, "valid");
    EXPECT_EQ(std::count(valid.begin(), valid.end(), 1), 124);
    EXPECT_EQ(valid[62], 0);
    EXPECT_EQ(scalar_values(classified, "predicted_surface")[62], 0);
}

TEST_F(Classify, RefusesAModelOfAnotherDimension) {
    fail(2, {"classify", save(block(6, 2), "flat.vtkhdf"), "--model", model, "-o", out},
         {"model.json", "flat.vtkhdf", "3D", "2D"});
}

TEST_F(Classify, OverwritesNoLabels) {
    const Path input = sample("droplet_iisph_04");
    const Path labelled = label(input);
    const std::string bytes = bytes_of(labelled);
    fail(2, {"classify", input, "--model", model, "-o", folder / "labelled"},
         {"droplet_iisph_04.vtkhdf", "exists"});
    EXPECT_TRUE(bytes_of(labelled) == bytes);
    succeed({"classify", input, "--model", model, "-o", out});
    succeed({"classify", input, "--model", model, "-o", out}); // over its own earlier output
}

TEST_F(Classify, NoParticlesAndOne) {
    Snapshot snapshot;
    snapshot.support_radius = 1;
    succeed({"classify", save(snapshot, "none.vtkhdf"), "--model", model, "-o", out});
    EXPECT_EQ(read_vtkhdf(out / "none.vtkhdf").size(), 0U);
    snapshot.positions = {{0, 0, 0}};
    succeed({"classify", save(snapshot, "one.vtkhdf"), "--model", model, "-o", out});
    EXPECT_EQ(scalar_values(read_vtkhdf(out / "one.vtkhdf"), "predicted_surface"),
              std::vector<double>{1});
}

} // namespace
} // namespace meniscus
