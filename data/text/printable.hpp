// Text of unknown origin for a terminal, a log or a message: names in files may be made of any
// bytes, among them those that move the cursor, clear the screen, or forge a line of their own.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace meniscus {

/// Bytes of a message, more than any that is made of sane names.
inline constexpr std::size_t max_message = 2000;

/// The text in one line of valid UTF-8: bytes that make no character, and those of characters that
/// are no sign on paper (control characters, line breaks, changes of the direction of writing), are
/// written as a backslash, an x and two digits. Where that takes more than `max` bytes, its middle
/// is left out for "...". What it returns stays as it is when it is made printable again.
std::string printable(std::string_view text, std::size_t max = max_message);

/// The same for several lines, of any length: line breaks stay.
std::string printable_lines(std::string_view text);

} // namespace meniscus
