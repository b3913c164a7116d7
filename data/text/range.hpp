// A closed range of numbers, such as what was seen in training.
#pragma once

namespace meniscus {

struct Range {
    double min = 0;
    double max = 0;
};

} // namespace meniscus
