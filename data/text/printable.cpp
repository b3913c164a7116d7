#include "printable.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace meniscus {
namespace {

constexpr char32_t no_character = 0xffffffff;

/// The character of UTF-8 that the text begins with, and its bytes; no_character, of one byte,
/// where there is none.
std::pair<char32_t, std::size_t> first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80)
        return {lead, 1};
    const std::size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < size)
        return {no_character, 1};
    char32_t character = lead & (0xffU >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0U) != 0x80)
            return {no_character, 1};
        character = (character << 6U) | (byte(i) & 0x3fU);
    }
    constexpr char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = character >= 0xd800 && character < 0xe000;
    if (character < smallest[size] || character > 0x10ffff || is_surrogate)
        return {no_character, 1};
    return {character, size};
}

/// First and last characters of those that are no sign on paper.
constexpr std::pair<char32_t, char32_t> unprintable[] = {{0x00, 0x1f},
                                                         {0x7f, 0x9f},
                                                         {0xad, 0xad},
                                                         {0x61c, 0x61c},
                                                         {0x200b, 0x200f},
                                                         {0x2028, 0x202e},
                                                         {0x2060, 0x206f},
                                                         {0xfeff, 0xfeff},
                                                         {0xfff0, 0xfffb},
                                                         {0xe0000, 0xe0fff},
                                                         {no_character, no_character}};

bool is_printable(char32_t character) {
    return std::none_of(std::begin(unprintable), std::end(unprintable), [&](const auto& range) {
        return character >= range.first && character <= range.second;
    });
}

std::string escaped(std::string_view bytes) {
    std::string text;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        text += "\\x";
        text += "0123456789abcdef"[byte / 16];
        text += "0123456789abcdef"[byte % 16];
    }
    return text;
}

std::string without_unprintable(std::string_view text, bool keeps_line_breaks) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const auto [character, size] = first_character(text);
        const bool stays = is_printable(character) || (keeps_line_breaks && character == '\n');
        result += stays ? std::string(text.substr(0, size)) : escaped(text.substr(0, size));
        text.remove_prefix(size);
    }
    return result;
}

bool begins_character(char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80;
}

} // namespace

std::string printable(std::string_view text, std::size_t max) {
    constexpr std::string_view gap = "...";
    // What is left out anyway, of texts of any length, is not looked at.
    if (text.size() > 3 * max)
        return printable(std::string(text.substr(0, max)) + std::string(gap) +
                             std::string(text.substr(text.size() - max)),
                         max);
    std::string line = without_unprintable(text, false);
    if (line.size() <= max)
        return line;
    std::size_t begin = 2 * (max - std::min(max, gap.size())) / 3;
    std::size_t end = line.size() - (max - std::min(max, gap.size()) - begin);
    while (begin > 0 && !begins_character(line[begin]))
        --begin;
    while (end < line.size() && !begins_character(line[end]))
        ++end;
    return line.replace(begin, end - begin, gap);
}

std::string printable_lines(std::string_view text) {
    return without_unprintable(text, true);
}

} // namespace meniscus
