// Halton's sequence (2020 paper, section 3.3): the digits of the index in one prime base, mirrored,
// give the height on the axis, those in another base the angle around it; on the circle the first
// base alone. Bases 2 and 3 are the paper's best scheme. A seed other than 0 moves the whole
// sequence by a random offset, which keeps its evenness (Cranley and Patterson 1976).
#include "detail/sampling_schemes.hpp"

#include <meniscus/runtime/math/random_directions.hpp>

namespace meniscus {
namespace {

/// The digits of `index` in `base`, mirrored at the decimal point; in [0, 1).
double radical_inverse(std::uint64_t index, std::uint64_t base) {
    std::uint64_t mirrored = 0;
    std::uint64_t scale = 1;
    for (; index > 0; index /= base) {
        mirrored = mirrored * base + index % base;
        scale *= base;
    }
    return static_cast<double>(mirrored) / static_cast<double>(scale);
}

double offset_of(std::uint64_t seed, std::uint64_t axis) {
    return seed == 0 ? 0 : random_fraction(mix_bits(2 * seed + axis));
}

double wrapped_sum(double a, double b) {
    const double sum = a + b;
    return sum < 1 ? sum : sum - 1;
}

bool is_prime(std::uint64_t number) {
    for (std::uint64_t divisor = 2; divisor * divisor <= number; ++divisor)
        if (number % divisor == 0)
            return false;
    return number > 1;
}

void fill_in_bases(std::uint64_t first, std::uint64_t second, int dimension, std::uint64_t seed,
                   std::vector<Direction>& directions) {
    const double offset_u = offset_of(seed, 0);
    const double offset_v = offset_of(seed, 1);
    const std::uint64_t base_around = dimension == 2 ? first : second;
    for (std::size_t k = 0; k < directions.size(); ++k) {
        // From index 1: index 0 would be the pole itself.
        const double u = wrapped_sum(radical_inverse(k + 1, first), offset_u);
        const double v = wrapped_sum(radical_inverse(k + 1, base_around), offset_v);
        directions[k] = direction_from_square(dimension, u, v);
    }
}

/// Of bases P along the axis and Q around it.
SamplingScheme scheme_of(std::string name, std::uint64_t p, std::uint64_t q) {
    return {std::move(name), false,
            [p, q](int dimension, std::uint64_t seed, std::uint64_t /*particle*/,
                   std::vector<Direction>& directions) {
                fill_in_bases(p, q, dimension, seed, directions);
            }};
}

constexpr std::uint64_t max_base = 31;

std::optional<SamplingScheme> find_in_bases(std::string_view name) {
    for (std::uint64_t p = 2; p <= max_base; ++p)
        for (std::uint64_t q = 2; q <= max_base; ++q)
            if (p != q && is_prime(p) && is_prime(q) &&
                name == "halton-" + std::to_string(p) + "-" + std::to_string(q))
                return scheme_of(std::string(name), p, q);
    return {};
}

} // namespace

SchemeRow halton_row() {
    return row_of(scheme_of("halton", 2, 3));
}

SchemeRow halton_in_bases_row() {
    return {"halton-P-Q (two different primes up to " + std::to_string(max_base) + ")",
            find_in_bases};
}

} // namespace meniscus
