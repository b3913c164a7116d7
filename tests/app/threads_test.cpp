// Threads, whatever environment and limits say: a number of them that crashes nothing, words where
// they cannot be started, and no core that is kept from others by waiting.
#include "command.hpp"

#include <fstream>
#include <iterator>
#include <unistd.h>

namespace meniscus {
namespace {

class Threads : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        input = save(block(4), "block.vtkhdf");
    }

    [[nodiscard]] Words label(const Words& more = {}) const {
        return program + Words{"label", input, "-o", folder / "out", "--quiet"} + more;
    }

    /// The same in an environment.
    [[nodiscard]] Outcome label_with(const std::string& setting) const {
        std::filesystem::remove_all(folder / "out");
        return run(Words{"env", setting} + label());
    }

    Path input;
};

TEST_F(Threads, NumbersOfTheEnvironmentAreLimited) {
    for (const char* number : {"70000", "4294967296"}) {
        const Outcome outcome = label_with(std::string("OMP_NUM_THREADS=") + number);
        EXPECT_EQ(outcome.status, 0) << number << outcome.errors;
        expect_mentions(outcome.errors, {"warning: OMP_NUM_THREADS", number, "1024"});
        expect_one_line(outcome.errors);
    }
    EXPECT_EQ(label_with("OMP_NUM_THREADS=3").errors, "");
}

TEST_F(Threads, ThatCannotBeStartedAreNamed) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the address sanitizer itself needs more than the limit";
#endif
    const Words limited = {"sh", "-c", "ulimit -v 1000000 && exec \"$@\"", "sh"};
    fail_as(3, limited + label({"--threads", "1024"}), {"1024 threads", "--threads", "ulimit"});
    const Outcome few = run(limited + label({"--threads", "2"}));
    EXPECT_EQ(few.status, 0) << few.errors;
}

TEST_F(Threads, SleepWhileTheyWait) {
    const auto environment_with = [&](const Words& setting) {
        const Path out = folder / "long";
        std::filesystem::remove_all(out);
        const pid_t process = start(Words{"env"} + setting + program +
                                    Words{"label", sample("crown_dfsph_15"), "-o", out, "--threads",
                                          "1", "--samples", "5000000"});
        while (!std::filesystem::exists(out))
            usleep(1000);
        std::ifstream stream("/proc/" + std::to_string(process) + "/environ");
        const std::string environment{std::istreambuf_iterator<char>(stream), {}};
        kill(process, SIGKILL);
        finish(process);
        return environment;
    };
    const Words nothing = {"-u", "OMP_WAIT_POLICY", "-u", "GOMP_SPINCOUNT"};
    EXPECT_NE(environment_with(nothing).find("OMP_WAIT_POLICY=passive"), std::string::npos);
    EXPECT_NE(environment_with({"OMP_WAIT_POLICY=active"}).find("OMP_WAIT_POLICY=active"),
              std::string::npos);
    EXPECT_EQ(environment_with(nothing + Words{"GOMP_SPINCOUNT=7"}).find("OMP_WAIT_POLICY"),
              std::string::npos);
}

} // namespace
} // namespace meniscus
