#include "command.hpp"
#include "runtime/option_values.hpp"

#include <meniscus/bindings/step/surface_step.hpp>
#include <meniscus/classifier/model/model.hpp>
#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/data/text/files.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

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

    /// Classifies, without a word, and reads what was written.
    [[nodiscard]] Snapshot classified(const Path& input, const Words& options = {}) const {
        std::filesystem::remove_all(out);
        EXPECT_EQ(
            succeed(Words{"classify", input, "--model", model, "-o", out, "--quiet"} + options),
            "");
        return read_vtkhdf(out / input.stem().concat(".vtkhdf"));
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

TEST_F(Classify, CandidatesAreThoseOfTheModelWithoutALineThatShips) {
    const Snapshot found = classified(sample("droplet_iisph_04"));
    const auto candidates = scalar_values(found, "predicted_surface");
    const auto classes = scalar_values(found, "surface_class");
    EXPECT_EQ(std::count_if(classes.begin(), classes.end(), [](double one) { return one > 0; }),
              std::count(candidates.begin(), candidates.end(), 1));
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
                           "--threads", threads, "--balance-momentum", "--quiet"}),
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

TEST_F(Classify, RefusesASupportRadiusOverNearlyAllParticles) {
    const Path input = save(block(16), "block.vtkhdf"); // 8 wide
    fail(2, {"classify", input, "--model", model, "-o", out, "--support-radius", "20"},
         {"block.vtkhdf", "support radius of 20 m", "neighbors a particle", "at most 2000"});
    Snapshot beside_walls = block(3);
    for (const auto& place : block(16).positions)
        beside_walls.boundary.push_back({place[0] - 9, place[1], place[2]});
    fail(2,
         {"classify", save(beside_walls, "walls.vtkhdf"), "--model", model, "-o", out,
          "--support-radius", "30"},
         {"walls.vtkhdf", "support radius of 30 m", "boundary particles"});
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

/// Three values a particle.
std::vector<std::array<double, 3>> vectors(const Snapshot& snapshot, const char* name) {
    const auto values = as_doubles(*find_array(snapshot, name));
    std::vector<std::array<double, 3>> all(snapshot.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        all[i / 3][i % 3] = values[i];
    return all;
}

double product(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

const char* const arrays_of_runtime[] = {"surface_class", "runtime_uncovered_fraction",
                                         "runtime_normal", "runtime_curvature", "runtime_force"};

/// True where the runtime wrote the same.
bool same_surface(const Snapshot& a, const Snapshot& b) {
    return std::all_of(std::begin(arrays_of_runtime), std::end(arrays_of_runtime),
                       [&](const char* name) {
                           return find_array(a, name)->values == find_array(b, name)->values;
                       });
}

/// With samples or without, the surface is that of the exact labels, as far as the line lets it
/// through.
TEST_F(Classify, SurfaceIsThatOfTheLabels) {
    const Path input = sample("dam_dfsph_08");
    succeed({"label", input, "-o", folder / "labelled", "--quiet"});
    const Snapshot labelled = read_vtkhdf(folder / "labelled" / input.filename());
    const auto surface = scalar_values(labelled, "surface");
    const auto lambda = scalar_values(labelled, "uncovered_fraction");
    const Snapshot sampled = classified(input);
    const Snapshot exact = classified(input, {"--coverage", "exact"});
    const auto line = scalar_values(sampled, "predicted_surface");
    const auto class_of = scalar_values(sampled, "surface_class");
    const auto exact_lambda = scalar_values(exact, "runtime_uncovered_fraction");
    EXPECT_EQ(scalar_values(exact, "surface_class"), class_of);
    EXPECT_EQ(std::set<double>(class_of.begin(), class_of.end()), (std::set<double>{0, 1, 2}));
    for (std::size_t i = 0; i < sampled.size(); ++i) {
        ASSERT_EQ(class_of[i], line[i] == 0 ? 0 : 1 + surface[i]) << i;
        ASSERT_NEAR(exact_lambda[i], line[i] * lambda[i], 1e-9) << i;
    }
}

TEST_F(Classify, NormalsCurvaturesAndForces) {
    const Snapshot found = classified(sample("droplet_iisph_04"));
    const auto class_of = scalar_values(found, "surface_class");
    const auto curvature = scalar_values(found, "runtime_curvature");
    const auto normals = vectors(found, "runtime_normal");
    const auto forces = vectors(found, "runtime_force");
    std::size_t exposed = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double length = std::sqrt(product(normals[i], normals[i]));
        EXPECT_TRUE(length == 0 || std::fabs(length - 1) < 1e-12) << i;
        exposed += length > 0 ? 1 : 0;
        EXPECT_EQ(length > 0, class_of[i] == 2) << i;
        // Along the normal, inwards where the fluid is convex.
        EXPECT_NEAR(product(forces[i], normals[i]),
                    -std::copysign(std::sqrt(product(forces[i], forces[i])), curvature[i]), 1e-15);
        EXPECT_TRUE(class_of[i] == 2 || curvature[i] == 0) << i;
    }
    EXPECT_GT(exposed, 2000U);
    EXPECT_EQ(find_array(found, "surface"), nullptr); // names of labels stay theirs
    EXPECT_EQ(find_array(found, "uncovered_fraction"), nullptr);
}

TEST_F(Classify, ForcesGrowWithSurfaceTensionAndBalance) {
    const Path input = sample("droplet_iisph_04");
    const auto usual = vectors(classified(input), "runtime_force");
    const auto tenfold = vectors(classified(input, {"--surface-tension", "0.72"}), "runtime_force");
    const auto balanced = vectors(classified(input, {"--balance-momentum"}), "runtime_force");
    std::array<double, 3> sum{};
    std::array<double, 3> balanced_sum{};
    double sizes = 0;
    for (std::size_t i = 0; i < usual.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(tenfold[i][axis], 10 * usual[i][axis], 1e-12 * std::fabs(tenfold[i][axis]));
            sum[axis] += usual[i][axis];
            balanced_sum[axis] += balanced[i][axis];
            sizes += std::fabs(usual[i][axis]);
        }
    EXPECT_GT(std::sqrt(product(sum, sum)), 1e-6 * sizes);
    EXPECT_LT(std::sqrt(product(balanced_sum, balanced_sum)), 1e-12 * sizes);
}

/// Each option changes what is written, and provenance says so.
TEST_F(Classify, OptionsOfTheRuntime) {
    const Path input = sample("droplet_iisph_14");
    const Snapshot usual = classified(input);
    const std::map<std::string, std::string> expected = {
        {"runtime_coverage", "sampled"},
        {"runtime_samples", "128"},
        {"runtime_seed", "0"},
        {"runtime_verification", "exact"},
        {"runtime_fade", "0.3333333333333333"},
        {"runtime_normal_passes", "1"},
        {"runtime_tau", "0.5"},
        {"runtime_covariance_share", "0"},
        {"runtime_curvature", "mapped"},
        {"runtime_curvature_passes", "0"},
        {"runtime_force", "calibrated"},
        {"runtime_surface_tension", "0.072"},
        {"runtime_balance_momentum", "false"},
    };
    for (const auto& [name, text] : expected)
        EXPECT_EQ(usual.provenance.at(name), text) << name;
    struct Case {
        Words options;
        std::string name, text;
    };
    const std::vector<Case> cases = {
        {{"--samples", "32"}, "samples", "32"},
        {{"--coverage", "exact"}, "coverage", "exact"},
        {{"--time-step", "0.002", "--sampling-density", "100000"}, "samples", "200"},
        {{"--time-step", "1e-9", "--sampling-density", "100000"}, "samples", "16"},
        {{"--time-step", "1e-9", "--sampling-density", "1e5", "--samples", "40"}, "samples", "40"},
        {{"--verification", "drop", "--samples", "16"}, "verification", "drop"},
        {{"--fade", "0.5"}, "fade", "0.5"},
        {{"--fade", "0"}, "fade", "0"},
        {{"--seed", "18446744073709551615"}, "seed", "18446744073709551615"},
        {{"--normal-passes", "3"}, "normal_passes", "3"},
        {{"--tau", "0.25"}, "tau", "0.25"},
        {{"--covariance-share", "0.5"}, "covariance_share", "0.5"},
        {{"--curvature", "closed"}, "curvature", "closed"},
        {{"--curvature-passes", "2"}, "curvature_passes", "2"},
        {{"--force", "paper"}, "force", "paper"},
        {{"--surface-tension", "1"}, "surface_tension", "1"},
        {{"--particle-spacing", "0.03"}, "spacing_ratio", "4"},
        {{"--balance-momentum"}, "balance_momentum", "true"},
    };
    for (const auto& [options, name, text] : cases) {
        const Snapshot other = classified(input, options);
        EXPECT_EQ(other.provenance.at("runtime_" + name), text);
        EXPECT_FALSE(same_surface(other, usual)) << options[0];
    }
}

/// What the runtime finds of a snapshot that was classified, its line's candidates given.
std::vector<std::array<double, 3>> forces_of(const Snapshot& snapshot,
                                             const SurfaceTensionOptions& options) {
    const NeighborLists lists = find_neighbors(snapshot.positions, *snapshot.support_radius);
    const auto predicted = scalar_values(snapshot, "predicted_surface");
    const std::vector<std::uint8_t> candidates(predicted.begin(), predicted.end());
    StepParticles particles;
    particles.count = snapshot.size();
    particles.positions = snapshot.positions.data();
    particles.support_radius = *snapshot.support_radius;
    particles.offsets = lists.offsets.data();
    particles.neighbors = lists.neighbors.data();
    particles.candidates = candidates.data();
    const auto step = surface_step(options, StepSetup{});
    step->step(particles);
    const SurfaceStepResults found = step->results();
    std::vector<std::array<double, 3>> forces(found.count);
    for (std::size_t slot = 0; slot < found.slots; ++slot)
        std::copy_n(static_cast<const double*>(found.force) + 3 * slot, 3,
                    forces[found.particle[slot]].begin());
    return forces;
}

/// Those of the table that neither the model nor the input gives.
template <class Visit>
void for_each_option_of_command(const Visit& visit) {
    const std::set<std::string> given = {"k", "d", "boundary_weight", "radius_ratio",
                                         "spacing_ratio"};
    for_each_surface_option([&](const auto& option) {
        std::string flag = std::string("--") + option.name;
        std::replace(flag.begin(), flag.end(), '_', '-');
        if (given.count(option.name) == 0)
            visit(option, flag);
    });
}

template <class Value>
std::string text_of(const SurfaceOption<Value>& option, Value value) {
    if constexpr (std::is_enum_v<Value>) {
        const auto number = static_cast<int>(value);
        return number == 0 || number == 1 ? option.range.words[number] : std::to_string(number);
    } else {
        std::ostringstream text;
        text << std::setprecision(17) << value;
        return text.str();
    }
}

/// Set here or in a program, an option gives the same bits, and provenance has its name and value.
TEST_F(Classify, EachOptionIsThatOfTheRuntime) {
    const Path input = sample("droplet_iisph_14");
    int options = 0;
    for_each_option_of_command([&](const auto& option, const std::string& flag) {
        SurfaceTensionOptions changed;
        set_other(option, changed);
        const std::string text = text_of(option, changed.*option.member);
        const Snapshot snapshot = classified(input, {flag, text});
        changed.spacing_ratio = std::stod(snapshot.provenance.at("runtime_spacing_ratio"));
        EXPECT_TRUE(vectors(snapshot, "runtime_force") == forces_of(snapshot, changed)) << flag;
        const std::string noted = snapshot.provenance.at(std::string("runtime_") + option.name);
        EXPECT_TRUE(text == noted || std::stod(text) == std::stod(noted)) << flag << noted;
        ++options;
    });
    EXPECT_EQ(options, 14);
}

TEST_F(Classify, NamesTheRangeOfEachOption) {
    const Words words = {"classify", sample("droplet_iisph_04"), "--model", model, "-o", out};
    for_each_option_of_command([&](const auto& option, const std::string& flag) {
        for (const auto value : values_out_of_range(option))
            fail(2, words + Words{flag, text_of(option, value)}, {flag.c_str(), option.range.text});
    });
}

TEST_F(Classify, PaperIsWhatItsOptionsSay) {
    const Path input = sample("droplet_iisph_14");
    const Words spelled = {"--verification",     "drop",   "--fade",  "0",
                           "--curvature",        "closed", "--force", "paper",
                           "--curvature-passes", "1"};
    const Snapshot paper = classified(input, {"--paper"});
    const std::string bytes = bytes_of(out / input.filename());
    EXPECT_FALSE(same_surface(paper, classified(input)));
    (void)classified(input, spelled);
    EXPECT_TRUE(bytes_of(out / input.filename()) == bytes);
    (void)classified(input, {"--paper", "--curvature-passes", "2"});
    EXPECT_FALSE(bytes_of(out / input.filename()) == bytes);
}

TEST_F(Classify, SaysWhatWasFound) {
    const Path input = sample("dam_dfsph_08");
    const Words words = {"classify", input, "--model", model, "-o", out};
    const auto counted = [&](const std::string& printed, double min) {
        const auto classes = scalar_values(read_vtkhdf(out / input.filename()), "surface_class");
        const auto count = std::count_if(classes.begin(), classes.end(),
                                         [&](double value) { return value >= min; });
        EXPECT_NE(printed.find(std::to_string(count)), std::string::npos) << printed << count;
    };
    const std::string printed = succeed(words);
    expect_mentions(printed, {"candidates of the line", "of them surface", "exact check"});
    counted(printed, 1);
    counted(printed, 2);
    const std::string dropping = succeed(words + Words{"--paper"});
    expect_mentions(dropping, {"dropped"});
    counted(dropping, 2);
}

TEST_F(Classify, SaysWhatItTookForTheSpacing) {
    Snapshot snapshot = block(6);
    const Words words = {"classify", save(snapshot, "measured.vtkhdf"), "--model", model, "-o",
                         out};
    expect_mentions(succeed(words), {"h is 2.00 spacings", "as measured", "--particle-volume"});
    const std::string given = succeed(words + Words{"--particle-volume", "0.1"});
    EXPECT_EQ(given.find("as measured"), std::string::npos) << given;
    expect_mentions(given, {"h is 2.15 spacings"});
}

TEST_F(Classify, BadValuesNameTheirOption) {
    const Words words = {"classify", sample("droplet_iisph_04"), "--model", model, "-o", out};
    const std::vector<Words> cases = {
        {"--samples", "3"},
        {"--samples", "20000"},
        {"--samples", "-5"},
        {"--time-step", "0.1"},
        {"--sampling-density", "1000"},
        {"--time-step", "0", "--sampling-density", "1000"},
        {"--sampling-density", "inf", "--time-step", "1"},
        {"--fade", "-1"},
        {"--fade", "1.5"},
        {"--tau", "2"},
        {"--tau", "nan"},
        {"--tau", "half"},
        {"--covariance-share", "-0.1"},
        {"--normal-passes", "-1"},
        {"--curvature-passes", "1.5"},
        {"--curvature", "open"},
        {"--force", "strong"},
        {"--surface-tension", "inf"},
        {"--particle-spacing", "0"},
        {"--samples", "16", "--coverage", "exact"},
        {"--verification", "drop", "--coverage", "exact"},
        {"--time-step", "0.1", "--sampling-density", "1e4", "--coverage", "exact"},
        {"--coverage", "0"},
        {"--seed", "-1"},
        {"--k", "1"},
    };
    for (const Words& options : cases)
        fail(2, words + options, {options[0].c_str()});
}

TEST_F(Classify, RerunsWithOtherOptionsLeaveNoTrace) {
    const Path input = sample("droplet_iisph_04");
    const Words words = {"classify", input, "--model", model, "--quiet", "-o"};
    succeed(words + Words{out, "--coverage", "exact", "--balance-momentum"});
    succeed(words + Words{out, "--paper", "--balance-momentum"});
    succeed(words + Words{folder / "fresh", "--paper", "--balance-momentum", "--threads", "1"});
    EXPECT_TRUE(bytes_of(out / input.filename()) == bytes_of(folder / "fresh" / input.filename()));
    // What was classified can be classified: its arrays are replaced.
    succeed({"classify", folder / "fresh" / input.filename(), "--model", model, "-o",
             folder / "again"});
    EXPECT_TRUE(same_surface(read_vtkhdf(folder / "again" / input.filename()), classified(input)));
}

TEST_F(Classify, IdsKeyTheSamples) {
    Snapshot snapshot = block(8);
    const Snapshot plain = classified(save(snapshot, "block.vtkhdf"));
    std::vector<std::int64_t> ids(snapshot.size());
    std::iota(ids.begin(), ids.end(), 0);
    set_array(snapshot, {"id", 1, ids});
    EXPECT_TRUE(same_surface(classified(save(snapshot, "block.vtkhdf")), plain));
    std::reverse(ids.begin(), ids.end());
    set_array(snapshot, {"id", 1, ids});
    const Snapshot reversed = classified(save(snapshot, "block.vtkhdf"));
    EXPECT_FALSE(same_surface(reversed, plain));
    EXPECT_EQ(scalar_values(reversed, "surface_class"), scalar_values(plain, "surface_class"));
}

/// Phases do not cover each other.
TEST_F(Classify, PhasesAreApart) {
    Snapshot snapshot = block(8);
    const auto count_surface = [&] {
        const auto classes =
            scalar_values(classified(save(snapshot, "block.vtkhdf")), "surface_class");
        return std::count(classes.begin(), classes.end(), 2);
    };
    const auto whole = count_surface();
    std::vector<std::int32_t> phases;
    for (const auto& position : snapshot.positions)
        phases.push_back(position[2] < 2 ? 0 : 1);
    set_array(snapshot, {"phase", 1, phases});
    EXPECT_GT(count_surface(), whole + 60);
}

/// A block on a floor: its lowest layer is covered, and a body at a wall is not free.
TEST_F(Classify, BoundaryCoversAndHolds) {
    const Path input = save(block(8), "block.vtkhdf");
    Snapshot layers;
    for (const auto& position : block(8).positions)
        if (position[2] < 1)
            layers.positions.push_back({position[0], position[1], position[2] - 1});
    const Words floor = {"--boundary", save(layers, "floor.vtkhdf")};
    const Snapshot free = classified(input);
    const Snapshot held = classified(input, floor);
    EXPECT_FALSE(same_surface(free, classified(input, {"--balance-momentum"})));
    EXPECT_TRUE(same_surface(held, classified(input, floor + Words{"--balance-momentum"})));
    const auto free_class = scalar_values(free, "surface_class");
    const auto held_class = scalar_values(held, "surface_class");
    std::size_t no_longer_surface = 0;
    for (std::size_t i = 0; i < free.size(); ++i) {
        EXPECT_LE(held_class[i], free_class[i]);
        EXPECT_TRUE(free.positions[i][2] <= 1 || held_class[i] == free_class[i]) << i;
        no_longer_surface += held_class[i] < 2 && free_class[i] == 2 ? 1 : 0;
    }
    EXPECT_GE(no_longer_surface, 16U);
}

TEST_F(Classify, LeftOutParticlesHaveNothing) {
    Snapshot snapshot = block(7);
    snapshot.positions[62][1] = std::numeric_limits<double>::quiet_NaN();
    const Snapshot found =
        classified(save(snapshot, "hole.vtkhdf"), {"--skip-invalid", "--balance-momentum"});
    for (const char* name : arrays_of_runtime) {
        const auto values = as_doubles(*find_array(found, name));
        EXPECT_TRUE(std::all_of(values.begin(), values.end(), [](double value) {
            return std::isfinite(value);
        })) << name;
    }
    EXPECT_EQ(scalar_values(found, "surface_class")[62], 0);
}

class ClassifyFlat : public Classify {
protected:
    void SetUp() override {
        Classify::SetUp();
        Model flat;
        flat.dimension = 2;
        flat.line = {20, 9};
        flat.objective = "by hand";
        write("model.json", model_to_json(flat));
    }
};

/// A pool in a tank, walls in the same file, as PySPH's examples are: surface is its upper edge.
TEST_F(ClassifyFlat, PoolInATank) {
    Snapshot pool;
    pool.dimension = 2;
    pool.support_radius = 1;
    pool.particle_spacing = 0.5;
    constexpr int width = 20;
    constexpr int height = 10;
    for (int y = -3; y < height; ++y)
        for (int x = -3; x < width + 3; ++x) {
            const bool wall = y < 0 || x < 0 || x >= width;
            (wall ? pool.boundary : pool.positions).push_back({0.5 * x, 0.5 * y, 0});
        }
    const Path input = save(pool, "pool.vtkhdf");
    const Snapshot found = classified(input, {"--balance-momentum"});
    const auto class_of = scalar_values(found, "surface_class");
    const auto normals = vectors(found, "runtime_normal");
    const auto forces = vectors(found, "runtime_force");
    for (std::size_t i = 0; i < found.size(); ++i) {
        const bool at_edge = found.positions[i][1] == 0.5 * (height - 1);
        EXPECT_EQ(class_of[i] == 2, at_edge) << i;
        EXPECT_EQ(normals[i][2], 0);
        EXPECT_EQ(forces[i][2], 0);
        EXPECT_TRUE(!at_edge || normals[i][1] > 0.9) << i;
    }
    const std::string bytes = bytes_of(out / input.filename());
    (void)classified(input, {"--balance-momentum", "--threads", "1"});
    EXPECT_TRUE(bytes_of(out / input.filename()) == bytes);
}

TEST_F(ClassifyFlat, PysphsOwnFile) {
    const Snapshot found =
        classified(Path(MENISCUS_TEST_SAMPLES) / "pysph_dam_break.hdf5",
                   {"--support-radius", "0.078", "--paper", "--balance-momentum"});
    ASSERT_EQ(found.dimension, 2);
    for (const char* name : arrays_of_runtime)
        EXPECT_NE(find_array(found, name), nullptr) << name;
    EXPECT_EQ(scalar_values(found, "surface_class"), std::vector<double>(found.size(), 2));
}

} // namespace
} // namespace meniscus
