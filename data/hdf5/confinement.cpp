#include "confinement.hpp"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <vector>

namespace meniscus {
namespace {

/// Closes the descriptors from first to last, if there are any between.
void close_between(unsigned first, unsigned last) {
    if (first <= last)
        syscall(SYS_close_range, first, last, 0U); // stays undone on kernels before 5.9
}

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0;
#endif

/// A system call that is allowed where the low half of an argument, of which only the bits of the
/// mask count, has a value.
struct AllowedCall {
    std::uint32_t number;
    std::uint32_t argument = 0;
    std::uint32_t mask = 0;
    std::uint32_t value = 0;
};

std::vector<AllowedCall> allowed_calls() {
    constexpr std::uint32_t executable = PROT_EXEC;
    const auto self = static_cast<std::uint32_t>(getpid());
    return {{SYS_pread64},
            {SYS_write},
            {SYS_close},
            {SYS_fstat},
            {SYS_brk},
            {SYS_mmap, 2, executable, 0},
            {SYS_mprotect, 2, executable, 0},
            {SYS_munmap},
            {SYS_mremap},
            {SYS_madvise},
            {SYS_futex},
            {SYS_sched_yield},
            {SYS_clock_gettime},
            {SYS_gettimeofday},
            {SYS_getrandom},
            {SYS_getpid},
            {SYS_gettid},
            {SYS_tgkill, 0, ~std::uint32_t{0}, self}, // how abort() ends a process
            {SYS_rt_sigprocmask},
            {SYS_rt_sigaction},
            {SYS_rt_sigreturn},
            {SYS_restart_syscall},
            {SYS_exit},
            {SYS_exit_group}};
}

sock_filter load(std::size_t offset) {
    return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
}

sock_filter answer(std::uint32_t value) {
    return BPF_STMT(BPF_RET | BPF_K, value);
}

/// Goes on where the accumulator has the value, else skips so many instructions.
sock_filter unless_skip(std::uint32_t value, std::uint8_t skipped) {
    return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, skipped);
}

/// A refused call fails as one without permission does, and whoever made it goes on with that.
std::vector<sock_filter> filter_of(const std::vector<AllowedCall>& calls) {
    const sock_filter refuse = answer(SECCOMP_RET_ERRNO | EPERM);
    std::vector<sock_filter> program = {load(offsetof(seccomp_data, arch)),
                                        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0),
                                        refuse};
    for (const AllowedCall& call : calls) {
        const std::size_t argument = offsetof(seccomp_data, args) + 8 * call.argument;
        program.insert(program.end(),
                       {load(offsetof(seccomp_data, nr)), unless_skip(call.number, 4),
                        load(argument), BPF_STMT(BPF_ALU | BPF_AND | BPF_K, call.mask),
                        unless_skip(call.value, 1), answer(SECCOMP_RET_ALLOW)});
    }
    program.push_back(refuse);
    return program;
}

} // namespace

void close_all_but(int one, int other) {
    const auto low = static_cast<unsigned>(std::min(one, other));
    const auto high = static_cast<unsigned>(std::max(one, other));
    close_between(3, low - 1);
    close_between(low + 1, high - 1);
    close_between(high + 1, UINT_MAX);
    const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (nowhere < 0 || dup2(nowhere, standard) < 0)
            close(standard);
    if (nowhere > STDERR_FILENO)
        close(nowhere);
}

void allow_memory_and_open_descriptors_only() {
    if (architecture == 0)
        return;
    std::vector<sock_filter> program = filter_of(allowed_calls());
    const sock_fprog filter = {static_cast<unsigned short>(program.size()), program.data()};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0)
        prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
}

} // namespace meniscus
