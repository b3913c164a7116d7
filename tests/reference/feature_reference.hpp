// All features of the list, written down as they are defined, in double: what the runtime's own
// sums are held against.
#pragma once

#include <meniscus/runtime/features/list.hpp>
#include <meniscus/runtime/math/angles.hpp>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace meniscus::test {

/// A particle around the one whose features are asked for.
template <int Dimension>
struct ReferenceNeighbor {
    Eigen::Matrix<double, Dimension, 1> step; ///< x_j - x_i over the mean radius of the pair
    double mass = 1;                          ///< m_j
    double own_radius = 1;                    ///< h_i and h_j over that mean radius
    double its_radius = 1;
};

inline double spline(double q, int dimension) {
    const double scale = dimension == 2 ? 40 / (7 * pi) : 8 / pi;
    return scale * (q <= 0.5 ? 1 - 6 * q * q + 6 * q * q * q : 2 * std::pow(1 - q, 3));
}

inline double spline_slope(double q, int dimension) {
    const double scale = dimension == 2 ? 40 / (7 * pi) : 8 / pi;
    return scale * (q <= 0.5 ? 18 * q * q - 12 * q : -6 * (1 - q) * (1 - q));
}

/// By name. Neighbors from 0.2 to 1 radius away count, less the band.
template <int Dimension>
std::map<std::string, double>
features_by_definition(const std::vector<ReferenceNeighbor<Dimension>>& around) {
    using Vector = Eigen::Matrix<double, Dimension, 1>;
    using Matrix = Eigen::Matrix<double, Dimension, Dimension>;
    Vector offset = Vector::Zero(), direction = offset, squared = offset;
    Matrix gradients = Matrix::Zero(), directions = gradients, moments = gradients;
    double count = 0;
    double mass = 0;
    double kernel = spline(0, Dimension);
    for (const auto& neighbor : around) {
        const double q = neighbor.step.norm();
        if (q <= 0.2 * (1 + neighbor_band) || q >= 1 - neighbor_band)
            continue;
        const double weight = neighbor.mass * std::pow(neighbor.own_radius, Dimension);
        const double size = std::pow(neighbor.its_radius, Dimension);
        const Matrix square = neighbor.step * neighbor.step.transpose();
        mass += weight;
        count += size;
        kernel += size * spline(q, Dimension);
        offset += weight * neighbor.step;
        direction += weight * neighbor.step / q;
        squared += weight * neighbor.step * q;
        gradients -= size * spline_slope(q, Dimension) / q * square;
        directions += size * square / (q * q);
        moments += size * square;
    }
    const double per_mass = mass > 0 ? 1 / mass : 0;
    const auto min = [](const Matrix& matrix) {
        return Eigen::SelfAdjointEigenSolver<Matrix>(matrix).eigenvalues()[0];
    };
    return {{"mass_offset", offset.norm() * per_mass},
            {"neighbor_count", count},
            {"direction_offset", direction.norm() * per_mass},
            {"squared_offset", squared.norm() * per_mass},
            {"kernel_sum", kernel},
            {"gradient_eigenvalue", min(gradients)},
            {"position_divergence", gradients.trace()},
            {"direction_eigenvalue", min(directions)},
            {"moment_eigenvalue", min(moments)}};
}

} // namespace meniscus::test
