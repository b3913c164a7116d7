#include "bytes.hpp"

#include <meniscus/data/text/errors.hpp>

#include <zlib.h>

namespace meniscus {

std::string deflated(std::string_view bytes) {
    uLongf size = compressBound(bytes.size());
    std::string compressed(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(compressed.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(),
                  Z_BEST_COMPRESSION) != Z_OK)
        throw FailureError("out of memory while compressing");
    compressed.resize(size);
    return compressed;
}

std::string base64(std::string_view bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t n) -> unsigned {
            return i + n < bytes.size() ? static_cast<unsigned char>(bytes[i + n]) : 0U;
        };
        const unsigned word = byte(0) << 16U | byte(1) << 8U | byte(2);
        for (unsigned digit = 0; digit < 4; ++digit)
            text += i + digit > bytes.size() ? '=' : digits[word >> (18U - 6U * digit) & 63U];
    }
    return text;
}

std::uint32_t crc_32(std::string_view bytes) {
    const uLong begin = crc32_z(0, nullptr, 0);
    return static_cast<std::uint32_t>(
        crc32_z(begin, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

} // namespace meniscus
