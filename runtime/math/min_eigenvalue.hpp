// The smallest eigenvalue of a symmetric matrix of two or three rows, in closed form. In double
// whatever the entries are: near two equal eigenvalues the closed form loses half of the digits.
#pragma once

#include "../simd/instruction_set.hpp"
#include "angles.hpp"
#include "coordinates.hpp"

#include <cmath>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

namespace eigenvalue {

MENISCUS_HOST_DEVICE inline double min_of(const double (&m)[3]) {
    const double half_difference = (m[0] - m[2]) / 2;
    return (m[0] + m[2]) / 2 - std::sqrt(half_difference * half_difference + m[1] * m[1]);
}

/// By the angle of the characteristic polynomial's roots (Smith 1961).
MENISCUS_HOST_DEVICE inline double min_of(const double (&m)[6]) {
    const double mean = (m[0] + m[2] + m[5]) / 3;
    const double a = m[0] - mean;
    const double b = m[2] - mean;
    const double c = m[5] - mean;
    const double beside = m[1] * m[1] + m[3] * m[3] + m[4] * m[4];
    const double squared = (a * a + b * b + c * c + 2 * beside) / 6;
    if (squared == 0) // a multiple of the identity
        return mean;
    const double size = std::sqrt(squared);
    const double determinant = a * (b * c - m[4] * m[4]) - m[1] * (m[1] * c - m[4] * m[3]) +
                               m[3] * (m[1] * m[4] - b * m[3]);
    double cosine = determinant / (2 * squared * size);
    cosine = cosine < -1 ? -1 : cosine > 1 ? 1 : cosine; // beyond by rounding
    const double angle = arctangent(std::sqrt((1 - cosine) * (1 + cosine)), cosine);
    return mean + 2 * size * cosine_and_sine_of_turn((angle / (2 * pi) + 1) / 3)[0];
}

} // namespace eigenvalue

/// Of the matrix whose entries on and below the diagonal stand in `lower`, row by row: 3 of them in
/// two dimensions, 6 in three. In their unit; not a number where one of them is none.
template <int Dimension, class Real>
MENISCUS_HOST_DEVICE Real min_eigenvalue(const Real* lower) {
    static_assert(Dimension == 2 || Dimension == 3, "matrices have two or three rows");
    double entries[axis_count<Dimension*(Dimension + 1) / 2>];
    for (double& entry : entries)
        entry = static_cast<double>(*lower++);
    return static_cast<Real>(eigenvalue::min_of(entries));
}

/// Whether it is above `limit`, without finding it: where the matrix less the limit times the
/// identity is positive definite, which the pivots of its elimination tell. False where an entry is
/// not a number, unless the compiler may assume that there is none.
template <int Dimension, class Real>
MENISCUS_HOST_DEVICE bool is_min_eigenvalue_above(const Real* lower, Real limit) {
    static_assert(Dimension == 2 || Dimension == 3, "matrices have two or three rows");
    double m[axis_count<Dimension>][axis_count<Dimension>];
    for (std::size_t row = 0; row < Dimension; ++row)
        for (std::size_t column = 0; column <= row; ++column)
            m[row][column] = static_cast<double>(*lower++);
    for (std::size_t row = 0; row < Dimension; ++row)
        m[row][row] -= static_cast<double>(limit);
    for (std::size_t pivot = 0; pivot < Dimension; ++pivot) {
        if (!(m[pivot][pivot] > 0))
            return false;
        for (std::size_t row = pivot + 1; row < Dimension; ++row) {
            const double factor = m[row][pivot] / m[pivot][pivot];
            for (std::size_t column = pivot + 1; column <= row; ++column)
                m[row][column] -= factor * m[column][pivot];
        }
    }
    return true;
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
