#include "periodic_copies.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace meniscus {
namespace {

constexpr const char* count_key = "periodic_copies";

std::vector<std::string> parts_of(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

[[noreturn]] void refuse(const std::string& text) {
    throw InputError("--periodic " + text +
                     ": expected sides such as x=0:1,y=0:2 or lengths such as 1,2,3");
}

double number_of(const std::string& text, const std::string& whole) {
    const auto number = number_from_text(text);
    if (!number || !std::isfinite(*number))
        refuse(whole);
    return *number;
}

/// "x=0:1"
void set_sides(PeriodicBox& box, const std::string& part, const std::string& whole) {
    const std::size_t axis = std::string("xyz").find(part[0]);
    const auto bounds = parts_of(part.substr(std::min<std::size_t>(2, part.size())), ':');
    if (axis > 2 || part[1] != '=' || bounds.size() != 2)
        refuse(whole);
    box[axis] = {number_of(bounds[0], whole), number_of(bounds[1], whole)};
}

/// The file's axes in the order that a flat state was turned into.
PeriodicBox turned(const PeriodicBox& box, const Snapshot& snapshot) {
    const auto plane = snapshot.provenance.find("plane");
    if (plane == snapshot.provenance.end() || plane->second.size() != 2)
        return box;
    PeriodicBox of_plane;
    for (std::size_t axis = 0; axis < 2; ++axis)
        of_plane[axis] = box[std::string("xyz").find(plane->second[axis]) % 3];
    return of_plane;
}

void check_sides(const PeriodicSides& sides, char axis, double radius) {
    if (sides.high - sides.low < radius)
        throw InputError(std::string("the periodic box is ") +
                         rounded_text(sides.high - sides.low, 4) + " m along " + axis +
                         ", expected at least the support radius of " + rounded_text(radius, 4) +
                         " m");
}

void check_inside(const Positions& positions, std::uint64_t first, const PeriodicSides& sides,
                  std::size_t axis, double radius) {
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (positions[i][axis] < sides.low - radius || positions[i][axis] > sides.high + radius)
            throw InputError("particle " + std::to_string(first + i) + " has " + "xyz"[axis] +
                             " = " + number_text(positions[i][axis]) +
                             ", outside the periodic box by more than the support radius");
}

/// Copies along one axis of all that is there, copies along the axes before included.
void copy_along(const Positions& fluid, Positions& others, std::size_t axis,
                const PeriodicSides& sides, double radius) {
    const double length = sides.high - sides.low;
    // Particles that have left the box by up to a radius need what lies around them.
    double out = 0;
    for (const auto& position : fluid)
        if (std::isfinite(position[axis]))
            out = std::max({out, sides.low - position[axis], position[axis] - sides.high});
    Positions copies;
    for (const Positions* positions : {&fluid, static_cast<const Positions*>(&others)}) {
        for (const auto& position : *positions) {
            if (!std::isfinite(position[axis]))
                continue;
            const double reach = radius + out;
            const double first = std::ceil((sides.low - reach - position[axis]) / length);
            const double last = std::floor((sides.high + reach - position[axis]) / length);
            for (double shift = first; shift <= last; ++shift) {
                if (shift == 0)
                    continue;
                auto copy = position;
                copy[axis] += shift * length;
                copies.push_back(copy);
            }
        }
    }
    others.insert(others.end(), copies.begin(), copies.end());
}

void check_phases(const Snapshot& snapshot) {
    const PointArray* phase = find_array(snapshot, "phase");
    const auto phases = phase == nullptr ? std::vector<double>() : as_doubles(*phase);
    if (std::adjacent_find(phases.begin(), phases.end(), std::not_equal_to<>()) != phases.end())
        throw InputError("a periodic box with several phases is not supported; label each phase by "
                         "itself, as with --fluid phase=0");
}

} // namespace

PeriodicBox periodic_box(const std::string& text) {
    PeriodicBox box;
    const auto parts = parts_of(text, ',');
    if (parts.size() > 3)
        refuse(text);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].find('=') != std::string::npos)
            set_sides(box, parts[i], text);
        else
            box[i] = {0, number_of(parts[i], text)};
    }
    for (const auto& sides : box)
        if (sides && !(sides->high > sides->low))
            refuse(text);
    return box;
}

void remove_periodic_copies(Snapshot& snapshot) {
    const auto count = snapshot.provenance.find(count_key);
    if (count == snapshot.provenance.end())
        return;
    std::size_t copies = 0;
    if (read_number(count->second, copies) == std::errc() && copies <= snapshot.boundary.size())
        snapshot.boundary.resize(snapshot.boundary.size() - copies);
    snapshot.provenance.erase(count);
}

void add_periodic_copies(Snapshot& snapshot, const PeriodicBox& box, double radius) {
    remove_periodic_copies(snapshot);
    check_phases(snapshot);
    const std::size_t before = snapshot.boundary.size();
    const PeriodicBox sides = turned(box, snapshot);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(snapshot.dimension); ++axis) {
        if (!sides[axis])
            continue;
        check_sides(*sides[axis], "xyz"[axis], radius);
        check_inside(snapshot.positions, snapshot.first_particle, *sides[axis], axis, radius);
        copy_along(snapshot.positions, snapshot.boundary, axis, *sides[axis], radius);
    }
    const std::size_t copies = snapshot.boundary.size() - before;
    snapshot.provenance[count_key] = std::to_string(copies);
    snapshot.notes.push_back("periodic: " + std::to_string(copies) +
                             " copies cover beyond the sides of the box");
}

std::vector<std::uint8_t> near_periodic_sides(const Positions& rows, std::uint64_t first,
                                              const Snapshot& frame, const PeriodicBox& box,
                                              double radius) {
    std::vector<std::uint8_t> near(rows.size());
    const PeriodicBox sides = turned(box, frame);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(frame.dimension); ++axis) {
        if (!sides[axis])
            continue;
        check_sides(*sides[axis], "xyz"[axis], radius);
        check_inside(rows, first, *sides[axis], axis, radius);
        // Particles may be out of the box by a radius, and reach one farther.
        const double reach = 2.001 * radius;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i][axis] <= sides[axis]->low + reach ||
                rows[i][axis] >= sides[axis]->high - reach)
                near[i] = 1;
    }
    return near;
}

} // namespace meniscus
