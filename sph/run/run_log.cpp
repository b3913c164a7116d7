#include "run_log.hpp"

#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace meniscus {
namespace {

using Column = std::pair<const char*, std::string>;

double mean(double sum, std::uint64_t count) {
    return count == 0 ? 0 : sum / static_cast<double>(count);
}

std::vector<Column> columns(std::uint64_t frame, double time, const StepSums& sums,
                            const Balance& balance) {
    const auto mean_text = [&](auto sum) {
        return number_text(mean(static_cast<double>(sum), sums.steps));
    };
    return {{"frame", std::to_string(frame)},
            {"time", number_text(time)},
            {"steps", std::to_string(sums.steps)},
            {"mean_time_step", mean_text(sums.time)},
            {"mean_pressure_iterations", mean_text(sums.pressure_iterations)},
            {"mean_divergence_iterations", mean_text(sums.divergence_iterations)},
            {"mean_density_error", mean_text(sums.density_error)},
            {"max_density_error", number_text(sums.max_density_error)},
            {"mean_divergence_error", mean_text(sums.divergence_error)},
            {"max_divergence_error", number_text(sums.max_divergence_error)},
            {"unconverged_steps", std::to_string(sums.unconverged_steps)},
            {"kinetic_energy", number_text(balance.kinetic_energy)},
            {"potential_energy", number_text(balance.potential_energy)},
            {"surface_area", number_text(balance.surface_area)},
            {"momentum_x", number_text(balance.momentum[0])},
            {"momentum_y", number_text(balance.momentum[1])},
            {"momentum_z", number_text(balance.momentum[2])},
            {"momentum_size", number_text(balance.momentum_size)},
            {"center_x", number_text(balance.center[0])},
            {"center_y", number_text(balance.center[1])},
            {"center_z", number_text(balance.center[2])},
            {"max_speed", number_text(balance.max_speed)},
            {"surface_particles", std::to_string(balance.surface_particles)},
            {"particles", std::to_string(balance.particles)}};
}

template <class TextOf>
std::string line_of(const std::vector<Column>& columns, const TextOf& text_of) {
    std::string line;
    for (const Column& column : columns)
        line += (line.empty() ? "" : ",") + std::string(text_of(column));
    return line + "\n";
}

} // namespace

void StepSums::add(const StepReport& report) {
    ++steps;
    unconverged_steps += report.converged ? 0 : 1;
    pressure_iterations += static_cast<std::uint64_t>(report.pressure_iterations);
    divergence_iterations += static_cast<std::uint64_t>(report.divergence_iterations);
    time += report.time_step;
    density_error += report.density_error;
    max_density_error = std::max(max_density_error, report.density_error);
    divergence_error += report.divergence_error;
    max_divergence_error = std::max(max_divergence_error, report.divergence_error);
}

std::string log_header() {
    return line_of(columns(0, 0, {}, {}), [](const Column& column) { return column.first; });
}

std::string log_row(std::uint64_t frame, double time, const StepSums& sums,
                    const Balance& balance) {
    return line_of(columns(frame, time, sums, balance),
                   [](const Column& column) { return column.second; });
}

} // namespace meniscus
