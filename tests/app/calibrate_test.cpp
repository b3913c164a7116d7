#include "command.hpp"

#include <meniscus/classifier/curvature/curvature_model.hpp>
#include <meniscus/classifier/export/header_export.hpp>

namespace meniscus {
namespace {

/// Few small clouds in two dimensions.
constexpr const char* tiny = R"({
  "format": "meniscus calibration", "format_version": 1, "dimension": 2,
  "radius_ratio": 0.8, "fade": 0.03, "tau": 0.5, "normal_passes": 1, "averaged": true,
  "terms": ["constant", "turning", "square"], "bias_penalty": 100, "min_curvature": 0.1,
  "samples": [0], "seed": 5,
  "clouds": {"kind": "filled", "spacing_ratios": [2.2], "particles": 100,
             "arrangements": [{"kind": "relaxed", "jitter": 0.1}]},
  "shapes": [{"kind": "circle", "sizes": [0.1, 0.2, 0.4], "sides": ["inside", "outside"]}]
})";

class Calibrate : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        config = write("clouds.json", tiny);
    }

    Path config;
    const Path model = folder / "curvature.json";
};

#if MENISCUS_TRAINER

TEST_F(Calibrate, MakesAModelThatExportTakes) {
    expect_mentions(succeed({"calibrate", config, "-o", model}),
                    {"curvature.json: h kappa =", "turning", "outside of circle, h/R 0.1 to 0.4"});
    const CurvatureModel made = read_curvature_model(model);
    EXPECT_EQ(made.map.dimension, 2);
    EXPECT_EQ(made.residuals.size(), 6U);
    EXPECT_NEAR(made.map.coefficients[1], 1.1, 0.2);
    EXPECT_LT(made.map.coefficients[2], 0);

    const Path header = folder / "curvature_coefficients.hpp";
    expect_mentions(succeed({"export", model, "-o", header}),
                    {"meniscus::CurvatureCoefficients2D"});
    EXPECT_EQ(bytes_of(header), coefficient_header(made, "CurvatureCoefficients2D"));
    succeed({"export", model, "-o", header, "--name", "Mine", "--quiet"});
    EXPECT_EQ(bytes_of(header), coefficient_header(made, "Mine"));
}

TEST_F(Calibrate, GivesTheSameBytesWhateverTheThreads) {
    Words models;
    for (const char* threads : {"OMP_NUM_THREADS=1", "OMP_NUM_THREADS=3"}) {
        const Outcome outcome = run(Words{"env", threads} + program +
                                    Words{"calibrate", config, "-o", model, "--quiet"});
        EXPECT_EQ(outcome.output + outcome.errors, "");
        models.push_back(bytes_of(model));
    }
    EXPECT_EQ(models[0], models[1]);
}

TEST_F(Calibrate, SaysWhichShapeCannotBeFilled) {
    std::string text = tiny;
    text.replace(text.find("\"dimension\": 2"), 14, "\"dimension\": 3");
    text.replace(text.find("\"circle\""), 8, "\"ellipsoid\", \"proportions\": [0.02, 1, 1]");
    fail(2, {"calibrate", write("small.json", text), "-o", model},
         {"small.json", "ellipsoid", "particle spacing"});
    EXPECT_FALSE(std::filesystem::exists(model));
}

#else

TEST_F(Calibrate, WithoutTorchItSaysSo) {
    fail(3, {"calibrate", config, "-o", model}, {"calibrate", "libtorch"});
}

#endif

TEST_F(Calibrate, RefusesWhatIsNoCalibration) {
    fail(2, {"calibrate", folder / "none.json", "-o", model}, {"none.json"});
    fail(2, {"calibrate", write("bad.json", "{"), "-o", model}, {"bad.json", "calibration"});
    fail(2, {"calibrate", config, "-o", config}, {"clouds.json", "overwrite"});
    EXPECT_EQ(bytes_of(config), tiny);
}

TEST_F(Calibrate, ACurvatureModelIsNoLine) {
    const Path shipped = Path(MENISCUS_MODELS) / "curvature_3d.json";
    fail(2, {"audit", sample("droplet_iisph_06"), "--model", shipped}, {"curvature_3d.json"});
    expect_mentions(succeed({"export", shipped, "-o", folder / "map.hpp"}),
                    {"meniscus::CurvatureCoefficients"});
}

} // namespace
} // namespace meniscus
