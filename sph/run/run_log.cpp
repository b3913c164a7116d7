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

std::string mean_text(double sum, const StepSums& sums) {
    return number_text(mean(sum, sums.steps));
}

std::vector<Column> common_columns(const LogRow& row) {
    const StepSums& sums = row.sums;
    const Balance& balance = row.balance;
    const auto mean_of = [&](auto sum) { return mean_text(static_cast<double>(sum), sums); };
    return {{"frame", std::to_string(row.frame)},
            {"time", number_text(row.time)},
            {"steps", std::to_string(sums.steps)},
            {"mean_time_step", mean_of(sums.time)},
            {"mean_pressure_iterations", mean_of(sums.pressure_iterations)},
            {"mean_divergence_iterations", mean_of(sums.divergence_iterations)},
            {"mean_density_error", mean_of(sums.density_error)},
            {"max_density_error", number_text(sums.max_density_error)},
            {"mean_divergence_error", mean_of(sums.divergence_error)},
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
            {"mean_speed", number_text(balance.mean_speed)},
            {"surface_particles", std::to_string(balance.surface_particles)},
            {"particles", std::to_string(balance.particles)}};
}

std::vector<Column> force_columns(const StepSums& sums) {
    return {{"tension_force", mean_text(sums.tension_force, sums)},
            {"tension_force_deviation", mean_text(sums.tension_force_deviation, sums)},
            {"pressure_force", mean_text(sums.pressure_force, sums)},
            {"pressure_force_deviation", mean_text(sums.pressure_force_deviation, sums)}};
}

std::vector<Column> body_columns(const Bodies& bodies) {
    return {{"bodies", std::to_string(bodies.count)},
            {"largest_body", std::to_string(bodies.largest)},
            {"largest_radius", number_text(bodies.radius)},
            {"largest_aspect", number_text(bodies.aspect)},
            {"largest_top", number_text(bodies.top)}};
}

std::vector<Column> columns(const LogRow& row, const LogOptions& options) {
    std::vector<Column> all = common_columns(row);
    const auto add = [&](const std::vector<Column>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    if (options.forces)
        add(force_columns(row.sums));
    if (options.bodies)
        add(body_columns(row.bodies));
    return all;
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
    tension_force += report.tension_forces.mean;
    tension_force_deviation += report.tension_forces.deviation;
    pressure_force += report.pressure_forces.mean;
    pressure_force_deviation += report.pressure_forces.deviation;
}

std::string log_header(const LogOptions& options) {
    return line_of(columns({}, options), [](const Column& column) { return column.first; });
}

std::string log_text(const LogRow& row, const LogOptions& options) {
    return line_of(columns(row, options), [](const Column& column) { return column.second; });
}

} // namespace meniscus
