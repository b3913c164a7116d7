#include "directions.hpp"

#include <meniscus/data/errors.hpp>
#include <meniscus/runtime/angles.hpp>

#include <cmath>

namespace meniscus {

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
