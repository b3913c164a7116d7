#include "run_record.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
    throw FailureError(file.string() + ": " + what + ": " + std::strerror(errno));
}

bool has_name(int descriptor, const fs::path& name) {
    struct stat opened = {};
    struct stat named = {};
    return fstat(descriptor, &opened) == 0 && stat(name.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

/// Opened and locked until it is closed.
int open_locked(const fs::path& file) {
    for (;;) {
        check_can_be_written(file);
        const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor < 0)
            fail(file, "cannot be opened");
        // File systems that know no locks go without.
        const bool taken = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        // Its last holder may have removed it before the lock was ours.
        if (!taken && has_name(descriptor, file))
            return descriptor;
        close(descriptor);
        if (taken)
            throw FailureError(file.string() +
                               ": another run of this name is at work in the folder; wait for it "
                               "to end, or choose another folder with -o");
    }
}

// All columns but the last are of fixed width, so that a line can change in its place.
constexpr std::size_t hash_width = 64;
constexpr std::size_t bytes_width = 16;
constexpr std::size_t name_begin = hash_width + bytes_width + 2;

std::string line_of(const RecordedFile& file) {
    const std::string bytes = std::to_string(file.bytes);
    return file.hash + std::string(hash_width + 1 - std::min(file.hash.size(), hash_width), ' ') +
           std::string(bytes_width - std::min(bytes.size(), bytes_width), ' ') + bytes + " " +
           file.name + "\n";
}

RecordedFile file_of(const std::string& line) {
    RecordedFile file;
    const std::size_t digits = line.find_first_not_of(' ', hash_width);
    if (line.size() > name_begin && digits < name_begin) {
        read_number(std::string_view(line).substr(digits, name_begin - 1 - digits), file.bytes);
        file.hash = line.substr(0, line.find(' '));
        file.name = line.substr(name_begin);
    }
    return file;
}

/// A last line that was cut off says nothing.
std::vector<RecordedFile> files_in(const std::string& text, const fs::path& file) {
    std::vector<RecordedFile> files;
    for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
        const std::string line = text.substr(begin, end - begin);
        files.push_back(file_of(line));
        if (line_of(files.back()) != line + "\n")
            throw InputError(
                file.string() + ": is no record of a run: expected SHA-256, size and name, found " +
                quoted_text(line) + "; move it away, or choose another folder with -o");
    }
    if (files.empty() && !text.empty())
        throw InputError(file.string() + ": is no record of a run, found " + quoted_text(text) +
                         "; move it away, or choose another folder with -o");
    return files;
}

} // namespace

RunRecord::RunRecord(fs::path its_file) : file(std::move(its_file)), descriptor(open_locked(file)) {
    try {
        if (fs::file_size(file) > 0)
            recorded = files_in(read_whole(file), file);
    } catch (...) {
        close(descriptor);
        throw;
    }
}

RunRecord::~RunRecord() {
    struct stat now = {};
    if (recorded.empty() && fstat(descriptor, &now) == 0 && now.st_size == 0)
        unlink(file.c_str());
    close(descriptor);
}

const RecordedFile* RunRecord::find(const std::string& name) const {
    const auto found = std::find_if(recorded.begin(), recorded.end(),
                                    [&](const RecordedFile& one) { return one.name == name; });
    return found == recorded.end() ? nullptr : &*found;
}

void RunRecord::set(const RecordedFile& changed) {
    const auto found = std::find_if(recorded.begin(), recorded.end(), [&](const RecordedFile& one) {
        return one.name == changed.name;
    });
    if (found == recorded.end())
        recorded.push_back(changed);
    else
        *found = changed;
    write();
}

void RunRecord::clear() {
    recorded.clear();
    write();
}

// In place, because a file that is renamed over this one would not be the one that is locked. All
// lines but one stay as they are, and none moves, so that a process killed midway spoils none.
void RunRecord::write() {
    std::string text;
    for (const RecordedFile& one : recorded)
        text += line_of(one);
    std::size_t written = 0;
    while (written < text.size()) {
        const ssize_t part = pwrite(descriptor, text.data() + written, text.size() - written,
                                    static_cast<off_t>(written));
        if (part < 0 && errno != EINTR)
            fail(file, "writing failed");
        written += part > 0 ? static_cast<std::size_t>(part) : 0;
    }
    if (ftruncate(descriptor, static_cast<off_t>(text.size())) != 0 || fdatasync(descriptor) != 0)
        fail(file, "writing failed");
}

std::string damage_of(const fs::path& file, const RecordedFile* recorded) {
    if (recorded != nullptr && recorded->hash == lost)
        return {};
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(file, error);
    if (error)
        return "is missing";
    if (recorded == nullptr || recorded->hash == unsettled)
        return "is not in the record of the run";
    if (bytes != recorded->bytes)
        return "has " + std::to_string(bytes) + " bytes, was written with " +
               std::to_string(recorded->bytes);
    return file_hash(file) == recorded->hash ? "" : "has not the content that it was written with";
}

bool is_replaced(const fs::path& file, const RecordedFile& recorded) {
    if (recorded.hash == unsettled || !fs::exists(file) || damage_of(file, &recorded).empty())
        return false;
    try {
        read_vtkhdf(file);
        return true;
    } catch (const InputError&) {
        return false; // damaged
    }
}

} // namespace meniscus
