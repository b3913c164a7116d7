#include "command.hpp"

#include <meniscus/data/text/files.hpp>

#include <cmath>
#include <limits>

namespace meniscus {
namespace {

using Label = CommandLine;
using Doubles = std::vector<double>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST_F(Label, NamesOutputsAfterInputs) {
    const std::string printed =
        succeed({"label", sample("droplet_iisph_01"), sample("cube_iisph_05"), "-o",
                 folder / "new" / "folder", "--samples", "500"});
    EXPECT_EQ(files(),
              (Words{"new/folder/cube_iisph_05.vtkhdf", "new/folder/droplet_iisph_01.vtkhdf"}));
    expect_mentions(printed,
                    {"droplet_iisph_01.vtkhdf: 8192 particles in 3D",
                     "cube_iisph_05.vtkhdf: 10648 particles in 3D", "mean neighbor count"});
}

TEST_F(Label, GenericNamesAreThoseOfTheirFolders) {
    std::filesystem::create_directories(folder / "Dam" / "vtk");
    const Path input = save(block(4), "Dam/vtk/ParticleData_Fluid_12.vtk");
    succeed({"label", input, "-o", folder / "out"});
    EXPECT_EQ(read_vtkhdf(folder / "out" / "Dam_12.vtkhdf").scene, "Dam");
}

TEST_F(Label, AChosenFrameIsLabelledUnderItsNumber) {
    const auto state = [](const std::string& x) {
        return "2\nProperties=pos:R:3\n" + x + " 0 0\n" + x + " 0 0.5\n";
    };
    const Path file = write("run.xyz", state("1") + state("2") + state("3"));
    const Words words = {"label", file, "-o", folder / "out", "--support-radius", "1"};
    const auto succeed = [&](const Words& label) { // which warns of so few neighbors
        const Outcome outcome = run(program + label);
        EXPECT_EQ(outcome.status, 0) << outcome.errors;
        return outcome.output;
    };
    expect_mentions(succeed(words + Words{"--frame", "1"}), {"run_1.vtkhdf", "state 1 of 0 to 2"});
    expect_mentions(succeed(words), {"run.vtkhdf", "last of 3 states"});
    const Snapshot chosen = read_vtkhdf(folder / "out/run_1.vtkhdf");
    EXPECT_EQ(chosen.positions[0][0], 2);
    EXPECT_EQ(chosen.scene, "run");
    EXPECT_EQ(chosen.provenance.at("frame"), "1");
    EXPECT_EQ(read_vtkhdf(folder / "out/run.vtkhdf").positions[0][0], 3);
    expect_mentions(succeed(words + Words{"--frame", "1"}), {"up to date"});
    fail(2, words + Words{"--frame", "3"}, {"run.xyz: --frame 3", "0 to 2"});
    fail(2, words + Words{"--frame", "-1"}, {"--frame"});
    fail(2, {"label", sample("cube_iisph_05"), "-o", folder / "out", "--frame", "0"},
         {"cube_iisph_05.vtkhdf: --frame 0", "one"});
}

TEST_F(Label, ACheckpointIsNoFrame) {
    Snapshot checkpoint = block(4);
    checkpoint.provenance = {{"run", "{}"}, {"log", ""}};
    fail(2, {"label", save(checkpoint, "dam_checkpoint.vtkhdf"), "-o", folder / "out"},
         {"dam_checkpoint.vtkhdf", "no frame", "dam_[0-9]*.vtkhdf"});
}

TEST_F(Label, AQuarterOfTheSupportRadiusIsTheParticleRadius) {
    const Path input = save(block(4), "block.vtkhdf");
    succeed({"label", input, "-o", folder / "out", "--particle-radius", "0.25"});
    EXPECT_EQ(read_vtkhdf(folder / "out" / "block.vtkhdf").support_radius, 1);
    fail(2, {"label", input, "-o", folder / "no", "--particle-radius", "-1"},
         {"--particle-radius", "positive"});
}

TEST_F(Label, AddsLabelsToWhatIsThere) {
    const Path input = sample("droplet_iisph_04");
    const Snapshot before = read_vtkhdf(input);
    const Snapshot after = read_vtkhdf(label(input));
    EXPECT_EQ(after.positions, before.positions);
    EXPECT_EQ(after.position_precision, before.position_precision);
    EXPECT_EQ(after.scene, before.scene);
    EXPECT_EQ(after.support_radius, before.support_radius);
    const auto is = [&](const char* name, auto type) {
        const PointArray* array = find_array(after, name);
        return array != nullptr &&
               std::holds_alternative<std::vector<decltype(type)>>(array->values);
    };
    EXPECT_TRUE(is("uncovered_fraction", double{}));
    EXPECT_TRUE(is("mass_offset", double{}));
    EXPECT_TRUE(is("surface", std::int8_t{}));
    EXPECT_TRUE(is("valid", std::int8_t{}));
    EXPECT_NE(find_array(after, "neighbor_count"), nullptr);
    for (const auto& [name, value] : {std::pair{"method", "monte-carlo"},
                                      {"samples", "500"},
                                      {"scheme", "halton"},
                                      {"seed", "0"}})
        EXPECT_EQ(after.provenance.at(name), value);
    EXPECT_EQ(after.provenance.at("input_hash"), file_hash(input));
    EXPECT_EQ(after.provenance.count("program"), 1U);
    EXPECT_EQ(after.provenance.count("radius_ratio"), 1U);
}

TEST_F(Label, RerunLeavesFilesAlone) {
    const Path input = save(block(5), "block.vtkhdf");
    const Path output = label(input);
    const std::string bytes = bytes_of(output);
    std::filesystem::last_write_time(output, std::filesystem::file_time_type::min());
    const auto time = std::filesystem::last_write_time(output);
    const std::string printed =
        succeed({"label", input, "-o", folder / "labelled", "--samples", "500", "--threads", "2"});
    EXPECT_EQ(printed, output.string() + ": up to date\n");
    EXPECT_EQ(bytes_of(output), bytes);
    EXPECT_EQ(std::filesystem::last_write_time(output), time);
}

TEST_F(Label, ACutOutputIsNotUpToDate) {
    const Path input = save(block(5), "block.vtkhdf");
    const Path output = label(input);
    const std::string bytes = bytes_of(output);
    const Words again = {"label", input, "-o", folder / "labelled", "--samples", "500"};
    std::filesystem::resize_file(output, bytes.size() - 1);
    fail(2, again, {"labelled/block.vtkhdf", "no snapshot"});
}

TEST_F(Label, ChangedOptionsAreLabelledAgain) {
    const Path input = save(block(5), "block.vtkhdf");
    const Path output = label(input);
    std::string bytes = bytes_of(output);
    for (const Words& options : {Words{"--samples", "600"},
                                 {"--seed", "7"},
                                 {"--scheme", "random"},
                                 {"--radius-ratio", "0.7"},
                                 {"--support-radius", "1.1"},
                                 {"--scene", "other"},
                                 {"--particle-spacing", "0.45"},
                                 {"--skip-invalid"}}) {
        const Words base = {"label", input, "-o", folder / "labelled"};
        const Words samples = options[0] == "--samples" ? Words{} : Words{"--samples", "500"};
        const std::string printed = succeed(base + samples + options);
        EXPECT_EQ(printed.find("up to date"), std::string::npos) << options[0];
        EXPECT_NE(bytes_of(output), bytes) << options[0];
        EXPECT_NE(succeed(base + samples + options).find("up to date"), std::string::npos);
        bytes = bytes_of(output);
    }
}

TEST_F(Label, ChangedInputIsLabelledAgain) {
    const Path output = label(save(block(5), "block.vtkhdf"));
    Snapshot moved = block(5);
    moved.positions[62][0] += 0.2;
    label(save(moved, "block.vtkhdf"));
    EXPECT_EQ(read_vtkhdf(output).positions, moved.positions);
}

TEST_F(Label, OverwritesNoLabelsOfAnotherInput) {
    const Path first = save(block(5), "block.vtkhdf");
    const Path out = folder / "out";
    succeed({"label", first, "-o", out});
    std::filesystem::create_directory(folder / "other");
    const Path second = save(block(4), "other/block.vtkhdf");
    fail(2, {"label", second, "-o", out}, {"out/block.vtkhdf", "another input", "--overwrite"});
    EXPECT_EQ(read_vtkhdf(out / "block.vtkhdf").size(), 125U);
    succeed({"label", second, "-o", out, "--overwrite"});
    EXPECT_EQ(read_vtkhdf(out / "block.vtkhdf").size(), 64U);
    // A copy is no other input, whatever it is called.
    std::filesystem::copy(second, folder / "block.vtkhdf",
                          std::filesystem::copy_options::overwrite_existing);
    expect_mentions(succeed({"label", first, "-o", out}), {"up to date"});
}

TEST_F(Label, OverwritesNothingThatItDidNotWrite) {
    const Path input = save(block(5), "block.vtkhdf");
    const Words words = {"label", input, "-o", folder / "out"};
    std::filesystem::create_directory(folder / "out");
    const Path text = write("out/block.vtkhdf", "notes of mine");
    fail(2, words, {"out/block.vtkhdf", "exists"});
    EXPECT_EQ(bytes_of(text), "notes of mine");
    const Path unlabelled = save(block(3), "out/block.vtkhdf");
    fail(2, words, {"out/block.vtkhdf", "exists"});
    EXPECT_EQ(read_vtkhdf(unlabelled).size(), 27U);
    std::filesystem::remove(unlabelled);
    std::filesystem::create_directory(unlabelled);
    fail(2, words, {"out/block.vtkhdf"});
}

TEST_F(Label, SameBytesWhateverTheThreads) {
    const Path output = folder / "labelled" / "droplet_iisph_14.vtkhdf";
    for (const Words& method :
         {Words{"--method", "exact"}, Words{"--scheme", "halton"}, Words{"--scheme", "random"},
          Words{"--scheme", "table"}, Words{"--scheme", "blue-noise"}}) {
        const bool exact = method[1] == "exact";
        std::string first;
        for (const char* threads : {"1", "1", "2", "8"}) {
            std::filesystem::remove_all(folder / "labelled");
            succeed(Words{"label", sample("droplet_iisph_14"), "-o", folder / "labelled",
                          "--threads", threads, "--quiet"} +
                    method + (exact ? Words{} : Words{"--samples", "500"}));
            if (first.empty())
                first = bytes_of(output);
            EXPECT_TRUE(bytes_of(output) == first) << method[1] << ", threads: " << threads;
        }
    }
}

TEST_F(Label, QuietPrintsNothing) {
    const Words words = {"label", save(block(4), "block.vtkhdf"), "-o", folder / "out", "--quiet"};
    EXPECT_EQ(succeed(words), "");
    EXPECT_EQ(succeed(words), "");
}

TEST_F(Label, WarnsOfAnImplausibleSupportRadius) {
    const Outcome outcome =
        run(program + Words{"label", save(block(8), "block.vtkhdf"), "-o", folder / "out",
                            "--samples", "50", "--support-radius", "0.55", "--quiet"});
    EXPECT_EQ(outcome.status, 0);
    expect_one_line(outcome.errors);
    expect_mentions(outcome.errors, {"warning", "support radius is 1.", "times", "1.6 to 5"});
}

TEST_F(Label, SaysWhereSinglePrecisionLosesThePositions) {
    const auto moved = [&](double distance) {
        Snapshot snapshot = block(8);
        snapshot.position_precision = Precision::float32;
        for (auto& position : snapshot.positions)
            position[0] += distance * *snapshot.support_radius;
        return save(snapshot, "far.vtkhdf");
    };
    const Outcome outcome =
        run(program + Words{"label", moved(1e4), "-o", folder / "out", "--quiet"});
    EXPECT_EQ(outcome.status, 0);
    expect_one_line(outcome.errors);
    expect_mentions(outcome.errors, {"warning", "single precision", "doubtful"});
    fail(2, {"label", moved(1e6), "-o", folder / "out"},
         {"far.vtkhdf", "512 of 512 particles", "single precision", "--skip-invalid"});
}

TEST_F(Label, InvalidParticlesAreLeftOutOnRequest) {
    Snapshot snapshot = block(5);
    const auto without =
        scalar_values(read_vtkhdf(label(save(snapshot, "whole.vtkhdf"))), "uncovered_fraction");
    snapshot.positions.insert(snapshot.positions.begin() + 3, {nan, 0, 0});
    snapshot.positions.push_back({0, HUGE_VAL, 0});
    const Path input = save(snapshot, "holes.vtkhdf");
    const Snapshot labelled = read_vtkhdf(label(input, {"--skip-invalid"}));
    ASSERT_EQ(labelled.size(), 127U);
    EXPECT_TRUE(std::isnan(labelled.positions[3][0]));
    auto valid = scalar_values(labelled, "valid");
    EXPECT_EQ(valid[3], 0);
    EXPECT_EQ(valid[126], 0);
    EXPECT_EQ(std::count(valid.begin(), valid.end(), 1), 125);
    auto fractions = scalar_values(labelled, "uncovered_fraction");
    fractions.erase(fractions.begin() + 3);
    fractions.pop_back();
    EXPECT_EQ(fractions, without);
}

TEST_F(Label, NoParticles) {
    Snapshot none;
    none.support_radius = 1;
    EXPECT_EQ(read_vtkhdf(label(save(none, "none.vtkhdf"))).size(), 0U);
}

TEST_F(Label, MethodsAndTheirOptions) {
    const Path input = save(block(5), "block.vtkhdf");
    const Path out = folder / "labelled";
    const auto method_of = [&](const Words& options) {
        succeed(Words{"label", input, "-o", out} + options);
        return read_vtkhdf(out / "block.vtkhdf").provenance;
    };
    EXPECT_EQ(method_of({}).at("method"), "exact");
    EXPECT_EQ(method_of({}).count("samples"), 0U);
    EXPECT_EQ(method_of({"--method", "exact", "--threads", "1"}).at("method"), "exact");
    EXPECT_EQ(method_of({"--seed", "3"}).at("method"), "monte-carlo");
    EXPECT_EQ(method_of({"--scheme", "blue-noise", "--samples", "70"}).at("scheme"), "blue-noise");
    EXPECT_EQ(method_of({"--method", "monte-carlo"}).at("samples"), "100000");
    fail(2, {"label", input, "-o", out, "--method", "exact", "--samples", "10"},
         {"--samples", "monte-carlo"});
    fail(2, {"label", input, "-o", out, "--method", "guess"}, {"--method", "guess", "exact"});
}

TEST_F(Label, BoundaryParticlesCover) {
    const Snapshot fluid = block(6);
    const Path input = save(fluid, "block.vtkhdf");
    Snapshot floor; // two layers below the block, as a file of their own
    for (const auto& position : fluid.positions)
        for (const double below : {0.25, 0.5})
            floor.positions.push_back({position[0], position[1], -below * *fluid.support_radius});
    const Path walls = save(floor, "floor.vtkhdf");
    const Path out = folder / "labelled";
    const auto surface_below = [&](const Words& options) {
        succeed(Words{"label", input, "-o", out, "--quiet"} + options);
        const Snapshot labelled = read_vtkhdf(out / "block.vtkhdf");
        const auto surface = scalar_values(labelled, "surface");
        double count = 0;
        for (std::size_t i = 0; i < labelled.size(); ++i)
            count += labelled.positions[i][2] < 0.1 * *fluid.support_radius ? surface[i] : 0;
        return count;
    };
    const double all = surface_below({});
    EXPECT_GT(all, 20);
    EXPECT_LT(surface_below({"--boundary", walls}), all);
    EXPECT_NE(succeed({"label", input, "-o", out, "--boundary", walls}).find("up to date"),
              std::string::npos);
    const Snapshot with = read_vtkhdf(out / "block.vtkhdf");
    EXPECT_EQ(with.boundary, floor.positions);
    EXPECT_EQ(with.provenance.at("boundary_hash"), file_hash(walls));
    EXPECT_EQ(with.provenance.at("boundary_particles"), std::to_string(floor.size()));
    // An input that holds its boundary is labelled with it, unless told otherwise.
    const Path again = folder / "again";
    expect_mentions(succeed({"label", out / "block.vtkhdf", "-o", again}),
                    {"boundary particles cover"});
    EXPECT_EQ(scalar_values(read_vtkhdf(again / "block.vtkhdf"), "surface"),
              scalar_values(with, "surface"));
    succeed({"label", out / "block.vtkhdf", "-o", again, "--no-boundary"});
    EXPECT_EQ(scalar_values(read_vtkhdf(again / "block.vtkhdf"), "surface"), [&] {
        surface_below({});
        return scalar_values(read_vtkhdf(out / "block.vtkhdf"), "surface");
    }());
    fail(2, {"label", input, "-o", out, "--boundary", folder / "none.vtk"}, {"none.vtk"});
    fail(2, {"label", input, "-o", out, "--boundary", save(Snapshot{}, "empty.vtkhdf")},
         {"empty.vtkhdf", "--boundary"});
    fail(2, {"label", input, "-o", out, "--boundary", walls, "--no-boundary"}, {"--boundary"});
}

TEST_F(Label, OneParticleIsAllSurface) {
    Snapshot one;
    one.positions = {{1, 2, 3}};
    const Path input = save(one, "one.vtkhdf");
    const Outcome outcome = run(program + Words{"label", input, "-o", folder / "out", "--quiet",
                                                "--support-radius", "0.1"});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    const Snapshot labelled = read_vtkhdf(folder / "out" / "one.vtkhdf");
    EXPECT_EQ(scalar_values(labelled, "uncovered_fraction"), Doubles{1});
    EXPECT_EQ(scalar_values(labelled, "neighbor_count"), Doubles{0});
}

TEST_F(Label, TwoParticlesInOnePlaceCoverNothingOfEachOther) {
    Snapshot pair;
    pair.dimension = 3;
    pair.support_radius = 1;
    pair.positions = {{1, 2, 3}, {1, 2, 3}};
    const Path input = save(pair, "pair.vtkhdf");
    const Outcome outcome = run(program + Words{"label", input, "-o", folder / "out", "--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    const Snapshot labelled = read_vtkhdf(folder / "out" / "pair.vtkhdf");
    EXPECT_EQ(scalar_values(labelled, "surface"), (Doubles{1, 1}));
    EXPECT_EQ(scalar_values(labelled, "mass_offset"), (Doubles{0, 0}));
}

TEST_F(Label, SupportRadiusOfEachParticle) {
    Snapshot snapshot = block(4);
    snapshot.support_radius.reset();
    Doubles radii(snapshot.size(), 1.0);
    set_array(snapshot, {"support_radius", 1, radii});
    EXPECT_EQ(read_vtkhdf(label(save(snapshot, "same.vtkhdf"))).support_radius, 1.0);
    radii[17] = 1.25;
    set_array(snapshot, {"support_radius", 1, radii});
    const Path varying = save(snapshot, "varying.vtkhdf");
    succeed({"label", varying, "-o", folder / "varying"});
    const Snapshot labelled = read_vtkhdf(folder / "varying" / "varying.vtkhdf");
    EXPECT_FALSE(labelled.support_radius);
    EXPECT_EQ(scalar_values(labelled, "support_radius"), radii);
    EXPECT_EQ(labelled.provenance.at("support_radius"), "1 to 1.25");
    expect_mentions(succeed({"label", varying, "-o", folder / "varying"}), {"up to date"});
    // One for all in their place, which is then what the file goes by.
    succeed({"label", varying, "-o", folder / "one", "--support-radius", "1"});
    EXPECT_EQ(read_vtkhdf(folder / "one" / "varying.vtkhdf").support_radius, 1.0);
    radii[3] = nan;
    set_array(snapshot, {"support_radius", 1, radii});
    fail(2, {"label", save(snapshot, "nan.vtkhdf"), "-o", folder / "out"},
         {"nan.vtkhdf", "particle 3", "nan"});
    radii[3] = 1e-4;
    set_array(snapshot, {"support_radius", 1, radii});
    fail(2, {"label", save(snapshot, "range.vtkhdf"), "-o", folder / "out"},
         {"range.vtkhdf", "particle 3", "particle 17", "--support-radius"});
}

TEST_F(Label, TwoDimensions) {
    const Path flat = save(block(8, 2), "flat.vtkhdf");
    const std::string printed = succeed({"label", flat, "-o", folder / "out"});
    expect_mentions(printed, {"64 particles in 2D"});
    fail(2, {"label", save(block(4), "solid.vtkhdf"), "-o", folder / "out", "--dimension", "2"},
         {"solid.vtkhdf", "--dimension 2", "particle 16"});
}

} // namespace
} // namespace meniscus
