// Ctrl-C ends the command at once, and whatever ends it, even the power switch, leaves whole files
// only: what is there is what an undisturbed run writes, and a rerun makes the rest.
#include "command.hpp"

#include <csignal>
#include <random>
#include <unistd.h>

namespace meniscus {
namespace {

class Interrupt : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        const Path first = save(block(8), "state_0.vtkhdf");
        for (int i = 1; i < 12; ++i)
            std::filesystem::copy(first, folder / ("state_" + std::to_string(i) + ".vtkhdf"));
    }

    /// Labels all states; enough samples to be caught in the middle.
    [[nodiscard]] Words label_into(const Path& out) const {
        Words words = program + Words{"label", "-o", out, "--samples", "20000"};
        for (int i = 0; i < 12; ++i)
            words.push_back(folder / ("state_" + std::to_string(i) + ".vtkhdf"));
        return words;
    }

    /// Whether the file is there, whole or under the name that it has before (write_whole()).
    static bool has_begun(const Path& file) {
        std::error_code not_there_yet;
        for (const auto& entry :
             std::filesystem::directory_iterator(file.parent_path(), not_there_yet))
            if (entry.path().filename().string().rfind(file.filename().string() + ".", 0) == 0)
                return true;
        return std::filesystem::exists(file);
    }

    /// Waits until the command has begun a file, which must be before it ends. The half-written
    /// file has its name for moments only, which a waiter may sleep through: the whole one counts.
    static void wait_for(const Path& file, pid_t process) {
        siginfo_t ended = {};
        while (!has_begun(file) && ended.si_pid == 0) {
            usleep(100);
            waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOHANG | WNOWAIT);
        }
        EXPECT_EQ(ended.si_pid, 0) << "ended without " << file;
    }

    /// Every file in `out` that bears the name of an output is what an undisturbed run writes.
    void expect_whole(const Path& out, const Path& undisturbed) const {
        for (const auto& entry : std::filesystem::directory_iterator(out))
            if (entry.path().extension() == ".vtkhdf") {
                EXPECT_TRUE(bytes_of(entry.path()) ==
                            bytes_of(undisturbed / entry.path().filename()))
                    << entry.path();
            }
    }
};

TEST_F(Interrupt, IsOneLineAndLeavesNothing) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
        const Path out = folder / std::to_string(signal);
        const pid_t process = start(
            program + Words{"label", sample("crown_dfsph_15"), "-o", out, "--samples", "5000000"});
        wait_for(out, process);
        usleep(200'000); // into the middle of what takes minutes
        kill(process, signal);
        const Outcome outcome = finish(process);
        EXPECT_EQ(outcome.status, 130);
        EXPECT_EQ(outcome.errors, "meniscus: interrupted\n");
        EXPECT_EQ(outcome.output, "");
        EXPECT_TRUE(std::filesystem::is_empty(out));
    }
}

TEST_F(Interrupt, GoesUnheardWhereTheParentSaysSo) {
    const Path out = folder / "out";
    const Words deaf = {"sh", "-c", "trap '' HUP && exec \"$@\"", "sh"}; // as nohup does
    const pid_t process = start(deaf + label_into(out));
    wait_for(out / "state_0.vtkhdf", process);
    kill(process, SIGHUP);
    EXPECT_EQ(finish(process).status, 0);
    EXPECT_TRUE(std::filesystem::exists(out / "state_11.vtkhdf"));
}

TEST_F(Interrupt, LeavesWholeFiles) {
    EXPECT_EQ(run(label_into(folder / "undisturbed")).status, 0);
    const Path out = folder / "out";
    const pid_t process = start(label_into(out));
    wait_for(out / "state_3.vtkhdf", process);
    kill(process, SIGINT);
    EXPECT_EQ(finish(process).status, 130);
    for (const std::string& name : files())
        EXPECT_EQ(name.find(".partial"), std::string::npos) << name;
    EXPECT_FALSE(std::filesystem::exists(out / "state_11.vtkhdf"));
    expect_whole(out, folder / "undisturbed");
}

TEST_F(Interrupt, KilledRunsAreCompletedByARerun) {
    const Path undisturbed = folder / "undisturbed";
    EXPECT_EQ(run(label_into(undisturbed)).status, 0);
    const Path out = folder / "out";
    for (const char* last : {"state_0.vtkhdf", "state_4.vtkhdf", "state_7.vtkhdf"}) {
        const pid_t process = start(label_into(out));
        wait_for(out / last, process);
        kill(process, SIGKILL);
        finish(process);
        expect_whole(out, undisturbed);
    }
    // And at random times, each run starting from what the ones before it left.
    std::mt19937 generator(2020);
    std::uniform_int_distribution<useconds_t> moment(0, 60'000);
    for (int kills = 0; kills < 12; ++kills) {
        if (kills % 4 == 0)
            std::filesystem::remove_all(out);
        const pid_t process = start(label_into(out));
        usleep(moment(generator));
        kill(process, SIGKILL);
        finish(process);
        if (std::filesystem::exists(out))
            expect_whole(out, undisturbed);
    }
    std::filesystem::remove(out / "state_11.vtkhdf");
    std::filesystem::create_directory(out);
    write("out/state_9.vtkhdf.0123456789abcdef.partial", "half of a file");
    const Outcome rerun = run(label_into(out));
    EXPECT_EQ(rerun.status, 0) << rerun.errors;
    expect_mentions(rerun.output, {"state_11.vtkhdf: 512 particles"});
    expect_mentions(run(label_into(out)).output,
                    {"state_0.vtkhdf: up to date", "state_11.vtkhdf: up to date"});
    expect_whole(out, undisturbed);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out), {}), 13); // and a .series
}

} // namespace
} // namespace meniscus
