// What a report's page holds, read back: its data as JSON and its arrays as numbers.
#pragma once

#include "command.hpp"

#include <nlohmann/json.hpp>

#include <cstring>
#include <zlib.h>

namespace meniscus {

inline nlohmann::json report_data(const std::string& page) {
    const std::string start = R"(<script type="application/json" id="report">)";
    const std::size_t begin = page.find(start) + start.size();
    return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

inline std::string from_base64(const std::string& text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned word = 0;
    int bits = 0;
    for (const char c : text) {
        if (c == '=')
            break;
        word = word << 6U | static_cast<unsigned>(digits.find(c));
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes += static_cast<char>(word >> static_cast<unsigned>(bits) & 255U);
        }
    }
    return bytes;
}

/// `count` numbers out of a packed array; none where it holds another number of them.
template <class Number>
std::vector<Number> unpacked(const nlohmann::json& packed, std::size_t count) {
    const std::string compressed = from_base64(packed.get<std::string>());
    std::vector<Number> numbers(count + 1);
    uLongf size = numbers.size() * sizeof(Number);
    const int status =
        uncompress(reinterpret_cast<Bytef*>(numbers.data()), &size,
                   reinterpret_cast<const Bytef*>(compressed.data()), compressed.size());
    if (status != Z_OK || size != count * sizeof(Number))
        return {};
    numbers.resize(count);
    return numbers;
}

} // namespace meniscus
