#include "isolated_read.hpp"

#include "confinement.hpp"
#include "deflate.hpp"
#include "descriptor_driver.hpp"
#include "hdf5_handles.hpp"
#include "hdf5_memory.hpp"
#include "hdf5_turn.hpp"
#include "snapshot_pipe.hpp"
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <hdf5.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace meniscus {

namespace {

namespace fs = std::filesystem;

#ifndef __has_feature // clang's
#define __has_feature(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
constexpr bool limits_memory = false;
#else
constexpr bool limits_memory = true;
#endif

void lower_limit(decltype(RLIMIT_CPU) resource, std::uint64_t max) {
    rlimit limit{};
    getrlimit(resource, &limit);
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_cur, max);
    setrlimit(resource, &limit);
}

/// Bytes of address space in use.
std::uint64_t memory_in_use() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// True where a child runs into the limit before the machine or its user has no more to give.
bool limit_comes_first(std::uint64_t max) {
    rlimit inherited{};
    getrlimit(RLIMIT_AS, &inherited);
    const std::uint64_t machine = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                                  static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    return limits_memory && max < machine && max < inherited.rlim_cur;
}

/// A child keeps none of its parent's ways with signals. Interrupts are its parent's to answer,
/// whose end is the child's too.
void reset_signals() {
    for (int signal = 1; signal < SIGRTMIN; ++signal)
        std::signal(signal, SIG_DFL);
    for (const int interrupt : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
        std::signal(interrupt, SIG_IGN);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// From here on the process can do nothing but read its file, calculate, and answer.
void settle_in(pid_t parent, int file, int pipe, const ReadLimits& limits,
               std::uint64_t max_memory) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(1); // it was gone before that
    prctl(PR_SET_DUMPABLE, 0);
    reset_signals();
    lower_limit(RLIMIT_CPU, limits.processor_seconds);
    if (limits_memory)
        lower_limit(RLIMIT_AS, max_memory);
    close_all_but(file, pipe);
    clearenv();
    allow_memory_and_open_descriptors_only();
}

void send_error(Sender& sender, Outcome outcome, const std::string& message) {
    sender.number(std::uint64_t{outcome});
    sender.text(message);
    sender.number(end_mark);
}

/// Throws where the machine has failed meanwhile: HDF5 then says, or has its caller believe, that
/// something is not in the file.
void check_machine(const OpenedFile& file) {
    if (const int error = error_of_reading(); error != 0)
        throw FailureError(file.path.string() + ": cannot be read: " + std::strerror(error));
    if (hdf5_lacked_memory())
        throw std::bad_alloc();
}

/// What `read` gives or throws, unless the machine is to blame.
Snapshot read_unless_machine_fails(const OpenedFile& file, const SnapshotReader& read) {
    try {
        Snapshot snapshot = read(file);
        check_machine(file);
        return snapshot;
    } catch (const InputError&) {
        check_machine(file);
        throw;
    }
}

void read_and_send(int pipe, const OpenedFile& file, const SnapshotReader& read) {
    Sender sender(pipe);
    H5open(); // returns where its lock is free
    sender.number(start_mark);
    const QuietErrors quiet;
    try {
        Snapshot snapshot = read_unless_machine_fails(file, read);
        sender.number(std::uint64_t{read_well});
        carry(sender, snapshot);
        sender.number(end_mark);
    } catch (const InputError& error) {
        send_error(sender, bad_input, error.what());
    } catch (const FailureError& error) {
        send_error(sender, failed, error.what());
    } catch (const std::bad_alloc&) {
        send_error(sender, out_of_memory, "");
    } catch (const std::exception& error) {
        send_error(sender, failed, file.path.string() + ": " + error.what());
    }
}

/// All that a child does. It neither returns nor throws: what the parent would do then is not for
/// the child.
[[noreturn]] void be_child(int pipe, const OpenedFile& file, const SnapshotReader& read) {
    try {
        read_and_send(pipe, file, read);
        _exit(0);
    } catch (...) {
        std::abort();
    }
}

/// A child that is at work. However this ends, the child ends and is waited for.
class Child {
public:
    Child(pid_t process, int pipe) : process(process), pipe(pipe) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        if (process > 0) {
            kill(process, SIGKILL);
            wait();
        }
    }

    /// Lets it end, and tells how it did, as waitpid does; 0 where the system does not keep that.
    int wait() {
        int status = 0;
        close(pipe); // ends one that has more to say
        while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
        }
        process = 0;
        return status;
    }

    [[nodiscard]] int descriptor() const { return pipe; }

private:
    pid_t process;
    int pipe;
};

[[noreturn]] void fail_to_start(const fs::path& file) {
    throw FailureError(file.string() +
                       ": cannot start a process to read it: " + std::strerror(errno));
}

/// Both ends of a pipe above the descriptors 0 to 2, which another program may count on or close.
std::pair<int, int> open_pipe(const fs::path& file) {
    int low[2];
    if (pipe2(low, O_CLOEXEC) != 0)
        fail_to_start(file);
    const int from = fcntl(low[0], F_DUPFD_CLOEXEC, 3);
    const int into = fcntl(low[1], F_DUPFD_CLOEXEC, 3);
    const int error = errno;
    close(low[0]);
    close(low[1]);
    if (from < 0 || into < 0) {
        close(from);
        close(into);
        errno = error;
        fail_to_start(file);
    }
    fcntl(into, F_SETPIPE_SZ, 1 << 20); // faster; goes without where it is refused
    return {from, into};
}

/// What a child is to do, and what became of starting it.
struct Start {
    const OpenedFile& file;
    const SnapshotReader& read;
    const ReadLimits& limits;
    std::uint64_t max_memory;
    int pipe;
    pid_t parent = getpid();
    pid_t child = -1;
    int error = ENOMEM; ///< where HDF5 fails before it comes to that
};

/// The child never comes back from here.
herr_t fork_once(hid_t /*list*/, const char* /*property*/, void* data) {
    auto& start = *static_cast<Start*>(data);
    start.child = fork();
    start.error = errno;
    if (start.child == 0) {
        settle_in(start.parent, start.file.descriptor, start.pipe, start.limits, start.max_memory);
        be_child(start.pipe, start.file, start.read);
    }
    return 1; // ends the iteration
}

/// Forks while no other thread is inside the HDF5 library, for which the child would wait for ever:
/// HDF5 calls functions of ours, such as one for each property of a list, with its lock held, and
/// the child's thread is then the one that holds it. A thread that comes to wait for the lock at
/// that very moment can still leave it in a state that no child gets over: see answers().
void fork_outside_hdf5(Start& start) {
    const std::lock_guard<FairLock> turn(hdf5_turn());
    int first = 0;
    H5Piterate(H5P_FILE_ACCESS_DEFAULT, &first, fork_once, &start);
}

/// Starts a child that reads, and returns the parent's end of the pipe and the child's number.
std::pair<int, pid_t> start(const OpenedFile& file, const SnapshotReader& read,
                            const ReadLimits& limits, std::uint64_t max_memory) {
    const auto [from, into] = open_pipe(file.path);
    // No signal may run the parent's handlers in the child.
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    Start start{file, read, limits, max_memory, into};
    fork_outside_hdf5(start);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    close(into);
    if (start.child < 0) {
        close(from);
        errno = start.error;
        fail_to_start(file.path);
    }
    return {from, start.child};
}

/// What a child has said.
struct Reply {
    std::uint64_t outcome = read_well;
    Snapshot snapshot;
    std::string message;
};

/// Nothing where the child did not say it to the end. Throws TimeIsOver.
std::optional<Reply> receive_reply(int pipe, const fs::path& file, const ReadLimits& limits) {
    Receiver receiver(pipe, limits.memory_bytes, limits.wall_time, file);
    Reply reply;
    std::uint64_t mark = 0;
    try {
        receiver.number(reply.outcome);
        if (reply.outcome == read_well) {
            carry(receiver, reply.snapshot);
            check_is_consistent(reply.snapshot);
        } else {
            receiver.text(reply.message);
        }
        receiver.number(mark);
    } catch (const BrokenPipe&) {
        return std::nullopt;
    }
    return mark == end_mark ? std::optional(std::move(reply)) : std::nullopt;
}

/// Whether the child is at work within that time, or came to an end; false where it waits for
/// HDF5's lock.
bool answers(const Child& child, const fs::path& file, std::chrono::milliseconds patience) {
    std::uint64_t mark = 0;
    try {
        Receiver(child.descriptor(), sizeof mark, patience, file).number(mark);
    } catch (const TimeIsOver&) {
        return false;
    } catch (const BrokenPipe&) { // as whoever waits for it will notice
    }
    return true;
}

[[noreturn]] void fail_as_damaged(const fs::path& file, const std::string& how) {
    throw InputError(file.string() + ": damaged: the HDF5 library failed while reading it (" + how +
                     "); export it again");
}

/// HDF5 ends the process where it has no memory for its own identifiers.
constexpr int status_of_hdf5 = 255;

[[noreturn]] void fail_as_it_ended(const fs::path& file, int status, const ReadLimits& limits) {
    if (!WIFSIGNALED(status) &&
        (WEXITSTATUS(status) == cannot_answer || WEXITSTATUS(status) == status_of_hdf5))
        throw FailureError(file.string() + ": the process that read it ended with status " +
                           std::to_string(WEXITSTATUS(status)) + "; the machine may lack memory");
    if (!WIFSIGNALED(status))
        fail_as_damaged(file, "it ended with status " + std::to_string(WEXITSTATUS(status)));
    const int signal = WTERMSIG(status);
    if (signal == SIGKILL) { // by the system or by somebody, whom no file can call
        throw FailureError(file.string() + ": the process that read it was killed; the machine "
                                           "may lack memory");
    }
    fail_as_damaged(file, signal == SIGXCPU
                              ? "it took more than " + std::to_string(limits.processor_seconds) +
                                    " s of processor time"
                              : strsignal(signal));
}

std::optional<Reply> reply_in_time(const Child& child, const fs::path& file,
                                   const ReadLimits& limits) {
    try {
        return receive_reply(child.descriptor(), file, limits);
    } catch (const TimeIsOver&) {
        const std::string seconds =
            rounded_text(std::chrono::duration<double>(limits.wall_time).count(), 3);
        throw FailureError(file.string() + ": reading it took more than " + seconds +
                           " s; copy it to a disk that answers, or try again");
    }
}

/// What a child has said and how it ended; nothing where it did not start to work in that time.
struct Ending {
    std::optional<Reply> reply;
    int status;
};

std::optional<Ending> try_to_read(const OpenedFile& file, const SnapshotReader& read,
                                  const ReadLimits& limits, std::uint64_t max_memory,
                                  std::chrono::milliseconds patience) {
    const auto [pipe, process] = start(file, read, limits, max_memory);
    Child child(process, pipe);
    if (!answers(child, file.path, patience))
        return std::nullopt;
    std::optional<Reply> reply = reply_in_time(child, file.path, limits);
    const int status = child.wait();
    return Ending{std::move(reply), status};
}

Snapshot read_opened(const OpenedFile& file, const SnapshotReader& read, const ReadLimits& limits) {
    start_hdf5();
    const std::uint64_t max_memory = memory_in_use() + limits.memory_bytes;
    std::optional<Ending> ending;
    // Each time for longer, as the machine may only be busy.
    for (std::chrono::seconds patience(2); !ending; patience *= 2) {
        if (patience > std::chrono::minutes(2))
            throw FailureError(file.path.string() + ": the process to read it does not start");
        ending = try_to_read(file, read, limits, max_memory, patience);
    }
    auto& [reply, status] = *ending;
    if (!reply)
        fail_as_it_ended(file.path, status, limits);
    switch (reply->outcome) {
    case read_well:
        return std::move(reply->snapshot);
    case bad_input:
        throw InputError(reply->message);
    case out_of_memory:
        if (limit_comes_first(max_memory)) {
            fail_as_damaged(file.path, "it took more than " +
                                           std::to_string(limits.memory_bytes >> 20) +
                                           " MiB of memory");
        }
        throw FailureError(file.path.string() + ": not enough memory to read it");
    default:
        throw FailureError(reply->message);
    }
}

} // namespace

ReadLimits limits_for(std::uint64_t file_bytes) {
    // Four times what its bytes can hold, a hundredth of the speed that files are read at, and a
    // machine or a network that is busy with ten times as much.
    const std::uint64_t seconds = 20 + file_bytes / 250'000;
    return {(std::uint64_t{256} << 20) + 4 * max_compression * file_bytes, seconds,
            std::chrono::seconds(10 * seconds)};
}

Snapshot read_isolated(const fs::path& file, const SnapshotReader& read, const ReadLimits& limits) {
    const Descriptor opened = open_regular_file(file);
    return read_opened({file, opened, size_of(opened, file)}, read, limits);
}

Snapshot read_isolated(const fs::path& file, const SnapshotReader& read) {
    const Descriptor opened = open_regular_file(file);
    const std::uint64_t bytes = size_of(opened, file);
    return read_opened({file, opened, bytes}, read, limits_for(bytes));
}

} // namespace meniscus
