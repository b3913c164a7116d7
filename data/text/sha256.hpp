// SHA-256 of bytes that come piece by piece: what files are told apart by, and what damage to a
// file is found by.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace meniscus {

class Sha256 {
public:
    /// Throws FailureError where OpenSSL has none.
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    /// Appends bytes. Throws FailureError where OpenSSL fails.
    void add(const void* bytes, std::size_t count);

    /// The sum of all that was added, as 64 hexadecimal digits; nothing can be added after. Throws
    /// FailureError where OpenSSL fails.
    [[nodiscard]] std::string text();

private:
    struct Context;
    std::unique_ptr<Context> context;
};

} // namespace meniscus
