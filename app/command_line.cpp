#include "command_line.hpp"

#include "threads.hpp"

#include <meniscus/app/report/report.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/particles/generic_names.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/threads/threads.hpp>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>

namespace meniscus {
namespace {

std::atomic<int> writing{0}; ///< guards that live, of all threads
volatile std::sig_atomic_t interrupt_waits = 0;

[[noreturn]] void end_interrupted() {
    constexpr char message[] = "meniscus: interrupted\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, message, sizeof message - 1);
    _exit(130);
}

void on_interrupt(int /*signal*/) {
    if (writing == 0)
        end_interrupted();
    interrupt_waits = 1;
}

} // namespace

void install_interrupt_handler() {
    struct sigaction action = {};
    action.sa_handler = on_interrupt;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
        struct sigaction inherited = {};
        sigaction(signal, nullptr, &inherited);
        if (inherited.sa_handler != SIG_IGN) // as nohup leaves it
            sigaction(signal, &action, nullptr);
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

WriteGuard::WriteGuard() {
    ++writing;
}

WriteGuard::~WriteGuard() {
    if (--writing == 0 && interrupt_waits != 0)
        end_interrupted();
}

bool interrupt_is_waiting() {
    return interrupt_waits != 0;
}

void add_quiet_option(CLI::App& verb, bool& quiet) {
    verb.add_flag("-q,--quiet", quiet, "Print nothing but errors and warnings");
}

void add_threads_option(CLI::App& verb, int& threads) {
    verb.add_option("--threads", threads, "Threads; 0: all cores")
        ->check(CLI::Range(0, thread_limit))
        ->capture_default_str();
    // Before the verb's own callback.
    verb.parse_complete_callback([&threads] { check_threads_start(threads); });
}

CLI::Range whole_numbers() {
    // Signed, because the reader of unsigned numbers takes -1 for the largest of them.
    return {std::int64_t{0}, std::numeric_limits<std::int64_t>::max()};
}

void print_error_line(const std::string& message) {
    // Where nobody can read it, work goes on and the exit status says the rest.
    std::fputs(("meniscus: " + printable(message) + "\n").c_str(), stderr);
}

void print_text(const std::string& text) {
    std::fputs(printable_lines(text).c_str(), stdout); // main() looks whether it came through
}

void open_standard_streams() {
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(standard, F_GETFD) < 0 && errno == EBADF)
            open("/dev/null", O_RDWR); // the lowest that is free
}

namespace {

/// What `meniscus simulate` goes on from is a snapshot too, of the last frame in another order.
void check_is_no_checkpoint(const Path& input) {
    constexpr std::string_view end = "_checkpoint";
    const std::string stem = input.stem().string();
    if (stem.size() < end.size() || stem.substr(stem.size() - end.size()) != end ||
        !is_vtkhdf(input))
        return;
    const auto provenance = read_vtkhdf(input).provenance;
    if (provenance.count("run") > 0 && provenance.count("log") > 0)
        throw InputError(
            fmt::format("{}: the checkpoint of a simulation is no frame of it; leave it "
                        "out, as in {}_[0-9]*.vtkhdf",
                        input.string(), stem.substr(0, stem.size() - end.size())));
}

} // namespace

std::vector<Path> output_files(const InputsAndFolder& files, const std::vector<Path>& also_read,
                               std::optional<std::uint64_t> frame) {
    const std::string suffix = frame ? fmt::format("_{}", *frame) : "";
    std::map<Path, Path> input_of;
    std::vector<Path> outputs;
    for (const Path& input : files.inputs) {
        if (!std::filesystem::exists(input))
            throw InputError(fmt::format("{}: no such file", input.string()));
        check_is_no_checkpoint(input);
        outputs.push_back(files.folder / (telling_stem(input) + suffix + ".vtkhdf"));
        const auto [other, is_new] = input_of.emplace(outputs.back(), input);
        if (!is_new)
            throw InputError(fmt::format("{} and {} would both be written to {}; label them into "
                                         "different folders",
                                         other->second.string(), input.string(),
                                         outputs.back().string()));
    }
    for (const Path& output : outputs) {
        check_is_not_an_input(output, files.inputs);
        check_is_not_an_input(output, also_read);
    }
    return outputs;
}

void add_overwrite_option(CLI::App& verb, InputsAndFolder& files) {
    verb.add_flag("--overwrite", files.overwrite,
                  "Overwrite outputs that were made from another input (default: refuse; those of "
                  "the same file are made anew where it or an option has changed)");
}

void make_writable_folder(const Path& folder) {
    if (folder.empty())
        throw InputError("the name of the output folder is empty; give one with -o");
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const std::string failure =
        fmt::format("{}: cannot create the output folder: {}", folder.string(), error.message());
    if (error == std::errc::no_space_on_device || error == std::errc::io_error ||
        error == std::errc::not_enough_memory)
        throw FailureError(failure);
    if (error)
        throw InputError(failure);
    if (access(folder.c_str(), W_OK) != 0)
        throw InputError(fmt::format("{}: the output folder is not writable", folder.string()));
}

void write_report(const Path& file, const ReportPage& page) {
    {
        const WriteGuard guard;
        write_whole(file, page.html);
    }
    for (const std::string& warning : page.warnings)
        print_error_line("warning: " + warning);
}

ProgressBar::ProgressBar(std::string title, std::size_t total, bool quiet)
    : title(printable(title, 200)), total(total), line(quiet) {}

void ProgressBar::show(std::size_t done) {
    line.show([&] {
        const std::size_t percent = done >= total ? 100 : 100 * done / total;
        constexpr std::size_t width = 40;
        const std::size_t filled = percent * width / 100;
        return fmt::format("{} [{:=<{}}{: <{}}] {:3} %", title, "", filled, "", width - filled,
                           percent);
    });
}

std::string span_text(double seconds) {
    if (seconds < 100)
        return fmt::format("{:.0f} s", seconds);
    if (seconds < 6000)
        return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
}

StatusLine::StatusLine(bool quiet) : visible(!quiet), in_place(isatty(STDERR_FILENO) != 0) {
    if (!in_place) // what is done by then needs no word
        shown = std::chrono::steady_clock::now();
}

StatusLine::~StatusLine() {
    clear();
}

void StatusLine::clear() {
    if (stands)
        std::fputs("\r\033[K", stderr);
    stands = false;
}

bool StatusLine::is_due() const {
    using namespace std::chrono;
    const milliseconds between = in_place ? milliseconds(200) : milliseconds(20'000);
    return visible && steady_clock::now() - shown > between;
}

void StatusLine::print(const std::string& text) {
    shown = std::chrono::steady_clock::now();
    if (!in_place) {
        print_error_line(text);
        return;
    }
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
    const std::size_t width = known ? size.ws_col - 1U : 79U;
    std::fputs(("\r\033[K" + printable(text).substr(0, width)).c_str(), stderr);
    std::fflush(stderr);
    stands = true;
}

} // namespace meniscus
