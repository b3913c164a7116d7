// The log of a run: one row of a CSV file for each frame, with sums over the fluid at the frame and
// means over the steps since the frame before; columns that cost time where the scene asks for them
// (LogOptions). docs/file_formats.md lists the columns. No times of
// the machine are in it: the same scene gives the same bytes.
#pragma once

#include "bodies.hpp"
#include <meniscus/sph/step/simulation.hpp>

#include <cstdint>
#include <string>

namespace meniscus {

/// What is kept of the steps since a frame.
struct StepSums {
    std::uint64_t steps = 0;
    std::uint64_t unconverged_steps = 0;
    std::uint64_t pressure_iterations = 0;
    std::uint64_t divergence_iterations = 0;
    double time = 0; ///< s
    double density_error = 0;
    double max_density_error = 0;
    double divergence_error = 0;
    double max_divergence_error = 0;
    double tension_force = 0;
    double tension_force_deviation = 0;
    double pressure_force = 0;
    double pressure_force_deviation = 0;

    void add(const StepReport& report);
};

/// What stands in a row.
struct LogRow {
    std::uint64_t frame = 0;
    double time = 0;
    StepSums sums;
    Balance balance;
    Bodies bodies; ///< where they are logged
};

/// Names of the columns, with a line break.
std::string log_header(const LogOptions& options);

/// A row, with a line break. Means over no steps are 0.
std::string log_text(const LogRow& row, const LogOptions& options);

} // namespace meniscus
