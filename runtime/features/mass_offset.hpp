// The feature x of the paper (2020, eq. 1): how far the neighbors' center of mass lies off the
// particle, in support radii. 0 inside a full neighborhood, up to 1 where all neighbors lie on one
// side.
#pragma once

#include "feature_neighbor.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

struct MassOffset {
    static constexpr const char* name = "mass_offset";
    static constexpr const char* meaning = "|sum_j m_j (x_j - x_i)| / (h sum_j m_j)";
    static constexpr double float_error = 5e-6;
    static constexpr bool is_fraction = true;
    static constexpr bool is_over_kernel = false;
    static constexpr bool is_eigenvalue = false;
    template <int Dimension>
    static constexpr int terms = mean_vector_terms<Dimension>;

    template <class Real, class Number, int Dimension>
    MENISCUS_HOST_DEVICE MENISCUS_INLINE static void
    add(const FeatureNeighbor<Number, Dimension>& neighbor, Number* sums) {
        add_to_mean_vector(neighbor, neighbor.mass, sums);
    }
    template <int Dimension, class Real>
    MENISCUS_HOST_DEVICE static Real value(const Real* sums) {
        return length_of_mean_vector<Dimension>(sums);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
