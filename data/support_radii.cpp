#include "support_radii.hpp"

#include <algorithm>
#include <utility>

namespace meniscus {

SupportRadii::SupportRadii(std::vector<double> radii, const std::vector<std::uint8_t>& valid)
    : smallest(0), largest(0) {
    bool is_first = true;
    bool vary = false;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        if (!valid.empty() && valid[i] == 0)
            continue;
        smallest = is_first ? radii[i] : std::min(smallest, radii[i]);
        largest = is_first ? radii[i] : std::max(largest, radii[i]);
        vary = vary || radii[i] != smallest || radii[i] != largest; // so is NaN
        is_first = false;
    }
    if (is_first && !radii.empty())
        smallest = largest = radii[0];
    if (vary)
        each = std::move(radii);
}

} // namespace meniscus
