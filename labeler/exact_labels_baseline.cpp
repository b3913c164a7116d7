#include "exact_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

#include "exact_labels_kernel.hpp"

namespace meniscus {

std::unique_ptr<ExactLabels> exact_labels_baseline() {
    return make_exact_labels();
}

} // namespace meniscus
