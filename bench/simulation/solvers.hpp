// The pressure solvers as the tables name them.
#pragma once

#include <string_view>

namespace meniscus {

struct NamedSolver {
    const char* name;
    std::string_view kind; ///< in scenes
};

inline constexpr NamedSolver all_solvers[] = {
    {"WCSPH", "wcsph"}, {"PCISPH", "pcisph"}, {"IISPH", "iisph"}, {"DFSPH", "dfsph"}};

} // namespace meniscus
