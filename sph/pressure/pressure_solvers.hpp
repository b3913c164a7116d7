// The list of pressure solvers: a new one is its file, included here, and its place in the list.
#pragma once

#include "dfsph.hpp"
#include "iisph.hpp"
#include "pcisph.hpp"
#include "wcsph.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

template <class Real, int Dimension>
using PressureSolvers = MethodList<PressureSolver<Real, Dimension>, //
                                   Wcsph<Real, Dimension>,          //
                                   Pcisph<Real, Dimension>,         //
                                   Iisph<Real, Dimension>,          //
                                   Dfsph<Real, Dimension>>;

/// The solver that the options name. Throws InputError where there is none of that name.
template <class Real, int Dimension>
std::unique_ptr<PressureSolver<Real, Dimension>> make_solver(const PressureOptions& options) {
    return PressureSolvers<Real, Dimension>::make(pressure_solver_place(options.solver), options);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
