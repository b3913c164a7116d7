#include "particle_arrays.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <meniscus/runtime/neighbors/position_resolution.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

namespace meniscus {
namespace {

bool fits_int64(double value) {
    return value >= -0x1p63 && value < 0x1p63 && std::trunc(value) == value;
}

template <class Value>
std::vector<std::int64_t> as_integers(const std::vector<Value>& values, std::string_view name,
                                      const std::vector<std::uint8_t>& valid,
                                      std::uint64_t first_particle) {
    if constexpr (std::is_integral_v<Value>) {
        return {values.begin(), values.end()};
    } else {
        std::vector<std::int64_t> integers(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (valid[i] == 0)
                continue;
            if (!fits_int64(values[i]))
                throw InputError("particle " + std::to_string(first_particle + i) + " has " +
                                 std::string(name) + " " + number_text(values[i]) +
                                 ", expected a whole number");
            integers[i] = static_cast<std::int64_t>(values[i]);
        }
        return integers;
    }
}

/// Steps in which the position of a particle with finite coordinates is stored, in its support
/// radii; 0 where the radius is no radius, which is for the neighbor search to say.
double step_of(const Snapshot& snapshot, const SupportRadii& radii, std::size_t i) {
    const bool is_float = snapshot.position_precision == Precision::float32;
    const int digits =
        is_float ? std::numeric_limits<float>::digits : std::numeric_limits<double>::digits;
    const double radius = radii.vary() && i >= radii.each.size() ? 0 : radii.of(i);
    return radius > 0 ? position_step(snapshot.positions[i], 3, radius, digits) : 0;
}

std::string type_name(const Snapshot& snapshot) {
    return snapshot.position_precision == Precision::float32 ? "single precision"
                                                             : "double precision";
}

/// Throws InputError, saying what these particles do, where there is one.
void refuse(const ParticlesAtFault& particles, std::uint64_t of, const std::string& what) {
    if (particles.count > 0)
        throw InputError(std::to_string(particles.count) + " of " + std::to_string(of) +
                         " particles " + what + ", the first is particle " +
                         std::to_string(particles.first) + "; --skip-invalid leaves them out");
}

} // namespace

std::vector<std::uint8_t> usable_positions(const Snapshot& snapshot, const SupportRadii& radii,
                                           PositionFaults& faults) {
    auto valid = finite_positions(snapshot);
    faults.particles += valid.size();
    for (std::size_t i = 0; i < valid.size(); ++i) {
        const std::uint64_t number = snapshot.first_particle + i;
        if (valid[i] == 0) {
            faults.not_finite.add(number);
            continue;
        }
        const double step = step_of(snapshot, radii, i);
        if (step >= coarsest_position_step) {
            faults.too_far.add(number);
            valid[i] = 0;
        } else if (step > faults.coarsest_step) {
            faults.coarsest_step = step;
            faults.coarsest = number;
        }
    }
    return valid;
}

void refuse_faults(const Snapshot& snapshot, const PositionFaults& faults) {
    refuse(faults.not_finite, faults.particles, "have positions that are not finite");
    refuse(faults.too_far, faults.particles,
           "lie so far from the origin that " + type_name(snapshot) +
               " cannot tell them from their neighbors (are positions and support "
               "radius in m, and measured from a point nearby?)");
}

std::string doubt_of(const Snapshot& snapshot, const PositionFaults& faults) {
    if (faults.coarsest_step <= doubtful_position_step)
        return {};
    return "particle " + std::to_string(faults.coarsest) + " lies so far from the origin that " +
           type_name(snapshot) + " moves it in steps of " + rounded_text(faults.coarsest_step, 2) +
           " support radii; particles whose label hangs on so little are doubtful";
}

std::vector<std::uint8_t> checked_positions(const Snapshot& snapshot, const SupportRadii& radii,
                                            bool skip_invalid) {
    PositionFaults faults;
    auto valid = usable_positions(snapshot, radii, faults);
    if (!skip_invalid)
        refuse_faults(snapshot, faults);
    return valid;
}

std::string doubtful_positions(const Snapshot& snapshot, const SupportRadii& radii,
                               const std::vector<std::uint8_t>& valid) {
    PositionFaults faults;
    for (std::size_t i = 0; i < valid.size(); ++i) {
        const double step = valid[i] != 0 ? step_of(snapshot, radii, i) : 0;
        if (step > faults.coarsest_step) {
            faults.coarsest_step = step;
            faults.coarsest = snapshot.first_particle + i;
        }
    }
    return doubt_of(snapshot, faults);
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
            throw InputError("particle " + std::to_string(snapshot.first_particle + i) +
                             " has mass " + number_text(masses[i]) +
                             ", expected a positive number");
    return masses;
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
    return std::visit(
        [&](const auto& values) {
            return as_integers(values, name, valid, snapshot.first_particle);
        },
        scalar_array(snapshot, name).values);
}

} // namespace meniscus
