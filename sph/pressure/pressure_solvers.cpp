#include "pressure_solvers.hpp"

namespace meniscus {

const std::vector<PressureSolverRow>& pressure_solvers() {
    static const std::vector<PressureSolverRow> rows = PressureSolvers<float, 3>::rows();
    return rows;
}

} // namespace meniscus
