// Between the options of meniscus.h and those of C++, member by member as the table has them
// (runtime/surface/option_table.hpp).
#pragma once

#include "meniscus.h"

#include <meniscus/runtime/surface/option_table.hpp>

namespace meniscus {

/// As C has them, with no curvature map and all threads.
meniscus_options to_c(const SurfaceTensionOptions& options);

/// As C++ has them; not checked. The curvature map is taken for one of that dimension.
SurfaceTensionOptions from_c(const meniscus_options& options, int dimension);

} // namespace meniscus
