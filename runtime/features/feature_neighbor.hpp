// A neighbor as features see it, the same for one support radius and for radii that vary: places in
// radii of the pair, and two weights. A feature is a struct (one file each, mass_offset.hpp to
// moment_eigenvalue.hpp, listed in list.hpp) with
//     name, meaning       for files, options and tables
//     float_error         bound of what float adds to its value
//     is_fraction         whether it lies between 0 and 1 by itself
//     is_over_kernel      whether it is a sum over a kernel: h^D over a particle's volume inside
//     is_eigenvalue       whether it is the smallest eigenvalue of the matrix of its sums
//     terms<Dimension>    how many sums it needs
//     add(neighbor, sums) what a neighbor adds to them
//     value(sums)         its value, without unit
//
// All are sums over the neighbors that NeighborRange lets count, independent of their order, of
// units and of rotations. Where radii vary, means weigh by mass and sums by the neighbor's own
// size, which is what either half of a fluid of two resolutions then agrees on.
#pragma once

#include "../math/coordinates.hpp"
#include "../math/min_eigenvalue.hpp"
#include "../neighbors/neighborhood.hpp"
#include "../neighbors/support_radius.hpp"

#include <cmath>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The square root, lane by lane; specialize it for vectors.
template <class Number>
struct SquareRoot {
    MENISCUS_HOST_DEVICE static Number of(Number a) { return std::sqrt(a); }
};

/// `Number` is float, double or a vector of them. Where lanes do not count, weights are 0 and the
/// rest is any that is finite, the distance above 0.
template <class Number, int Dimension>
struct FeatureNeighbor {
    Number step[axis_count<Dimension>]; ///< (x_j - x_i) / h_ij
    Number squared;                     ///< its squared length
    Number mass;                        ///< m_j (h_i / h_ij)^D in kg: the weight in means
    Number count; ///< (h_j / h_ij)^D: the weight in sums; 1 where radii do not vary

    [[nodiscard]] MENISCUS_HOST_DEVICE MENISCUS_INLINE Number distance() const {
        return SquareRoot<Number>::of(squared);
    }
};

/// Squared length of a displacement.
template <class Real, int Dimension, class Vector>
MENISCUS_HOST_DEVICE Real squared_length(const Vector& displacement) {
    Real sum = 0;
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        sum += displacement[axis] * displacement[axis];
    return sum;
}

/// Which neighbors count, of particles with these radii and spheres of radius ratio r2 / r1. In m^2
/// for one radius; where radii vary, in squared radii of the pair.
template <class Real>
MENISCUS_HOST_DEVICE NeighborRange<Real> range_of(const UniformRadius<Real>& radii,
                                                  double radius_ratio) {
    return neighbor_range<Real>(static_cast<double>(radii.radius), radius_ratio);
}
template <class Real>
MENISCUS_HOST_DEVICE NeighborRange<Real> range_of(const VaryingRadii<Real>& /*radii*/,
                                                  double radius_ratio) {
    return neighbor_range<Real>(1, radius_ratio);
}

/// Calls visit(FeatureNeighbor) for the particle j at `displacement` = x_j - x_i (m) of mass m_j
/// (kg), unless it lies outside `range` (i itself, too close, beyond h), which is range_of(radii).
template <int Dimension, class Real, class Vector, class Visit>
MENISCUS_HOST_DEVICE void visit_if_in_range(const Vector& displacement, Real mass,
                                            std::size_t /*i*/, std::size_t /*j*/,
                                            const UniformRadius<Real>& radii,
                                            const NeighborRange<Real>& range, Visit&& visit) {
    const Real squared = squared_length<Real, Dimension>(displacement);
    if (!range.contains(squared))
        return;
    FeatureNeighbor<Real, Dimension> neighbor;
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        neighbor.step[axis] = displacement[axis] * radii.inverse;
    neighbor.squared = squared * radii.inverse * radii.inverse;
    neighbor.mass = mass;
    neighbor.count = 1;
    visit(neighbor);
}

template <int Dimension, class Real>
MENISCUS_HOST_DEVICE Real to_the_dimension(Real value) {
    return Dimension == 2 ? value * value : value * value * value;
}

template <int Dimension, class Real, class Vector, class Visit>
MENISCUS_HOST_DEVICE void visit_if_in_range(const Vector& displacement, Real mass, std::size_t i,
                                            std::size_t j, const VaryingRadii<Real>& radii,
                                            const NeighborRange<Real>& range, Visit&& visit) {
    const Real inverse = radii.inverse_of_pair(i, j);
    FeatureNeighbor<Real, Dimension> neighbor;
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        neighbor.step[axis] = displacement[axis] * inverse;
    neighbor.squared = squared_length<Real, Dimension>(neighbor.step);
    if (!range.contains(neighbor.squared))
        return;
    // h_j / h_ij = 1 + excess and h_i / h_ij = 1 - excess, both exactly 1 where radii are equal.
    const Real excess = (radii.of(j) - radii.of(i)) * inverse / 2;
    neighbor.mass = mass * to_the_dimension<Dimension>(1 - excess);
    neighbor.count = to_the_dimension<Dimension>(1 + excess);
    visit(neighbor);
}

/// What features have in common: a weighted mean of vectors, Dimension sums and that of the masses,
template <int Dimension>
inline constexpr int mean_vector_terms = Dimension + 1;

template <class Number, int Dimension>
MENISCUS_HOST_DEVICE MENISCUS_INLINE void
add_to_mean_vector(const FeatureNeighbor<Number, Dimension>& neighbor, const Number& weight,
                   Number* sums) {
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        sums[axis] += weight * neighbor.step[axis];
    sums[Dimension] += neighbor.mass;
}

/// and its length; 0 where there is no neighbor.
template <int Dimension, class Real>
MENISCUS_HOST_DEVICE Real length_of_mean_vector(const Real* sums) {
    if (sums[Dimension] == 0)
        return 0;
    Real mean[axis_count<Dimension>]; // divided first, as masses may be tiny
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        mean[axis] = sums[axis] / sums[Dimension];
    return std::sqrt(squared_length<Real, Dimension>(mean));
}

/// And a sum of matrices step step^T, on and below its diagonal, for min_eigenvalue().
template <int Dimension>
inline constexpr int matrix_terms = Dimension*(Dimension + 1) / 2;

template <class Number, int Dimension>
MENISCUS_HOST_DEVICE MENISCUS_INLINE void
add_to_matrix(const FeatureNeighbor<Number, Dimension>& neighbor, const Number& weight,
              Number* sums) {
    for (std::size_t row = 0; row < Dimension; ++row) {
        const Number along = weight * neighbor.step[row];
        for (std::size_t column = 0; column <= row; ++column)
            *sums++ += along * neighbor.step[column];
    }
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
