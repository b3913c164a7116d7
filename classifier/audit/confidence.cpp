#include "confidence.hpp"

#include <cmath>

namespace meniscus {
namespace {

/// Probability of at most `successes` in `trials` of probability p each, 0 < p < 1.
double binomial_distribution(std::size_t successes, std::size_t trials, double p) {
    const auto n = static_cast<double>(trials);
    double sum = 0;
    for (std::size_t i = 0; i <= successes; ++i) {
        const auto m = static_cast<double>(i);
        sum += std::exp(std::lgamma(n + 1) - std::lgamma(m + 1) - std::lgamma(n - m + 1) +
                        m * std::log(p) + (n - m) * std::log1p(-p));
    }
    return sum;
}

} // namespace

double upper_bound_of_probability(std::size_t with_misses, std::size_t snapshots,
                                  double confidence) {
    if (with_misses >= snapshots)
        return 1;
    double below = 0;
    double above = 1;
    // The probability of so few misses falls with p; sixty halvings exhaust a double.
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = (below + above) / 2;
        const bool plausible =
            binomial_distribution(with_misses, snapshots, middle) > 1 - confidence;
        (plausible ? below : above) = middle;
    }
    return above;
}

double upper_bound_of_mean_rate(const std::vector<double>& rates, double confidence) {
    if (rates.empty())
        return 1;
    double logarithm = std::log(1 - confidence);
    for (const double rate : rates)
        logarithm += std::log1p(-rate);
    return -std::expm1(logarithm / static_cast<double>(rates.size()));
}

} // namespace meniscus
