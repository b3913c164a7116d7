#include "tension_models.hpp"

namespace meniscus {

const std::vector<TensionModelRow>& tension_models() {
    static const std::vector<TensionModelRow> rows = TensionModels<float, 3>::rows();
    return rows;
}

} // namespace meniscus
