// Small helpers for text that people and programs read: numbers that read back to the same bits,
// and error messages that name the file they are about.
#pragma once

#include "errors.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace meniscus {

/// The number in decimal, as short as reads back to the same bits; always with a point or an
/// exponent ("2.0", "1e-05"), so that C++ and JSON take it for a floating-point number. "nan",
/// "inf" and "-inf" otherwise.
std::string number_text(double value);

/// The number in decimal, rounded to `digits` significant digits, for people ("25.93").
std::string rounded_text(double value, int digits);

/// The number that the whole text stands for, or nothing; the same in every locale.
std::optional<double> number_from_text(const std::string& text);

/// Calls `work()`; an InputError from it that does not begin with the file's name gets it in front.
template <class Work>
auto naming_file(const std::filesystem::path& file, Work&& work) {
    try {
        return work();
    } catch (const InputError& error) {
        const std::string message = error.what();
        if (message.rfind(file.string(), 0) == 0)
            throw;
        throw InputError(file.string() + ": " + message);
    }
}

} // namespace meniscus
