// How much the neighbors lie on one side, whatever their distance: the length of the mean of the
// unit vectors towards them. 0 inside, up to 1 where all lie in one direction.
#pragma once

#include "feature_neighbor.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

struct DirectionOffset {
    static constexpr const char* name = "direction_offset";
    static constexpr const char* meaning = "|sum_j m_j (x_j - x_i) / r_ij| / sum_j m_j";
    static constexpr double float_error = 1e-5;
    static constexpr bool is_fraction = true;
    static constexpr bool is_over_kernel = false;
    static constexpr bool is_eigenvalue = false;
    template <int Dimension>
    static constexpr int terms = mean_vector_terms<Dimension>;

    template <class Real, class Number, int Dimension>
    MENISCUS_HOST_DEVICE MENISCUS_INLINE static void
    add(const FeatureNeighbor<Number, Dimension>& neighbor, Number* sums) {
        add_to_mean_vector(neighbor, neighbor.mass / neighbor.distance(), sums);
    }
    template <int Dimension, class Real>
    MENISCUS_HOST_DEVICE static Real value(const Real* sums) {
        return length_of_mean_vector<Dimension>(sums);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
