// What cannot be written: wrong places are bad input (2), a machine that fails is not (3). Either
// way nothing half-written stays.
#include "command.hpp"

#include <meniscus/classifier/model/model.hpp>

#include <unistd.h>

namespace meniscus {
namespace {

class BadOutput : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        input = save(block(7), "block.vtkhdf");
        labelled = label(input);
        succeed({"train", labelled, "-o", model, "--quiet"});
    }

    /// Every verb that writes a file, with its output below a folder.
    [[nodiscard]] std::vector<Words> writers(const Path& below) const {
        return {{"label", input, "-o", below, "--samples", "500"},
                {"classify", input, "--model", model, "-o", below},
                {"train", labelled, "-o", below / "trained.json"},
                {"export", model, "-o", below / "header.hpp"},
                {"simulate", scene, "-o", below},
                {"audit", labelled, "--model", model, "--report", below / "page.html", "--quiet"},
                {"picture", input, "-o", below / "picture.png"}};
    }

    const Path scene = Path(MENISCUS_MODELS).parent_path() / "scenes" / "drop_2d.json";
    Path input;
    Path labelled;
    const Path model = folder / "model.json";
};

TEST_F(BadOutput, FolderThatCannotBe) {
    const Path file = write("file", "not a folder");
    for (const Path& below : {file, file / "folder", Path("/proc/nothing")})
        for (const Words& words : writers(below))
            fail(2, words, {below.c_str()});
    fail(2, {"demo", "-o", file}, {file.c_str()});
}

TEST_F(BadOutput, FolderWithoutAName) {
    fail(2, {"label", input, "-o", ""}, {"output folder is empty"});
    fail(2, {"classify", input, "--model", model, "-o", ""}, {"output folder is empty"});
    fail(2, {"simulate", scene, "-o", ""}, {"output folder is empty"});
}

TEST_F(BadOutput, FolderWithoutPermission) {
    if (geteuid() == 0)
        GTEST_SKIP() << "the superuser may write anywhere";
    const Path below = folder / "theirs";
    std::filesystem::create_directory(below);
    std::filesystem::permissions(below, std::filesystem::perms::owner_read |
                                            std::filesystem::perms::owner_exec);
    for (const Words& words : writers(below))
        fail(2, words, {below.c_str()});
}

TEST_F(BadOutput, NamesThatAreFolders) {
    std::filesystem::create_directories(folder / "taken.json");
    fail(2, {"train", labelled, "-o", folder / "taken.json"}, {"taken.json", "folder"});
    fail(2, {"export", model, "-o", folder / "taken.json"}, {"taken.json", "folder"});
    fail(2, {"train", labelled, "-o", folder / "none" / "m.json"}, {"none"});
    fail(2, {"export", model, "-o", folder / "none" / "h.hpp"}, {"none"});
}

TEST_F(BadOutput, IsFoundOutBeforeTheWork) {
    const Path no_input = write("text", "neither labelled nor a model");
    for (const Path& output : {folder / "none" / "file", Path()}) {
        const char* said = output.empty() ? "the name of a file" : output.c_str();
        fail(2, {"train", no_input, "-o", output}, {said});
        fail(2, {"export", no_input, "-o", output}, {said});
    }
}

TEST_F(BadOutput, NamesThatCollide) {
    std::filesystem::create_directory(folder / "other");
    const Path twin = save(block(5), "other/block.vtkhdf");
    const Words both = {input, twin, "-o", folder / "out"};
    fail(2, Words{"label"} + both, {input.c_str(), twin.c_str(), "out/block.vtkhdf"});
    fail(2, Words{"classify", "--model", model} + both, {input.c_str(), twin.c_str()});
    const Path other_name = folder / "block.vtk"; // another name with the same stem
    std::filesystem::copy(input, other_name);
    fail(2, {"label", input, other_name, "-o", folder / "out"}, {"block.vtk", "block.vtkhdf"});
}

TEST_F(BadOutput, OverItsOwnInput) {
    const std::string bytes = bytes_of(input);
    fail(2, {"label", input, "-o", folder}, {"block.vtkhdf", "overwrite"});
    fail(2, {"label", input, "-o", folder / "labelled" / ".."}, {"block.vtkhdf", "overwrite"});
    fail(2, {"classify", input, "--model", model, "-o", folder}, {"block.vtkhdf", "overwrite"});
    std::filesystem::create_directory_symlink(folder, folder / "link");
    fail(2, {"label", input, "-o", folder / "link"}, {"block.vtkhdf", "overwrite"});
    std::filesystem::create_hard_link(input, folder / "source.vtkhdf");
    std::filesystem::create_directory(folder / "out");
    std::filesystem::create_hard_link(input, folder / "out" / "source.vtkhdf");
    fail(2, {"label", folder / "source.vtkhdf", "-o", folder / "out"},
         {"source.vtkhdf", "overwrite"});
    EXPECT_TRUE(bytes_of(input) == bytes);
}

TEST_F(BadOutput, OverWhatElseItReads) {
    const Path model_named_so = folder / "out" / "block.vtkhdf";
    std::filesystem::create_directory(folder / "out");
    std::filesystem::copy(model, model_named_so);
    fail(2, {"classify", input, "--model", model_named_so, "-o", folder / "out"}, {"overwrite"});
    std::filesystem::remove(model_named_so);
    const Path walls = save(block(3), "out/block.vtkhdf");
    for (const Path& name : {walls, folder / "labelled" / ".." / "out" / "block.vtkhdf"}) {
        fail(2, {"label", input, "-o", folder / "out", "--boundary", name}, {"overwrite"});
        fail(2, {"classify", input, "--model", model, "-o", folder / "out", "--boundary", name},
             {"overwrite"});
    }
    EXPECT_EQ(read_vtkhdf(walls).size(), 27U);
    fail(2, {"train", labelled, "-o", model, "--keep-k", model}, {"model.json", "overwrite"});
    fail(2, {"export", model, "-o", folder / "out" / ".." / "model.json"}, {"overwrite"});
    EXPECT_NO_THROW(read_model(model));
}

TEST_F(BadOutput, FileTooLarge) {
    const Words limited = {"sh", "-c", "ulimit -f 4 && exec \"$@\"", "sh"};
    for (const std::size_t verb : {0U, 1U})
        fail_as(3, limited + program + writers(folder / "out")[verb], {"out/block.vtkhdf"});
    EXPECT_TRUE(std::filesystem::is_empty(folder / "out"));
    fail_as(3, limited + program + writers(folder / "out")[4], {"out/drop_2d_checkpoint.vtkhdf"});
    EXPECT_TRUE(std::filesystem::is_empty(folder / "out"));
}

TEST_F(BadOutput, DiskFull) {
    const Path disk = folder / "disk";
    const Words on_disk = on_small_disk(disk, "16k", "16384");
    if (on_disk.empty())
        GTEST_SKIP() << "mounting is not permitted here";
    for (const Words& words : writers(disk)) {
        const Outcome outcome = run(on_disk + program + words);
        EXPECT_EQ(outcome.status, 3) << words[0];
        expect_one_line(outcome.errors);
        expect_mentions(outcome.errors, {disk.c_str(), "space"});
        EXPECT_EQ(outcome.output, "filler\n");
    }
}

TEST_F(BadOutput, StandardOutputFull) {
    const Words full = {"sh", "-c", "exec \"$@\" > /dev/full", "sh"};
    fail_as(3, full + program + Words{"audit", labelled, "--model", model, "--format", "json"},
            {"standard output"});
}

TEST_F(BadOutput, OutOfMemory) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the address sanitizer itself needs more than the limit";
#endif
    const Words limited = {"sh", "-c", "ulimit -v 1000000 && exec \"$@\"", "sh"};
    for (const char* scheme : {"halton", "random"})
        fail_as(3,
                limited + program +
                    Words{"label", input, "-o", folder / "out", "--samples", "100000000",
                          "--scheme", scheme},
                {"out of memory"});
}

} // namespace
} // namespace meniscus
