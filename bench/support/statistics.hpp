// Means, deviations and slopes of what is measured.
#pragma once

#include <cmath>

namespace meniscus {

/// Mean and deviation of weighed values.
struct Spread {
    double weights = 0;
    double sum = 0;
    double squares = 0;

    void add(double value, double weight = 1) {
        weights += weight;
        sum += weight * value;
        squares += weight * value * value;
    }
    void add(const Spread& other) {
        weights += other.weights;
        sum += other.sum;
        squares += other.squares;
    }
    /// NaN where nothing was added.
    [[nodiscard]] double mean() const { return sum / weights; }
    [[nodiscard]] double deviation() const {
        return std::sqrt(std::fmax(squares / weights - mean() * mean(), 0));
    }
    [[nodiscard]] double root_mean_square() const { return std::sqrt(squares / weights); }
};

/// Slope of the least-squares line through points.
struct Slope {
    double count = 0, x_sum = 0, y_sum = 0, xx_sum = 0, xy_sum = 0;

    void add(double x, double y) {
        count += 1;
        x_sum += x, y_sum += y, xx_sum += x * x, xy_sum += x * y;
    }
    [[nodiscard]] double value() const {
        return (count * xy_sum - x_sum * y_sum) / (count * xx_sum - x_sum * x_sum);
    }
};

} // namespace meniscus
