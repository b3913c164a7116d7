#include "command_line.hpp"

#include <meniscus/app/report/report.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/particles/generic_names.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <csignal>
#include <cstdio>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>

namespace meniscus {
namespace {

volatile std::sig_atomic_t writing = 0;
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
    writing = 1;
}

WriteGuard::~WriteGuard() {
    writing = 0;
    if (interrupt_waits != 0)
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
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
}

CLI::Range whole_numbers() {
    // Signed, because the reader of unsigned numbers takes -1 for the largest of them.
    return {std::int64_t{0}, std::numeric_limits<std::int64_t>::max()};
}

void print_error_line(const std::string& message) {
    std::string line = message;
    for (char& c : line)
        if (c == '\n' || c == '\r')
            c = ' ';
    fmt::print(stderr, "meniscus: {}\n", line);
}

void check_is_not_an_input(const Path& output, const std::vector<Path>& inputs) {
    for (const Path& input : inputs) {
        std::error_code ignored;
        if (std::filesystem::equivalent(input, output, ignored))
            throw InputError(fmt::format("output {} would overwrite the input of that name; choose "
                                         "another name with -o",
                                         output.string()));
    }
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

std::vector<Path> output_files(const InputsAndFolder& files) {
    std::map<Path, Path> input_of;
    std::vector<Path> outputs;
    for (const Path& input : files.inputs) {
        if (!std::filesystem::exists(input))
            throw InputError(fmt::format("{}: no such file", input.string()));
        check_is_no_checkpoint(input);
        outputs.push_back(files.folder / (telling_stem(input) + ".vtkhdf"));
        const auto [other, is_new] = input_of.emplace(outputs.back(), input);
        if (!is_new)
            throw InputError(fmt::format("{} and {} would both be written to {}; label them into "
                                         "different folders",
                                         other->second.string(), input.string(),
                                         outputs.back().string()));
    }
    for (const Path& output : outputs)
        check_is_not_an_input(output, files.inputs);
    return outputs;
}

void make_writable_folder(const Path& folder) {
    if (folder.empty())
        throw InputError("the name of the output folder is empty; give one with -o");
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw InputError(fmt::format("{}: cannot create the output folder: {}", folder.string(),
                                     error.message()));
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
    : title(std::move(title)), total(total), visible(!quiet && isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
    if (shown_percent >= 0)
        std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(std::size_t done) {
    const int percent = total == 0 ? 100 : static_cast<int>(100 * done / total);
    if (!visible || percent == shown_percent)
        return;
    shown_percent = percent;
    constexpr int width = 40;
    const int filled = percent * width / 100;
    fmt::print(stderr, "\r{} [{:=<{}}{: <{}}] {:3} %", title, "", filled, "", width - filled,
               percent);
    std::fflush(stderr);
}

StatusLine::StatusLine(bool quiet) : visible(!quiet && isatty(STDERR_FILENO) != 0) {}

StatusLine::~StatusLine() {
    if (shown.time_since_epoch().count() != 0)
        std::fputs("\r\033[K", stderr);
}

bool StatusLine::is_due() const {
    return visible && std::chrono::steady_clock::now() - shown > std::chrono::milliseconds(200);
}

void StatusLine::print(const std::string& text) {
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
    const std::size_t width = known ? size.ws_col - 1U : 79U;
    fmt::print(stderr, "\r\033[K{}", text.substr(0, width));
    std::fflush(stderr);
    shown = std::chrono::steady_clock::now();
}

} // namespace meniscus
