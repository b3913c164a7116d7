#include "hdf5_signature.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <cstdint>
#include <fstream>
#include <string>

namespace meniscus {
namespace {

const std::string signature = "\x89HDF\r\n\x1a\n";

} // namespace

bool is_hdf5(const std::filesystem::path& file) {
    if (read_whole(file, signature.size()) == signature)
        return true;
    std::ifstream stream(file, std::ios::binary);
    std::string found(signature.size(), '\0');
    // Where the format allows it to stand; reading fails at the end of the file.
    for (std::streamoff offset = 512; stream; offset *= 2) {
        stream.seekg(offset);
        if (stream.read(found.data(), static_cast<std::streamsize>(found.size())) &&
            found == signature)
            return true;
    }
    if (stream.bad() || !stream.eof())
        throw FailureError(file.string() + ": cannot be read");
    return false;
}

bool is_own_hdf5_of_full_length(const std::filesystem::path& file) {
    // Superblock 2: version, sizes of offsets and lengths, flags; base address, extension, end of
    // file.
    const std::string begin = signature + "\x02\x08\x08";
    constexpr std::size_t end_of_file = 28;
    std::uint64_t length = 0;
    const std::string bytes = read_whole(file, end_of_file + sizeof length);
    if (bytes.size() < end_of_file + sizeof length || bytes.compare(0, begin.size(), begin) != 0)
        return false;
    for (std::size_t byte = sizeof length; byte-- > 0;) // the lowest comes first
        length = length << 8 | static_cast<unsigned char>(bytes[end_of_file + byte]);
    return std::filesystem::file_size(file) == length;
}

} // namespace meniscus
