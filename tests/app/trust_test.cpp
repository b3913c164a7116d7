// What the command is built, started and fed with by people it knows nothing of: no library out of
// the current folder, closed standard streams, names made to fool a terminal.
#include "command.hpp"

#include <meniscus/classifier/model/model.hpp>

#include <nlohmann/json.hpp>

#include <sys/stat.h>

namespace meniscus {
namespace {

using Json = nlohmann::ordered_json;

class Trust : public CommandLine {
protected:
    /// The command with redirections of the shell's.
    [[nodiscard]] Outcome redirected(const Words& words, const std::string& redirections) const {
        return run(Words{"sh", "-c", "exec \"$@\" " + redirections, "sh"} + program + words);
    }

    /// No byte that a terminal would do something with but for line breaks.
    static void expect_harmless(const std::string& text) {
        for (const char c : text)
            EXPECT_TRUE(c == '\n' || (static_cast<unsigned char>(c) >= 32 && c != 127)) << text;
    }

    static constexpr const char* evil = "\x1b]0;owned\a\x1b[31m\nforged line\r\xff*/ \\ \u202e";
};

TEST_F(Trust, LibrariesAreLookedForInWholePathsAlone) {
    const Outcome outcome = run(Words{"readelf", "-dW"} + program);
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    expect_mentions(outcome.output, {"NEEDED", "BIND_NOW", "PIE"});
    for (const char* tag : {"runpath: [", "rpath: ["}) {
        const std::size_t found = outcome.output.find(tag);
        if (found == std::string::npos)
            continue;
        const std::size_t begin = outcome.output.find('[', found) + 1;
        const std::size_t end = outcome.output.find(']', begin);
        const std::string path = ":" + outcome.output.substr(begin, end - begin) + ":";
        for (std::size_t at = 0; at + 1 < path.size(); at = path.find(':', at + 1))
            EXPECT_EQ(path[at + 1], '/') << path;
    }
}

TEST_F(Trust, StandardStreamsMayBeClosed) {
    const Path input = save(block(5), "block.vtkhdf");
    const Path output = folder / "labelled" / "block.vtkhdf";
    for (const char* closed : {"<&-", ">&-", "2>&-", "<&- >&-", ">&- 2>&-", "<&- >&- 2>&-"}) {
        const Outcome outcome =
            redirected({"label", input, "-o", output.parent_path(), "--samples", "50"}, closed);
        EXPECT_EQ(outcome.status, 0) << closed << outcome.errors;
        EXPECT_TRUE(std::filesystem::remove(output)) << closed;
    }
}

TEST_F(Trust, WarningsThatNobodyCanReadEndNoWork) {
    Snapshot dense = block(7);
    dense.support_radius = 0.1; // a warning
    const Path input = save(dense, "block.vtkhdf");
    const Words words = {"label", input, "-o", folder / "labelled", "--samples", "50"};
    EXPECT_NE(run(program + words).errors, "");
    std::filesystem::remove_all(folder / "labelled");
    EXPECT_EQ(redirected(words, "2> /dev/full").status, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "labelled" / "block.vtkhdf"));
}

TEST_F(Trust, WantOfDescriptorsIsAFailureOfTheMachine) {
    const Path input = save(block(5), "block.vtkhdf");
    // Whoever runs the tests may have left files open.
    const Words limited = {"sh", "-c", "exec 3<&- 4<&- 5<&-; ulimit -n 4 && exec \"$@\"", "sh"};
    fail_as(3, limited + program + Words{"label", input, "-o", folder / "out"}, {"block.vtkhdf"});
}

TEST_F(Trust, NamesInFilesDoNothingToATerminal) {
    const Path key =
        write("key.json", Json{{evil, 1}}.dump(-1, ' ', false, Json::error_handler_t::replace));
    const Outcome refused = run(program + Words{"export", key, "-o", folder / "h.hpp"});
    EXPECT_EQ(refused.status, 2);
    expect_one_line(refused.errors);
    expect_harmless(refused.errors);
    Snapshot snapshot = block(7);
    snapshot.scene = evil;
    const Path labelled = label(save(snapshot, "block.vtkhdf"));
    const Path model = folder / "model.json";
    const std::string trained = succeed({"train", labelled, "-o", model});
    expect_mentions(trained, {"\\x1b]0;owned\\x07", "\\x0aforged line\\x0d\\xff"});
    expect_harmless(trained);
    Json changed = Json::parse(bytes_of(model));
    changed["objective"] = "\x1b[31m\nforged line\r";
    write("model.json", changed.dump());
    for (const char* format : {"table", "json", "csv"}) {
        const std::string audit =
            succeed({"audit", labelled, "--model", model, "--format", format});
        expect_harmless(audit);
        EXPECT_EQ(audit.find("\nforged"), std::string::npos) << audit;
    }
    succeed({"export", model, "-o", folder / "h.hpp", "--quiet"});
    EXPECT_EQ(bytes_of(folder / "h.hpp").find("\nforged"), std::string::npos);
}

TEST_F(Trust, LongNamesMakeShortMessages) {
    const Path key = write("key.json", "{\"" + std::string(300'000, 'k') + "\": 1e999}");
    fail(2, {"export", key, "-o", folder / "h.hpp"}, {"key.json", "kkk...kkk", "too large"});
    const Path nested = write("nested.json", std::string(100'000, '['));
    fail(2, {"export", nested, "-o", folder / "h.hpp"}, {"nested.json", "nest more than 100"});
}

TEST_F(Trust, DeepChangesAreNoCrash) {
    const Path scene = Path(MENISCUS_SCENES) / "drop_2d.json";
    fail(2,
         {"simulate", scene, "-o", folder / "other", "--set", "name=" + std::string(50'000, '[')},
         {"name"});
    std::string value(50'000, '[');
    value += std::string(50'000, ']');
    fail(2, {"simulate", scene, "-o", folder / "other", "--set", "gravity=" + value},
         {"gravity", "nest more than 100"});
    std::string key;
    for (int i = 0; i < 20'000; ++i)
        key += "a.";
    fail(2, {"simulate", scene, "-o", folder / "other", "--set", key + "a=1"}, {"a.a.a", "key"});
}

} // namespace
} // namespace meniscus
