#include "hdf5_signature.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <fstream>
#include <string>

namespace meniscus {

bool is_hdf5(const std::filesystem::path& file) {
    const std::string signature = "\x89HDF\r\n\x1a\n";
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

} // namespace meniscus
