// The command as several processes of MPI on one machine: what they write, together, is what one
// writes, also where one of them is killed, a file is damaged, or the disk is full.
#include "command.hpp"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>
#include <unistd.h>

namespace meniscus {
namespace {

class RanksOfMpi : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        // Containers run as root; more processes than cores are meant here.
        setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
        setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
        setenv("OMPI_MCA_rmaps_base_oversubscribe", "1", 1);
        setenv("OMP_NUM_THREADS", "1", 1);
    }

    static Words on_ranks(int count) {
        return {MENISCUS_MPIRUN, "-n",   std::to_string(count),
                "--bind-to",     "none", MENISCUS_PROGRAM};
    }

    /// Runs on so many ranks; must succeed. Returns what is printed.
    [[nodiscard]] std::string succeed_on(int ranks, const Words& words) const {
        const Outcome outcome = run(on_ranks(ranks) + words);
        EXPECT_EQ(outcome.status, 0) << outcome.errors;
        return outcome.output;
    }

    void expect_same_files(const Path& a, const Path& b) const {
        std::size_t compared = 0;
        for (const auto& entry : std::filesystem::directory_iterator(a)) {
            EXPECT_TRUE(bytes_of(entry.path()) == bytes_of(b / entry.path().filename()))
                << entry.path();
            ++compared;
        }
        EXPECT_EQ(compared, names_in(b).size());
        EXPECT_GT(compared, 0U);
    }

    static Words names_in(const Path& folder) {
        Words names;
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            names.push_back(entry.path().filename());
        return names;
    }

    /// A hundred small files, of which one may be damaged.
    [[nodiscard]] Words hundred_files(bool with_damage) const {
        Words names;
        for (int i = 0; i < 100; ++i)
            names.push_back(save(block(5 + i % 7), "block_" + std::to_string(i) + ".vtkhdf"));
        if (with_damage)
            std::filesystem::resize_file(names[37], std::filesystem::file_size(names[37]) / 2);
        return names;
    }
};

TEST_F(RanksOfMpi, LabelAndClassifyShippedSamples) {
    for (const char* verb : {"label", "classify"}) {
        const Words words = {verb, MENISCUS_SAMPLES, "--quiet", "-o"};
        const Outcome one = run(program + words + Words{folder / "one" / verb});
        EXPECT_EQ(one.status, 0) << one.errors;
        for (const int ranks : {2, 3, 4}) {
            const Path several = folder / std::to_string(ranks) / verb;
            const Outcome outcome = run(on_ranks(ranks) + words + Words{several});
            EXPECT_EQ(outcome.status, 0) << outcome.errors;
            EXPECT_EQ(outcome.output, "");
            EXPECT_EQ(outcome.errors, one.errors); // a warning of the line's range
            expect_same_files(folder / "one" / verb, several);
        }
    }
}

TEST_F(RanksOfMpi, SayWhatOneProcessSays) {
    const Words words = {"label", MENISCUS_SAMPLES, "-o", folder / "out"};
    const std::string said = run(program + words).output;
    std::filesystem::remove_all(folder / "out");
    EXPECT_EQ(succeed_on(3, words), said);
    expect_mentions(succeed_on(2, words), {"up to date"});
}

TEST_F(RanksOfMpi, LabelSamplesInSlabsTogether) {
    const Words words = {"label", MENISCUS_SAMPLES, "--quiet", "--features", "all", "-o"};
    succeed(words + Words{folder / "one"});
    for (const int ranks : {2, 3}) {
        const Path several = folder / std::to_string(ranks);
        // Less than the largest ones need in one pass.
        EXPECT_EQ(succeed_on(ranks, words + Words{several, "--memory", "60MB"}), "");
        expect_same_files(folder / "one", several);
    }
}

TEST_F(RanksOfMpi, LabelALargeStateTogether) {
    const Path input = save(block(126), "block.vtkhdf"); // 2.0e6 particles
    succeed({"label", input, "-o", folder / "one", "--quiet"});
    const std::string said =
        succeed_on(2, {"label", input, "-o", folder / "two", "--memory", "120MB"});
    expect_mentions(said, {"2000376 particles", " slabs; ", "2 ranks exchanged"});
    EXPECT_TRUE(bytes_of(folder / "one/block.vtkhdf") == bytes_of(folder / "two/block.vtkhdf"));
}

TEST_F(RanksOfMpi, ClassifyALargeStateTogether) {
    const Path input = save(block(60), "block.vtkhdf");
    succeed({"classify", input, "-o", folder / "one", "--quiet"});
    for (const int ranks : {2, 3}) {
        const Path several = folder / std::to_string(ranks);
        expect_mentions(succeed_on(ranks, {"classify", input, "-o", several, "--memory", "100MB"}),
                        {"216000 particles", " slabs; ", "ranks exchanged"});
        EXPECT_TRUE(bytes_of(folder / "one/block.vtkhdf") == bytes_of(several / "block.vtkhdf"));
    }
}

TEST_F(RanksOfMpi, TrainAndAudit) {
    succeed({"label", MENISCUS_SAMPLES, "-o", folder / "labelled", "--quiet"});
    const Words train = {"train", folder / "labelled", "-o"};
    std::string said = succeed(train + Words{folder / "one.json"});
    const Words audit = {"audit", folder / "labelled", "--format", "json", "--model"};
    const std::string report = run(program + audit + Words{folder / "one.json"}).output;
    for (const int ranks : {2, 4}) {
        const Path model = folder / (std::to_string(ranks) + ".json");
        const std::string said_here = succeed_on(ranks, train + Words{model});
        EXPECT_EQ(said_here.substr(model.string().size()),
                  said.substr((folder / "one.json").string().size()));
        EXPECT_EQ(bytes_of(model), bytes_of(folder / "one.json"));
        EXPECT_EQ(run(on_ranks(ranks) + audit + Words{model}).output, report);
    }
}

TEST_F(RanksOfMpi, ADamagedFileStopsNoOther) {
    const Words inputs = hundred_files(true);
    const Words words = Words{"label", "-o", folder / "out", "--keep-going"} + inputs;
    const Outcome outcome = run(on_ranks(3) + words);
    EXPECT_EQ(outcome.status, 2);
    expect_mentions(outcome.errors, {"block_37.vtkhdf", "1 of 100 files", "the others were"});
    expect_mentions(outcome.output, {"100 files: 99 labelled", "1 at fault"});
    EXPECT_EQ(names_in(folder / "out").size(), 99U + 1); // and the series
    const Outcome strict = run(on_ranks(2) + Words{"label", "-o", folder / "strict"} + inputs);
    EXPECT_EQ(strict.status, 2);
    expect_mentions(strict.errors, {"block_37.vtkhdf"});
}

/// Processes below mpirun that are ranks of the command, by the names of their programs.
std::vector<pid_t> ranks_below(pid_t mpirun) {
    std::vector<pid_t> ranks;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        const std::string name = entry.path().filename();
        if (name.find_first_not_of("0123456789") != std::string::npos)
            continue;
        std::ifstream status(entry.path() / "stat");
        std::string number, program, state;
        pid_t parent = 0;
        status >> number >> program >> state >> parent;
        if (parent == mpirun && program == "(meniscus)")
            ranks.push_back(std::stoi(name));
    }
    return ranks;
}

TEST_F(RanksOfMpi, AKilledRankLosesItsFileAlone) {
    const Words inputs = hundred_files(false);
    const Words words = Words{"label", "--samples", "3000", "--quiet", "-o"};
    succeed(words + Words{folder / "one"} + inputs);
    std::mt19937 random(20);
    for (int kill = 0; kill < 4; ++kill) {
        const pid_t mpirun = start(on_ranks(2) + words + Words{folder / "out"} + inputs);
        std::this_thread::sleep_for(std::chrono::milliseconds(500 + random() % 1500));
        const auto ranks = ranks_below(mpirun);
        if (!ranks.empty())
            ::kill(ranks[random() % ranks.size()], SIGKILL);
        const Outcome outcome = finish(mpirun);
        EXPECT_TRUE(outcome.status != 0 || ranks.empty() || names_in(folder / "out").size() == 101)
            << outcome.status;
        for (const std::string& name : names_in(folder / "out"))
            if (Path(name).extension() == ".vtkhdf") { // whole, or not there
                EXPECT_TRUE(bytes_of(folder / "out" / name) == bytes_of(folder / "one" / name))
                    << name;
            }
    }
    EXPECT_EQ(succeed_on(2, words + Words{folder / "out"} + inputs), "");
    expect_same_files(folder / "one", folder / "out");
}

TEST_F(RanksOfMpi, AFullDiskFailsInOneLine) {
    const Path disk = folder / "disk";
    const Words on_disk = on_small_disk(disk, "512k", "1");
    if (on_disk.empty())
        GTEST_SKIP() << "mounting is not permitted here";
    const Path input = save(block(100), "block.vtkhdf");
    for (const Words& memory : {Words{}, Words{"--memory", "90MB"}}) {
        const Outcome outcome =
            run(on_disk + on_ranks(2) + Words{"label", input, "-o", disk} + memory);
        EXPECT_EQ(outcome.status, 3) << outcome.errors;
        expect_mentions(outcome.errors, {"meniscus: ", disk.c_str(), "No space left on device"});
        EXPECT_EQ(outcome.output, "filler\n");
    }
}

TEST_F(RanksOfMpi, OtherVerbsAreForOneProcess) {
    const Outcome outcome = run(on_ranks(2) + Words{"models"});
    EXPECT_EQ(outcome.status, 2);
    expect_mentions(outcome.errors, {"meniscus: models works in one process", "mpirun"});
}

} // namespace
} // namespace meniscus
