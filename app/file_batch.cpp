#include "file_batch.hpp"

#include "frame_series.hpp"

#include <meniscus/app/ranks/ranks_of_program.hpp>
#include <meniscus/data/ranks/packing.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/threads/threads.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <fmt/format.h>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <system_error>

namespace meniscus {
namespace {

constexpr std::size_t max_lines = 20;           // more files get a summary
constexpr std::size_t max_warnings = 5;         // in front of a summary
constexpr std::uintmax_t small_file = 32 << 20; // bytes; each thread holds one
constexpr std::size_t files_a_thread = 2;       // fewer leave threads without work

/// Gathers what is said of files, from any thread, and prints it in their order.
class Reports {
public:
    Reports(const std::vector<Path>& its_files, const FileBatch& its_batch)
        : files(its_files), batch(its_batch), waiting(its_files.size()), line(its_batch.quiet) {}

    void add(std::size_t file, FileReport report, const std::exception_ptr& failure) {
        const std::lock_guard alone(lock);
        if (batch.collect && !failure)
            batch.collect(file, report.found);
        waiting[file] = Entry{std::move(report), failure};
        ++done;
        while (next < waiting.size() && waiting[next]) {
            print(*waiting[next]);
            waiting[next].reset(); // its memory
            ++next;
        }
        show_progress();
    }

    /// The end, once all files are there or one has failed.
    void finish() {
        line.clear();
        if (ending)
            std::rethrow_exception(ending);
        print_summary();
        if (failed > 0)
            throw InputError(fmt::format("{} of {} files could not be {}, the first one {}{}",
                                         failed, files.size(), batch.done, first_failed,
                                         failed < files.size() ? "; the others were" : ""));
    }

    [[nodiscard]] bool should_stop() const { return stop; }

private:
    struct Entry {
        FileReport report;
        std::exception_ptr failure;
    };
    using Clock = std::chrono::steady_clock;

    const std::vector<Path>& files;
    const FileBatch& batch;
    std::mutex lock;
    std::vector<std::optional<Entry>> waiting;
    StatusLine line;
    Clock::time_point start = Clock::now();
    std::atomic<bool> stop{false};
    std::size_t next = 0; ///< to be printed
    std::size_t done = 0;
    std::size_t failed = 0;
    std::size_t up_to_date = 0;
    std::size_t with_warnings = 0;
    bool shown_one = false;
    std::string first_failed;
    std::exception_ptr ending; ///< what the work ends with early
    std::array<std::size_t, 3> counts{};

    [[nodiscard]] bool gets_summary() const { return files.size() > max_lines; }

    void print(const Entry& entry) {
        if (entry.failure) {
            note_failure(entry.failure);
            return;
        }
        const FileReport& report = entry.report;
        up_to_date += report.is_up_to_date ? 1 : 0;
        for (std::size_t c = 0; c < counts.size(); ++c)
            counts[c] += report.counts[c];
        with_warnings += report.warnings.empty() ? 0 : 1;
        if (!gets_summary() || with_warnings <= max_warnings)
            for (const std::string& warning : report.warnings) {
                line.clear();
                print_error_line("warning: " + warning);
            }
        if (!batch.quiet && (!gets_summary() || (!report.is_up_to_date && !shown_one))) {
            line.clear();
            print_text(report.text);
            std::fflush(stdout);
            shown_one = shown_one || !report.is_up_to_date;
        }
    }

    void note_failure(const std::exception_ptr& failure) {
        try {
            std::rethrow_exception(failure);
        } catch (const InputError& error) {
            first_failed = failed == 0 ? files[next].string() : first_failed;
            ++failed;
            if (!batch.keep_going)
                end_with(failure);
            line.clear();
            if (batch.keep_going)
                print_error_line(error.what());
        } catch (...) { // the machine's
            end_with(failure);
        }
    }

    void end_with(const std::exception_ptr& failure) {
        ending = ending ? ending : failure;
        stop = true;
    }

    void show_progress() {
        if (files.size() < 2 || done == files.size())
            return;
        line.show([&] {
            const double passed = std::chrono::duration<double>(Clock::now() - start).count();
            const double left =
                passed * static_cast<double>(files.size() - done) / static_cast<double>(done);
            return fmt::format("{}: file {} of {}, {} left", batch.doing, done, files.size(),
                               span_text(left));
        });
    }

    void print_summary() const {
        if (with_warnings > max_warnings && gets_summary())
            print_error_line(fmt::format("warning: {} files in all have such warnings; each shows "
                                         "its own when it is given alone",
                                         with_warnings));
        if (batch.quiet || !gets_summary() || batch.counted[0] == nullptr)
            return;
        const std::size_t worked_on = files.size() - up_to_date - failed;
        std::string text = fmt::format("{} files: {} {}", files.size(), worked_on, batch.done);
        if (up_to_date > 0)
            text += fmt::format(", {} up to date", up_to_date);
        if (failed > 0)
            text += fmt::format(", {} at fault", failed);
        for (std::size_t c = 0; c < counts.size() && worked_on > 0; ++c)
            text += fmt::format("{} {} {}", c == 0 ? ";" : ",", counts[c], batch.counted[c]);
        print_text(text + "\n");
    }
};

} // namespace

bool are_many_and_small(const std::vector<Path>& files, int threads) {
    if (files.size() < files_a_thread * static_cast<std::size_t>(threads))
        return false;
    return std::all_of(files.begin(), files.end(), [](const Path& file) {
        std::error_code unknown;
        const auto bytes = std::filesystem::file_size(file, unknown);
        return unknown || bytes <= small_file;
    });
}

void add_keep_going_option(CLI::App& verb, bool& keep_going) {
    verb.add_flag("--keep-going", keep_going,
                  "Go on with the other files where one is at fault; the exit status is 2 in the "
                  "end");
}

namespace {

/// A report or what was thrown instead, on its way to the first rank.
struct Outcome {
    FileReport report;
    std::exception_ptr failure;
};

/// What kind of error was thrown, and what it says.
enum class Fault : std::uint8_t { none, input, machine };

template <class Pack>
void carry(Pack& pack, FileReport& report) {
    carry(pack, report.warnings);
    carry(pack, report.text);
    pack.number(report.is_up_to_date);
    pack.number(report.counts);
    carry(pack, report.found);
}

std::string packed_outcome(const Outcome& outcome) {
    Packer pack;
    Fault fault = Fault::none;
    std::string message;
    try {
        if (outcome.failure)
            std::rethrow_exception(outcome.failure);
    } catch (const InputError& error) {
        fault = Fault::input;
        message = error.what();
    } catch (const std::bad_alloc&) {
        fault = Fault::machine;
        message = "out of memory";
    } catch (const std::exception& error) {
        fault = Fault::machine;
        message = error.what();
    }
    FileReport report = outcome.report;
    pack.number(fault);
    carry(pack, message);
    carry(pack, report);
    return pack.bytes;
}

Outcome unpacked_outcome(const std::string& bytes) {
    Unpacker pack(bytes);
    Outcome outcome;
    Fault fault = Fault::none;
    std::string message;
    pack.number(fault);
    carry(pack, message);
    carry(pack, outcome.report);
    if (fault == Fault::input)
        outcome.failure = std::make_exception_ptr(InputError(message));
    else if (fault == Fault::machine)
        outcome.failure = std::make_exception_ptr(FailureError(message));
    return outcome;
}

template <class Work>
Outcome outcome_of(const Work& work) {
    try {
        return {work(), nullptr};
    } catch (...) { // must leave neither a parallel region nor a rank
        return {{}, std::current_exception()};
    }
}

/// Places of files, the largest first.
std::vector<std::size_t> by_size(const std::vector<Path>& files) {
    std::vector<std::uintmax_t> bytes;
    for (const Path& file : files) {
        std::error_code unknown;
        const auto size = std::filesystem::file_size(file, unknown);
        bytes.push_back(unknown ? 0 : size);
    }
    std::vector<std::size_t> places(files.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::stable_sort(places.begin(), places.end(),
                     [&](std::size_t a, std::size_t b) { return bytes[a] > bytes[b]; });
    return places;
}

/// For each file whether all ranks work on it, as the first rank has it.
std::vector<std::uint8_t> shared_files(std::size_t count, const FileBatch& batch, Ranks& ranks) {
    std::vector<std::uint8_t> shared(count);
    if (ranks.rank() == 0 && batch.is_shared)
        for (std::size_t f = 0; f < count; ++f) {
            try {
                shared[f] = batch.is_shared(f) ? 1 : 0;
            } catch (const std::exception&) { // whoever works on it says so
            }
        }
    return unpacked<std::vector<std::uint8_t>>(gather(ranks, packed(shared)).front());
}

void for_each_file_on_ranks(const std::vector<Path>& files, const FileBatch& batch,
                            const std::function<FileReport(std::size_t, int)>& work, Ranks& ranks) {
    FileBatch own = batch;
    own.quiet = batch.quiet || ranks.rank() > 0;
    Reports reports(files, own);
    const auto shared = shared_files(files.size(), batch, ranks);
    std::vector<std::size_t> alone;
    std::vector<std::uint64_t> stop = {0};
    for (const std::size_t f : by_size(files)) {
        if (shared[f] == 0) {
            alone.push_back(f);
        } else if (stop[0] == 0) {
            const Outcome outcome = outcome_of([&] { return batch.work_together(f); });
            if (ranks.rank() == 0)
                reports.add(f, outcome.report, outcome.failure);
            stop[0] = outcome.failure && !batch.keep_going ? 1 : 0;
        }
        ranks.sum(stop);
    }
    if (stop[0] == 0)
        hand_out(
            ranks, alone,
            [&](std::size_t f) {
                return packed_outcome(outcome_of([&] { return work(f, batch.threads); }));
            },
            [&](std::size_t f, const std::string& result) {
                const Outcome outcome = unpacked_outcome(result);
                reports.add(f, outcome.report, outcome.failure);
                return !reports.should_stop();
            });
    if (ranks.rank() == 0)
        reports.finish();
}

} // namespace

void for_each_file(const std::vector<Path>& files, const FileBatch& batch,
                   const std::function<FileReport(std::size_t, int)>& work) {
    if (Ranks& ranks = ranks_of_program(); ranks.size() > 1)
        return for_each_file_on_ranks(files, batch, work, ranks);
    const int threads = thread_count(batch.threads);
    const bool in_parallel = threads > 1 && are_many_and_small(files, threads);
    Reports reports(files, batch);
    const auto count = static_cast<std::int64_t>(files.size());
#pragma omp parallel for num_threads(in_parallel ? threads : 1) schedule(dynamic, 1)
    for (std::int64_t f = 0; f < count; ++f) {
        if (reports.should_stop() || interrupt_is_waiting())
            continue;
        const auto file = static_cast<std::size_t>(f);
        Outcome outcome = outcome_of([&] { return work(file, in_parallel ? 1 : batch.threads); });
        reports.add(file, std::move(outcome.report), outcome.failure);
    }
    reports.finish();
}

void write_for_each_file(const std::vector<Path>& files, const std::vector<Path>& outputs,
                         const FileBatch& batch,
                         const std::function<FileReport(std::size_t, int)>& work) {
    try {
        for_each_file(files, batch, work);
        if (is_other_rank())
            return;
    } catch (const InputError&) {
        if (batch.keep_going)
            write_frame_series(outputs);
        throw;
    }
    write_frame_series(outputs);
}

} // namespace meniscus
