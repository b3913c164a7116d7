#include "text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <locale>
#include <sstream>
#include <type_traits>

namespace meniscus {

namespace {

/// For numbers that from_chars calls out of range, be they too large or too small.
template <class Number>
bool read_as_tiny(std::string_view text, Number& value) {
    std::istringstream stream{std::string(text)};
    stream.imbue(std::locale::classic());
    Number number = 0;
    const bool tiny = (stream >> number) && number == 0;
    value = tiny ? number : value;
    return tiny;
}

} // namespace

std::string number_text(double value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    std::string text(digits, end);
    if (std::isfinite(value) && text.find_first_of(".e") == std::string::npos)
        text += ".0";
    return text;
}

std::string rounded_text(double value, int digits) {
    char text[64];
    const auto end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr;
    return {text, end};
}

std::optional<double> number_from_text(const std::string& text) {
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size())
        return {};
    return value;
}

template <class Number>
std::errc read_number(std::string_view text, Number& value) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-')
        text.remove_prefix(1); // which from_chars does not know
    const char* end = text.data() + text.size();
    Number number = 0;
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (stop != end)
        return std::errc::invalid_argument;
    if (error == std::errc())
        value = number;
    else if constexpr (std::is_floating_point_v<Number>)
        return read_as_tiny(text, value) ? std::errc() : error;
    return error;
}

template std::errc read_number(std::string_view text, std::int8_t& value);
template std::errc read_number(std::string_view text, std::uint8_t& value);
template std::errc read_number(std::string_view text, std::int16_t& value);
template std::errc read_number(std::string_view text, std::uint16_t& value);
template std::errc read_number(std::string_view text, std::int32_t& value);
template std::errc read_number(std::string_view text, std::uint32_t& value);
template std::errc read_number(std::string_view text, std::int64_t& value);
template std::errc read_number(std::string_view text, std::uint64_t& value);
template std::errc read_number(std::string_view text, float& value);
template std::errc read_number(std::string_view text, double& value);

std::string lowered(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

std::string quoted_text(std::string_view text) {
    return "'" + printable(text, 60) + "'";
}

std::optional<std::string> repeated_name(std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    const auto repeated = std::adjacent_find(names.begin(), names.end());
    return repeated == names.end() ? std::nullopt : std::make_optional(*repeated);
}

} // namespace meniscus
