#include "files.hpp"

#include "errors.hpp"
#include "sha256.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace meniscus {

namespace {

namespace fs = std::filesystem;

std::string errno_text() {
    return std::strerror(errno);
}

std::ifstream open_for_reading(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found)
        throw InputError(file.string() + ": expected a file, found none; check the path");
    if (fs::is_directory(status))
        throw InputError(file.string() + ": expected a file, found a folder; name the files in it");
    if (!fs::is_regular_file(status)) {
        const std::string found = error ? error.message() : "a device, pipe or socket";
        throw InputError(file.string() + ": expected a regular file, found: " + found);
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        throw InputError(file.string() + ": cannot be opened: " + errno_text());
    return stream;
}

// What the machine did wrong; everything else that keeps a file from being created is the path's.
bool is_failure_of_machine(int error) {
    for (const int failure : {ENOSPC, EDQUOT, EIO, ENFILE, EMFILE, ENOMEM, EFBIG})
        if (error == failure)
            return true;
    return false;
}

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

[[noreturn]] void fail_to_create(const fs::path& file) {
    const std::string message = file.string() + ": cannot write to folder " +
                                folder_of(file).string() + ": " + errno_text();
    if (is_failure_of_machine(errno))
        throw FailureError(message);
    throw InputError(message);
}

[[noreturn]] void fail_to_write(const fs::path& file) {
    throw FailureError(file.string() + ": writing failed, nothing was kept: " + errno_text());
}

/// True where the open file still has that name.
bool has_name(int descriptor, const fs::path& name) {
    struct stat opened = {};
    struct stat named = {};
    return fstat(descriptor, &opened) == 0 && stat(name.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

[[noreturn]] void fail_as_being_written(const fs::path& file) {
    throw FailureError(file.string() +
                       ": is being written by another process; wait for it to end, or choose "
                       "another output");
}

/// Opens the partial file of `target`, empty and locked until it is closed, or refuses. A lock ends
/// with its process, so what a killed one left behind is taken over.
int open_locked(const fs::path& partial, const fs::path& target) {
    for (int attempt = 0; attempt < 100; ++attempt) {
        const int descriptor = open(partial.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor < 0)
            fail_to_create(target);
        // File systems that know no locks go without.
        const bool taken = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        // Before the lock was ours, its last holder may have given the file its final name.
        if (!taken && has_name(descriptor, partial) && ftruncate(descriptor, 0) == 0)
            return descriptor;
        close(descriptor);
        if (taken)
            break;
    }
    fail_as_being_written(target);
}

/// The file that bytes go to before it takes its name. Removed unless it was renamed; closed last,
/// because closing lets go of the lock.
class PartialFile {
public:
    explicit PartialFile(const fs::path& file)
        : target(file), partial(fs::path(file) += ".partial"),
          descriptor(open_locked(partial, target)) {}

    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;

    ~PartialFile() {
        if (!renamed)
            unlink(partial.c_str());
        close(descriptor);
    }

    void append(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t written = write(descriptor, bytes.data(), bytes.size());
            if (written >= 0)
                bytes.remove_prefix(static_cast<std::size_t>(written));
            else if (errno != EINTR)
                fail_to_write(target);
        }
    }

    void rename_to_target() {
        // Without fsync a crash soon after could leave the name with nothing behind it.
        if (fsync(descriptor) != 0 || std::rename(partial.c_str(), target.c_str()) != 0)
            fail_to_write(target);
        renamed = true;
    }

private:
    fs::path target;
    fs::path partial;
    int descriptor;
    bool renamed = false;
};

} // namespace

std::string read_whole(const fs::path& file, std::size_t max) {
    std::ifstream stream = open_for_reading(file);
    const std::uintmax_t size = fs::file_size(file);
    if (size == 0)
        throw InputError(file.string() + ": expected a snapshot, found an empty file");
    std::string bytes(static_cast<std::size_t>(std::min<std::uintmax_t>(size, max)), '\0');
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
        throw InputError(file.string() + ": cannot be read: " + errno_text());
    return bytes;
}

std::string file_hash(const fs::path& file) {
    std::ifstream stream = open_for_reading(file);
    Sha256 sum;
    std::vector<char> block(1 << 20);
    while (stream) {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        sum.add(block.data(), static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad())
        throw InputError(file.string() + ": cannot be read: " + errno_text());
    return sum.text();
}

void check_can_be_written(const fs::path& file) {
    if (!file.has_filename())
        throw InputError("'" + file.string() + "': expected the name of a file to write");
    std::error_code ignored; // where the path cannot even be looked at, its folder says why
    const fs::file_status status = fs::status(file, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        throw InputError(file.string() +
                         ": expected a file to replace or no file at all, found a " +
                         (fs::is_directory(status) ? "folder" : "device, pipe or socket"));
    }
    if (access((folder_of(file) / ".").c_str(), W_OK | X_OK) != 0)
        fail_to_create(file);
}

void write_whole(const fs::path& file, std::string_view bytes) {
    check_can_be_written(file);
    PartialFile partial(file);
    partial.append(bytes);
    partial.rename_to_target();
}

} // namespace meniscus
