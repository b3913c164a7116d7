#include "particle_arrays.hpp"

#include "errors.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

namespace meniscus {
namespace {

bool fits_int64(double value) {
    return value >= -0x1p63 && value < 0x1p63 && std::trunc(value) == value;
}

template <class Value>
std::vector<std::int64_t> as_integers(const std::vector<Value>& values, std::string_view name,
                                      const std::vector<std::uint8_t>& valid) {
    if constexpr (std::is_integral_v<Value>) {
        return {values.begin(), values.end()};
    } else {
        std::vector<std::int64_t> integers(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (valid[i] == 0)
                continue;
            if (!fits_int64(values[i]))
                throw InputError("particle " + std::to_string(i) + " has " + std::string(name) +
                                 " " + number_text(values[i]) + ", expected a whole number");
            integers[i] = static_cast<std::int64_t>(values[i]);
        }
        return integers;
    }
}

} // namespace

std::vector<std::uint8_t> checked_positions(const Snapshot& snapshot, bool skip_invalid) {
    auto valid = finite_positions(snapshot);
    const auto first = std::find(valid.begin(), valid.end(), 0);
    if (first != valid.end() && !skip_invalid)
        throw InputError(std::to_string(std::count(first, valid.end(), 0)) + " of " +
                         std::to_string(valid.size()) +
                         " particles have positions that are not finite, the first is particle " +
                         std::to_string(first - valid.begin()) +
                         "; --skip-invalid leaves them out");
    return valid;
}

SupportRadii support_radii(const Snapshot& snapshot) {
    if (snapshot.support_radius)
        return *snapshot.support_radius;
    if (find_array(snapshot, "support_radius") == nullptr || snapshot.size() == 0)
        throw InputError("no support radius is stored; give the kernel radius h in m with "
                         "--support-radius");
    return SupportRadii(scalar_values(snapshot, "support_radius"), finite_positions(snapshot));
}

std::vector<double> checked_masses(const Snapshot& snapshot,
                                   const std::vector<std::uint8_t>& valid) {
    if (find_array(snapshot, "mass") == nullptr)
        return {};
    auto masses = scalar_values(snapshot, "mass");
    for (std::size_t i = 0; i < masses.size(); ++i)
        if (valid[i] != 0 && !(masses[i] > 0 && std::isfinite(masses[i])))
            throw InputError("particle " + std::to_string(i) + " has mass " +
                             number_text(masses[i]) + ", expected a positive number");
    return masses;
}

double mean_mass(const std::vector<double>& masses, const std::vector<std::uint8_t>& valid) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < masses.size(); ++i)
        if (valid[i] != 0) {
            sum += masses[i];
            ++count;
        }
    return count == 0 ? 1 : sum / static_cast<double>(count);
}

void check_boundary(const Snapshot& snapshot) {
    for (std::size_t i = 0; i < snapshot.boundary.size(); ++i) {
        const auto& position = snapshot.boundary[i];
        for (const double coordinate : position)
            if (!std::isfinite(coordinate))
                throw InputError("boundary particle " + std::to_string(i) +
                                 " has a position that is not finite");
        if (snapshot.dimension == 2 && !snapshot.positions.empty() &&
            std::isfinite(snapshot.positions[0][2]) && position[2] != snapshot.positions[0][2])
            throw InputError(
                "boundary particle " + std::to_string(i) + " has z = " + number_text(position[2]) +
                ", but the fluid in 2D lies at z = " + number_text(snapshot.positions[0][2]));
    }
}

std::vector<std::int64_t> integer_values(const Snapshot& snapshot, std::string_view name,
                                         const std::vector<std::uint8_t>& valid) {
    if (find_array(snapshot, name) == nullptr)
        return {};
    return std::visit([&](const auto& values) { return as_integers(values, name, valid); },
                      scalar_array(snapshot, name).values);
}

} // namespace meniscus
