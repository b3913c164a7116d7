// `--memory`: states and campaigns that are larger than what may be taken give the same bytes as
// those that fit.
#include "command.hpp"

#include <cstdlib>
#include <limits>
#include <string>
#include <sys/resource.h>

namespace meniscus {
namespace {

class LargeStates : public CommandLine {
protected:
    /// Labels in one pass and in slabs; the files must be the same. Returns what is said of slabs.
    std::string expect_same_bytes(const Path& input, const Words& options,
                                  const std::string& memory = "36MB",
                                  const char* verb = "label") const {
        const Path name = input.stem().concat(".vtkhdf");
        std::filesystem::remove_all(folder / "whole");
        std::filesystem::remove_all(folder / "slabs");
        succeed(Words{verb, input, "-o", folder / "whole", "--quiet"} + options);
        const Outcome outcome =
            run(program + Words{verb, input, "-o", folder / "slabs", "--memory", memory} + options);
        EXPECT_EQ(outcome.status, 0) << outcome.errors;
        EXPECT_TRUE(bytes_of(folder / "whole" / name) == bytes_of(folder / "slabs" / name))
            << input << " in slabs: " << outcome.output;
        return outcome.output;
    }

    /// A block with everything that decides on labels.
    static Snapshot block_with_arrays(int edge) {
        Snapshot snapshot = block(edge);
        std::vector<float> masses;
        std::vector<std::int32_t> phases;
        std::vector<std::int64_t> ids;
        for (std::size_t i = 0; i < snapshot.size(); ++i) {
            masses.push_back(1 + 0.1F * static_cast<float>(i % 7));
            phases.push_back(snapshot.positions[i][2] > 3 ? 1 : 0);
            ids.push_back(static_cast<std::int64_t>(7 * i));
        }
        snapshot.point_data = {{"mass", 1, masses},
                               {"phase", 1, phases},
                               {"id", 1, ids},
                               {"velocity", 3, std::vector<float>(3 * snapshot.size(), 2.5F)}};
        return snapshot;
    }
};

TEST_F(LargeStates, MassesPhasesAndIdsAreTheSame) {
    const Path input = save(block_with_arrays(44), "block.vtkhdf");
    expect_mentions(expect_same_bytes(input, {}), {" slabs; "});
    expect_same_bytes(input, {"--samples", "300", "--scheme", "random"});
}

TEST_F(LargeStates, ScatteredOnesAreTheSame) {
    Snapshot snapshot = block(57);
    for (std::size_t i = 0; i < snapshot.size(); i += 3)
        snapshot.positions[i][0] += 1e5; // cells share buckets then
    std::swap(snapshot.positions.front(), snapshot.positions.back());
    snapshot.boundary = block(20).positions;
    for (auto& position : snapshot.boundary)
        position[2] -= 10;
    expect_mentions(expect_same_bytes(save(snapshot, "block.vtkhdf"), {}, "42MB"), {" slabs; "});
}

TEST_F(LargeStates, InvalidParticlesAreLeftOut) {
    Snapshot snapshot = block(44);
    snapshot.positions[5][1] = std::numeric_limits<double>::quiet_NaN();
    snapshot.positions[60000][0] = 1e17;
    const Path input = save(snapshot, "block.vtkhdf");
    expect_same_bytes(input, {"--skip-invalid"});
    fail(2, {"label", input, "-o", folder / "no", "--memory", "36MB"},
         {"block.vtkhdf", "1 of 85184 particles", "not finite", "particle 5", "--skip-invalid"});
    snapshot.positions[5][1] = 0;
    fail(2, {"label", save(snapshot, "far.vtkhdf"), "-o", folder / "no", "--memory", "36MB"},
         {"far.vtkhdf", "1 of 85184 particles", "from the origin", "particle 60000"});
}

TEST_F(LargeStates, WhatCannotBeReadInPartsIsRefused) {
    Snapshot snapshot = block(44);
    set_array(snapshot, {"phase", 1, std::vector<std::int32_t>(snapshot.size())});
    snapshot.provenance["periodic"] = "x=0:22";
    fail(2, {"label", save(snapshot, "block.vtkhdf"), "-o", folder / "out", "--memory", "34MB"},
         {"block.vtkhdf", "--memory", "MiB", "periodic"});
    fail(2,
         {"classify", save(block(44), "block.vtkhdf"), "-o", folder / "out", "--memory", "34MB",
          "--balance-momentum"},
         {"block.vtkhdf", "MiB to classify", "--balance-momentum"});
    fail(2, {"label", save(block(44), "block.vtkhdf"), "-o", folder / "out", "--memory", "26MB"},
         {"block.vtkhdf", "slabs take", "MiB", "--memory"});
    fail(2, {"label", save(block(10), "block.vtkhdf"), "-o", folder / "out", "--memory", "much"},
         {"--memory"});
}

TEST_F(LargeStates, PeriodicBoxesAreTheSame) {
    Snapshot snapshot = block(57);
    std::swap(snapshot.positions.front(), snapshot.positions.back());
    snapshot.positions[77][1] -= 0.4; // out of the box
    const Path input = save(snapshot, "block.vtkhdf");
    const Words box = {"--periodic", "x=0:28.5,y=0:28.5"};
    expect_mentions(expect_same_bytes(input, box, "43MB"), {" slabs; ", "copies cover"});
    expect_same_bytes(input, box + Words{"--no-boundary"}, "43MB");
    fail(2, {"label", input, "-o", folder / "no", "--memory", "43MB", "--periodic", "z=0:20"},
         {"block.vtkhdf", "outside the periodic box"});
}

TEST_F(LargeStates, ClassesAreTheSame) {
    const auto expect_same = [&](const Snapshot& snapshot, const Words& options,
                                 const std::string& memory) {
        expect_mentions(
            expect_same_bytes(save(snapshot, "block.vtkhdf"), options, memory, "classify"),
            {" slabs; ", "candidates"});
    };
    expect_same(block(44), {}, "50MB");
    // Deeper halos, forces that reach farther, and other ways to find the surface.
    expect_same(block(44), {"--normal-passes", "2", "--curvature-passes", "2"}, "66MB");
    expect_same(block(44), {"--paper"}, "60MB");
    expect_same(block(44), {"--coverage", "exact", "--model", "surface_3d"}, "50MB");
    Snapshot scattered = block_with_arrays(44);
    for (std::size_t i = 0; i < scattered.size(); ++i)
        std::swap(scattered.positions[i], scattered.positions[(i * 7919) % scattered.size()]);
    scattered.positions[3][0] = std::numeric_limits<double>::quiet_NaN();
    scattered.particle_volume = 0.125;
    scattered.boundary = block(20).positions;
    for (auto& position : scattered.boundary)
        position[2] -= 10;
    expect_same(scattered, {"--skip-invalid"}, "66MB");
    expect_same(block(44), {"--periodic", "x=0:22"}, "64MB");
}

TEST_F(LargeStates, TrainingIsTheSame) {
    Words files;
    for (const char* name : {"droplet_iisph_01", "cube_iisph_05", "dam_dfsph_01", "dam_dfsph_04",
                             "dam_dfsph_08", "dam_dfsph_14", "boxhole_dfsph_04"})
        files.push_back(label(sample(name)));
    for (const Words& options :
         {Words{}, Words{"--features", "neighbor_count,mass_offset"}, Words{"--scene", "all"}}) {
        succeed(Words{"train", "-o", folder / "whole.json", "--quiet"} + files + options);
        succeed(Words{"train", "-o", folder / "visits.json", "--quiet", "--memory", "40MB"} +
                files + options);
        EXPECT_EQ(bytes_of(folder / "whole.json"), bytes_of(folder / "visits.json"));
    }
    fail(2,
         Words{"train", "-o", folder / "no.json", "--memory", "40MB", "--objective", "logistic"} +
             files,
         {"logistic", "--memory"});
    fail(2, Words{"train", "-o", folder / "no.json", "--memory", "1MB"} + files,
         {"droplet_iisph_01", "MiB", "--memory"});
}

TEST_F(LargeStates, MemoryIsWhatWasAllowed) {
    const Path input = save(block(90), "block.vtkhdf");
    /// Peak memory of the command, in bytes.
    const auto peak_of = [&](const Words& words) {
        int status = 0;
        rusage usage{};
        wait4(start(program + words), &status, 0, &usage);
        EXPECT_EQ(status, 0);
        return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
    };
    constexpr std::uint64_t allowed = std::uint64_t{60} << 20;
    EXPECT_LE(peak_of({"label", input, "-o", folder / "slabs", "--quiet", "--memory", "60MB"}),
              allowed);
    EXPECT_GT(peak_of({"label", input, "-o", folder / "whole", "--quiet"}), allowed * 4 / 3);
    EXPECT_TRUE(bytes_of(folder / "whole/block.vtkhdf") == bytes_of(folder / "slabs/block.vtkhdf"));
}

} // namespace
} // namespace meniscus
