// What a reader may do wrong in its process, done on purpose.
#include "hdf5_folder.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/hdf5/isolated_read.hpp>
#include <meniscus/data/text/errors.hpp>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <future>
#include <limits>
#include <new>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#ifndef __has_feature // clang's
#define __has_feature(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
constexpr bool has_memory_limit = false;
#else
constexpr bool has_memory_limit = true;
#endif

namespace meniscus {
namespace {

namespace fs = std::filesystem;

using Read = Snapshot (*)(const OpenedFile&);

constexpr ReadLimits small = {std::uint64_t{64} << 20, 1};

/// A folder with a file, which the readers here leave alone unless they say so.
class IsolatedRead : public TestFolder {
protected:
    IsolatedRead() { file = folder / "some/state.hdf5"; }
    void SetUp() override {
        fs::create_directories(file.parent_path());
        write("some/state.hdf5", "bytes of the file");
    }

    std::string input_error(const SnapshotReader& read, const ReadLimits& limits = small) const {
        return error_of<InputError>([&] { read_isolated(file, read, limits); });
    }

    fs::path file;
};

/// Of every type that a snapshot holds; the positions come with what no equality finds equal.
Snapshot everything(const OpenedFile& /*file*/ = {}) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Snapshot snapshot;
    snapshot.dimension = 2;
    snapshot.positions = {{1, -0.0, nan}, {std::numeric_limits<double>::infinity(), 1e-310, 0}};
    snapshot.position_precision = Precision::float32;
    snapshot.boundary = {{1, 2, 3}, {4, 5, 6}, {7, 8, nan}};
    snapshot.support_radius = 0.1;
    snapshot.time = -0.0;
    snapshot.scene = "Wassertropfen über Öl";
    snapshot.provenance = {
        {"", "empty name"}, {"empty text", ""}, {"long", std::string(3'000'000, 'x')}};
    set_array(snapshot, {"int8", 1, std::vector<std::int8_t>{-128, 127}});
    set_array(snapshot, {"uint8", 1, std::vector<std::uint8_t>{0, 255}});
    set_array(snapshot, {"int16", 1, std::vector<std::int16_t>{-32768, 32767}});
    set_array(snapshot, {"uint16", 1, std::vector<std::uint16_t>{0, 65535}});
    set_array(snapshot, {"int32", 1, std::vector<std::int32_t>{INT32_MIN, INT32_MAX}});
    set_array(snapshot, {"uint32", 1, std::vector<std::uint32_t>{0, UINT32_MAX}});
    set_array(snapshot, {"int64", 1, std::vector<std::int64_t>{INT64_MIN, INT64_MAX}});
    set_array(snapshot, {"uint64", 1, std::vector<std::uint64_t>{0, UINT64_MAX}});
    set_array(snapshot, {"float", 3, std::vector<float>{1, -0.0F, std::nanf(""), 4, 5, 6}});
    set_array(snapshot, {"double", 1, std::vector<double>{nan, 1}});
    return snapshot;
}

/// More than a pipe holds, and than arrives at once.
Snapshot many(const OpenedFile& /*file*/ = {}) {
    Snapshot snapshot;
    for (int i = 0; i < 700'000; ++i)
        snapshot.positions.push_back({1.0 * i, 0.5 * i, -1.0 * i});
    snapshot.boundary = snapshot.positions;
    return snapshot;
}

template <class Value>
bool same_bytes(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

/// Open descriptors of this process.
std::size_t descriptors() {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator("/proc/self/fd"), {}));
}

TEST_F(IsolatedRead, BringsEverythingBackBitForBit) {
    const Snapshot wanted = everything();
    const Snapshot found = read_isolated(file, everything);
    EXPECT_EQ(found.dimension, wanted.dimension);
    EXPECT_TRUE(same_bytes(found.positions, wanted.positions));
    EXPECT_EQ(found.position_precision, wanted.position_precision);
    EXPECT_TRUE(same_bytes(found.boundary, wanted.boundary));
    EXPECT_EQ(found.support_radius, wanted.support_radius);
    EXPECT_EQ(found.particle_spacing, std::nullopt);
    EXPECT_TRUE(found.time && std::signbit(*found.time));
    EXPECT_EQ(found.scene, wanted.scene);
    EXPECT_EQ(found.provenance, wanted.provenance);
    ASSERT_EQ(found.point_data.size(), wanted.point_data.size());
    for (std::size_t i = 0; i < wanted.point_data.size(); ++i) {
        const PointArray& array = wanted.point_data[i];
        EXPECT_EQ(found.point_data[i].name, array.name);
        EXPECT_EQ(found.point_data[i].components, array.components);
        std::visit(
            [&](const auto& values) {
                using Values = std::decay_t<decltype(values)>;
                const auto* same = std::get_if<Values>(&found.point_data[i].values);
                EXPECT_TRUE(same != nullptr && same_bytes(*same, values)) << array.name;
            },
            array.values);
    }
}

TEST_F(IsolatedRead, BringsManyParticlesBack) {
    const Snapshot found = read_isolated(file, many, {std::uint64_t{1} << 30, 60});
    EXPECT_EQ(found.positions, many().positions);
    EXPECT_EQ(found.boundary, many().positions);
}

TEST_F(IsolatedRead, ErrorsArriveAsTheyAre) {
    EXPECT_EQ(input_error([](const OpenedFile&) -> Snapshot { throw InputError("bad: input"); }),
              "bad: input");
    EXPECT_EQ(error_of<FailureError>([&] {
                  read_isolated(file, [](const OpenedFile&) -> Snapshot {
                      throw FailureError("a machine's failure");
                  });
              }),
              "a machine's failure");
    expect_mentions(error_of<FailureError>([&] {
                        read_isolated(file, [](const OpenedFile&) -> Snapshot {
                            throw std::logic_error("our own mistake");
                        });
                    }),
                    {"some/state.hdf5", "our own mistake"});
}

TEST_F(IsolatedRead, TheReaderGetsTheFile) {
    EXPECT_EQ(input_error([](const OpenedFile& given) -> Snapshot {
                  std::string bytes(given.bytes, '\0');
                  if (pread(given.descriptor, bytes.data(), bytes.size(), 0) < 0)
                      bytes = "nothing";
                  throw InputError(given.path.string() + ": " + bytes);
              }),
              file.string() + ": bytes of the file");
}

TEST_F(IsolatedRead, TheReaderGetsNothingElse) {
    static const int other = open(file.c_str(), O_RDONLY);
    static const std::string path = file.string();
    setenv("MENISCUS_TEST_SECRET", "secret", 1);
    const std::string message = input_error([](const OpenedFile& given) -> Snapshot {
        std::string text;
        const auto say = [&](const char* what, bool is_possible) {
            text += std::string(what) + (is_possible ? ": yes; " : ": no; ");
        };
        char byte = 0;
        const char* no_words[] = {nullptr};
        say("open", open(path.c_str(), O_RDONLY) >= 0);
        say("open by number", open("/proc/self/fd/3", O_RDONLY) >= 0);
        say("inherit", pread(other, &byte, 1, 0) >= 0 && other != given.descriptor);
        say("write", pwrite(given.descriptor, &byte, 1, 0) >= 0);
        say("connect", socket(AF_UNIX, SOCK_STREAM, 0) >= 0);
        say("start a program", execve("/bin/true", const_cast<char**>(no_words), environ) == 0);
        say("fork", fork() >= 0);
        say("signal", kill(getppid(), 0) == 0);
        say("environment", getenv("MENISCUS_TEST_SECRET") != nullptr);
        say("read the file", pread(given.descriptor, &byte, 1, 0) == 1);
        throw InputError(text);
    });
    close(other);
    EXPECT_EQ(message, "open: no; open by number: no; inherit: no; write: no; connect: no; "
                       "start a program: no; fork: no; signal: no; environment: no; "
                       "read the file: yes; ");
}

TEST_F(IsolatedRead, WhatIsNoFileIsRefusedAndNotWaitedFor) {
    fs::remove(file);
    expect_mentions(input_error(everything), {"some/state.hdf5", "found none"});
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    expect_mentions(input_error(everything), {"some/state.hdf5", "regular file", "pipe"});
}

TEST_F(IsolatedRead, WaitingForeverIsAFailure) {
    const ReadLimits short_time = {std::uint64_t{64} << 20, 60, std::chrono::milliseconds(50)};
    expect_mentions(error_of<FailureError>([&] {
                        read_isolated(
                            file,
                            [](const OpenedFile&) -> Snapshot {
                                std::promise<void>().get_future().wait();
                                return {};
                            },
                            short_time);
                    }),
                    {"some/state.hdf5", "more than 0.05 s"});
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1); // no child is left
}

TEST_F(IsolatedRead, StandardStreamsMayBeClosed) {
    const int saved[] = {dup(0), dup(1), dup(2)};
    for (const int standard : {0, 1, 2})
        close(standard);
    std::size_t size = 0;
    std::string error;
    try {
        size = read_isolated(file, everything).size();
    } catch (const std::exception& caught) {
        error = caught.what();
    }
    for (const int standard : {0, 1, 2}) {
        dup2(saved[standard], standard);
        close(saved[standard]);
    }
    EXPECT_EQ(size, 2U) << error;
}

TEST_F(IsolatedRead, CrashesAreDamage) {
    expect_mentions(input_error([](const OpenedFile&) -> Snapshot {
                        std::raise(SIGSEGV);
                        return {};
                    }),
                    {"some/state.hdf5: damaged", "Segmentation fault", "export it again"});
    expect_mentions(input_error([](const OpenedFile&) -> Snapshot { std::abort(); }),
                    {"some/state.hdf5: damaged", "Aborted"});
    expect_mentions(input_error([](const OpenedFile&) -> Snapshot { _exit(7); }),
                    {"some/state.hdf5: damaged", "status 7"});
    expect_mentions(input_error([](const OpenedFile&) -> Snapshot { _exit(0); }),
                    {"some/state.hdf5: damaged", "status 0"});
    expect_mentions(input_error([](const OpenedFile&) -> Snapshot { throw 1; }),
                    {"some/state.hdf5: damaged", "Aborted"});
}

int depth(volatile int* above) {
    volatile int here[1000] = {*above};
    return here[0] == 1 ? 0 : 1 + depth(here);
}

TEST_F(IsolatedRead, AFullStackIsDamage) {
    expect_mentions(input_error([](const OpenedFile&) -> Snapshot {
                        volatile int zero = 0;
                        throw InputError(std::to_string(depth(&zero)));
                    }),
                    {"some/state.hdf5: damaged"});
}

TEST_F(IsolatedRead, EndlessWorkIsDamage) {
    expect_mentions(input_error([](const OpenedFile&) -> Snapshot {
                        for (volatile bool going = true; going;) {
                        }
                        return {};
                    }),
                    {"some/state.hdf5: damaged", "1 s of processor time"});
}

TEST_F(IsolatedRead, EndlessMemoryIsDamage) {
    if (!has_memory_limit)
        GTEST_SKIP() << "memory is not limited under AddressSanitizer";
    expect_mentions(input_error([](const OpenedFile&) -> Snapshot {
                        Snapshot snapshot;
                        for (;;)
                            snapshot.positions.push_back({1, 2, 3});
                    }),
                    {"some/state.hdf5: damaged", "64 MiB of memory"});
}

TEST_F(IsolatedRead, WantOfMemoryThatIsNotTheFilesIsAFailure) {
    if (!has_memory_limit)
        GTEST_SKIP() << "memory is not limited under AddressSanitizer";
    const ReadLimits beyond_any_machine = {std::uint64_t{1} << 50, 60};
    expect_mentions(error_of<FailureError>([&] {
                        read_isolated(
                            file, [](const OpenedFile&) -> Snapshot { throw std::bad_alloc(); },
                            beyond_any_machine);
                    }),
                    {"some/state.hdf5", "not enough memory"});
}

TEST_F(IsolatedRead, InterruptsAreTheParentsToAnswer) {
    const Snapshot found = read_isolated(file, [](const OpenedFile& given) {
        for (const int interrupt : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
            std::raise(interrupt); // as the terminal sends it to parent and child
        return everything(given);
    });
    EXPECT_EQ(found.size(), 2U);
}

TEST_F(IsolatedRead, BeingKilledIsAFailure) {
    expect_mentions(error_of<FailureError>([&] {
                        read_isolated(file, [](const OpenedFile&) -> Snapshot {
                            std::raise(SIGKILL);
                            return {};
                        });
                    }),
                    {"some/state.hdf5", "killed"});
}

TEST_F(IsolatedRead, MoreThanAFileHoldsIsDamage) {
    // Sent back, though never held at once.
    expect_mentions(input_error(
                        [](const OpenedFile&) {
                            Snapshot snapshot;
                            snapshot.provenance["a"] = std::string(50 << 20, 'x');
                            return snapshot;
                        },
                        {std::uint64_t{49} << 20, 60}),
                    {"some/state.hdf5: damaged"});
}

TEST_F(IsolatedRead, WhatIsInconsistentIsDamage) {
    for (const Read read : {+[](const OpenedFile&) {
                                Snapshot snapshot = everything();
                                snapshot.dimension = 4;
                                return snapshot;
                            },
                            +[](const OpenedFile&) {
                                Snapshot snapshot = everything();
                                snapshot.positions.emplace_back();
                                return snapshot;
                            },
                            +[](const OpenedFile&) {
                                Snapshot snapshot = everything();
                                snapshot.point_data[1].components = -1;
                                return snapshot;
                            },
                            +[](const OpenedFile&) {
                                Snapshot snapshot = everything();
                                snapshot.point_data[1].name = snapshot.point_data[0].name;
                                return snapshot;
                            }})
        expect_mentions(input_error(read), {"some/state.hdf5: damaged"});
}

TEST_F(IsolatedRead, PrintsNothing) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    input_error([](const OpenedFile&) -> Snapshot {
        std::puts("noise");
        std::fputs("noise", stderr);
        std::fflush(stdout);
        throw InputError("bad");
    });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST_F(IsolatedRead, LeavesNoProcessAndNoDescriptor) {
    const std::size_t before = descriptors();
    for (const Read read :
         {+everything, +[](const OpenedFile&) -> Snapshot { throw InputError("bad"); },
          +[](const OpenedFile&) -> Snapshot { std::abort(); }}) {
        try {
            read_isolated(file, read, small);
        } catch (const InputError&) { // two of them
        }
        EXPECT_EQ(descriptors(), before);
        EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1); // no child is left
    }
}

TEST_F(IsolatedRead, TheParentsWaysWithSignalsStay) {
    sigset_t before;
    sigset_t after;
    pthread_sigmask(SIG_SETMASK, nullptr, &before);
    std::signal(SIGUSR1, SIG_IGN);
    read_isolated(file, everything);
    EXPECT_EQ(std::signal(SIGUSR1, SIG_DFL), SIG_IGN);
    pthread_sigmask(SIG_SETMASK, nullptr, &after);
    for (int signal = 1; signal < SIGRTMIN; ++signal)
        EXPECT_EQ(sigismember(&before, signal), sigismember(&after, signal)) << signal;
}

TEST_F(IsolatedRead, ASystemThatKeepsNoStatusWillDo) {
    std::signal(SIGCHLD, SIG_IGN); // children then vanish at their end
    EXPECT_EQ(read_isolated(file, everything).size(), 2U);
    const std::string message = input_error([](const OpenedFile&) -> Snapshot { std::abort(); });
    std::signal(SIGCHLD, SIG_DFL);
    expect_mentions(message, {"some/state.hdf5: damaged"});
}

void ignore_signal(int /*signal*/) {}

TEST_F(IsolatedRead, SignalsDoNotDisturb) {
    struct sigaction action = {}; // without SA_RESTART
    action.sa_handler = ignore_signal;
    sigaction(SIGUSR1, &action, nullptr);
    bool done = false;
    const pthread_t reader = pthread_self();
    std::thread disturber([&] {
        for (int i = 0; i < 200; ++i) {
            pthread_kill(reader, SIGUSR1);
            usleep(500);
        }
        done = true;
    });
    const Snapshot found = read_isolated(file, many, {std::uint64_t{1} << 30, 60});
    disturber.join();
    std::signal(SIGUSR1, SIG_DFL);
    EXPECT_TRUE(done);
    EXPECT_EQ(found.size(), 700'000U);
}

TEST_F(IsolatedRead, TheChildEndsWithItsParent) {
    ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0); // what is left of the parent comes to us
    const pid_t parent = fork();
    if (parent == 0) {
        read_isolated(file, [](const OpenedFile&) -> Snapshot {
            std::promise<void>().get_future().wait();
            return {};
        });
        _exit(0);
    }
    usleep(100'000); // for the grandchild to start; without it the test passes as well
    kill(parent, SIGKILL);
    waitpid(parent, nullptr, 0);
    int status = 0;
    if (waitpid(-1, &status, 0) > 0) {
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << status;
    }
    prctl(PR_SET_CHILD_SUBREAPER, 0);
}

TEST_F(IsolatedRead, SeveralThreadsMayRead) {
    std::vector<std::size_t> sizes(8);
    std::vector<std::thread> readers;
    readers.reserve(sizes.size());
    for (std::size_t& size : sizes)
        readers.emplace_back([&] { size = read_isolated(file, everything).size(); });
    for (std::thread& reader : readers)
        reader.join();
    EXPECT_EQ(sizes, std::vector<std::size_t>(8, 2));
}

TEST_F(IsolatedRead, AnotherThreadMayUseHdf5) {
    hbool_t is_for_threads = 0;
    if (H5is_library_threadsafe(&is_for_threads) < 0 || is_for_threads == 0)
        GTEST_SKIP() << "HDF5 is not built for threads";
    Snapshot snapshot;
    snapshot.positions = {{1, 2, 3}, {4, 5, 6}};
    write_vtkhdf(snapshot, folder / "state.vtkhdf");
    std::atomic<bool> going{true};
    std::thread writer([&] {
        while (going)
            write_vtkhdf(snapshot, folder / "other.vtkhdf");
    });
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(read_vtkhdf(folder / "state.vtkhdf").size(), 2U);
    going = false;
    writer.join();
}

class Hdf5Files : public Hdf5Folder {
protected:
    Hdf5Files() : Hdf5Folder("state.hdf5") {}
};

TEST_F(Hdf5Files, MissingAndEmptyOnesAreNamed) {
    expect_mentions(error_of<InputError>([&] { read_vtkhdf(file); }), {"state.hdf5", "none"});
    write("state.hdf5", "");
    expect_mentions(error_of<InputError>([&] { read_vtkhdf(file); }), {"state.hdf5", "empty"});
    EXPECT_THROW(is_vtkhdf(file), InputError);
}

} // namespace
} // namespace meniscus
