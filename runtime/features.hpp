// The two features that tell surface particles from others (2020 paper, section 3.1, eq. 1): how
// far the neighborhood's center of mass lies off the particle, and how many neighbors it has. Both
// come from sums over the neighbors that any SPH step visits anyway, so a host can add them up in
// its density loop: one FeatureSum a particle, one add() a neighbor.
#pragma once

#include "neighborhood.hpp"

#include <cmath>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The sums over a particle's neighbors. Start from a value-initialized one.
template <class Real, int Dimension>
struct FeatureSum {
    Real moment[Dimension] = {}; ///< sum of m_j (x_j - x_i) in kg m
    Real mass = 0;               ///< sum of m_j in kg
    int count = 0;               ///< number of neighbors

    /// Adds a particle at `displacement` = x_j - x_i (m), whose squared length (m^2) the caller
    /// has, with mass m_j (kg). Outside the range (itself, too close, beyond h) it adds nothing.
    template <class Vector>
    void add(const Vector& displacement, Real distance_squared, Real neighbor_mass,
             const NeighborRange<Real>& range) {
        const bool counts = range.contains(distance_squared);
        const Real weight = counts ? neighbor_mass : Real(0);
        for (int axis = 0; axis < Dimension; ++axis)
            moment[axis] += weight * displacement[axis];
        mass += weight;
        count += static_cast<int>(counts);
    }

    /// As above, with the squared length worked out here.
    template <class Vector>
    void add(const Vector& displacement, Real neighbor_mass, const NeighborRange<Real>& range) {
        Real distance_squared = 0;
        for (int axis = 0; axis < Dimension; ++axis)
            distance_squared += displacement[axis] * displacement[axis];
        add(displacement, distance_squared, neighbor_mass, range);
    }
};

/// Feature x (eq. 1): |sum_j m_j (x_j - x_i)| / (h sum_j m_j), without unit, between 0 and 1; 0
/// where there is no neighbor.
template <class Real, int Dimension>
Real mass_offset(const FeatureSum<Real, Dimension>& sum, Real support_radius) {
    if (sum.count == 0)
        return 0;
    Real moment_squared = 0;
    for (int axis = 0; axis < Dimension; ++axis)
        moment_squared += sum.moment[axis] * sum.moment[axis];
    return std::sqrt(moment_squared) / (support_radius * sum.mass);
}

/// The sums of particle i over a neighborhood view.
template <class Real, int Dimension, class View>
FeatureSum<Real, Dimension> sum_features(const View& view, std::size_t i,
                                         const NeighborRange<Real>& range) {
    FeatureSum<Real, Dimension> sum;
    view(i, [&](std::size_t, const auto& displacement, Real mass) {
        sum.add(displacement, mass, range);
    });
    return sum;
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
