/* Calls of the system and the C library that fail, one after another, in a program that knows
 * nothing of it: loaded before all other libraries (LD_PRELOAD) by failed_calls.py. Of the kind of
 * calls that MENISCUS_FAILING_CALLS names, the one of number MENISCUS_FAILING_NUMBER fails, or with
 * MENISCUS_FAILING_ON all from that one on. They are counted from the start of main(), over threads
 * and forked children, in the file MENISCUS_FAILING_COUNT of 8 bytes. A program that then crashes
 * inside the HDF5 library ends with status 98. */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

enum kind { MEMORY, OPEN, READ, WRITE, SYNC, STATUS, THREAD, PROCESS, KINDS };
static const char* const names[KINDS] = {"memory", "open",   "read",   "write",
                                         "sync",   "status", "thread", "process"};

static _Atomic uint64_t* count; /* none before main() */
static enum kind failing = KINDS;
static uint64_t number;
static int goes_on;

static int fails(enum kind kind, int error) {
    if (kind != failing || count == NULL)
        return 0;
    const uint64_t at = atomic_fetch_add(count, 1);
    if (at != number && (at < number || !goes_on))
        return 0;
    errno = error;
    return 1;
}

enum { max_frames = 32 };

static void say_whose_crash(int signal_number) {
    void* frames[max_frames];
    const int frame_count = backtrace(frames, max_frames);
    for (int i = 0; i < frame_count; ++i) {
        Dl_info place;
        if (dladdr(frames[i], &place) != 0 && strstr(place.dli_fname, "libhdf5") != NULL)
            _exit(98);
    }
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}

static void begin(void) {
    const char* kind = getenv("MENISCUS_FAILING_CALLS");
    const char* file = getenv("MENISCUS_FAILING_COUNT");
    const char* first = getenv("MENISCUS_FAILING_NUMBER");
    if (kind == NULL || file == NULL || first == NULL)
        return;
    goes_on = getenv("MENISCUS_FAILING_ON") != NULL;
    number = strtoull(first, NULL, 10);
    for (int i = 0; i < KINDS; ++i)
        if (strcmp(kind, names[i]) == 0)
            failing = (enum kind)i;
    const int counter = openat(AT_FDCWD, file, O_RDWR);
    void* page = mmap(NULL, sizeof *count, PROT_READ | PROT_WRITE, MAP_SHARED, counter, 0);
    close(counter);
    if (failing == KINDS || page == MAP_FAILED) {
        fprintf(stderr, "failing_calls: no kind '%s', or no file '%s'\n", kind, file);
        _exit(99);
    }
    void* frame;
    backtrace(&frame, 1); /* loads what it needs while there is memory */
    struct sigaction crash = {0};
    crash.sa_handler = say_whose_crash;
    crash.sa_flags = SA_NODEFER | SA_ONSTACK; /* the stack itself may be used up */
    static char own_stack[1 << 16];
    const stack_t stack = {.ss_sp = own_stack, .ss_size = sizeof own_stack};
    sigaltstack(&stack, NULL);
    sigaction(SIGSEGV, &crash, NULL);
    count = page;
}

typedef int (*main_function)(int, char**, char**);
static main_function given_main;

static int main_that_fails(int arguments, char** words, char** environment) {
    begin();
    return given_main(arguments, words, environment);
}

/* What starts a program before its main(). */
int __libc_start_main(main_function program, int arguments, char** words, void (*init)(void),
                      void (*fini)(void), void (*rtld_fini)(void), void* stack_end) {
    typedef int (*start)(main_function, int, char**, void (*)(void), void (*)(void), void (*)(void),
                         void*);
    given_main = program;
    const start next = (start)dlsym(RTLD_NEXT, "__libc_start_main");
    return next(main_that_fails, arguments, words, init, fini, rtld_fini, stack_end);
}

/* The allocator by its own names, since to look for it needs memory. */
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t items, size_t size);
void* __libc_realloc(void* memory, size_t size);
void* __libc_memalign(size_t alignment, size_t size);

void* malloc(size_t size) {
    return fails(MEMORY, ENOMEM) ? NULL : __libc_malloc(size);
}
void* calloc(size_t items, size_t size) {
    return fails(MEMORY, ENOMEM) ? NULL : __libc_calloc(items, size);
}
void* realloc(void* memory, size_t size) {
    return fails(MEMORY, ENOMEM) ? NULL : __libc_realloc(memory, size);
}
void* memalign(size_t alignment, size_t size) {
    return fails(MEMORY, ENOMEM) ? NULL : __libc_memalign(alignment, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
    return memalign(alignment, size);
}
int posix_memalign(void** memory, size_t alignment, size_t size) {
    *memory = memalign(alignment, size);
    return *memory == NULL ? ENOMEM : 0;
}

/* A function of the C library that fails: its kind, result, name, parameters, their names, and what
 * it then returns and sets errno to. */
#define FAILING(KIND, RESULT, NAME, PARAMETERS, ARGUMENTS, FAILURE, ERROR)                         \
    RESULT NAME PARAMETERS {                                                                       \
        static RESULT(*next) PARAMETERS;                                                           \
        if (next == NULL)                                                                          \
            next = (RESULT(*) PARAMETERS)dlsym(RTLD_NEXT, #NAME);                                  \
        return fails(KIND, ERROR) ? FAILURE : next ARGUMENTS;                                      \
    }

/* Those that create files have a mode. */
#define FAILING_OPEN(NAME, FIRST, ARGUMENTS)                                                       \
    int NAME FIRST {                                                                               \
        static int(*next) FIRST;                                                                   \
        if (next == NULL)                                                                          \
            next = (int(*) FIRST)dlsym(RTLD_NEXT, #NAME);                                          \
        va_list more;                                                                              \
        va_start(more, flags);                                                                     \
        const int mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(more, int) : 0;                    \
        va_end(more);                                                                              \
        return fails(OPEN, EIO) ? -1 : next ARGUMENTS;                                             \
    }
FAILING_OPEN(open, (const char* path, int flags, ...), (path, flags, mode))
FAILING_OPEN(open64, (const char* path, int flags, ...), (path, flags, mode))
FAILING_OPEN(openat, (int folder, const char* path, int flags, ...), (folder, path, flags, mode))
FAILING_OPEN(openat64, (int folder, const char* path, int flags, ...), (folder, path, flags, mode))
FAILING(OPEN, FILE*, fopen, (const char* path, const char* mode), (path, mode), NULL, EIO)
FAILING(OPEN, FILE*, fopen64, (const char* path, const char* mode), (path, mode), NULL, EIO)
FAILING(OPEN, DIR*, opendir, (const char* path), (path), NULL, EIO)
FAILING(OPEN, DIR*, fdopendir, (int folder), (folder), NULL, EIO)

FAILING(READ, ssize_t, read, (int file, void* to, size_t size), (file, to, size), -1, EIO)
FAILING(READ, ssize_t, pread, (int file, void* to, size_t size, off_t at), (file, to, size, at), -1,
        EIO)
FAILING(READ, ssize_t, pread64, (int file, void* to, size_t size, off64_t at), (file, to, size, at),
        -1, EIO)
FAILING(READ, struct dirent*, readdir, (DIR * folder), (folder), NULL, EIO)
FAILING(READ, ssize_t, readlink, (const char* path, char* to, size_t size), (path, to, size), -1,
        EIO)

FAILING(WRITE, ssize_t, write, (int file, const void* from, size_t size), (file, from, size), -1,
        ENOSPC)
FAILING(WRITE, ssize_t, pwrite, (int file, const void* from, size_t size, off_t at),
        (file, from, size, at), -1, ENOSPC)
FAILING(WRITE, ssize_t, pwrite64, (int file, const void* from, size_t size, off64_t at),
        (file, from, size, at), -1, ENOSPC)
FAILING(WRITE, ssize_t, writev, (int file, const struct iovec* from, int parts),
        (file, from, parts), -1, ENOSPC)

FAILING(SYNC, int, fsync, (int file), (file), -1, EIO)
FAILING(SYNC, int, fdatasync, (int file), (file), -1, EIO)
FAILING(SYNC, int, ftruncate, (int file, off_t size), (file, size), -1, EIO)
FAILING(SYNC, int, ftruncate64, (int file, off64_t size), (file, size), -1, EIO)
FAILING(SYNC, int, rename, (const char* from, const char* to), (from, to), -1, EIO)
FAILING(SYNC, int, mkdir, (const char* path, mode_t mode), (path, mode), -1, EIO)
FAILING(SYNC, int, unlink, (const char* path), (path), -1, EIO)

FAILING(STATUS, int, stat, (const char* path, struct stat* to), (path, to), -1, EIO)
FAILING(STATUS, int, lstat, (const char* path, struct stat* to), (path, to), -1, EIO)
FAILING(STATUS, int, fstat, (int file, struct stat* to), (file, to), -1, EIO)
FAILING(STATUS, int, stat64, (const char* path, struct stat64* to), (path, to), -1, EIO)
FAILING(STATUS, int, lstat64, (const char* path, struct stat64* to), (path, to), -1, EIO)
FAILING(STATUS, int, fstat64, (int file, struct stat64* to), (file, to), -1, EIO)

FAILING(PROCESS, pid_t, fork, (void), (), -1, EAGAIN)
FAILING(PROCESS, int, pipe2, (int ends[2], int flags), (ends, flags), -1, EMFILE)

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*),
                   void* data) {
    typedef int (*create)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    static create next;
    if (next == NULL)
        next = (create)dlsym(RTLD_NEXT, "pthread_create");
    return fails(THREAD, EAGAIN) ? EAGAIN : next(thread, attributes, run, data);
}
