// The feature y of the paper (2020, section 3.1): how many neighbors count. A whole number, unless
// radii vary: then each neighbor counts by its own size. The bound of its error is that of the
// rounding of a line's constant up to 2,000.
#pragma once

#include "feature_neighbor.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

struct NeighborCount {
    static constexpr const char* name = "neighbor_count";
    static constexpr const char* meaning = "number of neighbors";
    static constexpr double float_error = 2.5e-4;
    static constexpr bool is_fraction = false;
    static constexpr bool is_over_kernel = false;
    static constexpr bool is_eigenvalue = false;
    template <int Dimension>
    static constexpr int terms = 1;

    template <class Real, class Number, int Dimension>
    MENISCUS_HOST_DEVICE MENISCUS_INLINE static void
    add(const FeatureNeighbor<Number, Dimension>& neighbor, Number* sums) {
        sums[0] += neighbor.count;
    }
    template <int Dimension, class Real>
    MENISCUS_HOST_DEVICE static Real value(const Real* sums) {
        return sums[0];
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
