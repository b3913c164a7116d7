// What the runs of the drop formation say together: by model and solver, beside the paper's times,
// and finding by finding. Axes are "solver" and "force", whose values are "MODEL, COEFFICIENT".
#pragma once

#include "framework/study.hpp"

namespace meniscus {

/// Eq. 13 of Huber et al. and the same of forces: means over a model's coefficients, with the
/// standard deviation among them.
Table table_of_models(const Json& result);

/// How the largest coefficient of each model ends.
Table table_of_ends(const Json& result);

/// Seconds for one simulated second with IISPH, and what the paper has over its Becker 2007.
Table table_of_times(const Json& result, const Json& reference);

/// The paper's findings.
Table table_of_drop_findings(const Json& result, const Json& reference);

/// Whether no other run of the same model and solver has a larger coefficient.
bool is_largest_coefficient(const Json& result, const Json& run);

} // namespace meniscus
