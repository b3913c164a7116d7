#include "measures.hpp"

#include "support/statistics.hpp"

#include <meniscus/data/particles/neighbor_search.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace meniscus {
namespace {

/// r^n P_n(cos theta), or r^n cos(n theta), and its gradient.
struct Harmonic {
    double value;
    Place gradient;
};

Harmonic harmonic_in_plane(const Place& at, int mode) {
    const double radius = std::hypot(at[0], at[1]);
    const double angle = std::atan2(at[1], at[0]);
    const double slope = mode * std::pow(radius, mode - 1);
    return {std::pow(radius, mode) * std::cos(mode * angle),
            {slope * std::cos((mode - 1) * angle), -slope * std::sin((mode - 1) * angle), 0}};
}

/// The solid harmonics of order 0, in x and s = y^2 + z^2.
Harmonic harmonic_in_space(const Place& at, int mode) {
    const double x = at[0];
    const double s = at[1] * at[1] + at[2] * at[2];
    const auto with = [&](double value, double by_x, double by_s) {
        return Harmonic{value, {by_x, 2 * by_s * at[1], 2 * by_s * at[2]}};
    };
    switch (mode) {
    case 2:
        return with(x * x - s / 2, 2 * x, -0.5);
    case 3:
        return with(x * x * x - 1.5 * x * s, 3 * x * x - 1.5 * s, -1.5 * x);
    case 4:
        return with(x * x * x * x - 3 * x * x * s + 0.375 * s * s, 4 * x * x * x - 6 * x * s,
                    -3 * x * x + 0.75 * s);
    default:
        throw std::invalid_argument("modes from 2 to 4 are known");
    }
}

Harmonic harmonic(const Place& at, int mode, int dimension) {
    return dimension == 2 ? harmonic_in_plane(at, mode) : harmonic_in_space(at, mode);
}

Place difference_of(const Place& one, const Place& other) {
    return {one[0] - other[0], one[1] - other[1], one[2] - other[2]};
}

} // namespace

MeanAndDeviation mean_and_deviation(const std::vector<double>& values) {
    Spread spread;
    for (const double value : values)
        spread.add(value);
    const double mean = spread.mean();
    Spread about_mean; // squares of what is left keep their digits
    for (const double value : values)
        about_mean.add(value - mean);
    return {mean, about_mean.root_mean_square()};
}

Place center_of(const Positions& positions) {
    Place center{};
    for (const Place& place : positions)
        for (int axis = 0; axis < 3; ++axis)
            center[axis] += place[axis] / static_cast<double>(positions.size());
    return center;
}

MeanAndDeviation inside(const Positions& positions, const std::vector<double>& values,
                        double radius) {
    const Place center = center_of(positions);
    std::vector<double> some;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Place arm = difference_of(positions[i], center);
        if (std::hypot(arm[0], arm[1], arm[2]) < radius)
            some.push_back(values[i]);
    }
    return mean_and_deviation(some);
}

double convergence_order(const std::vector<double>& lengths, const std::vector<double>& errors) {
    Slope slope;
    for (std::size_t n = 0; n < lengths.size(); ++n)
        slope.add(std::log(lengths[n]), std::log(errors[n]));
    return slope.value();
}

double mode_moment(const Positions& positions, int mode, int dimension) {
    const Place center = center_of(positions);
    double sum = 0;
    for (const Place& place : positions)
        sum += harmonic(difference_of(place, center), mode, dimension).value;
    return sum / static_cast<double>(positions.size());
}

Positions in_mode(Positions positions, int mode, double amplitude, double radius, int dimension) {
    const double scale = amplitude / (mode * std::pow(radius, mode - 2));
    for (Place& place : positions) {
        const Place gradient = harmonic(place, mode, dimension).gradient;
        for (int axis = 0; axis < dimension; ++axis)
            place[axis] += scale * gradient[axis];
    }
    return positions;
}

Swing swing_of(const std::vector<double>& times, const std::vector<double>& values) {
    std::vector<double> zeros;
    std::vector<double> peaks; // of |value|, after each zero
    for (std::size_t n = 1; n < values.size(); ++n) {
        if (values[n - 1] * values[n] < 0) {
            const double share = values[n - 1] / (values[n - 1] - values[n]);
            zeros.push_back(times[n - 1] + share * (times[n] - times[n - 1]));
            peaks.push_back(0);
        }
        if (!peaks.empty())
            peaks.back() = std::max(peaks.back(), std::abs(values[n]));
    }
    Swing swing;
    swing.zeros = zeros.size();
    if (zeros.size() < 3)
        return swing;
    const std::size_t periods = (zeros.size() - 1) / 2;
    swing.period = (zeros[2 * periods] - zeros[0]) / static_cast<double>(periods);
    if (zeros.size() > 3) // the last peak may be cut short
        swing.left = peaks[2] / peaks[0];
    return swing;
}

int local_maxima(const std::vector<double>& values, double share) {
    if (values.empty())
        return 0;
    const double rise = share * *std::max_element(values.begin(), values.end());
    int maxima = 0;
    bool rising = false;
    double lowest = values[0];
    double highest = values[0];
    for (const double value : values) {
        if (rising) {
            highest = std::max(highest, value);
            if (highest - value > rise) {
                ++maxima;
                rising = false;
                lowest = value;
            }
        } else {
            lowest = std::min(lowest, value);
            if (value - lowest > rise) {
                rising = true;
                highest = value;
            }
        }
    }
    return maxima;
}

std::optional<double> stays_below(const std::vector<double>& times,
                                  const std::vector<double>& values, double limit) {
    std::optional<double> since;
    for (std::size_t n = 0; n < values.size(); ++n) {
        if (values[n] > limit)
            since.reset();
        else if (!since)
            since = times[n];
    }
    return since;
}

double share_closer(const Positions& positions, double distance) {
    const NeighborLists lists = find_neighbors(positions, distance);
    std::size_t close = 0;
    for (std::size_t i = 0; i < positions.size(); ++i)
        close += lists.offsets[i + 1] > lists.offsets[i] ? 1 : 0;
    return static_cast<double>(close) / static_cast<double>(positions.size());
}

} // namespace meniscus
