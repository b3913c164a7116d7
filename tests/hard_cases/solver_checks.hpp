// What the pressure solvers, the models of surface tension and the step make of hard cases. A check
// is one method on one case.
#pragma once

#include "checks.hpp"
#include "solver_runs.hpp"

#include <vector>

namespace meniscus::test {

/// Ten steps of a particle set under our surface tension; `method` is of the case's dimension.
Check check_set(const HardCase& hard_case, const Method& method);

/// Particles that must stay or part, states far from rest, momentum, and that neither where the
/// fluid lies nor its scale nor the order of its particles matters.
std::vector<Check> check_motion(const Method& method);

/// A dam break ("dam_break") or a droplet ("droplet") on its way, a hundred steps each of 1 to 1e-5
/// of the stable length, and ten times as many of a tenth of the length.
std::vector<Check> check_step_lengths(const std::string& flow, const Method& method);

/// The same flow for the time of twenty stable steps in steps of a thousandth, beside stable ones.
Check check_long_run(const std::string& flow, const Method& method);

/// What no run can start from or go on with, and the message that must say so.
std::vector<Check> check_refusals();

} // namespace meniscus::test
