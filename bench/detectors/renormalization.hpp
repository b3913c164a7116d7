// The renormalization matrix of a particle, M = sum_j V_j grad W_ij (x_j - x_i)^T: close to the
// identity where neighbors lie all around, far from it where a side is missing. Its smallest
// eigenvalue (Marrone et al. 2010, who call its inverse the matrix) and its trace, the divergence
// of position (Lee et al. 2008), are what free-surface solvers find their surface by. W is the
// cubic spline that ends at the support radius, as it is for the volumes.
#pragma once

#include "neighbor_packs.hpp"

#include <meniscus/classifier/detectors/cones.hpp>
#include <meniscus/runtime/math/cubic_spline.hpp>

#include <Eigen/Eigenvalues>

namespace meniscus {

/// The cubic spline of radius 1 (Monaghan 1992) for squared distances.
template <class Real, int Dimension>
struct SplinePack {
    using Pieces = CubicSplinePieces<Real, Pack<Real>>;
    static constexpr Real scale = static_cast<Real>(cubic_spline_scale<Dimension>);

    MENISCUS_INLINE static Pack<Real> value(const Pack<Real>& distance_squared) {
        return Pieces(square_root(distance_squared)).value(scale);
    }

    /// -W'(q) / q, not negative; 0 where q is 0.
    MENISCUS_INLINE static Pack<Real> slope(const Pack<Real>& distance_squared) {
        const Pack<Real> distance = square_root(distance_squared);
        const Pack<Real> min = all_lanes<Pack<Real>>(Real(1e-6));
        return -Pieces(distance).slope(scale) / (distance > min ? distance : min);
    }
};

/// What all particles of a state share.
template <class Real, int Dimension>
struct GradientSums {
    const FluidState<Real>& state;
    Real per_radius_squared = 1 / (state.support_radius * state.support_radius);
    /// V_j over h^(D + 2), by which W'(q) / q of the kernel of radius 1 becomes V_j W' / r.
    Real scale =
        state.particle_volume * per_radius_squared /
        (Dimension == 3 ? state.support_radius * state.support_radius * state.support_radius
                        : state.support_radius * state.support_radius);

    /// Calls add(pairs, slope), V_j grad_i W_ij being scale * slope * step, slopes not negative.
    template <class Add>
    MENISCUS_INLINE void visit(std::size_t i, Add&& add) const {
        visit_packs<Dimension>(state, i, [&](const PairPack<Real, Dimension>& pairs) {
            add(pairs, SplinePack<Real, Dimension>::slope(pairs.squared * per_radius_squared));
        });
    }
};

template <class Real, int Dimension>
using SquareMatrix = Eigen::Matrix<Real, Dimension, Dimension>;

/// M, and a gradient by the same loop; both zero for a particle that has no neighbor.
template <class Real, int Dimension>
struct Renormalization {
    SquareMatrix<Real, Dimension> matrix;
    Vector<Real, Dimension> gradient; ///< sum_j f_j V_j grad W_ij, f_j what `values` says
};

/// Of particle i. `values(pairs)` is f at the neighbors.
template <class Real, int Dimension, class Values>
MENISCUS_INLINE Renormalization<Real, Dimension>
renormalization(const GradientSums<Real, Dimension>& sums, std::size_t i, Values&& values) {
    Pack<Real> matrix[Dimension][Dimension] = {};
    Pack<Real> gradient[Dimension] = {};
    sums.visit(i, [&](const auto& pairs, const Pack<Real>& slope) {
        const Pack<Real> value = values(pairs);
        for (int row = 0; row < Dimension; ++row) {
            const Pack<Real> along = slope * pairs.step[row];
            gradient[row] += value * along;
            for (int column = 0; column <= row; ++column)
                matrix[row][column] += along * pairs.step[column];
        }
    });
    Renormalization<Real, Dimension> result;
    for (int row = 0; row < Dimension; ++row) {
        result.gradient[row] = sums.scale * sum_of_lanes(gradient[row]);
        for (int column = 0; column <= row; ++column)
            result.matrix(row, column) = result.matrix(column, row) =
                sums.scale * sum_of_lanes(matrix[row][column]);
    }
    return result;
}

/// M of particle i alone.
template <class Real, int Dimension>
MENISCUS_INLINE SquareMatrix<Real, Dimension>
renormalization_matrix(const GradientSums<Real, Dimension>& sums, std::size_t i) {
    return renormalization(sums, i, [](const auto&) { return Pack<Real>{}; }).matrix;
}

/// The trace of M, the divergence of position: the dimension where neighbors lie all around.
template <class Real, int Dimension>
MENISCUS_INLINE Real position_divergence(const GradientSums<Real, Dimension>& sums, std::size_t i) {
    Pack<Real> total{};
    sums.visit(i,
               [&](const auto& pairs, const Pack<Real>& slope) { total += slope * pairs.squared; });
    return sums.scale * sum_of_lanes(total);
}

/// Of a symmetric matrix, in closed form.
template <class Real, int Dimension>
Real min_eigenvalue(const SquareMatrix<Real, Dimension>& matrix) {
    Eigen::SelfAdjointEigenSolver<SquareMatrix<Real, Dimension>> solver;
    return solver.computeDirect(matrix, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

} // namespace meniscus
