// The direction eigenvalue with distant neighbors weighing more: the smallest eigenvalue of the
// summed second moments, in support radii.
#pragma once

#include "feature_neighbor.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

struct MomentEigenvalue {
    static constexpr const char* name = "moment_eigenvalue";
    static constexpr const char* meaning =
        "smallest eigenvalue of sum_j (x_j - x_i)(x_j - x_i)^T / h^2";
    static constexpr double float_error = 2e-4;
    static constexpr bool is_fraction = false;
    static constexpr bool is_over_kernel = false;
    static constexpr bool is_eigenvalue = true;
    template <int Dimension>
    static constexpr int terms = matrix_terms<Dimension>;

    template <class Real, class Number, int Dimension>
    MENISCUS_HOST_DEVICE MENISCUS_INLINE static void
    add(const FeatureNeighbor<Number, Dimension>& neighbor, Number* sums) {
        add_to_matrix<Number, Dimension>(neighbor, neighbor.count, sums);
    }
    template <int Dimension, class Real>
    MENISCUS_HOST_DEVICE static Real value(const Real* sums) {
        return min_eigenvalue<Dimension>(sums);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
