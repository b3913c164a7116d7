// What files are: meniscus inspect, and meniscus models.
#include "command.hpp"

namespace meniscus {
namespace {

class Inspect : public CommandLine {
protected:
    /// A block with walls below and two phases.
    [[nodiscard]] Path two_phases() const {
        Snapshot snapshot = block(6);
        std::vector<std::int32_t> phase(snapshot.size());
        std::fill(phase.begin(), phase.begin() + 100, 1);
        set_array(snapshot, {"phase", 1, phase});
        snapshot.boundary = {{0, 0, -0.5}, {1, 0, -0.5}};
        snapshot.time = 0.25;
        snapshot.scene = "puddle";
        return save(snapshot, "two.vtkhdf");
    }
};

TEST_F(Inspect, SaysWhatASnapshotHolds) {
    expect_mentions(succeed({"inspect", two_phases()}),
                    {"two.vtkhdf: VTKHDF", "216 in 3D, positions in double", "z 0 to 2.5 m",
                     "puddle", "0.25 s", "2.00 spacings", "surface_3d fits",
                     "2 particles, x 0 to 1 m", "0: 116 particles, 1: 100 particles", "int32"});
}

TEST_F(Inspect, SaysWhatTheVerbsHaveMade) {
    const Path labelled = label(two_phases());
    expect_mentions(succeed({"inspect", labelled}),
                    {"labelled", "uncovered_fraction", "double", "####", "input_hash"});
    expect_mentions(succeed({"inspect", Path(MENISCUS_MODELS) / "surface_2d.json"}),
                    {"a model", "spacings in 2D", "second line", "0 false negatives"});
}

TEST_F(Inspect, ForeignFilesWithoutARadius) {
    const Path table = write("table.csv", "x,y,z,T\n0,0,0,1\n1,0,0,nan\n0,1,1,2\n1,1,0.5,2\n");
    expect_mentions(succeed({"inspect", table}),
                    {"CSV", "4 in 3D", "not stored", "--support-radius", "1 not finite"});
    expect_mentions(succeed({"inspect", table, "--support-radius", "2"}), {"2 m, "});
    const Path bad = write("bad.csv", "no table\n");
    fail(2, {"inspect", bad}, {"bad.csv"});
    const Outcome outcome = run(program + Words{"inspect", bad, table, "--keep-going"});
    EXPECT_EQ(outcome.status, 2);
    expect_mentions(outcome.output, {"4 in 3D"});
    expect_mentions(outcome.errors, {"bad.csv", "1 of 2 files could not be read"});
}

TEST_F(Inspect, ModelsThatShipAndTheOneThatFits) {
    expect_mentions(succeed({"models"}),
                    {"surface_3d_widest", "spacings in 2D", "splishsplash_d28"});
    const Path solid = save(block(6), "solid.vtkhdf");
    EXPECT_NE(succeed({"models", solid}).find("solid.vtkhdf: surface_3d ("), std::string::npos);
    const auto fit = [&](const char* h) {
        return succeed({"models", solid, "--support-radius", h, "--particle-volume", "0.125"});
    };
    expect_mentions(fit("1.25"), {"surface_3d_wide ("});
    expect_mentions(fit("1.6"), {"surface_3d_widest ("});
    expect_mentions(succeed({"models", save(block(9, 2), "flat.vtkhdf")}), {"surface_2d ("});
    fail(2, {"models", solid, "--support-radius", "4", "--particle-volume", "0.125"},
         {"solid.vtkhdf", "8 spacings", "--model"});
}

TEST_F(Inspect, VerbsChooseTheModelThatFits) {
    const Path solid = save(block(6), "solid.vtkhdf");
    const Path flat = save(block(9, 2), "flat.vtkhdf");
    const Path models = MENISCUS_MODELS;
    const Outcome chosen = run(program + Words{"classify", solid, flat, "-o", folder / "chosen"});
    EXPECT_EQ(chosen.status, 0) << chosen.errors; // a warning: the small block has a small ratio
    expect_mentions(chosen.output, {"model surface_3d,", "model surface_2d,"});
    succeed({"classify", solid, "-o", folder / "given", "--model", models / "surface_3d.json"});
    succeed({"classify", solid, "-o", folder / "named", "--model", "surface_3d"});
    EXPECT_TRUE(bytes_of(folder / "given" / "solid.vtkhdf") ==
                bytes_of(folder / "named" / "solid.vtkhdf"));
    EXPECT_EQ(read_vtkhdf(folder / "chosen" / "solid.vtkhdf").provenance.at("model_hash"),
              read_vtkhdf(folder / "given" / "solid.vtkhdf").provenance.at("model_hash"));
    fail(2, {"classify", solid, "-o", folder / "no", "--model", "surface_3d_wid"},
         {"did you mean 'surface_3d_wide'?"});
    fail(2, {"classify", solid, "-o", folder / "no", "--model", ""}, {"cannot be read", "a model"});
    const Path labelled = label(solid);
    expect_mentions(succeed({"audit", labelled}), {"model surface_3d,"});
    EXPECT_EQ(succeed({"audit", labelled, "--format", "json"}),
              succeed({"audit", labelled, "--format", "json", "--model", "surface_3d"}));
}

TEST_F(Inspect, FilesOfAnotherKindAreNamed) {
    const Path solid = save(block(4), "solid.vtkhdf");
    const Path scene = write("scene.json", R"({"name": "a", "particle_spacing": 1, "fluid": []})");
    const Path model = Path(MENISCUS_MODELS) / "surface_3d.json";
    const Path curvature = Path(MENISCUS_MODELS) / "curvature_3d.json";
    const Words classify = {"classify", solid, "-o", folder / "out", "--model"};
    fail(2, classify + Words{scene}, {"scene.json is a scene, not a model", "meniscus train"});
    fail(2, classify + Words{curvature}, {"is a curvature model, not a model"});
    fail(2, classify + Words{solid}, {"solid.vtkhdf is an HDF5 file", "not a model"});
    fail(2, {"export", scene, "-o", folder / "a.hpp"}, {"is a scene, not a model"});
    fail(2, {"simulate", model, "-o", folder / "out"}, {"is a model, not a scene"});
    fail(2, {"calibrate", model, "-o", folder / "a.json"}, {"is a model, not a calibration"});
    fail(2, {"label", model, "-o", folder / "out"}, {"surface_3d.json", "a model", "--model"});
    fail(2, {"label", scene, "-o", folder / "out"}, {"scene.json", "a scene", "meniscus simulate"});
}

} // namespace
} // namespace meniscus
