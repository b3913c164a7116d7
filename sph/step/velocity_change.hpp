// What pressure changes of the velocities of one step, in the stretches of it in which pressure
// acts: the force behind it, whatever the solver.
#pragma once

#include "state.hpp"

#include <meniscus/sph/fluid/fluid.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Mean and deviation of factor |row| over the particles.
template <class Real, int Dimension>
ForceSizes sizes_of(const std::vector<Row<Real>>& rows, double factor,
                    const Fluid<Real, Dimension>& fluid) {
    if (rows.empty())
        return {};
    const auto size = [&](std::size_t i) {
        return factor * std::sqrt(static_cast<double>(dot_rows(rows[i], rows[i])));
    };
    const auto count = static_cast<double>(rows.size());
    const double mean = fluid.loop.sum(rows.size(), size) / count;
    const double squares = fluid.loop.sum(
        rows.size(), [&](std::size_t i) { return (size(i) - mean) * (size(i) - mean); });
    return {mean, std::sqrt(squares / count)};
}

/// The sum of the changes between each begin() and end() since clear().
template <class Real, int Dimension>
class VelocityChange {
public:
    using FluidType = Fluid<Real, Dimension>;

    void clear(std::size_t count) { rows.assign(count, {}); }
    void begin(const FluidType& fluid) { turn(fluid); }
    void end(const FluidType& fluid) { turn(fluid); }

    /// Once it has ended.
    [[nodiscard]] ForceSizes sizes(double factor, const FluidType& fluid) const {
        return sizes_of<Real, Dimension>(rows, factor, fluid);
    }

private:
    std::vector<Row<Real>> rows; ///< the change, or between begin and end the velocity less it

    void turn(const FluidType& fluid) {
        fluid.loop.each(rows.size(), [&](std::size_t i) {
            rows[i] = plus(fluid.velocity[i], Real(-1), rows[i]);
        });
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
