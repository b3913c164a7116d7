#include "command.hpp"

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/data/text/files.hpp>

namespace meniscus {
namespace {

using Train = CommandLine;

/// Those that this build has.
Words objectives() {
    return MENISCUS_TRAINER ? Words{"neyman-pearson", "logistic", "network"}
                            : Words{"neyman-pearson"};
}

TEST_F(Train, MissesNoSurfaceParticleOfItsTrainingSet) {
    const Path droplet = label(sample("droplet_iisph_06"));
    const Path cube = label(sample("cube_iisph_05"));
    const Path file = folder / "model.json";
    const std::string printed = succeed({"train", droplet, cube, "-o", file});
    expect_mentions(printed, {"model.json: y <= ", "neyman-pearson", " 0 false negatives"});
    const Model model = read_model(file);
    EXPECT_EQ(model.objective, "neyman-pearson");
    EXPECT_EQ(model.false_negatives, 0U);
    ASSERT_EQ(model.training_files.size(), 2U);
    EXPECT_EQ(model.training_files[0].name, "droplet_iisph_06.vtkhdf");
    EXPECT_EQ(model.training_files[0].hash, file_hash(sample("droplet_iisph_06")));
    EXPECT_EQ(model.training_files[1].particles, 10648U);
    EXPECT_LT(model.false_positives, 500U);
}

TEST_F(Train, EveryObjectivePassesItsOwnAuditWhateverTheThreads) {
    const Path labelled = label(save(block(8), "block.vtkhdf"));
    for (const std::string& objective : objectives()) {
        Words models;
        for (const char* threads : {"OMP_NUM_THREADS=1", "OMP_NUM_THREADS=8"}) {
            const Path file = folder / (objective + threads + ".json");
            const Outcome outcome =
                run(Words{"env", threads} + program +
                    Words{"train", labelled, "-o", file, "--quiet", "--objective", objective});
            EXPECT_EQ(outcome.output + outcome.errors, "");
            succeed({"audit", labelled, "--model", file, "--max-false-negatives", "0", "--quiet"});
            EXPECT_EQ(read_model(file).objective, objective);
            models.push_back(bytes_of(file));
        }
        EXPECT_EQ(models[0], models[1]) << objective;
    }
}

TEST_F(Train, ReadsFilesInParallelWithTheSameModel) {
    std::filesystem::create_directory(folder / "in");
    for (int i = 0; i < 9; ++i) {
        Snapshot snapshot = block(5);
        snapshot.positions[62][0] += 0.02 * i;
        write_vtkhdf(snapshot, folder / "in" / ("block_" + std::to_string(i) + ".vtkhdf"));
    }
    succeed({"label", folder / "in", "-o", folder / "out", "--samples", "200", "--quiet"});
    const Path model = folder / "model.json";
    Words models;
    for (const char* threads : {"1", "2", "4"}) {
        succeed({"train", folder / "out", "-o", model, "--quiet", "--threads", threads});
        models.push_back(bytes_of(model));
    }
    EXPECT_EQ(models[0], models[1]);
    EXPECT_EQ(models[0], models[2]);
    ASSERT_EQ(read_model(model).training_files.size(), 9U);
    EXPECT_EQ(read_model(model).training_files[7].name, "block_7.vtkhdf");

    for (const char* cut : {"out/block_3.vtkhdf", "out/block_6.vtkhdf"})
        std::filesystem::resize_file(folder / cut, 3000);
    for (const char* threads : {"1", "4"})
        fail(2, {"train", folder / "out", "-o", model, "--quiet", "--threads", threads},
             {"block_3.vtkhdf"});
}

TEST_F(Train, KeepsTheSlopeOfAnotherModel) {
    const Path block_file = label(save(block(8), "block.vtkhdf"));
    const Path droplet = label(sample("droplet_iisph_14"));
    succeed({"train", block_file, "-o", folder / "block.json", "--quiet"});
    succeed({"train", droplet, "-o", folder / "droplet.json", "--quiet", "--keep-k",
             folder / "block.json"});
    const Model other = read_model(folder / "block.json");
    const Model model = read_model(folder / "droplet.json");
    EXPECT_EQ(model.line.k, other.line.k);
    EXPECT_NE(model.line.d, other.line.d);
    EXPECT_EQ(model.objective, "keep-k");
    EXPECT_EQ(model.false_negatives, 0U);
    fail(2, {"train", droplet, "-o", folder / "m.json", "--keep-k", folder / "none.json"},
         {"none.json"});
    fail(2,
         {"train", droplet, "-o", folder / "m.json", "--keep-k", folder / "block.json",
          "--objective", "neyman-pearson"},
         {"--keep-k", "--objective"});
}

TEST_F(Train, NeedsBothClasses) {
    const Path input = save(block(6), "block.vtkhdf");
    const Path labelled = label(input);
    const Path model = folder / "model.json";
    fail(2, {"train", labelled, "-o", model, "--label-threshold", "0.99"},
         {"block.vtkhdf", "no surface particle", "--label-threshold"});
    Snapshot dust = block(3);
    for (auto& position : dust.positions)
        position[0] *= 100;
    const Path scattered = folder / "dust.vtkhdf";
    const Outcome labelling = run(program + Words{"label", save(dust, "dust.vtkhdf"), "-o",
                                                  folder / "labelled", "--samples", "50"});
    EXPECT_EQ(labelling.status, 0) << labelling.errors;
    fail(2, {"train", folder / "labelled" / scattered.filename(), "-o", model},
         {"dust.vtkhdf", "no interior particle"});
}

TEST_F(Train, RefusesWhatCannotShareALine) {
    const Path solid = label(save(block(6), "solid.vtkhdf"));
    const Path flat = label(save(block(9, 2), "flat.vtkhdf"));
    const Path wide = label(save(block(6), "wide.vtkhdf"), {"--radius-ratio", "0.9"});
    const Path model = folder / "model.json";
    fail(2, {"train", solid, flat, "-o", model}, {"solid.vtkhdf is 3D", "flat.vtkhdf is 2D"});
    fail(2, {"train", solid, wide, "-o", model}, {"solid.vtkhdf", "wide.vtkhdf", "radius ratio"});
    succeed({"train", flat, "-o", folder / "flat.json", "--quiet"});
    fail(2, {"train", solid, "-o", model, "--keep-k", folder / "flat.json"},
         {"flat.json", "solid.vtkhdf", "2D", "3D"});
}

TEST_F(Train, DoesNotOverwriteItsInput) {
    const Path labelled = label(save(block(6), "block.vtkhdf"));
    const std::string bytes = bytes_of(labelled);
    fail(2, {"train", labelled, "-o", labelled}, {"block.vtkhdf", "overwrite"});
    EXPECT_TRUE(bytes_of(labelled) == bytes);
}

TEST_F(Train, SceneOfTheOption) {
    const Path labelled = label(save(block(6), "block.vtkhdf"));
    const Path model = folder / "model.json";
    expect_mentions(succeed({"train", labelled, "-o", model, "--scene", "puddle"}),
                    {"puddle: 216"});
    EXPECT_EQ(read_model(model).training_files[0].scene, "puddle");
}

TEST_F(Train, InTheFeaturesOfTheOption) {
    const Path input = save(block(8), "block.vtkhdf");
    const Path plain = label(input);
    const Path model = folder / "model.json";
    const Words pair = {"--features", "mass_offset,direction_eigenvalue"};
    fail(2, Words{"train", plain, "-o", model} + pair,
         {"block.vtkhdf", "meniscus label --features direction_eigenvalue"});
    const Path labelled = label(input, {"--features", "direction_eigenvalue,kernel_sum"});
    expect_mentions(succeed(Words{"train", labelled, "-o", model} + pair),
                    {"model.json: direction_eigenvalue", " mass_offset + ", " 0 false negatives"});
    succeed({"audit", labelled, "--model", model, "--max-false-negatives", "0"});
    succeed({"classify", labelled, "--model", model, "-o", folder / "classes", "--quiet"});
    const Path header = folder / "line.hpp";
    succeed({"export", model, "-o", header, "--quiet"});
    expect_mentions(bytes_of(header), {"{\"mass_offset\", \"direction_eigenvalue\"}"});
    // A model to keep brings its features.
    succeed({"train", labelled, "-o", folder / "kept.json", "--keep-k", model, "--quiet"});
    EXPECT_EQ(read_model(folder / "kept.json").line.k, read_model(model).line.k);
    fail(2, {"train", labelled, "-o", model, "--features", "mass_offset,density"},
         {"'density'", "kernel_sum", "neighbor_count"});
    fail(2, {"train", labelled, "-o", model, "--features", "mass_offset"},
         {"two different features"});
    fail(2, {"label", input, "-o", folder / "other", "--features", "density"},
         {"'density'", "kernel_sum"});
}

} // namespace
} // namespace meniscus
