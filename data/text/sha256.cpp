#include "sha256.hpp"

#include "errors.hpp"

#include <openssl/evp.h>

#include <array>

namespace meniscus {
namespace {

void demand(bool fine) {
    if (!fine)
        throw FailureError("a SHA-256 could not be computed by OpenSSL");
}

} // namespace

struct Sha256::Context {
    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> digest{EVP_MD_CTX_new(),
                                                                   EVP_MD_CTX_free};
};

Sha256::Sha256() : context(std::make_unique<Context>()) {
    EVP_MD_CTX* const digest = context->digest.get();
    demand(digest != nullptr && EVP_DigestInit_ex(digest, EVP_sha256(), nullptr) == 1);
}

Sha256::~Sha256() = default;

void Sha256::add(const void* bytes, std::size_t count) {
    demand(EVP_DigestUpdate(context->digest.get(), bytes, count) == 1);
}

std::string Sha256::text() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int length = 0;
    demand(EVP_DigestFinal_ex(context->digest.get(), digest.data(), &length) == 1);
    std::string text;
    for (unsigned int i = 0; i < length; ++i) {
        text += "0123456789abcdef"[digest[i] >> 4];
        text += "0123456789abcdef"[digest[i] & 15];
    }
    return text;
}

} // namespace meniscus
