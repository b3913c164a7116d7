// Bytes on their way into pages and pictures: made smaller by deflate, written as text, summed up.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace meniscus {

/// Compressed by deflate, in zlib's container. Throws FailureError where memory lacks.
std::string deflated(std::string_view bytes);

/// In base64, padded.
std::string base64(std::string_view bytes);

/// The checksum CRC-32, as PNG and gzip have it.
std::uint32_t crc_32(std::string_view bytes);

} // namespace meniscus
