#include "report_page.hpp"

namespace meniscus {
namespace {

using Json = nlohmann::json;

class Report : public CommandLine {
protected:
    [[nodiscard]] Path shipped(const std::string& name) const {
        return Path(MENISCUS_MODELS) / (name + ".json");
    }

    /// Writes a page and returns it.
    [[nodiscard]] std::string page(const Words& words) const {
        succeed(Words{"audit", "--report", page_file, "--quiet"} + words);
        return bytes_of(page_file);
    }

    const Path page_file = folder / "page.html";
};

struct Counted {
    std::size_t surface = 0;
    std::size_t missed = 0;
    std::size_t passed = 0;
};

/// What the page's script does: the lines on the features that it is given.
Counted count(const Json& planes, const Json& state) {
    const std::size_t particles = state["count"];
    const auto surface = unpacked<std::uint8_t>(state["arrays"]["surface"], particles);
    const auto neighbors = unpacked<double>(state["arrays"]["neighbor_count"], particles);
    std::vector<bool> predicted(particles, true);
    for (std::size_t p = 0; p < planes.size(); ++p) {
        const auto x = unpacked<double>(state["arrays"][planes[p]["features"][0]], particles);
        const auto y = unpacked<double>(state["arrays"][planes[p]["features"][1]], particles);
        const double ratio =
            state["scales"][p][1].get<double>() / state["scales"][p][0].get<double>();
        const double k = planes[p]["k"].get<double>() * ratio;
        const double d = planes[p]["d"].get<double>() * state["scales"][p][1].get<double>();
        for (std::size_t i = 0; i < particles; ++i)
            predicted[i] = predicted[i] && y[i] <= k * x[i] + d;
    }
    Counted counted;
    for (std::size_t i = 0; i < particles; ++i) {
        const bool is_predicted = predicted[i] || neighbors[i] == 0;
        counted.surface += surface[i];
        counted.missed += surface[i] != 0 && !is_predicted ? 1 : 0;
        counted.passed += surface[i] == 0 && is_predicted ? 1 : 0;
    }
    return counted;
}

TEST_F(Report, ItsArraysGiveTheAuditsCounts) {
    const Path labelled = label(sample("droplet_iisph_04"), {"--features", "direction_eigenvalue"});
    // One line, two lines that follow the spacing, and one that misses.
    for (const char* name : {"splishsplash_d12", "surface_3d", "surface_3d_strict"}) {
        const Words words = {labelled, "--model", shipped(name), "--label-threshold", "0.02"};
        const Json audit = Json::parse(succeed(Words{"audit", "--format", "json"} + words));
        const Json data = report_data(page(words));
        EXPECT_EQ(data["audit"], audit) << name;
        ASSERT_EQ(data["states"].size(), 1U);
        const Counted counted = count(data["planes"], data["states"][0]);
        EXPECT_EQ(counted.surface, audit["total"]["surface"]) << name;
        EXPECT_EQ(counted.missed, audit["total"]["false_negatives"]) << name;
        EXPECT_EQ(counted.passed, audit["total"]["false_positives"]) << name;
        EXPECT_GT(counted.missed + counted.passed, 0U) << name;
    }
}

TEST_F(Report, PositionsAreRoundedToTheExtent) {
    const Path labelled = label(sample("snake_dfsph_05"));
    const Snapshot snapshot = read_vtkhdf(labelled);
    const Json state = report_data(page({labelled, "--model", shipped("surface_3d")}))["states"][0];
    const std::size_t particles = snapshot.size();
    const auto steps = unpacked<std::uint16_t>(state["arrays"]["position"], 3 * particles);
    ASSERT_EQ(steps.size(), 3 * particles);
    const double step = state["step"];
    for (std::size_t i = 0; i < particles; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(state["low"][axis].get<double>() + step * steps[axis * particles + i],
                        snapshot.positions[i][axis], 0.5001 * step);
}

TEST_F(Report, HundredThousandParticlesAreBelowTenMegabytes) {
    const Path labelled = label(sample("droplet_iisph_04"), {"--features", "direction_eigenvalue"});
    const std::string one = page({labelled, "--model", shipped("surface_3d")});
    const std::string two =
        page({labelled, label(sample("cube_iisph_05")), "--model", shipped("surface_3d")});
    const double bytes_a_particle = static_cast<double>(two.size() - one.size()) / 10648;
    EXPECT_LT(static_cast<double>(one.size()) + bytes_a_particle * 100'000, 10e6);
}

TEST_F(Report, TextsOutOfFilesStayTexts) {
    const std::string hostile = "</script><img src=x onerror=alert(1)><!--\xe2\x80\xa8\"'&";
    const Path labelled = label(save(block(6), "<b onclick=x>.vtkhdf"));
    const std::string text =
        page({labelled, "--model", shipped("splishsplash_d28"), "--scene", hostile});
    EXPECT_EQ(text.find("<img"), std::string::npos);
    EXPECT_EQ(text.find("<b onclick"), std::string::npos);
    EXPECT_EQ(text.find("\xe2\x80\xa8"), std::string::npos);
    const Json data = report_data(text);
    EXPECT_EQ(data["states"][0]["scene"], hostile);
    EXPECT_EQ(data["states"][0]["file"], "<b onclick=x>.vtkhdf");
    EXPECT_EQ(data["audit"]["scenes"][0]["scene"], hostile);
}

TEST_F(Report, AsksNothingOfTheNetwork) {
    const std::string text =
        page({label(save(block(5), "block.vtkhdf")), "--model", shipped("splishsplash_d28")});
    EXPECT_NE(text.find("default-src 'none'"), std::string::npos);
    for (const char* reference : {" src=\"", " href=\"", "@import", "url("})
        EXPECT_EQ(text.find(reference), std::string::npos) << reference;
}

TEST_F(Report, FlatStatesAndWallsAreInIt) {
    Snapshot flat = block(9, 2);
    flat.particle_volume = 0.245; // within what the model was trained on
    for (int b = -3; b < 12; ++b)
        flat.boundary.push_back({0.5 * b, -0.5, 0});
    flat.boundary.push_back({1000, 0, 0}); // too far to be seen
    const Path labelled = label(save(flat, "flat.vtkhdf"), {"--features", "direction_eigenvalue"});
    const Json state = report_data(page({labelled, "--model", shipped("surface_2d")}))["states"][0];
    EXPECT_EQ(state["dimension"], 2);
    EXPECT_EQ(state["boundary_count"], 15);
    EXPECT_EQ(unpacked<std::uint16_t>(state["arrays"]["boundary"], 45).size(), 45U);
}

TEST_F(Report, OfClassifyHoldsWhatAnAuditOfItsLabelsFinds) {
    const Path input = sample("droplet_iisph_04");
    for (const char* name : {"splishsplash_d12", "surface_3d"}) {
        succeed({"classify", input, "-o", folder / name, "--model", shipped(name), "--report",
                 page_file, "--quiet"});
        const Json data = report_data(bytes_of(page_file));
        const Path labels = folder / (std::string(name) + "_labels");
        succeed({"label", folder / name / input.filename(), "-o", labels, "--quiet"});
        Json audit =
            Json::parse(succeed({"audit", "--format", "json", labels, "--model", shipped(name)}));
        for (const char* key : {"particles", "surface", "bands", "false_negatives",
                                "false_positives", "false_positives_float", "missed_area"})
            EXPECT_EQ(data["audit"]["total"][key], audit["total"][key]) << name << " " << key;
        EXPECT_EQ(data["model_file"], name);
        const Counted counted = count(data["planes"], data["states"][0]);
        EXPECT_EQ(counted.missed, audit["total"]["false_negatives"]) << name;
        EXPECT_EQ(counted.passed, audit["total"]["false_positives"]) << name;
    }
    const std::string page = bytes_of(page_file); // of outputs that are up to date, too
    succeed({"classify", input, "-o", folder / "surface_3d", "--model", shipped("surface_3d"),
             "--report", page_file, "--quiet", "--threads", "1"});
    EXPECT_EQ(bytes_of(page_file), page);
    fail(2, {"classify", input, "-o", folder / "out", "--report", input}, {"overwrite"});
}

TEST_F(Report, SameBytesWhateverTheThreads) {
    const Words words = {label(sample("droplet_iisph_04")), "--model", shipped("surface_3d")};
    const std::string once = page(words + Words{"--threads", "1"});
    EXPECT_EQ(page(words + Words{"--threads", "4"}), once);
}

TEST_F(Report, IsRefusedWhereItCannotBeWritten) {
    const Path labelled = label(save(block(5), "block.vtkhdf"));
    const Words words = {"audit", labelled, "--model", shipped("splishsplash_d28"), "--report"};
    fail(2, words + Words{labelled}, {"block.vtkhdf", "overwrite"});
    fail(2, words + Words{""}, {"the name of a file"});
    fail(2, words + Words{folder / "missing" / "page.html"}, {"missing"});
}

} // namespace
} // namespace meniscus
