#include "scratch_file.hpp"

#include "errors.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <string>

namespace meniscus {
namespace {

[[noreturn]] void fail(const std::filesystem::path& folder, const std::string& what) {
    throw FailureError(folder.string() + ": " + what + ": " + std::strerror(errno));
}

int open_without_name(const std::filesystem::path& folder) {
    const int opened = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (opened >= 0 || (errno != EOPNOTSUPP && errno != EISDIR && errno != ENOENT))
        return opened;
    // A file system that knows no such files.
    std::string name = (folder / ".meniscus_scratch_XXXXXX").string();
    const int named = mkostemp(name.data(), O_CLOEXEC);
    if (named >= 0)
        unlink(name.c_str());
    return named;
}

} // namespace

ScratchFile::ScratchFile(const std::filesystem::path& folder)
    : folder(folder), descriptor(open_without_name(folder)) {
    if (descriptor < 0)
        fail(folder, "cannot make a file for what does not fit into memory");
}

void ScratchFile::append(const void* bytes, std::size_t count) {
    write(bytes_written, bytes, count);
}

void ScratchFile::write(std::uint64_t place, const void* bytes, std::size_t count) {
    const auto* from = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t written = pwrite(descriptor, from, count, static_cast<off_t>(place));
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            fail(folder, "cannot store what does not fit into memory");
        from += written;
        place += static_cast<std::uint64_t>(written);
        bytes_written = std::max(bytes_written, place);
        count -= static_cast<std::size_t>(written);
    }
}

void ScratchFile::clear() {
    if (ftruncate(descriptor, 0) != 0)
        fail(folder, "cannot empty a file for what does not fit into memory");
    bytes_written = 0;
}

void ScratchFile::read(std::uint64_t place, void* bytes, std::size_t count) const {
    auto* into = static_cast<char*>(bytes);
    while (count > 0) {
        const ssize_t got = pread(descriptor, into, count, static_cast<off_t>(place));
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            fail(folder, "cannot read back what does not fit into memory");
        into += got;
        place += static_cast<std::uint64_t>(got);
        count -= static_cast<std::size_t>(got);
    }
}

} // namespace meniscus
