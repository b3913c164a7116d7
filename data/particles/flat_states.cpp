#include "flat_states.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace meniscus {
namespace {

constexpr double flatness = 1e-6; // of the extent; no layer of particles is as thin

constexpr std::size_t min_plane_particles =
    4; // three always have a plane, and it may be one of these

/// Which axes become x, y and z.
struct Plane {
    const char* name;
    std::array<std::size_t, 3> axes;
};

// In the order in which they are tried.
constexpr Plane planes[] = {{"xy", {0, 1, 2}}, {"xz", {0, 2, 1}}, {"yz", {1, 2, 0}}};

struct Bounds {
    std::array<double, 3> min;
    std::array<double, 3> max;
    std::size_t count = 0;

    [[nodiscard]] double extent(std::size_t axis) const { return max[axis] - min[axis]; }
    [[nodiscard]] double thickness() const {
        return flatness * std::max({extent(0), extent(1), extent(2)});
    }
};

bool is_finite(const std::array<double, 3>& position) {
    return std::all_of(position.begin(), position.end(), [](double x) { return std::isfinite(x); });
}

void include(const Positions& positions, Bounds& bounds) {
    for (const auto& position : positions) {
        if (!is_finite(position))
            continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = position[axis];
            bounds.min[axis] = bounds.count == 0 ? x : std::min(bounds.min[axis], x);
            bounds.max[axis] = bounds.count == 0 ? x : std::max(bounds.max[axis], x);
        }
        ++bounds.count;
    }
}

Bounds bounds_of(const Snapshot& snapshot) {
    Bounds bounds{};
    include(snapshot.positions, bounds);
    include(snapshot.boundary, bounds);
    return bounds;
}

/// How far positions lie from a line through `first` at most, times the length of `along`.
double area_from_line(const Positions& positions, const std::array<double, 3>& first,
                      const std::array<double, 3>& along) {
    double max = 0;
    for (const auto& position : positions) {
        std::array<double, 3> to{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            to[axis] = position[axis] - first[axis];
        for (std::size_t axis = 0; axis < 3 && is_finite(position); ++axis) {
            const std::size_t a = (axis + 1) % 3;
            const std::size_t b = (axis + 2) % 3;
            max = std::max(max, std::abs(to[a] * along[b] - to[b] * along[a]));
        }
    }
    return max;
}

/// Whether all lies in a line, whatever its direction.
bool is_line(const Snapshot& snapshot, const Bounds& bounds) {
    const auto& positions = snapshot.positions;
    const auto first = std::find_if(positions.begin(), positions.end(), is_finite);
    if (first == positions.end())
        return true;
    std::array<double, 3> along{};
    double longest = 0;
    for (const auto& position : positions) {
        const double length = std::hypot(position[0] - (*first)[0], position[1] - (*first)[1],
                                         position[2] - (*first)[2]);
        if (!std::isfinite(length) || length <= longest)
            continue;
        longest = length;
        for (std::size_t axis = 0; axis < 3; ++axis)
            along[axis] = position[axis] - (*first)[axis];
    }
    const double thickness = bounds.thickness() * longest;
    return area_from_line(positions, *first, along) <= thickness &&
           area_from_line(snapshot.boundary, *first, along) <= thickness;
}

/// The plane that all lies in; nothing where there is none, or too little to tell.
const Plane* plane_of(const Snapshot& snapshot, const Bounds& bounds) {
    const auto is_flat = [&](std::size_t axis) {
        return bounds.extent(axis) <= bounds.thickness();
    };
    if (bounds.count < 2)
        return nullptr;
    if (is_flat(2))
        return planes;
    if (bounds.count < min_plane_particles || is_flat(0) == is_flat(1) || is_line(snapshot, bounds))
        return nullptr;
    return is_flat(1) ? planes + 1 : planes + 2;
}

/// The third coordinate is made `level` where it is so but for rounding.
void turn(Positions& positions, const Plane& plane, double level, double thickness) {
    for (auto& position : positions) {
        std::array<double, 3> turned{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            turned[axis] = position[plane.axes[axis]];
        if (std::abs(turned[2] - level) <= thickness)
            turned[2] = level;
        position = turned;
    }
}

/// Vectors, which are arrays of three floating-point numbers a particle.
void turn(PointArray& array, const Plane& plane) {
    std::visit(
        [&](auto& values) {
            using Value = typename std::decay_t<decltype(values)>::value_type;
            if constexpr (std::is_floating_point_v<Value>) {
                for (std::size_t i = 0; array.components == 3 && i < values.size(); i += 3) {
                    const std::array<Value, 3> stored{values[i], values[i + 1], values[i + 2]};
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        values[i + axis] = stored[plane.axes[axis]];
                }
            }
        },
        array.values);
}

/// The third coordinate of all: that of the first particle which has one.
double level_of(const Positions& positions, std::size_t axis) {
    const auto first = std::find_if(positions.begin(), positions.end(), is_finite);
    return first == positions.end() ? 0 : (*first)[axis];
}

void apply(Snapshot& snapshot, const Plane& plane, const Bounds& bounds) {
    snapshot.dimension = 2;
    const bool is_ours = &plane == planes;
    const std::size_t third = plane.axes[2];
    if (is_ours && bounds.extent(third) == 0)
        return;
    const double level = level_of(snapshot.positions, third);
    turn(snapshot.positions, plane, level, bounds.thickness());
    turn(snapshot.boundary, plane, level, bounds.thickness());
    for (PointArray& array : snapshot.point_data)
        turn(array, plane);
    if (!is_ours)
        snapshot.provenance["plane"] = plane.name;
    snapshot.notes.push_back(
        is_ours ? "2D: z is the same but for rounding (" + rounded_text(bounds.extent(2), 2) + " m)"
                : std::string("2D in the plane ") + plane.name + ", taken as x, y");
}

} // namespace

void settle_plane(Snapshot& snapshot) {
    const Bounds bounds = bounds_of(snapshot);
    if (const Plane* plane = plane_of(snapshot, bounds))
        apply(snapshot, *plane, bounds);
}

void demand_plane(Snapshot& snapshot) {
    const Bounds bounds = bounds_of(snapshot);
    if (bounds.count >= 2 && plane_of(snapshot, bounds) == nullptr) {
        const double level = level_of(snapshot.positions, 2);
        const auto& positions = snapshot.positions;
        const auto other = std::find_if(positions.begin(), positions.end(), [&](const auto& at) {
            return is_finite(at) && std::abs(at[2] - level) > bounds.thickness();
        });
        const std::string who = other == positions.end()
                                    ? "boundary particles do not lie in the plane of the fluid"
                                    : "particle " + std::to_string(other - positions.begin()) +
                                          " has z = " + number_text((*other)[2]) +
                                          " and others before it " + number_text(level) +
                                          ", and no other plane holds all";
        throw InputError("--dimension 2, but " + who +
                         "; a flat state has one z: export it so, or take it in 3D");
    }
    settle_plane(snapshot);
    snapshot.dimension = 2;
}

void turn_into_plane(const Snapshot& state, Positions& positions) {
    const auto name = state.provenance.find("plane");
    const bool turned = state.dimension == 2 && name != state.provenance.end();
    if (state.dimension != 2)
        return;
    Bounds bounds = bounds_of(state);
    const auto* plane =
        turned ? std::find_if(std::begin(planes), std::end(planes),
                              [&](const Plane& known) { return known.name == name->second; })
               : planes;
    if (plane != std::end(planes))
        turn(positions, *plane, level_of(state.positions, 2), bounds.thickness());
}

} // namespace meniscus
