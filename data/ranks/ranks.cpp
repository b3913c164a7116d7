#include "ranks.hpp"

#include <meniscus/data/text/errors.hpp>

#include <cstring>
#include <exception>
#include <utility>

namespace meniscus {
namespace {

class OneProcess final : public Ranks {
public:
    [[nodiscard]] int rank() const override { return 0; }
    [[nodiscard]] int size() const override { return 1; }
    std::vector<std::string> exchange(std::vector<std::string> for_rank) override {
        return for_rank;
    }
    void sum(std::vector<std::uint64_t>& /*values*/) override {}
    void min(std::vector<double>& /*values*/) override {}
    void max(std::vector<double>& /*values*/) override {}
};

/// An error as a text whose first letter says of which kind it is; empty: none.
std::string packed(const std::exception_ptr& error) {
    if (!error)
        return {};
    try {
        std::rethrow_exception(error);
    } catch (const InputError& known) {
        return std::string("i") + known.what();
    } catch (const std::bad_alloc&) {
        return "fnot enough memory";
    } catch (const std::exception& other) {
        return std::string("f") + other.what();
    }
}

} // namespace

Ranks& one_process() {
    static OneProcess alone;
    return alone;
}

void do_together(Ranks& ranks, const std::function<void()>& share) {
    std::exception_ptr error;
    try {
        share();
    } catch (...) {
        error = std::current_exception();
    }
    if (ranks.size() == 1) {
        if (error)
            std::rethrow_exception(error);
        return;
    }
    for (const std::string& said : gather(ranks, packed(error))) {
        if (said.empty())
            continue;
        if (said[0] == 'i')
            throw InputError(said.substr(1));
        throw FailureError(said.substr(1));
    }
}

std::vector<std::string> gather(Ranks& ranks, const std::string& said) {
    return ranks.exchange(std::vector<std::string>(static_cast<std::size_t>(ranks.size()), said));
}

double nth_of_all(Ranks& ranks, std::uint64_t place,
                  const std::function<void(const std::function<void(double)>&)>& visit) {
    // Positive numbers are in the order of their bits. Sixteen of them are found at a time.
    std::uint64_t found = 0;
    for (int shift = 48; shift >= 0; shift -= 16) {
        std::vector<std::uint64_t> counts(std::size_t{1} << 16);
        visit([&](double value) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            if (shift == 48 || bits >> (shift + 16) == found)
                ++counts[(bits >> shift) & 0xffff];
        });
        ranks.sum(counts);
        std::uint64_t digit = 0;
        while (place >= counts.at(digit))
            place -= counts[digit++];
        found = found << 16 | digit;
    }
    double value = 0;
    std::memcpy(&value, &found, sizeof value);
    return value;
}

} // namespace meniscus
