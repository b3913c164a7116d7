// The report's page in a browser without a window: what its script makes of the data.
#include "report_page.hpp"

#include <meniscus/classifier/model/model.hpp>

#include <algorithm>

namespace meniscus {
namespace {

using Json = nlohmann::json;

class Browser : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        if (std::string(MENISCUS_BROWSER).find("NOTFOUND") != std::string::npos)
            GTEST_SKIP() << "needs chromium";
        std::filesystem::create_directories(folder);
        labelled = label(sample("droplet_iisph_04"));
    }

    Json audit(const Path& model) const {
        return Json::parse(succeed({"audit", labelled, "--model", model, "--label-threshold",
                                    "0.02", "--format", "json", "--report", page}))["total"];
    }

    /// The page once its script has run with a link's fragment.
    [[nodiscard]] std::string shown(const std::string& fragment) const {
        const Outcome outcome =
            run({MENISCUS_BROWSER, "--headless", "--no-sandbox", "--use-angle=swiftshader",
                 "--enable-unsafe-swiftshader", "--user-data-dir=" + (folder / "profile").string(),
                 "--virtual-time-budget=20000", "--dump-dom",
                 "file://" + page.string() + "#" + fragment});
        EXPECT_NE(outcome.output.find("data-ready=\"yes\""), std::string::npos)
            << outcome.errors.substr(0, 2000);
        return outcome.output;
    }

    /// The text of the element of that id.
    [[nodiscard]] static std::string text(const std::string& document, const std::string& id) {
        const std::size_t start = document.find('>', document.find("id=\"" + id + "\"")) + 1;
        return document.substr(start, document.find('<', start) - start);
    }

    [[nodiscard]] static std::string cell(const std::string& document, const std::string& name) {
        const std::string head = name + "</th><td>";
        const std::size_t start = document.find(head) + head.size();
        return document.substr(start, document.find('<', start) - start);
    }

    static void expect_counts(const std::string& document, const Json& counts) {
        EXPECT_EQ(text(document, "particles"), counts["particles"].dump());
        EXPECT_EQ(text(document, "surface"), counts["surface"].dump());
        EXPECT_EQ(text(document, "false-negatives"), counts["false_negatives"].dump());
        EXPECT_EQ(text(document, "false-positives"), counts["false_positives"].dump());
    }

    Path labelled;
    const Path page = folder / "page.html";
    const Path model = Path(MENISCUS_MODELS) / "surface_3d.json";
};

TEST_F(Browser, CountsAsTheAuditDoesWhereverTheLineIs) {
    const Json as_trained = audit(model);
    const std::string document = shown("scope=all");
    expect_counts(document, as_trained);
    EXPECT_EQ(text(document, "notes"), "");
    Model moved = read_model(model);
    moved.line.d = 14.5;
    moved.line.k = 40;
    const Path moved_file = write("moved.json", model_to_json(moved));
    const Json as_moved = audit(moved_file);
    EXPECT_GT(as_moved["false_negatives"], 0);
    audit(model); // its page
    const std::string page_moved = shown("k=40&d=14.5");
    expect_counts(page_moved, as_moved);
    EXPECT_NE(page_moved.find("constexpr double d = 14.5;"), std::string::npos);
    // What it offers for copying is a model that judges alike.
    std::string copied = text(page_moved, "model-text");
    for (std::size_t at; (at = copied.find("&lt;")) != std::string::npos;)
        copied.replace(at, 4, "<");
    EXPECT_EQ(audit(write("copied.json", copied))["false_negatives"], as_moved["false_negatives"]);
}

TEST_F(Browser, ShiftsToZeroFalseNegatives) {
    audit(Path(MENISCUS_MODELS) / "splishsplash_d12.json");
    const std::string before = shown("d=0");
    EXPECT_NE(text(before, "false-negatives"), "0");
    const std::string after = shown("d=0&zero");
    EXPECT_EQ(text(after, "false-negatives"), "0");
    EXPECT_EQ(text(after, "missed-area"), "0.0000 %");
}

TEST_F(Browser, ShowsThePickedParticleAndWhatCoversIt) {
    audit(model);
    const Snapshot snapshot = read_vtkhdf(labelled);
    const auto lambda = scalar_values(snapshot, "uncovered_fraction");
    const auto counts = scalar_values(snapshot, "neighbor_count");
    std::size_t surface = 0;
    while (lambda[surface] < 0.1)
        ++surface;
    const std::string document = shown("pick=" + std::to_string(surface));
    EXPECT_EQ(cell(document, "particle"), std::to_string(surface));
    EXPECT_EQ(cell(document, "caps of neighbors"),
              std::to_string(static_cast<int>(counts[surface])));
    EXPECT_NEAR(std::stod(cell(document, "uncovered fraction lambda")), lambda[surface], 1e-5);
    EXPECT_EQ(document.find("needs WebGL"), std::string::npos);
}

TEST_F(Browser, ShowsLabelsWithoutALine) {
    succeed(
        {"label", sample("droplet_iisph_04"), "-o", folder / "again", "--quiet", "--report", page});
    const auto surface =
        scalar_values(read_vtkhdf(folder / "again" / labelled.filename()), "surface");
    const std::string document = shown("pick=0&d=3");
    EXPECT_EQ(text(document, "surface"),
              std::to_string(std::count(surface.begin(), surface.end(), 1)));
    EXPECT_EQ(cell(document, "by label"), surface[0] != 0 ? "surface" : "interior");
}

} // namespace
} // namespace meniscus
