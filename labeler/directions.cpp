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
    };
    return schemes;
}

const SamplingScheme& sampling_scheme(std::string_view name) {
    std::string known;
    for (const SamplingScheme& scheme : sampling_schemes()) {
        if (scheme.name == name)
            return scheme;
        known += (known.empty() ? "" : ", ") + std::string(scheme.name);
    }
    throw InputError("unknown sampling scheme '" + std::string(name) + "'; known are " + known);
}

Direction direction_from_square(int dimension, double u, double v) {
    const auto [cosine, sine] = cosine_and_sine_of_turn(v);
    if (dimension == 2)
        return {cosine, sine, 0};
    const double z = 1 - 2 * u;
    const double radius = std::sqrt(1 - z * z);
    return {radius * cosine, radius * sine, z};
}

std::uint64_t mix_bits(std::uint64_t value) {
    value += 0x9e3779b97f4a7c15ULL;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
    value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
    return value ^ (value >> 31);
}

} // namespace meniscus
