#include "command.hpp"

#include <unistd.h>

namespace meniscus {
namespace {

/// Those of builds with benchmarks, as `bench`.
using StudyVerb = CommandLine;

TEST_F(StudyVerb, RunsAStudyAndHoldsItAgainstTheCommittedOne) {
    const Path out = folder / "out";
    const Outcome outcome =
        run(program + Words{"study", "thin_shells", "-o", out, "--threads", "1", "--check"});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    expect_mentions(outcome.errors, {"study thin_shells: 1 / 10", "study thin_shells: 10 / 10"});
    expect_mentions(outcome.output, {"| 10 | ball |"});
    EXPECT_EQ(bytes_of(out / "thin_shells_small.md"), outcome.output); // no states, no pictures
    EXPECT_TRUE(std::filesystem::exists(out / "thin_shells_small.json"));
    // What is there is not run again.
    EXPECT_EQ(succeed({"study", "thin_shells", "-o", out, "--threads", "1", "--check"}),
              outcome.output);
    // The committed one is the same but for what it took.
    const auto rows = [](const std::string& text) { return text.substr(text.find('|')); };
    EXPECT_EQ(rows(succeed({"study", "thin_shells", "--show"})), rows(outcome.output));
    EXPECT_EQ(succeed({"study", "thin_shells", "--show", "--quiet"}), "");
}

TEST_F(StudyVerb, ExitsWithOneWhereAFigureDiffers) {
    const Path out = folder / "out";
    EXPECT_EQ(run(program + Words{"study", "thin_shells", "-o", out, "--quiet"}).status, 0);
    const std::string one = "out/thin_shells_small/10_1.json";
    std::string text = bytes_of(folder / one);
    const std::size_t place = text.find("0.5");
    ASSERT_NE(place, std::string::npos) << text;
    write(one, text.replace(place, 3, "0.9"));
    const Outcome outcome =
        run(program + Words{"study", "thin_shells", "-o", out, "--quiet", "--check"});
    EXPECT_EQ(outcome.status, 1);
    expect_mentions(outcome.errors, {"study thin_shells: 10_1", "expected within", "1 figures"});
}

TEST_F(StudyVerb, DrawsThePlotsOfACommittedResult) {
    std::filesystem::create_directory(folder / "plots");
    succeed({"study", "drop_formation", "--show", "--quiet", "--plots", folder / "plots"});
    EXPECT_TRUE(std::filesystem::exists(folder / "plots/drop_formation_speed.svg"));
}

TEST_F(StudyVerb, ListsWhatEachDoesAndHowLargeItIs) {
    const std::string list = succeed({"study", "--list"});
    expect_mentions(list, {"pressure_jump\n", "small: 16 runs, ", " min on ",
                           "up to 14147 particles", "water_glass\n", "paper: "});
}

TEST_F(StudyVerb, GoesOnWhereItWasInterrupted) {
    const Path out = folder / "out";
    const Words words = program + Words{"study", "pressure_jump", "-o", out, "--threads", "1"};
    const pid_t process = start(words);
    const Path first = out / "pressure_jump_small/2D_IISPH_R_6.json";
    siginfo_t ended = {};
    while (!std::filesystem::exists(first) && ended.si_pid == 0) {
        usleep(1000);
        waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOHANG | WNOWAIT);
    }
    kill(process, SIGINT);
    const Outcome outcome = finish(process);
    EXPECT_EQ(outcome.status, 130);
    expect_mentions(outcome.errors,
                    {"study pressure_jump: stopped; the same command goes on from here"});
    EXPECT_TRUE(std::filesystem::exists(first));
    EXPECT_FALSE(std::filesystem::exists(out / "pressure_jump_small.json"));
}

TEST_F(StudyVerb, BadUsageIsNamed) {
    fail(2, {"study"}, {"--all", "--list"});
    fail(2, {"study", "no_such"}, {"no_such", "meniscus study --help"});
    fail(2, {"study", "thin_shells", "--show", "--check"}, {"--show", "--check"});
    fail(2, {"study", "thin_shells", "--show", "--size", "paper"},
         {"thin_shells", "no committed result", "'paper'"});
    fail(2, {"study", "thin_shells", "--size", "huge"}, {"--size", "huge"});
}

} // namespace
} // namespace meniscus
