// Which libraries the command loads: libtorch costs half a second, so only the verb that needs it
// may load it. The system's loader says what it loads (ld.so(8)).
#include "command.hpp"

namespace meniscus {
namespace {

class Libraries : public CommandLine {
protected:
    /// What the loader loads while the command runs.
    [[nodiscard]] std::string loaded_by(const Words& words) const {
        const Outcome outcome = run(Words{"env", "LD_DEBUG=files"} + program + words);
        EXPECT_EQ(outcome.status, 0) << outcome.errors;
        expect_mentions(outcome.errors, {"libc.so"});
        return outcome.errors;
    }
};

bool has_torch(const std::string& libraries) {
    return libraries.find("libtorch") != std::string::npos ||
           libraries.find("libc10") != std::string::npos;
}

TEST_F(Libraries, TheProgramLinksNoTorch) {
    const Outcome outcome = run(Words{"env", "LD_TRACE_LOADED_OBJECTS=1"} + program);
    expect_mentions(outcome.output, {"libhdf5", "libc.so"});
    EXPECT_FALSE(has_torch(outcome.output)) << outcome.output;
}

TEST_F(Libraries, OnlyFitsThatNeedTorchLoadIt) {
    const Path input = save(block(6), "block.vtkhdf");
    const Path labelled = folder / "labelled" / "block.vtkhdf";
    const Path model = folder / "model.json";
    for (const Words& words : {Words{"label", input, "-o", folder / "labelled"},
                               {"train", labelled, "-o", model},
                               {"export", model, "-o", folder / "header.hpp"},
                               {"audit", labelled, "--model", model},
                               {"classify", input, "--model", model, "-o", folder / "classified"}})
        EXPECT_FALSE(has_torch(loaded_by(words))) << words[0];
    if (MENISCUS_TRAINER)
        EXPECT_TRUE(
            has_torch(loaded_by({"train", labelled, "-o", model, "--objective", "logistic"})));
    else
        fail(3, {"train", labelled, "-o", model, "--objective", "logistic"}, {"libtorch"});
}

} // namespace
} // namespace meniscus
