// What does not fit into memory and is wanted again: bytes in a file without a name, which is gone
// when its process is, however that ends.
#pragma once

#include "descriptor.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace meniscus {

class ScratchFile {
public:
    /// Makes an empty one on the disk of that folder. Throws FailureError where that fails.
    explicit ScratchFile(const std::filesystem::path& folder);

    /// Adds bytes at the end. Throws FailureError where the disk is full.
    void append(const void* bytes, std::size_t count);

    /// Writes `count` bytes at `place`, at the end or beyond it, what lies between being zeros, or
    /// over what is there. Throws as append does.
    void write(std::uint64_t place, const void* bytes, std::size_t count);

    /// Reads `count` bytes from `place` on, which must be there. Throws FailureError where that
    /// fails.
    void read(std::uint64_t place, void* bytes, std::size_t count) const;

    /// Gives what it holds back to the disk.
    void clear();

    [[nodiscard]] std::uint64_t size() const { return bytes_written; }

private:
    std::filesystem::path folder;
    Descriptor descriptor;
    std::uint64_t bytes_written = 0;
};

} // namespace meniscus
