// Exact coverage for the labeler: runtime/exact_coverage.hpp, compiled for several instruction sets
// of which the best is picked at run time.
#pragma once

#include <meniscus/runtime/exact_coverage.hpp>

namespace meniscus {

/// What the caps of `coverage` leave uncovered of the sphere, or of the circle in two dimensions.
UncoveredPart exact_uncovered_part(int dimension, ExactCoverage& coverage);

/// True where that is more than zero_uncovered_fraction.
bool is_exactly_uncovered(int dimension, ExactCoverage& coverage);

} // namespace meniscus
