#include "threads.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/threads/threads.hpp>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <omp.h>
#include <sys/wait.h>
#include <unistd.h>

namespace meniscus {
namespace {

void start_all(int threads) {
    std::atomic<int> started{0}; // what does nothing would be left out
#pragma omp parallel num_threads(threads)
    started.fetch_add(1, std::memory_order_relaxed);
}

/// Tries it in a child, which libgomp may end as it likes; nothing of what it prints is seen.
bool can_start(int threads) {
    std::fflush(nullptr); // or the child would print it again
    const pid_t child = fork();
    if (child == 0) {
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDERR_FILENO);
        start_all(threads);
        _exit(0);
    }
    int status = 0;
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace

void wait_asleep(char** arguments) {
    if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr)
        return;
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error || setenv("OMP_WAIT_POLICY", "passive", 1) != 0)
        return;
    execv(program.c_str(), arguments); // where that fails, threads wait as they would
}

std::string limit_threads() {
    const int asked = omp_get_max_threads(); // 0 for 2^32
    if (asked >= 1 && asked <= thread_limit)
        return {};
    omp_set_num_threads(thread_limit);
    const char* said = std::getenv("OMP_NUM_THREADS");
    return fmt::format("warning: OMP_NUM_THREADS must be from 1 to {0}, found {1}; takes {0}",
                       thread_limit, said != nullptr ? said : std::to_string(asked));
}

void check_threads_start(int threads) {
    const int count = thread_count(threads);
    if (count > 1 && !can_start(count))
        throw FailureError(fmt::format("{} threads cannot be started here; take fewer with "
                                       "--threads or OMP_NUM_THREADS, or allow more memory and "
                                       "processes (ulimit -v, -u)",
                                       count));
}

} // namespace meniscus
