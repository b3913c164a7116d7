// The two features where every particle has a support radius of its own (support_radius.hpp): the
// sums of features.hpp with each pair measured in its mean radius h_ij = (h_i + h_j) / 2. With
//     u_j = (x_j - x_i) / h_ij,   w_j = m_j / h_ij^D
// the mass offset is x = |sum_j w_j u_j| / sum_j w_j, and the neighbor count y = sum_j (h_j /
// h_ij)^D, a real number. In the dense half of a fluid of two resolutions particles are small and
// many, in the other large and few: either half then pulls and counts the same. Masses should be
// given; where none are, all are taken to be equal.
#pragma once

#include "features.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The sums over a particle's neighbors in units of h_i: `moment` holds w_j u_j and `mass` w_j,
/// both times h_i^D and so in kg. Its support radius, where a function asks for one, is 1.
template <class Real, int Dimension>
using ScaledFeatureSum = FeatureSum<Real, Dimension, Real>;

/// Adds particle j at `displacement` = x_j - x_i (m) with mass m_j (kg) to the sums of particle i.
/// `range` is that of support radius 1; outside it (i itself, too close, beyond h_ij) it adds
/// nothing.
template <class Real, int Dimension, class Vector>
void add_scaled(const Vector& displacement, Real neighbor_mass, std::size_t i, std::size_t j,
                const VaryingRadii<Real>& radii, const NeighborRange<Real>& range,
                ScaledFeatureSum<Real, Dimension>& sum) {
    visit_if_in_range<Dimension>(displacement, neighbor_mass, i, j, radii, range,
                                 [&](const FeatureNeighbor<Real, Dimension>& neighbor) {
                                     sum.add_counted(neighbor.step, neighbor.mass, neighbor.count);
                                 });
}

/// Adds the boundary particles around i, after its fluid neighbors, each measured in its radius.
template <class Real, int Dimension, class Boundary>
void add_scaled_boundary(const Boundary& boundary, std::size_t i, const VaryingRadii<Real>& radii,
                         const NeighborRange<Real>& range, ScaledFeatureSum<Real, Dimension>& sum) {
    boundary(i, [&](std::size_t, const auto& displacement, Real weight) {
        const Real inverse = radii.inverse_of_pair(i, i);
        Coordinates<Real, Dimension> step;
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            step[axis] = displacement[axis] * inverse;
        sum.add_boundary(step, squared_length<Real, Dimension>(step), weight, range);
    });
}

/// The sums of particle i over any neighborhood view; `range` is that of support radius 1.
template <class Real, int Dimension, class View>
ScaledFeatureSum<Real, Dimension> sum_features(const View& view, std::size_t i,
                                               const VaryingRadii<Real>& radii,
                                               const NeighborRange<Real>& range) {
    ScaledFeatureSum<Real, Dimension> sum;
    view(i, [&](std::size_t j, const auto& displacement, Real mass) {
        add_scaled(displacement, mass, i, j, radii, range, sum);
    });
    return sum;
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
