#include "nearest_spacing.hpp"

#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus {
namespace {

constexpr std::size_t max_samples = 1000;
constexpr std::size_t min_particles = 30; ///< for a doubt

/// Positions of valid particles, sorted by x, and their radii.
struct Sorted {
    std::vector<std::size_t> particles;
    const Positions& positions;

    [[nodiscard]] const std::array<double, 3>& at(std::size_t place) const {
        return positions[particles[place]];
    }
};

double squared_distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    return sum;
}

/// To the nearest other particle, looking no farther along x than the nearest so far.
double nearest_distance(const Sorted& sorted, std::size_t place) {
    const auto& center = sorted.at(place);
    double nearest = std::numeric_limits<double>::infinity();
    const auto look = [&](std::size_t other) {
        const double along_x = sorted.at(other)[0] - center[0];
        if (along_x * along_x >= nearest)
            return false;
        nearest = std::min(nearest, squared_distance(center, sorted.at(other)));
        return true;
    };
    bool before = true;
    bool behind = true;
    for (std::size_t step = 1; before || behind; ++step) {
        before = before && step <= place && look(place - step);
        behind = behind && place + step < sorted.particles.size() && look(place + step);
    }
    return std::sqrt(nearest);
}

Sorted sorted_by_x(const Snapshot& snapshot, const std::vector<std::uint8_t>& valid) {
    Sorted sorted{{}, snapshot.positions};
    for (std::size_t i = 0; i < snapshot.size(); ++i)
        if (valid[i] != 0)
            sorted.particles.push_back(i);
    std::sort(sorted.particles.begin(), sorted.particles.end(), [&](std::size_t a, std::size_t b) {
        return snapshot.positions[a] < snapshot.positions[b];
    });
    return sorted;
}

} // namespace

std::optional<double> nearest_spacing_ratio(const Snapshot& snapshot, const SupportRadii& radii,
                                            const std::vector<std::uint8_t>& valid) {
    const Sorted sorted = sorted_by_x(snapshot, valid);
    const std::size_t count = sorted.particles.size();
    if (count < 2)
        return std::nullopt;
    std::vector<double> ratios;
    const std::size_t stride = (count + max_samples - 1) / max_samples;
    for (std::size_t place = 0; place < count; place += stride)
        ratios.push_back(radii.of(sorted.particles[place]) / nearest_distance(sorted, place));
    const auto tenth = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 10);
    std::nth_element(ratios.begin(), tenth, ratios.end());
    return *tenth;
}

std::string doubtful_support_radius(const Snapshot& snapshot, const SupportRadii& radii,
                                    const std::vector<std::uint8_t>& valid) {
    const auto count = std::count_if(valid.begin(), valid.end(), [](auto v) { return v != 0; });
    if (static_cast<std::size_t>(count) < min_particles)
        return {};
    const double ratio = *nearest_spacing_ratio(snapshot, radii, valid);
    const auto [lowest, highest] = plausible_spacing_ratios;
    if (ratio >= lowest && ratio <= highest)
        return {};
    if (!std::isfinite(ratio))
        return "particles lie in the same place, so that the support radius cannot be judged";
    return "the support radius is " + rounded_text(ratio, 2) +
           " times the distance of nearest particles, where " + rounded_text(lowest, 2) + " to " +
           rounded_text(highest, 2) +
           " are plausible; h is the radius of the kernel: 4 particle radii in SPlisHSPlasH, 2 "
           "smoothing lengths in PySPH and DualSPHysics";
}

} // namespace meniscus
