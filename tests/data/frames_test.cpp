// Text files of several states, and files of one of which another is asked for.
#include "expected_errors.hpp"
#include "test_folder.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/text/errors.hpp>

#include <gtest/gtest.h>

namespace meniscus {
namespace {

class Frames : public TestFolder {
protected:
    static Snapshot read(const std::filesystem::path& file, std::uint64_t frame) {
        ReadChoices choices;
        choices.frame = frame;
        return read_snapshot(file, choices);
    }

    static std::string error_for(const std::filesystem::path& file, std::uint64_t frame) {
        return error_of<InputError>([&] { read(file, frame); });
    }
};

TEST_F(Frames, OfExtendedXyz) {
    const std::string text = "2\nProperties=pos:R:3\n1 2 3\n4 5 6\n"
                             "1\nProperties=pos:R:3:w:R:1\n7 8 9 10\n";
    const auto file = write("two.xyz", text);
    const Snapshot last = read_snapshot(file);
    EXPECT_EQ(last.positions, (Positions{{7, 8, 9}}));
    expect_mentions(last.notes.at(0), {"last of 2 states", "--frame"});
    EXPECT_EQ(read(file, 0).positions, (Positions{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(read(file, 0).provenance["frame"], "0");
    EXPECT_EQ(read(file, 1).positions, last.positions);
    expect_mentions(error_for(file, 2), {"two.xyz", "--frame 2", "0 to 1", "2 states"});

    const auto cut = write("cut.xyz", text + "3\nProperties=pos:R:3\n1 2 3\n");
    EXPECT_EQ(read(cut, 1).positions, last.positions);
    expect_mentions(error_of<InputError>([&] { read_snapshot(cut); }), {"cut.xyz: line 11"});
    const auto longer = write("longer.xyz", text + "1 2 3\n4 5 6\n");
    expect_mentions(error_of<InputError>([&] { read_snapshot(longer); }), {"longer.xyz: line 10"});
}

TEST_F(Frames, OfLammpsDumps) {
    const auto state = [](const std::string& time, const std::string& atoms) {
        return "ITEM: TIMESTEP\n" + time +
               "\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\n"
               "ITEM: ATOMS id x y z\n" +
               atoms + "\n";
    };
    const auto file = write("three.dump", state("0", "1 1 2 3") + state("10", "1 4 5 6") +
                                              state("20", "1 7 8 9"));
    EXPECT_EQ(read_snapshot(file).positions, (Positions{{7, 8, 9}}));
    EXPECT_EQ(read(file, 0).positions, (Positions{{1, 2, 3}}));
    EXPECT_EQ(read(file, 1).positions, (Positions{{4, 5, 6}}));
    EXPECT_EQ(read(file, 1).provenance["frame"], "1");
    expect_mentions(read(file, 1).notes.at(0), {"state 1 of 0 to 2"});
    expect_mentions(error_for(file, 3), {"three.dump", "--frame 3", "0 to 2"});

    const auto wrong = write("wrong.dump", state("0", "1 1 2 3") + state("10", "1 4 5 word"));
    expect_mentions(error_for(wrong, 1), {"wrong.dump: line 20"});
    EXPECT_EQ(read(wrong, 0).positions, (Positions{{1, 2, 3}}));
    const auto more = write("more.dump", state("0", "1 1 2 3\n2 1 2 3") + state("10", "1 4 5 6"));
    expect_mentions(error_for(more, 0), {"more.dump: line 10", "ITEM: TIMESTEP"});
}

TEST_F(Frames, AreRefusedWhereThereIsOne) {
    Snapshot snapshot;
    snapshot.positions = {{0, 0, 0}, {1, 0, 0}};
    snapshot.provenance["frame"] = "3"; // of the trajectory that it was made from
    write_vtkhdf(snapshot, folder / "one.vtkhdf");
    for (const auto& file : {folder / "one.vtkhdf", write("one.csv", "x,y,z\n0,0,0\n")})
        expect_mentions(error_for(file, 0), {"one.", "--frame 0", "a format of one"});
    const auto one = write("one.xyz", "1\nProperties=pos:R:3\n1 2 3\n");
    EXPECT_EQ(read(one, 0).notes.size(), 0U);
    expect_mentions(error_for(one, 1), {"one.xyz", "--frame 1", "1 state"});
}

} // namespace
} // namespace meniscus
