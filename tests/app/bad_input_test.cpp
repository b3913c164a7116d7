#include "command.hpp"

#include <meniscus/classifier/model/model.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace meniscus {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

class BadInput : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        write("model.json", model_to_json(by_hand()));
    }

    static Model by_hand() {
        Model model;
        model.line = {60, 20};
        model.objective = "by hand";
        return model;
    }

    /// Every verb that reads snapshots, on this one.
    [[nodiscard]] std::vector<Words> readers(const Path& input) const {
        return {{"label", input, "-o", folder / "out"},
                {"classify", input, "--model", model, "-o", folder / "out"},
                {"train", input, "-o", folder / "trained.json"},
                {"audit", input, "--model", model}};
    }

    void every_reader_fails(const Path& input, std::initializer_list<const char*> parts) const {
        for (const Words& words : readers(input))
            fail(2, words, parts);
    }

    const Path model = folder / "model.json";
};

/// Particles in SPlisHSPlasH's legacy format, big endian.
std::string legacy_vtk(const Positions& positions) {
    const std::string count = std::to_string(positions.size());
    std::string text = "# vtk DataFile Version 4.1\nparticles\nBINARY\nDATASET UNSTRUCTURED_GRID\n"
                       "POINTS " +
                       count + " float\n";
    const auto append = [&](auto value) {
        const char* bytes = reinterpret_cast<const char*>(&value);
        text += std::string(std::make_reverse_iterator(bytes + sizeof value),
                            std::make_reverse_iterator(bytes));
    };
    for (const auto& position : positions)
        for (const double coordinate : position)
            append(static_cast<float>(coordinate));
    text += "\nCELLS " + count + " " + std::to_string(2 * positions.size()) + "\n";
    for (std::size_t i = 0; i < positions.size(); ++i) {
        append(std::int32_t{1});
        append(static_cast<std::int32_t>(i));
    }
    text += "\nCELL_TYPES " + count + "\n";
    for (std::size_t i = 0; i < positions.size(); ++i)
        append(std::int32_t{1});
    return text + "\n";
}

TEST_F(BadInput, FilesThatAreNoSnapshots) {
    every_reader_fails(folder / "missing.vtk", {"missing.vtk"});
    every_reader_fails(write("empty.vtk", ""), {"empty.vtk", "empty"});
    every_reader_fails(write("notes.vtk", "Monday: wash the tank.\n"), {"notes.vtk", "format"});
    std::filesystem::create_directory(folder / "states");
    every_reader_fails(folder / "states", {"states", "folder"});
    every_reader_fails("/dev/null", {"/dev/null"});
    every_reader_fails(write("two\nlines.vtk", "text"), {"two\\x0alines.vtk"});
}

TEST_F(BadInput, TruncatedLegacyVtk) {
    const std::string whole = legacy_vtk(block(4).positions);
    for (const std::size_t length :
         {std::size_t{10}, std::size_t{100}, whole.size() / 2, whole.size() - 64})
        every_reader_fails(write("short.vtk", whole.substr(0, length)), {"short.vtk"});
}

TEST_F(BadInput, TruncatedVtkhdf) {
    const std::string whole = bytes_of(label(save(block(6), "block.vtkhdf")));
    for (const std::size_t length :
         {std::size_t{4}, std::size_t{8}, std::size_t{1000}, whole.size() / 2, whole.size() - 1})
        every_reader_fails(write("short.vtkhdf", whole.substr(0, length)), {"short.vtkhdf"});
}

TEST_F(BadInput, NoSupportRadius) {
    Snapshot snapshot = block(4);
    snapshot.support_radius.reset();
    const Path stored = save(snapshot, "bare.vtkhdf");
    const Path foreign = write("foreign.vtk", legacy_vtk(snapshot.positions));
    fail(2, readers(stored)[0], {"bare.vtkhdf", "no support radius", "--support-radius"});
    fail(2, readers(stored)[1], {"bare.vtkhdf", "no support radius", "--support-radius"});
    fail(2, readers(foreign)[0], {"foreign.vtk", "no support radius", "--support-radius"});
    succeed(readers(foreign)[0] + Words{"--support-radius", "1"});
}

TEST_F(BadInput, SupportRadiusThatIsNone) {
    const Path input = save(block(4), "block.vtkhdf");
    for (const char* radius : {"0", "-1", "nan", "inf", "-inf"}) {
        fail(2, readers(input)[0] + Words{"--support-radius", radius},
             {"block.vtkhdf", "--support-radius", "positive", radius});
        fail(2, readers(input)[1] + Words{"--support-radius", radius},
             {"block.vtkhdf", "--support-radius", "positive", radius});
    }
    fail(2, readers(input)[0] + Words{"--support-radius", "wide"}, {"--support-radius", "wide"});
    fail(2, readers(input)[0] + Words{"--support-radius", "1e-300"},
         {"block.vtkhdf", "support radi"});
}

TEST_F(BadInput, StoredSupportRadiusThatIsNone) {
    for (const double radius : {0.0, -1.0, nan, infinity}) {
        Snapshot snapshot = block(4);
        snapshot.support_radius.reset();
        set_array(snapshot, {"support_radius", 1, std::vector<double>(snapshot.size(), radius)});
        fail(2, readers(save(snapshot, "stored.vtkhdf"))[0], {"stored.vtkhdf", "support radius"});
    }
}

TEST_F(BadInput, PositionsThatAreNotFinite) {
    Snapshot snapshot = block(5);
    snapshot.positions[31][2] = nan;
    snapshot.positions[17][0] = infinity;
    snapshot.positions[99][1] = -infinity;
    const Path foreign = write("holes.vtk", legacy_vtk(snapshot.positions));
    const Words words = readers(foreign)[0] + Words{"--support-radius", "1", "--quiet"};
    fail(2, words, {"holes.vtk", "3 of 125", "particle 17", "--skip-invalid"});
    succeed(words + Words{"--skip-invalid"});
    const auto valid = scalar_values(read_vtkhdf(folder / "out" / "holes.vtkhdf"), "valid");
    for (std::size_t i = 0; i < valid.size(); ++i)
        EXPECT_EQ(valid[i], i == 17 || i == 31 || i == 99 ? 0 : 1) << i;
}

TEST_F(BadInput, SnapshotOfASolverWithNans) {
    const Path input = Path(MENISCUS_SHARED_SNAPSHOTS) / "splishsplash/dam_wcsph_04_with_nan.vtk";
    if (!std::filesystem::exists(input))
        GTEST_SKIP() << "no snapshots of real solvers at " << MENISCUS_SHARED_SNAPSHOTS;
    const Words words = readers(input)[0] + Words{"--support-radius", "0.1", "--samples", "100"};
    fail(2, words, {"dam_wcsph_04_with_nan.vtk", "12 of 26136", "first is particle"});
    succeed(words + Words{"--skip-invalid"});
    const Path labelled = folder / "out" / "dam_wcsph_04_with_nan.vtkhdf";
    const auto valid = scalar_values(read_vtkhdf(labelled), "valid");
    EXPECT_EQ(valid.size(), 26136U);
    EXPECT_EQ(std::count(valid.begin(), valid.end(), 0), 12);
    succeed({"train", labelled, "-o", folder / "trained.json"});
}

TEST_F(BadInput, SnapshotsWithoutLabels) {
    const Path input = save(block(4), "block.vtkhdf");
    fail(2, readers(input)[2], {"block.vtkhdf", "not a labelled snapshot", "meniscus label"});
    fail(2, readers(input)[3], {"block.vtkhdf", "not a labelled snapshot", "meniscus label"});
}

TEST_F(BadInput, LabelsThatAreDamaged) {
    const Path labelled = label(save(block(4), "block.vtkhdf"));
    const auto damage = [&](const char* array, double value) {
        Snapshot snapshot = read_vtkhdf(labelled);
        auto values = scalar_values(snapshot, array);
        values[21] = value;
        set_array(snapshot, {array, 1, values});
        return readers(save(snapshot, "damaged.vtkhdf"));
    };
    for (const char* array : {"uncovered_fraction", "mass_offset", "neighbor_count"})
        for (const double value : {nan, infinity, -1.0, 1e9}) {
            fail(2, damage(array, value)[2], {"damaged.vtkhdf", array, "21"});
            fail(2, damage(array, value)[3], {"damaged.vtkhdf", array, "21"});
        }
}

TEST_F(BadInput, MassesThatAreNotPositive) {
    for (const double mass : {0.0, -1.0, nan, infinity}) {
        Snapshot snapshot = block(4);
        std::vector<double> masses(snapshot.size(), 0.001);
        masses[5] = mass;
        set_array(snapshot, {"mass", 1, masses});
        const auto verbs = readers(save(snapshot, "masses.vtkhdf"));
        fail(2, verbs[0], {"masses.vtkhdf", "particle 5", "mass"});
        fail(2, verbs[1], {"masses.vtkhdf", "particle 5", "mass"});
    }
}

class BadModel : public BadInput {
protected:
    /// Every verb that reads a model, on this text.
    void every_reader_fails(const std::string& text, std::initializer_list<const char*> parts) {
        const Path bad = write("bad.json", text);
        fail(2, {"audit", labelled, "--model", bad}, parts);
        fail(2, {"classify", input, "--model", bad, "-o", folder / "out"}, parts);
        fail(2, {"export", bad, "-o", folder / "header.hpp"}, parts);
        fail(2, {"train", labelled, "-o", folder / "trained.json", "--keep-k", bad}, parts);
    }

    void SetUp() override {
        BadInput::SetUp();
        input = save(block(6), "block.vtkhdf");
        labelled = label(input);
    }

    Path input;
    Path labelled;
};

TEST_F(BadModel, TextThatIsNoModel) {
    every_reader_fails("", {"bad.json"});
    every_reader_fails("k = 60, d = 20\n", {"bad.json", "not JSON"});
    every_reader_fails("{}", {"bad.json", "missing"});
    every_reader_fails("[1, 2]", {"bad.json", "object"});
    const std::string whole = model_to_json(by_hand());
    every_reader_fails(whole.substr(0, whole.size() / 2), {"bad.json", "not JSON"});
}

TEST_F(BadModel, NumbersThatAreMissingOrNotFinite) {
    const auto whole = nlohmann::ordered_json::parse(model_to_json(by_hand()));
    for (const char* key : {"k", "d", "dimension", "radius_ratio", "label_threshold"}) {
        auto missing = whole;
        missing.erase(key);
        every_reader_fails(missing.dump(), {"bad.json", key, "missing"});
        for (const char* value : {"null", "\"60\"", "1e999", "-1e999", "NaN", "Infinity", "[60]"}) {
            auto marked = whole;
            marked[key] = "HERE";
            std::string text = marked.dump();
            text.replace(text.find("\"HERE\""), 6, value);
            every_reader_fails(text, {"bad.json", key});
        }
    }
}

TEST_F(BadModel, FilesThatAreNoModels) {
    for (const Path& file : {folder / "missing.json", folder, labelled}) {
        fail(2, {"audit", labelled, "--model", file}, {file.c_str()});
        fail(2, {"export", file, "-o", folder / "header.hpp"}, {file.c_str()});
    }
}

} // namespace
} // namespace meniscus
