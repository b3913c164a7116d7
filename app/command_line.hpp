// What all verbs of the `meniscus` command share: how they are registered, how they report, and
// how they name files. A verb is one file with one function that adds it to the command.
#pragma once

#include <meniscus/data/text/printable.hpp>
#include <meniscus/data/text/same_file.hpp>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace meniscus {

using Path = std::filesystem::path;
struct ReportPage;

/// A limit that the user asked for is exceeded: exit status 1.
class LimitExceeded : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The verbs.
void add_simulate(CLI::App& command);
void add_label(CLI::App& command);
void add_train(CLI::App& command);
void add_calibrate(CLI::App& command);
void add_export(CLI::App& command);
void add_audit(CLI::App& command);
void add_classify(CLI::App& command);
void add_demo(CLI::App& command);
void add_inspect(CLI::App& command);
void add_models(CLI::App& command);
void add_man(CLI::App& command);
void add_completion(CLI::App& command);
void add_picture(CLI::App& command);
void add_plot(CLI::App& command);
// Where the benchmarks are built.
void add_bench(CLI::App& command);
void add_study(CLI::App& command);

/// Adds --quiet to a verb.
void add_quiet_option(CLI::App& verb, bool& quiet);

/// Adds --threads to a verb.
void add_threads_option(CLI::App& verb, int& threads);

/// What a seed or a count may be.
CLI::Range whole_numbers();

/// Opens /dev/null in place of standard streams that are closed, so that no file that is opened
/// later is taken for one of them. To be called first of all.
void open_standard_streams();

/// Prints one line on standard error, whatever a file's name contains.
void print_error_line(const std::string& message);

/// Prints lines on standard output, whatever the texts in them contain but for line breaks, of
/// which printable() (data/text/printable.hpp) rids a name.
void print_text(const std::string& text);

/// The inputs that label and classify take and where their outputs go.
struct InputsAndFolder {
    std::vector<Path> inputs;
    Path folder;
    bool overwrite = false; ///< outputs that were made from another input
};

/// Output of each input: folder/<stem of input>.vtkhdf, or <stem>_<frame> where a state of a
/// trajectory is chosen. Throws InputError where an input does not
/// exist, where two inputs have one output name, or where an output would fall on an input or on
/// one of the other files that are read.
std::vector<Path> output_files(const InputsAndFolder& files, const std::vector<Path>& also_read,
                               std::optional<std::uint64_t> frame);

/// Adds --overwrite to a verb.
void add_overwrite_option(CLI::App& verb, InputsAndFolder& files);

/// Creates the folder where it is missing; throws InputError where it cannot be written to.
void make_writable_folder(const Path& folder);

/// "12 s", "3 min", "2.5 h".
std::string span_text(double seconds);

/// Writes the page of a report and prints its warnings on standard error.
void write_report(const Path& file, const ReportPage& page);

/// One line on standard error that says how something long comes along, changed a few times a
/// second at most; where that is no terminal a line of its own now and then.
class StatusLine {
public:
    explicit StatusLine(bool quiet);
    ~StatusLine();
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;

    /// Shows what `text()` returns, cut to the width of the terminal, where it is time to.
    template <class Text>
    void show(const Text& text) {
        if (is_due())
            print(text());
    }

    /// Takes the line away, for another one to be printed in its place.
    void clear();

private:
    bool visible;
    bool in_place; ///< on a terminal
    bool stands = false;
    std::chrono::steady_clock::time_point shown;

    [[nodiscard]] bool is_due() const;
    void print(const std::string& text);
};

/// A bar on the status line while something long runs.
class ProgressBar {
public:
    ProgressBar(std::string title, std::size_t total, bool quiet);

    void show(std::size_t done);

private:
    std::string title;
    std::size_t total;
    StatusLine line;
};

/// From now on an interrupt (Ctrl-C, SIGTERM, a terminal that closes) ends the program with status
/// 130, at once or, while a file is being written, right after: files appear whole or not at all. A
/// file that outgrows a limit on its size becomes an ordinary error of writing.
void install_interrupt_handler();

/// While one lives, an interrupt waits.
class WriteGuard {
public:
    WriteGuard();
    ~WriteGuard();
    WriteGuard(const WriteGuard&) = delete;
    WriteGuard& operator=(const WriteGuard&) = delete;
};

/// Whether an interrupt waits for a WriteGuard to end.
bool interrupt_is_waiting();

} // namespace meniscus
