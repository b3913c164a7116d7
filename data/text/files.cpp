#include "files.hpp"

#include "errors.hpp"
#include "sha256.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace meniscus {

namespace {

namespace fs = std::filesystem;

std::string errno_text() {
    return std::strerror(errno);
}

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

[[noreturn]] void fail_to_create(const fs::path& file) {
    const int error = errno;
    fail_for(error, file.string() + ": cannot write to folder " + folder_of(file).string() + ": " +
                        std::strerror(error));
}

/// The same file under another number where a closed standard stream has left it its own.
Descriptor above_standard_streams(Descriptor opened) {
    if (opened < 0 || opened > STDERR_FILENO)
        return opened;
    return Descriptor(fcntl(opened, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
}

[[noreturn]] void fail_as_irregular(const fs::path& file) {
    throw InputError(file.string() + ": expected a regular file, found a device, pipe or socket");
}

[[noreturn]] void fail_to_open(const fs::path& file) {
    if (errno == ENOENT || errno == ENOTDIR)
        throw InputError(file.string() + ": expected a file, found none; check the path");
    if (errno == ENXIO)
        fail_as_irregular(file);
    const int error = errno;
    fail_for(error, file.string() + ": cannot be opened: " + std::strerror(error));
}

/// Fills the memory with what comes next, less only at the end of the file.
std::size_t read_some(int descriptor, char* bytes, std::size_t size, const fs::path& file) {
    std::size_t done = 0;
    while (done < size) {
        const ssize_t count = read(descriptor, bytes + done, size - done);
        if (count == 0)
            break;
        if (count < 0 && errno != EINTR)
            throw FailureError(file.string() + ": cannot be read: " + errno_text());
        done += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    }
    return done;
}

[[noreturn]] void fail_by_errno(const fs::path& file) {
    meniscus::fail_to_write(file, errno);
}

/// True where the open file still has that name.
bool has_name(int descriptor, const fs::path& name) {
    struct stat opened = {};
    struct stat named = {};
    return fstat(descriptor, &opened) == 0 && lstat(name.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

[[noreturn]] void fail_as_being_written(const fs::path& file) {
    throw FailureError(file.string() +
                       ": is being written by another process; wait for it to end, or choose "
                       "another output");
}

/// The file that a name stands for: where it is a symbolic link, what the link leads to, be that
/// there or not. Throws InputError where links lead to one another.
fs::path without_links(fs::path file) {
    constexpr int max_links = 40; // as the system has it
    std::error_code ignored;      // whoever opens the file says why
    const fs::path given = file;
    for (int i = 0; fs::is_symlink(fs::symlink_status(file, ignored)); ++i) {
        if (i == max_links)
            throw InputError(given.string() + ": expected a file, found links in a circle");
        file = folder_of(file) / fs::read_symlink(file, ignored);
    }
    return file;
}

/// Names of partial files begin with that of their target, as far as there is room for it, and have
/// a number that nobody can guess, so that nobody can put a file or a link in its place.
constexpr std::string_view partial_end = ".partial";
constexpr std::size_t partial_digits = 16;

std::string partial_start(const fs::path& target) {
    return target.filename().string().substr(0, 200) + ".";
}

fs::path random_partial_name(const fs::path& target) {
    std::uint64_t number = 0;
    if (getrandom(&number, sizeof number, 0) != sizeof number)
        throw FailureError(target.string() + ": the system gives no random numbers");
    char digits[partial_digits + 1];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(number));
    return folder_of(target) / (partial_start(target) + digits + std::string(partial_end));
}

bool is_partial_name(std::string_view name, std::string_view start) {
    const std::size_t end = start.size() + partial_digits;
    return name.substr(0, start.size()) == start &&
           name.find_first_not_of("0123456789abcdef", start.size()) == end &&
           name.substr(std::min(end, name.size())) == partial_end;
}

/// Removes a partial file that a killed process left behind. A lock ends with its process: where
/// there is one, that process is at work, and false is returned.
bool remove_leftover(const fs::path& partial) {
    const Descriptor left(open(partial.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status = {};
    if (left < 0 || fstat(left, &status) != 0 || !S_ISREG(status.st_mode) ||
        status.st_uid != geteuid())
        return true; // not ours to judge
    if (flock(left, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return false;
    unlink(partial.c_str());
    return true;
}

/// Removes what killed processes left of `target`; refuses where one is at work on it.
void remove_leftovers(const fs::path& target, const fs::path& own) {
    std::error_code ignored;
    const std::string start = partial_start(target);
    for (const auto& entry : fs::directory_iterator(folder_of(target), ignored))
        if (is_partial_name(entry.path().filename().string(), start) &&
            entry.path().filename() != own.filename() && !remove_leftover(entry.path()))
            fail_as_being_written(target);
}

/// Rights of the file that is replaced, or those that the system gives a new one.
std::optional<struct stat> replaced_status(const fs::path& target) {
    struct stat status = {};
    if (stat(target.c_str(), &status) == 0)
        return status;
    if (is_failure_of_machine(errno))
        fail_to_create(target);
    return std::nullopt;
}

/// The file that bytes go to before it takes its name. Removed unless it was renamed; closed last,
/// because closing lets go of the lock.
class PartialFile {
public:
    explicit PartialFile(const fs::path& given)
        : name(given), target(without_links(given)), replaced(replaced_status(target)),
          partial(random_partial_name(target)),
          descriptor(above_standard_streams(Descriptor(make()))) {
        // File systems that know no locks go without.
        flock(descriptor, LOCK_EX | LOCK_NB);
        try {
            remove_leftovers(target, partial);
        } catch (...) {
            unlink(partial.c_str());
            throw;
        }
    }

    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;

    ~PartialFile() {
        if (!renamed)
            unlink(partial.c_str());
    }

    void append(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t written = write(descriptor, bytes.data(), bytes.size());
            if (written >= 0)
                bytes.remove_prefix(static_cast<std::size_t>(written));
            else if (errno != EINTR)
                fail_by_errno(name);
        }
    }

    [[nodiscard]] int number() const { return descriptor; }

    void rename_to_target() {
        if (!has_name(descriptor, partial)) // taken for a leftover before the lock was ours
            fail_as_being_written(name);
        if (replaced)
            take_rights(*replaced);
        // Without fsync a crash soon after could leave the name with nothing behind it.
        if (fsync(descriptor) != 0 || std::rename(partial.c_str(), target.c_str()) != 0)
            fail_by_errno(name);
        renamed = true;
        const Descriptor folder(
            open(folder_of(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        if (folder >= 0)
            fsync(folder); // its own entry for the name; not every file system has that
    }

private:
    [[nodiscard]] int make() const {
        // Closed to others until it has the rights of what it replaces.
        const mode_t mode = replaced ? 0600 : 0666;
        const int made =
            open(partial.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
        if (made < 0)
            fail_to_create(name);
        return made;
    }

    void take_rights(const struct stat& from) const {
        // Who may not give a file away keeps it, and then nobody gets rights that were meant for
        // another group.
        const bool same_group = fchown(descriptor, from.st_uid, from.st_gid) == 0 ||
                                fchown(descriptor, -1, from.st_gid) == 0;
        fchmod(descriptor, from.st_mode & (same_group ? 0777U : 0707U));
    }

    fs::path name; ///< as it was given, for messages
    fs::path target;
    std::optional<struct stat> replaced;
    fs::path partial;
    Descriptor descriptor;
    bool renamed = false;
};

} // namespace

Descriptor open_regular_file(const fs::path& file) {
    // Without O_NONBLOCK a pipe would wait for its other end.
    const int flags = O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
    Descriptor opened = above_standard_streams(Descriptor(open(file.c_str(), flags)));
    struct stat status = {};
    if (opened < 0 || fstat(opened, &status) != 0)
        fail_to_open(file);
    if (S_ISDIR(status.st_mode))
        throw InputError(file.string() + ": expected a file, found a folder; name the files in it");
    if (!S_ISREG(status.st_mode))
        fail_as_irregular(file);
    return opened;
}

std::uint64_t size_of(const Descriptor& opened, const fs::path& file) {
    struct stat status = {};
    if (fstat(opened, &status) != 0)
        throw FailureError(file.string() + ": cannot be read: " + errno_text());
    return static_cast<std::uint64_t>(status.st_size);
}

std::string read_whole(const fs::path& file, std::size_t max) {
    const Descriptor opened = open_regular_file(file);
    const std::uint64_t size = size_of(opened, file);
    if (size == 0)
        throw InputError(file.string() + ": expected a snapshot, found an empty file");
    std::string bytes(static_cast<std::size_t>(std::min<std::uint64_t>(size, max)), '\0');
    if (read_some(opened, bytes.data(), bytes.size(), file) != bytes.size())
        throw InputError(file.string() + ": cannot be read: it became shorter meanwhile");
    return bytes;
}

std::string file_hash(const fs::path& file) {
    const Descriptor opened = open_regular_file(file);
    Sha256 sum;
    std::vector<char> block(std::min<std::uint64_t>(size_of(opened, file) + 1, 1 << 20));
    for (std::size_t count = block.size(); count == block.size();) {
        count = read_some(opened, block.data(), block.size(), file);
        sum.add(block.data(), count);
    }
    return sum.text();
}

void check_can_be_written(const fs::path& name) {
    if (!name.has_filename())
        throw InputError("'" + name.string() + "': expected the name of a file to write");
    const fs::path file = without_links(name);
    std::error_code ignored; // where the path cannot even be looked at, its folder says why
    const fs::file_status status = fs::status(file, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        throw InputError(name.string() +
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

void write_whole(const fs::path& file, const std::function<void(int)>& fill) {
    check_can_be_written(file);
    PartialFile partial(file);
    fill(partial.number());
    partial.rename_to_target();
}

void fail_to_write(const fs::path& file, int error) {
    throw FailureError(file.string() +
                       ": writing failed, nothing was kept: " + std::strerror(error));
}

} // namespace meniscus
