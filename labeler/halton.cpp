// The Halton sequence in bases 2 and 3 (2020 paper, section 3.3): the paper's best scheme. On the
// circle base 2 alone. A seed other than 0 moves the whole sequence by a random offset, which keeps
// its evenness (Cranley and Patterson 1976).
#include "directions.hpp"

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
    return seed == 0 ? 0 : static_cast<double>(mix_bits(2 * seed + axis) >> 11) * 0x1p-53;
}

double wrapped_sum(double a, double b) {
    const double sum = a + b;
    return sum < 1 ? sum : sum - 1;
}

} // namespace

void fill_halton(int dimension, std::uint64_t seed, std::uint64_t /*particle*/,
                 std::vector<Direction>& directions) {
    const double offset_u = offset_of(seed, 0);
    const double offset_v = offset_of(seed, 1);
    const std::uint64_t base_around = dimension == 2 ? 2 : 3;
    for (std::size_t k = 0; k < directions.size(); ++k) {
        // From index 1: index 0 would be the pole itself.
        const double u = wrapped_sum(radical_inverse(k + 1, 2), offset_u);
        const double v = wrapped_sum(radical_inverse(k + 1, base_around), offset_v);
        directions[k] = direction_from_square(dimension, u, v);
    }
}

} // namespace meniscus
