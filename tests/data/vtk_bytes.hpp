// Numbers as binary legacy VTK files store them.
#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace meniscus {

/// The values' bytes, big endian.
template <class Number>
std::string big_endian(const std::vector<Number>& values) {
    std::string bytes;
    for (const Number& value : values) {
        const char* begin = reinterpret_cast<const char*>(&value);
        std::reverse_copy(begin, begin + sizeof(Number), std::back_inserter(bytes));
    }
    return bytes;
}

} // namespace meniscus
