// Errors that a test expects: their message, which must be one line, and what it must mention.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace meniscus {

/// The message of the error of type Error that `action` throws; it must be one line.
template <class Error, class Action>
std::string error_of(Action action) {
    try {
        action();
    } catch (const Error& error) {
        std::string message = error.what();
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        return message;
    }
    ADD_FAILURE() << "expected an error, found none";
    return {};
}

inline void expect_mentions(const std::string& message, std::initializer_list<const char*> parts) {
    for (const char* part : parts)
        EXPECT_NE(message.find(part), std::string::npos) << "no '" << part << "' in: " << message;
}

} // namespace meniscus
