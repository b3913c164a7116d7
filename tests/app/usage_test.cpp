#include "command.hpp"

#include <meniscus/runtime/version.hpp>

namespace meniscus {
namespace {

using Usage = CommandLine;

constexpr const char* verbs[] = {"simulate", "label", "train",   "export", "audit",
                                 "classify", "demo",  "picture", "bench"};

TEST_F(Usage, HelpOfEveryVerb) {
    const std::string overview = succeed({"--help"});
    for (const char* verb : verbs) {
        expect_mentions(overview, {verb});
        expect_mentions(succeed({verb, "--help"}), {verb, "--quiet"});
    }
}

TEST_F(Usage, Version) {
    EXPECT_EQ(succeed({"--version"}), std::string("meniscus ") + program_version + "\n");
}

TEST_F(Usage, UnknownVerbsAndOptionsAreNamed) {
    fail(2, {}, {"verb", "--help"});
    fail(2, {"mark"}, {"mark"});
    for (const char* verb : verbs)
        fail(2, {verb, "--no-such-option"}, {"--help"});
    fail(2, {"demo", "--no-such-option"}, {"--no-such-option"});
    fail(2, {"label", sample("droplet_iisph_01")}, {"--output", "required"});
    fail(2, {"audit", sample("droplet_iisph_01")}, {"--model", "required"});
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
