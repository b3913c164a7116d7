// Small helpers for text that people and programs read: numbers that read back to the same bits,
// and error messages that name the file they are about. None depends on the locale.
#pragma once

#include "errors.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace meniscus {

/// The number in decimal, as short as reads back to the same bits; always with a point or an
/// exponent ("2.0", "1e-05"), so that C++ and JSON take it for a floating-point number. "nan",
/// "inf" and "-inf" otherwise.
std::string number_text(double value);

/// The number in decimal, rounded to `digits` significant digits, for people ("25.93").
std::string rounded_text(double value, int digits);

/// The number that the whole text stands for, or nothing; the same in every locale.
std::optional<double> number_from_text(const std::string& text);

/// Reads the whole text as a decimal number of the given type: any integer type of a snapshot's
/// arrays, float or double. A sign may stand in front, and floating-point numbers may be nan or inf
/// in letters of any case; what is too small for them becomes 0. Returns std::errc() where it was
/// read, result_out_of_range for a number that the type cannot hold, invalid_argument for anything
/// else; `value` is set in the first case only.
template <class Number>
std::errc read_number(std::string_view text, Number& value);

/// The text with ASCII letters in lower case.
std::string lowered(std::string_view text);

/// Text of a file in quotes for a message: printable (printable.hpp), and at most some 60 bytes.
std::string quoted_text(std::string_view text);

/// A name that occurs more than once, or nothing.
std::optional<std::string> repeated_name(std::vector<std::string> names);

/// Calls `work()`; an InputError from it that does not begin with the file's name gets it in front.
template <class Work>
auto naming_file(const std::filesystem::path& file, Work&& work) {
    try {
        return work();
    } catch (const InputError& error) {
        const std::string message = error.what();
        if (message.rfind(printable(file.string()), 0) == 0)
            throw;
        throw InputError(file.string() + ": " + message);
    }
}

} // namespace meniscus
