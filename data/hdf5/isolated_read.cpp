#include "isolated_read.hpp"

#include "deflate.hpp"
#include "hdf5_lock.hpp"
#include <meniscus/data/text/errors.hpp>

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

/// What a child has to say; the first number that it sends.
enum Outcome : std::uint64_t { read_well, bad_input, failed, out_of_memory };

/// The last number, after which nothing is missing.
constexpr std::uint64_t end_mark = 0x6d656e6973637573;

/// Thrown where the pipe brings less than it should, or what no child sends that is well.
struct BrokenPipe {};

/// The child's end. Arrays are given back to the system as soon as they are sent.
class Sender {
public:
    explicit Sender(int pipe) : descriptor(pipe) {}

    template <class Number>
    void number(const Number& value) {
        send(&value, sizeof value);
    }

    void text(const std::string& text) {
        number(std::uint64_t{text.size()});
        send(text.data(), text.size());
    }

    template <class Value>
    void values(std::vector<Value>& values) {
        number(std::uint64_t{values.size()});
        send(values.data(), values.size() * sizeof(Value));
        std::vector<Value>().swap(values);
    }

    template <class Entries, class Carry>
    void list(Entries& entries, Carry carry) {
        number(std::uint64_t{entries.size()});
        std::for_each(entries.begin(), entries.end(), carry);
    }

private:
    void send(const void* data, std::size_t size) const {
        const auto* bytes = static_cast<const char*>(data);
        while (size > 0) {
            const ssize_t sent = write(descriptor, bytes, size);
            if (sent >= 0) {
                bytes += sent;
                size -= static_cast<std::size_t>(sent);
            } else if (errno != EINTR) {
                _exit(1); // nobody is there to receive it
            }
        }
    }

    int descriptor;
};

/// The parent's end. What the child claims to send is believed as it arrives, and no more than
/// `most` bytes of it.
class Receiver {
public:
    Receiver(int pipe, std::uint64_t max) : descriptor(pipe), left(max) {}

    template <class Number>
    void number(Number& value) {
        receive(&value, sizeof value);
    }

    void text(std::string& text) { grow(text, 1); }

    template <class Value>
    void values(std::vector<Value>& values) {
        grow(values, sizeof(Value));
    }

    template <class Entries, class Carry>
    void list(Entries& entries, Carry carry) {
        std::uint64_t count = 0;
        number(count);
        for (std::uint64_t i = 0; i < count; ++i) {
            entries.emplace_back();
            carry(entries.back());
        }
    }

private:
    template <class Values>
    void grow(Values& values, std::size_t value_size) {
        std::uint64_t count = 0;
        number(count);
        while (values.size() < count) {
            const std::size_t before = values.size();
            const std::size_t max = std::max((std::size_t{1} << 20) / value_size, 4 * before);
            values.reserve(std::min<std::uint64_t>(count, max));
            values.resize(std::min<std::uint64_t>(count, max));
            receive(&values[before], (values.size() - before) * value_size);
        }
    }

    void receive(void* data, std::size_t size) {
        if (size > left)
            throw BrokenPipe();
        left -= size;
        auto* bytes = static_cast<char*>(data);
        while (size > 0) {
            const ssize_t received = ::read(descriptor, bytes, size);
            if (received > 0) {
                bytes += received;
                size -= static_cast<std::size_t>(received);
            } else if (received == 0 || errno != EINTR) {
                throw BrokenPipe();
            }
        }
    }

    int descriptor;
    std::uint64_t left;
};

template <class Pipe>
void carry_optional(Pipe& pipe, std::optional<double>& value) {
    std::uint64_t known = value ? 1 : 0;
    double number = value.value_or(0);
    pipe.number(known);
    pipe.number(number);
    if (known != 0)
        value = number;
}

/// The values under the number of their type.
template <std::size_t Kind = 0, class Pipe>
void carry_values(Pipe& pipe, ArrayValues& values, std::uint64_t kind) {
    if constexpr (Kind < std::variant_size_v<ArrayValues>) {
        if (kind != Kind)
            return carry_values<Kind + 1>(pipe, values, kind);
        if (values.index() != Kind)
            values.emplace<Kind>();
        pipe.values(std::get<Kind>(values));
    } else {
        throw BrokenPipe();
    }
}

/// One function for both ends, so that they cannot disagree.
template <class Pipe>
void carry(Pipe& pipe, Snapshot& snapshot) {
    std::uint64_t is_single = snapshot.position_precision == Precision::float32 ? 1 : 0;
    pipe.number(is_single);
    snapshot.position_precision = is_single != 0 ? Precision::float32 : Precision::float64;
    pipe.number(snapshot.dimension);
    pipe.number(snapshot.dimension_is_stated);
    carry_optional(pipe, snapshot.support_radius);
    carry_optional(pipe, snapshot.particle_spacing);
    carry_optional(pipe, snapshot.particle_volume);
    carry_optional(pipe, snapshot.time);
    pipe.text(snapshot.scene);
    std::vector<std::pair<std::string, std::string>> texts(snapshot.provenance.begin(),
                                                           snapshot.provenance.end());
    pipe.list(texts, [&](auto& entry) {
        pipe.text(entry.first);
        pipe.text(entry.second);
    });
    snapshot.provenance = {texts.begin(), texts.end()};
    pipe.list(snapshot.notes, [&](std::string& note) { pipe.text(note); });
    pipe.values(snapshot.positions);
    pipe.values(snapshot.boundary);
    pipe.list(snapshot.point_data, [&](PointArray& array) {
        pipe.text(array.name);
        pipe.number(array.components);
        std::uint64_t kind = array.values.index();
        pipe.number(kind);
        carry_values(pipe, array.values, kind);
    });
}

/// Damage in the child's memory may have gone unnoticed.
void check_is_consistent(const Snapshot& snapshot) {
    bool fine = snapshot.dimension == 2 || snapshot.dimension == 3;
    std::set<std::string_view> names;
    for (const PointArray& array : snapshot.point_data) {
        const std::size_t count =
            std::visit([](const auto& values) { return values.size(); }, array.values);
        fine = fine && array.components > 0 && names.insert(array.name).second &&
               count == snapshot.size() * static_cast<std::size_t>(array.components);
    }
    if (!fine)
        throw BrokenPipe();
}

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

/// The library prints what it likes, and the system what it makes of a crash; the parent says it in
/// one line.
void silence() {
    const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
}

void settle_in(pid_t parent, const ReadLimits& limits, std::uint64_t max_memory) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(1); // it was gone before that
    prctl(PR_SET_DUMPABLE, 0);
    reset_signals();
    silence();
    lower_limit(RLIMIT_CPU, limits.processor_seconds);
    if (limits_memory)
        lower_limit(RLIMIT_AS, max_memory);
}

void send_error(Sender& sender, Outcome outcome, const std::string& message) {
    sender.number(std::uint64_t{outcome});
    sender.text(message);
    sender.number(end_mark);
}

void read_and_send(int pipe, const fs::path& file, const SnapshotReader& read) {
    Sender sender(pipe);
    try {
        Snapshot snapshot = read(file);
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
        send_error(sender, failed, file.string() + ": " + error.what());
    }
}

/// All that a child does. It neither returns nor throws: what the parent would do then is not for
/// the child.
[[noreturn]] void be_child(int pipe, const fs::path& file, const SnapshotReader& read) {
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

/// Forks a child that reads, and returns the parent's end of the pipe and the child's number.
std::pair<int, pid_t> start(const fs::path& file, const SnapshotReader& read,
                            const ReadLimits& limits, std::uint64_t max_memory) {
    const std::lock_guard alone(hdf5_lock()); // nor may another child inherit this one's pipe
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        fail_to_start(file);
    fcntl(ends[1], F_SETPIPE_SZ, 1 << 20); // faster; goes without where it is refused
    // No signal may run the parent's handlers in the child.
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        settle_in(parent, limits, max_memory);
        be_child(ends[1], file, read);
    }
    const int error = errno;
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    close(ends[1]);
    if (child < 0) {
        close(ends[0]);
        errno = error;
        fail_to_start(file);
    }
    return {ends[0], child};
}

/// What a child has said.
struct Reply {
    std::uint64_t outcome = read_well;
    Snapshot snapshot;
    std::string message;
};

/// Nothing where the child did not say it to the end.
std::optional<Reply> receive_reply(int pipe, std::uint64_t max) {
    Receiver receiver(pipe, max);
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

[[noreturn]] void fail_as_damaged(const fs::path& file, const std::string& how) {
    throw InputError(file.string() + ": damaged: the HDF5 library failed while reading it (" + how +
                     "); export it again");
}

[[noreturn]] void fail_as_it_ended(const fs::path& file, int status, const ReadLimits& limits) {
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

} // namespace

ReadLimits limits_for(std::uint64_t file_bytes) {
    // Four times what its bytes can hold, and a hundredth of the speed that files are read at.
    return {(std::uint64_t{256} << 20) + 4 * max_compression * file_bytes,
            20 + file_bytes / 250'000};
}

Snapshot read_isolated(const fs::path& file, const SnapshotReader& read, const ReadLimits& limits) {
    const std::uint64_t max_memory = memory_in_use() + limits.memory_bytes;
    const auto [pipe, process] = start(file, read, limits, max_memory);
    Child child(process, pipe);
    std::optional<Reply> reply = receive_reply(child.descriptor(), limits.memory_bytes);
    const int status = child.wait();
    if (!reply)
        fail_as_it_ended(file, status, limits);
    switch (reply->outcome) {
    case read_well:
        return std::move(reply->snapshot);
    case bad_input:
        throw InputError(reply->message);
    case out_of_memory:
        if (limit_comes_first(max_memory)) {
            fail_as_damaged(file, "it took more than " + std::to_string(limits.memory_bytes >> 20) +
                                      " MiB of memory");
        }
        throw FailureError(file.string() + ": not enough memory to read it");
    default:
        throw FailureError(reply->message);
    }
}

Snapshot read_isolated(const fs::path& file, const SnapshotReader& read) {
    std::error_code unknown; // whoever reads says why
    const std::uintmax_t bytes = fs::file_size(file, unknown);
    return read_isolated(file, read, limits_for(unknown ? 0 : bytes));
}

} // namespace meniscus
