#include "support_radii.hpp"

#include <algorithm>
#include <utility>

namespace meniscus {

SupportRadii::SupportRadii(std::vector<double> radii, const std::vector<std::uint8_t>& valid)
    : min(0), max(0) {
    bool is_first = true;
    bool vary = false;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        if (!valid.empty() && valid[i] == 0)
            continue;
        min = is_first ? radii[i] : std::min(min, radii[i]);
        max = is_first ? radii[i] : std::max(max, radii[i]);
        vary = vary || radii[i] != min || radii[i] != max; // so is NaN
        is_first = false;
    }
    if (is_first && !radii.empty())
        min = max = radii[0];
    if (vary)
        each = std::move(radii);
}

} // namespace meniscus
