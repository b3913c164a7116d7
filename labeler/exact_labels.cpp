#include "exact_labels.hpp"

namespace meniscus {

std::unique_ptr<ExactLabels> exact_labels() {
    if (auto widest = exact_labels_avx512())
        return widest;
    if (auto wide = exact_labels_avx2())
        return wide;
    return exact_labels_baseline();
}

} // namespace meniscus
