#include "command.hpp"

#include <meniscus/runtime/version.hpp>

#include <sstream>

namespace meniscus {
namespace {

using Usage = CommandLine;

constexpr const char* verbs[] = {"simulate", "label", "train",   "export",  "audit", "classify",
                                 "demo",     "bench", "inspect", "picture", "study"};

TEST_F(Usage, HelpOfEveryVerb) {
    const std::string overview = succeed({"--help"});
    for (const char* verb : verbs) {
        expect_mentions(overview, {verb});
        expect_mentions(succeed({verb, "--help"}), {verb, "--quiet"});
    }
}

TEST_F(Usage, HelpIsWrappedAndHasExamples) {
    for (const char* verb : verbs) {
        const std::string help = succeed({"help", verb});
        EXPECT_EQ(help, succeed({verb, "--help"}));
        expect_mentions(help, {"Examples:", (std::string("  meniscus ") + verb).c_str()});
        EXPECT_EQ(help.find("9223372036854775807"), std::string::npos) << help;
        std::istringstream lines(help);
        for (std::string line; std::getline(lines, line);)
            EXPECT_TRUE(line.size() <= 100 || line.find_first_of(' ', 30) == std::string::npos)
                << line;
    }
    EXPECT_EQ(succeed({"help"}), succeed({"--help"}));
    fail(2, {"help", "trian"}, {"'trian'", "did you mean 'train'?"});
}

TEST_F(Usage, LabelNamesWhatItReads) {
    const std::string help = succeed({"label", "--help"});
    for (const char* kind :
         {".vtkhdf", ".vtk", ".vtu", ".vtp", ".bgeo", "PySPH", "GADGET", "H5Part", "LagrangeBench",
          "CSV", ".ply", ".npy", ".xyz", "LAMMPS", "DeepLagrangianFluids"})
        expect_mentions(help, {kind});
}

TEST_F(Usage, Version) {
    EXPECT_EQ(succeed({"--version"}), std::string("meniscus ") + program_version + "\n");
    EXPECT_EQ(succeed({"-V"}), succeed({"--version"}));
}

TEST_F(Usage, SaysWhatWasPerhapsMeant) {
    fail(2, {"lable", "x.vtk"}, {"no verb 'lable'", "did you mean 'label'?"});
    fail(2, {"label", "x.vtk", "-o", "out", "--suport-radius", "1"},
         {"label has no option '--suport-radius'", "did you mean '--support-radius'?",
          "meniscus label --help"});
    fail(2, {"classify", "x.vtk", "-o", "out", "--surface-tensoin=1"},
         {"'--surface-tensoin'", "did you mean '--surface-tension'?"});
    fail(2, {"audit"}, {"LABELLED", "meniscus audit --help"});
    const Outcome far = run(program + Words{"zzzzzzzz"});
    EXPECT_EQ(far.errors.find("did you mean"), std::string::npos) << far.errors;
}

TEST_F(Usage, CompletionAndManualKnowEveryVerbAndItsOptions) {
    const std::string page = succeed({"man"});
    for (const char* verb : verbs)
        expect_mentions(page, {(std::string(".SS meniscus ") + verb + "\n").c_str()});
    expect_mentions(page,
                    {"\\-\\-support\\-radius", "\\-\\-curvature\\-passes", ".SH EXIT STATUS"});
    const Path bash = write("completion.bash", succeed({"completion", "bash"}));
    const auto completed = [&](const std::string& words, int place) {
        return run({"bash", "-c",
                    "source " + bash.string() + "; COMP_WORDS=(" + words + "); COMP_CWORD=" +
                        std::to_string(place) + "; _meniscus; echo ${COMPREPLY[@]}"})
            .output;
    };
    EXPECT_EQ(completed("meniscus cla", 1), "classify\n");
    EXPECT_EQ(completed("meniscus label --supp", 2), "--support-radius\n");
    EXPECT_EQ(completed("meniscus label --method mon", 3), "monte-carlo\n");
    EXPECT_EQ(completed("meniscus help tra", 2), "train\n");
    expect_mentions(succeed({"completion", "zsh"}), {"#compdef meniscus", "--support-radius["});
    fail(2, {"completion", "fish"}, {"fish"});
}

TEST_F(Usage, UnknownVerbsAndOptionsAreNamed) {
    fail(2, {}, {"verb", "--help"});
    fail(2, {"mark"}, {"mark"});
    for (const char* verb : verbs)
        fail(2, {verb, "--no-such-option"}, {"--help"});
    fail(2, {"demo", "--no-such-option"}, {"--no-such-option"});
    fail(2, {"label", sample("droplet_iisph_01")}, {"--output", "required"});
    fail(2, {"export", "model.json"}, {"--output", "required"});
}

TEST_F(Usage, OptionsOutOfRangeAreNamed) {
    const Words label = {"label", save(block(2), "block.vtkhdf"), "-o", folder / "out"};
    fail(2, label + Words{"--samples", "0"}, {"--samples", "0"});
    fail(2, label + Words{"--samples", "-5"}, {"--samples", "-5"});
    fail(2, label + Words{"--samples", "many"}, {"--samples", "many"});
    fail(2, label + Words{"--samples", "1000000000000000000"}, {"--samples"});
    fail(2, label + Words{"--seed", "-1"}, {"--seed", "-1"});
    fail(2, label + Words{"--threads", "-1"}, {"--threads", "-1"});
    fail(2, label + Words{"--threads", "100000"}, {"--threads", "100000"});
    fail(2, label + Words{"--scheme", "dice"}, {"--scheme", "dice", "halton", "blue-noise"});
    fail(2, label + Words{"--scheme", "halton-2-4"}, {"--scheme", "halton-2-4", "primes"});
    fail(2, label + Words{"--method", "guess"}, {"--method", "guess", "monte-carlo"});
    fail(2, label + Words{"--dimension", "4"}, {"--dimension", "4"});
    for (const char* ratio : {"0", "1", "-1", "nan", "inf"})
        fail(2, label + Words{"--radius-ratio", ratio}, {"radius", "ratio"});
    for (const char* spacing : {"0", "-1", "nan", "inf"})
        fail(2, label + Words{"--particle-spacing", spacing}, {"--particle-spacing", spacing});
}

TEST_F(Usage, LabelThresholdOutOfRange) {
    const Path labelled = label(save(block(6), "block.vtkhdf"));
    succeed({"train", labelled, "-o", folder / "model.json", "--quiet"});
    for (const char* threshold : {"-0.1", "1", "nan", "inf"}) {
        fail(2, {"train", labelled, "-o", folder / "m.json", "--label-threshold", threshold},
             {"label threshold"});
        fail(2,
             {"audit", labelled, "--model", folder / "model.json", "--label-threshold", threshold},
             {"label threshold"});
    }
}

} // namespace
} // namespace meniscus
