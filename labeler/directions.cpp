#include "directions.hpp"

#include <meniscus/data/errors.hpp>

#include <cmath>

namespace meniscus {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Sine and cosine of 2 pi times `turn` in [0, 1). The C library's differ in the last bit between
/// machines; a Taylor series within an eighth of a turn does not, and is as exact.
std::array<double, 2> cosine_and_sine_of_turn(double turn) {
    const auto octant = static_cast<int>(turn * 8);
    // Even octants count up from their start, odd ones down from their end.
    const double part = octant % 2 == 0 ? turn - octant / 8.0 : (octant + 1) / 8.0 - turn;
    const double angle = 2 * pi * part;
    const double square = angle * angle;
    double cosine = 1;
    double sine = 1;
    for (int order = 18; order >= 2; order -= 2) {
        cosine = 1 - cosine * square / (order * (order - 1));
        sine = 1 - sine * square / (order * (order + 1));
    }
    sine *= angle;
    switch (octant) {
    case 0:
        return {cosine, sine};
    case 1:
        return {sine, cosine};
    case 2:
        return {-sine, cosine};
    case 3:
        return {-cosine, sine};
    case 4:
        return {-cosine, -sine};
    case 5:
        return {-sine, -cosine};
    case 6:
        return {sine, -cosine};
    default:
        return {cosine, -sine};
    }
}

} // namespace

const std::vector<SamplingScheme>& sampling_schemes() {
    static const std::vector<SamplingScheme> schemes = {
        {"halton", false, fill_halton},
        {"random", true, fill_random},
        {"table", true, fill_table},
        {"blue-noise", false, fill_blue_noise},
    };
    return schemes;
}

std::string sampling_scheme_names() {
    std::string names;
    for (const SamplingScheme& scheme : sampling_schemes())
        names += scheme.name + ", ";
    return names + "halton-P-Q (two different primes up to " + std::to_string(largest_halton_base) +
           ")";
}

SamplingScheme sampling_scheme(std::string_view name) {
    for (const SamplingScheme& scheme : sampling_schemes())
        if (scheme.name == name)
            return scheme;
    if (auto scheme = halton_scheme(name))
        return *scheme;
    throw InputError("unknown sampling scheme '" + std::string(name) + "'; known are " +
                     sampling_scheme_names());
}

Direction direction_from_square(int dimension, double u, double v) {
    const auto [cosine, sine] = cosine_and_sine_of_turn(v);
    if (dimension == 2)
        return {cosine, sine, 0};
    const double z = 1 - 2 * u;
    const double radius = std::sqrt(1 - z * z);
    return {radius * cosine, radius * sine, z};
}

double random_fraction(std::uint64_t bits) {
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

} // namespace meniscus
