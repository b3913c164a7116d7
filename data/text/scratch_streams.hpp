// Many streams of bytes in one scratch file, each written piece by piece and read from its
// beginning: what is sorted into more heaps than a process may have files open.
#pragma once

#include "scratch_file.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace meniscus {

class ScratchStreams {
public:
    /// So many empty ones on the disk of that folder. Throws as ScratchFile does, and so does what
    /// follows.
    ScratchStreams(const std::filesystem::path& folder, std::size_t count)
        : file(folder), pieces(count) {}

    /// Adds bytes at the end of a stream. Pieces are best large: each is kept in mind.
    void append(std::size_t stream, std::string_view bytes);

    [[nodiscard]] std::uint64_t size(std::size_t stream) const;

    /// Calls use(bytes) with all bytes of a stream, in their order, at most `at_once` at a time and
    /// a multiple of `record`, of which each piece was one.
    void visit(std::size_t stream, std::size_t record, std::size_t at_once,
               const std::function<void(std::string_view)>& use) const;

private:
    struct Piece {
        std::uint64_t first;
        std::uint64_t size;
    };

    ScratchFile file;
    std::vector<std::vector<Piece>> pieces; ///< of each stream
};

} // namespace meniscus
