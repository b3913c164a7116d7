#include "test_folder.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <atomic>
#include <csignal>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <thread>
#include <vector>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

using SnapshotFiles = TestFolder;

TEST_F(SnapshotFiles, EachUnreadableKindHasItsOwnMessage) {
    const auto message = [](const fs::path& file) {
        return error_of<InputError>([&] { read_snapshot(file); });
    };
    expect_mentions(message(folder / "none.vtk"), {"none.vtk", "found none"});
    expect_mentions(message(folder), {folder.c_str(), "folder"});
    expect_mentions(message(write("empty.vtk", "")), {"empty.vtk", "empty file"});
    expect_mentions(message("/dev/null"), {"/dev/null", "device"});
    expect_mentions(message(write("text.vtk", "x y z\n")), {"text.vtk", "VTKHDF", "legacy VTK"});
}

TEST_F(SnapshotFiles, FormatIsToldByContent) {
    Snapshot snapshot;
    snapshot.positions = {{1, 2, 3}};
    write_vtkhdf(snapshot, folder / "misnamed.vtk");
    EXPECT_EQ(read_snapshot(folder / "misnamed.vtk").positions, snapshot.positions);
}

TEST_F(SnapshotFiles, ReadsTheWholeFileOrItsBeginning) {
    const fs::path file = write("bytes", std::string_view("a\0b\n", 4));
    EXPECT_EQ(read_whole(file), std::string("a\0b\n", 4));
    EXPECT_EQ(read_whole(file, 1), "a");
}

TEST_F(SnapshotFiles, HashIsSha256) {
    EXPECT_EQ(file_hash(write("abc", "abc")),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(file_hash(write("empty", "")),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(file_hash(write("million", std::string(1'000'000, 'a'))),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    EXPECT_EQ(file_hash(write("block", std::string(1 << 20, '\0'))),
              "30e14955ebf1352266dc2ff8067e68104607e750abb9d3b36582b8af909fcb58");
    EXPECT_THROW(file_hash(folder / "none"), InputError);
    EXPECT_THROW(file_hash(folder), InputError);
}

TEST_F(SnapshotFiles, WritesWholeFilesOverOldOnes) {
    const fs::path file = write("out", "something old and longer");
    write_whole(file, "new");
    EXPECT_EQ(bytes_of(file), "new");
    write_whole(file, "");
    EXPECT_EQ(bytes_of(file), "");
    EXPECT_FALSE(fs::exists(folder / "out.partial"));
}

TEST_F(SnapshotFiles, RefusesFoldersThatCannotBeWrittenTo) {
    const auto message = [](const fs::path& file) {
        return error_of<InputError>([&] { write_whole(file, "bytes"); });
    };
    expect_mentions(message(folder / "none" / "out"),
                    {(folder / "none").c_str(), "No such file or directory"});
    const fs::path file = write("file", "");
    expect_mentions(message(file / "out"), {file.c_str(), "Not a directory"});
    expect_mentions(message(folder), {folder.c_str(), "found a folder"});
    expect_mentions(message("/dev/null"), {"/dev/null", "device"});
    if (geteuid() != 0) { // nothing is closed to root
        fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
        expect_mentions(message(folder / "out"), {folder.c_str(), "Permission denied"});
        fs::permissions(folder, fs::perms::owner_all);
    }
}

TEST_F(SnapshotFiles, RefusesNamesWithoutAFile) {
    for (const fs::path& file : {fs::path(), folder / "none" / ""})
        expect_mentions(error_of<InputError>([&] { write_whole(file, "bytes"); }),
                        {file.c_str(), "the name of a file"});
}

TEST_F(SnapshotFiles, WhatCannotBeWrittenIsKnownBefore) {
    check_can_be_written(folder / "out");
    check_can_be_written(write("old", "old"));
    EXPECT_EQ(bytes_of(folder / "old"), "old");
    EXPECT_FALSE(fs::exists(folder / "out"));
    for (const fs::path& file : {fs::path(), folder, folder / "none" / "out", folder / "old" / "x"})
        EXPECT_THROW(check_can_be_written(file), InputError) << file;
}

TEST_F(SnapshotFiles, TwoWritersOfOneFileDoNotMix) {
    // Another process in the middle of writing the same file.
    const fs::path partial = write("out.partial", "half of");
    const int other = open(partial.c_str(), O_WRONLY);
    ASSERT_EQ(flock(other, LOCK_EX), 0);
    expect_mentions(error_of<FailureError>([&] { write_whole(folder / "out", "bytes"); }),
                    {"out", "being written by another process"});
    EXPECT_EQ(bytes_of(partial), "half of");
    EXPECT_FALSE(fs::exists(folder / "out"));
    close(other); // it dies, and what it left is written over
    write_whole(folder / "out", "bytes");
    EXPECT_EQ(bytes_of(folder / "out"), "bytes");
    EXPECT_FALSE(fs::exists(partial));
}

TEST_F(SnapshotFiles, ManyWritersOfOneFileLeaveAWholeOne) {
    const fs::path file = folder / "out";
    std::atomic<int> written{0};
    std::vector<std::thread> writers;
    for (const char letter : {'a', 'b', 'c', 'd'})
        writers.emplace_back([&, letter] {
            for (int round = 0; round < 50; ++round) {
                try {
                    write_whole(file, std::string(10'000, letter));
                    ++written;
                } catch (const FailureError&) { // another one is at it
                }
            }
        });
    for (std::thread& writer : writers)
        writer.join();
    EXPECT_GT(written, 0);
    EXPECT_EQ(bytes_of(file), std::string(10'000, bytes_of(file).at(0)));
    EXPECT_FALSE(fs::exists(folder / "out.partial"));
}

TEST_F(SnapshotFiles, LeavesNothingBehindWhenTheDiskIsFull) {
    const fs::path file = write("out", "old");
    // A limit on file size fails in write() just as a full disk does.
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto previous = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{4096, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string message =
        error_of<FailureError>([&] { write_whole(file, std::string(100'000, 'x')); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, previous);
    expect_mentions(message, {"out", "File too large"});
    EXPECT_EQ(bytes_of(file), "old");
    EXPECT_FALSE(fs::exists(folder / "out.partial"));
}

} // namespace
} // namespace meniscus
