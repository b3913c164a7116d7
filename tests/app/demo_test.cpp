#include "command.hpp"

#include <meniscus/classifier/export/header_export.hpp>

#include <algorithm>
#include <set>

namespace meniscus {
namespace {

using Demo = CommandLine;

TEST_F(Demo, RunsTheWholeChainAndKeepsItsLabels) {
    const std::string printed = succeed({"demo", "-o", folder / "demo"});
    const Model model = read_model(folder / "demo" / "model.json");
    EXPECT_EQ(model.false_negatives, 0U);
    const std::string header = bytes_of(folder / "demo" / "surface_coefficients.hpp");
    EXPECT_EQ(header, coefficient_header(model, "SurfaceCoefficients"));
    // The shipped line was trained on just these labels, and on states of our own scenes.
    std::set<std::string> shipped;
    for (const auto& file : read_model(Path(MENISCUS_MODELS) / "surface_3d.json").training_files)
        shipped.insert(file.hash);
    for (const auto& file : model.training_files)
        EXPECT_EQ(shipped.count(file.hash), 1U) << file.name;
    EXPECT_GT(shipped.size(), model.training_files.size());
    expect_mentions(printed, {"SurfaceTension_DoubleDroplet_ZR2020", "false pos.", header.c_str()});
    std::size_t samples = 0;
    for (const auto& entry : std::filesystem::directory_iterator(MENISCUS_SAMPLES))
        samples += entry.path().extension() == ".vtkhdf" ? 1 : 0;
    EXPECT_EQ(model.training_files.size(), samples);
    const Words written = files();
    const auto series = std::count_if(written.begin(), written.end(), [](const std::string& file) {
        return Path(file).extension() == ".series";
    });
    EXPECT_EQ(written.size(), samples + 2 + static_cast<std::size_t>(series));
    EXPECT_EQ(succeed({"demo", "-o", folder / "demo", "--quiet"}), "");
    EXPECT_EQ(bytes_of(folder / "demo" / "surface_coefficients.hpp"), header);
}

} // namespace
} // namespace meniscus
