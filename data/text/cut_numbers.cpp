#include "cut_numbers.hpp"

#include "text.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>

namespace meniscus {
namespace {

struct NumberShape {
    std::size_t decimals = 0;
    std::size_t digits = 0; ///< significant ones
    bool has_point = false;
    bool has_exponent = false;
};

NumberShape shape_of(std::string_view number) {
    NumberShape shape;
    for (const char c : number) {
        if (c == '.') {
            shape.has_point = true;
        } else if (c == 'e' || c == 'E') {
            shape.has_exponent = true;
        } else if (std::isdigit(static_cast<unsigned char>(c)) != 0 && !shape.has_exponent) {
            shape.decimals += shape.has_point ? 1 : 0;
            shape.digits += c != '0' || shape.digits > 0 ? 1 : 0;
        }
    }
    return shape;
}

bool follows(std::string_view last, std::string_view before) {
    std::int64_t a = 0;
    std::int64_t b = 0;
    return read_number(last, a) == std::errc() && read_number(before, b) == std::errc() &&
           (a == b || a - 1 == b);
}

} // namespace

bool may_be_cut(std::string_view last, const std::vector<std::string_view>& before) {
    if (before.size() < 2)
        return true;
    const NumberShape shape = shape_of(last);
    if (!shape.has_point && !shape.has_exponent)
        return !follows(last, before.back());
    NumberShape longest;
    longest.decimals = shape_of(before.back()).decimals;
    bool same_decimals = true;
    for (const std::string_view number : before) {
        const NumberShape other = shape_of(number);
        longest.digits = std::max(longest.digits, other.digits);
        longest.has_exponent = longest.has_exponent || other.has_exponent;
        same_decimals = same_decimals && other.decimals == longest.decimals;
    }
    const auto length = [](std::string_view number) {
        const std::size_t e = number.find_first_of("eE");
        return e == std::string_view::npos ? 0 : number.size() - e;
    };
    if (longest.has_exponent) // of two digits at least, as all programs write it
        return !(shape.has_exponent && length(last) >= 4 && length(last) >= length(before.back()));
    constexpr std::size_t usual_digits = 6; // of programs that drop zeros behind
    return same_decimals ? shape.decimals != longest.decimals
                         : shape.digits < std::max(longest.digits, usual_digits);
}

} // namespace meniscus
