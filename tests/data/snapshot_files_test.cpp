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

std::ptrdiff_t files_in(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), {});
}

TEST_F(SnapshotFiles, WritesWholeFilesOverOldOnes) {
    const fs::path file = write("out", "something old and longer");
    write_whole(file, "new");
    EXPECT_EQ(bytes_of(file), "new");
    write_whole(file, "");
    EXPECT_EQ(bytes_of(file), "");
    EXPECT_EQ(files_in(folder), 1);
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
    const fs::path partial = write("out.0123456789abcdef.partial", "half of");
    const int other = open(partial.c_str(), O_WRONLY);
    ASSERT_EQ(flock(other, LOCK_EX), 0);
    expect_mentions(error_of<FailureError>([&] { write_whole(folder / "out", "bytes"); }),
                    {"out", "being written by another process"});
    EXPECT_EQ(bytes_of(partial), "half of");
    EXPECT_EQ(files_in(folder), 1);
    close(other); // it dies, and what it left is removed
    write_whole(folder / "out", "bytes");
    EXPECT_EQ(bytes_of(folder / "out"), "bytes");
    EXPECT_EQ(files_in(folder), 1);
}

TEST_F(SnapshotFiles, WritesThroughNothingThatLiesInTheWay) {
    const fs::path precious = write("precious", "precious");
    fs::create_symlink(precious, folder / "out.partial");
    fs::create_symlink(precious, folder / "out.0123456789abcdef.partial");
    fs::create_hard_link(precious, folder / "out.0123456789abcdee.partial");
    ASSERT_EQ(mkfifo((folder / "out.0123456789abcded.partial").c_str(), 0600), 0);
    write("out.0123456789.partial", "of another name");
    write_whole(folder / "out", "bytes");
    EXPECT_EQ(bytes_of(folder / "out"), "bytes");
    EXPECT_FALSE(fs::is_symlink(folder / "out"));
    EXPECT_EQ(bytes_of(precious), "precious");
    EXPECT_EQ(bytes_of(folder / "out.0123456789.partial"), "of another name");
}

TEST_F(SnapshotFiles, ALinkStaysALinkAndItsTargetIsWritten) {
    fs::create_directory(folder / "there");
    const fs::path target = write("there/target", "old");
    fs::create_symlink("there/second", folder / "out"); // links are relative to their folders
    fs::create_symlink("target", folder / "there" / "second");
    write_whole(folder / "out", "new");
    EXPECT_EQ(bytes_of(target), "new");
    EXPECT_TRUE(fs::is_symlink(folder / "out") && fs::is_symlink(folder / "there" / "second"));
    fs::create_symlink("there/none", folder / "dangling");
    write_whole(folder / "dangling", "made");
    EXPECT_EQ(bytes_of(folder / "there" / "none"), "made");
    fs::create_symlink("/dev/null", folder / "nowhere");
    expect_mentions(error_of<InputError>([&] { write_whole(folder / "nowhere", "bytes"); }),
                    {"nowhere", "device"});
    fs::create_symlink("circle", folder / "circle");
    EXPECT_THROW(write_whole(folder / "circle", "bytes"), InputError);
    EXPECT_EQ(files_in(folder / "there"), 3);
}

TEST_F(SnapshotFiles, RightsStayThoseOfTheReplacedFile) {
    const fs::path file = write("out", "old");
    for (const fs::perms rights : {fs::perms(0600), fs::perms(0640), fs::perms(0444)}) {
        fs::permissions(file, rights);
        write_whole(file, "new");
        EXPECT_EQ(fs::status(file).permissions(), rights);
    }
    const mode_t before = umask(027);
    write_whole(folder / "fresh", "new");
    umask(before);
    EXPECT_EQ(fs::status(folder / "fresh").permissions(), fs::perms(0640));
}

TEST_F(SnapshotFiles, LongNamesCanBeWritten) {
    const std::string name(255, 'n');
    write_whole(folder / name, "bytes");
    EXPECT_EQ(bytes_of(folder / name), "bytes");
}

TEST_F(SnapshotFiles, WantOfDescriptorsIsAFailure) {
    const fs::path file = write("file", "bytes");
    rlimit before{};
    getrlimit(RLIMIT_NOFILE, &before);
    const rlimit none{0, before.rlim_max};
    setrlimit(RLIMIT_NOFILE, &none);
    std::string reading;
    std::string writing;
    try {
        read_whole(file);
    } catch (const FailureError& error) {
        reading = error.what();
    }
    try {
        write_whole(folder / "out", "bytes");
    } catch (const FailureError& error) {
        writing = error.what();
    }
    setrlimit(RLIMIT_NOFILE, &before);
    expect_mentions(reading, {"file", "Too many open files"});
    expect_mentions(writing, {"out", "Too many open files"});
}

TEST_F(SnapshotFiles, MoreArraysThanAnyStateHasAreRefused) {
    std::string header = "x,y,z";
    std::string row = "1,2,3";
    for (int i = 0; i < 5000; ++i) {
        header += ",a" + std::to_string(i);
        row += ",1";
    }
    const fs::path file = write("wide.csv", header + "\n" + row + "\n");
    expect_mentions(error_of<InputError>([&] { read_snapshot(file); }),
                    {"wide.csv", "at most 1000 arrays", "5000"});
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
    EXPECT_EQ(files_in(folder), 1);
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
    EXPECT_EQ(files_in(folder), 1);
}

} // namespace
} // namespace meniscus
