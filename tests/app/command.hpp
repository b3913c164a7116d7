// Runs the real `meniscus` command on real files, as a user does at a terminal, and looks at what
// comes back: exit status, both outputs, and the files that are there afterwards.
#pragma once

#include <data/test_folder.hpp>

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/particles/snapshot.hpp>

#include <csignal>
#include <fcntl.h>
#include <regex>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <vector>

namespace meniscus {

using Path = std::filesystem::path;
using Words = std::vector<std::string>;

struct Outcome {
    int status = 0; ///< exit status, or 128 + signal, as a shell has it
    std::string output;
    std::string errors;
};

/// First words of every command, with more to follow.
inline Words operator+(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

class CommandLine : public TestFolder {
protected:
    /// Starts a program with its outputs going to files of the test folder.
    [[nodiscard]] pid_t start(const Words& words) const {
        std::vector<char*> arguments;
        for (const std::string& word : words)
            arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t files;
        posix_spawn_file_actions_init(&files);
        constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
        posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, output_file.c_str(), flags, 0600);
        posix_spawn_file_actions_addopen(&files, STDERR_FILENO, errors_file.c_str(), flags, 0600);
        // A shell that runs the tests in the background has them ignore Ctrl-C.
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        sigset_t all;
        sigfillset(&all);
        posix_spawnattr_setsigdefault(&attributes, &all);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
        pid_t process = 0;
        EXPECT_EQ(
            posix_spawnp(&process, arguments[0], &files, &attributes, arguments.data(), environ), 0)
            << words[0];
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&files);
        return process;
    }

    Outcome finish(pid_t process) const {
        int status = 0;
        waitpid(process, &status, 0);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
                bytes_of(output_file), bytes_of(errors_file)};
    }

    Outcome run(const Words& words) const { return finish(start(words)); }

    /// What runs a command beside a disk of its own at the folder, which holds `filler` bytes in a
    /// file of that name, and is listed on standard output in the end. None where mounting is not
    /// permitted.
    [[nodiscard]] Words on_small_disk(const Path& disk, const std::string& size,
                                      const std::string& filler) const {
        const std::string script = R"(mount -t tmpfs -o "size=$1" none "$0" || exit
            head -c "$2" /dev/zero > "$0/filler" && shift 2 || exit
            "$@"
            status=$?
            ls -A "$0"
            exit $status)";
        std::filesystem::create_directory(disk);
        const Words on_disk = {
            "unshare", "--user", "--map-root-user", "--mount", "sh", "-c", script, disk, size};
        const bool works = run(on_disk + Words{"1", "true"}).output == "filler\n";
        return works ? on_disk + Words{filler} : Words{};
    }

    /// What was said but for how far the command is, which it says where the machine is slow.
    static std::string without_progress(const std::string& errors) {
        static const std::regex progress("meniscus: [a-z]+: file [0-9]+ of [0-9]+, .* left\n");
        return std::regex_replace(errors, progress, "");
    }

    /// Runs the command; it must succeed without a warning. Returns what it prints.
    std::string succeed(const Words& words) const {
        const Outcome outcome = run(program + words);
        EXPECT_EQ(outcome.status, 0) << outcome.errors;
        EXPECT_EQ(without_progress(outcome.errors), "");
        return outcome.output;
    }

    /// Runs the command; it must fail with this status and one line that mentions these parts, and
    /// leave the files below the folder as they were.
    void fail(int status, const Words& words, std::initializer_list<const char*> parts) const {
        fail_as(status, program + words, parts);
    }

    /// The same for a command that is run by way of another one.
    void fail_as(int status, const Words& words, std::initializer_list<const char*> parts) const {
        const Words before = files();
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, status) << outcome.errors;
        expect_one_line(outcome.errors);
        expect_mentions(outcome.errors, parts);
        EXPECT_EQ(files(), before);
    }

    static void expect_one_line(const std::string& errors) {
        EXPECT_EQ(errors.rfind("meniscus: ", 0), 0U) << errors;
        EXPECT_EQ(errors.find('\n'), errors.size() - 1) << errors;
        EXPECT_LT(errors.size(), 500U) << errors;
    }

    /// All files below the folder but those that hold what a program printed.
    [[nodiscard]] Words files() const {
        Words names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (!entry.is_directory() && entry.path() != output_file && entry.path() != errors_file)
                names.push_back(std::filesystem::relative(entry.path(), folder));
        std::sort(names.begin(), names.end());
        return names;
    }

    static Path sample(const std::string& name) {
        return Path(MENISCUS_SAMPLES) / (name + ".vtkhdf");
    }

    /// Labels with few samples, which is quick, and returns the labelled file.
    Path label(const Path& input, const Words& options = {}) const {
        succeed(Words{"label", input, "-o", folder / "labelled", "--samples", "500", "--quiet"} +
                options);
        return folder / "labelled" / input.stem().concat(".vtkhdf");
    }

    [[nodiscard]] Path save(const Snapshot& snapshot, const std::string& name) const {
        write_vtkhdf(snapshot, folder / name);
        return folder / name;
    }

    const Words program = {MENISCUS_PROGRAM};

private:
    const Path output_file = folder / "standard_output";
    const Path errors_file = folder / "standard_error";
};

/// A block of `edge`^dimension particles, one support radius being two spacings, dented by a wave
/// so that features vary.
inline Snapshot block(int edge, int dimension = 3) {
    Snapshot snapshot;
    snapshot.dimension = dimension;
    snapshot.support_radius = 1;
    snapshot.particle_spacing = 0.5;
    for (int z = 0; z < (dimension == 3 ? edge : 1); ++z)
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x)
                snapshot.positions.push_back({0.5 * x + 0.05 * ((3 * y + z) % 5),
                                              0.5 * y + 0.03 * ((2 * x + z) % 7), 0.5 * z});
    return snapshot;
}

} // namespace meniscus
