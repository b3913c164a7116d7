#include "known_names.hpp"

#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace meniscus {
namespace {

struct Quantity {
    std::string_view ours;
    std::size_t components;
    std::array<std::string_view, 6> names; ///< in lower case, the likeliest first
};

constexpr Quantity quantities[] = {
    {"velocity", 3, {"velocity", "velocities", "vel", "v"}},
    {"density", 1, {"density", "densities", "rho", "rhop"}},
    {"mass", 1, {"mass", "masses", "m"}},
    {"id", 1, {"id", "ids", "idp", "particle_id", "particleids", "particleid"}},
    {"phase", 1, {"phase"}},
    {"support_radius", 1, {"support_radius"}},
};

constexpr std::array<std::string_view, 3> velocity_components[] = {
    {"velocity_x", "velocity_y", "velocity_z"},
    {"velocity:0", "velocity:1", "velocity:2"},
    {"vel_x", "vel_y", "vel_z"},
    {"vel:0", "vel:1", "vel:2"},
    {"velx", "vely", "velz"},
    {"vx", "vy", "vz"},
    {"v_x", "v_y", "v_z"},
    {"u", "v", "w"},
};

/// The array of that name in letters of any case, of one component.
const PointArray* find_component(const Snapshot& snapshot, std::string_view name) {
    for (const PointArray& array : snapshot.point_data)
        if (array.components == 1 && lowered(array.name) == name)
            return &array;
    return nullptr;
}

void erase_array(Snapshot& snapshot, const std::string& name) {
    auto& arrays = snapshot.point_data;
    arrays.erase(std::remove_if(arrays.begin(), arrays.end(),
                                [&](const PointArray& array) { return array.name == name; }),
                 arrays.end());
}

/// `stored` arrays of one component each as one of three, in place of them.
void join_velocity(Snapshot& snapshot, const std::vector<const PointArray*>& stored) {
    std::vector<double> velocity(3 * snapshot.size());
    std::vector<std::string> names;
    for (std::size_t axis = 0; axis < stored.size(); ++axis) {
        if (stored[axis] == nullptr)
            continue;
        const std::vector<double> values = as_doubles(*stored[axis]);
        for (std::size_t i = 0; i < values.size(); ++i)
            velocity[3 * i + axis] = values[i];
        names.push_back(stored[axis]->name);
    }
    for (const std::string& name : names)
        erase_array(snapshot, name);
    set_array(snapshot, {"velocity", 3, std::move(velocity)});
}

/// One component may be missing in two dimensions.
void join_components(Snapshot& snapshot) {
    for (const auto& names : velocity_components) {
        std::vector<const PointArray*> stored;
        for (const std::string_view name : names)
            stored.push_back(find_component(snapshot, name));
        const auto missing = std::count(stored.begin(), stored.end(), nullptr);
        if (stored[0] != nullptr && missing <= (snapshot.dimension == 2 ? 1 : 0))
            return join_velocity(snapshot, stored);
    }
}

/// Two components a particle, and a third that is 0.
void widen(PointArray& array) {
    std::visit(
        [](auto& values) {
            std::decay_t<decltype(values)> wide(values.size() / 2 * 3);
            for (std::size_t i = 0; i < values.size(); ++i)
                wide[i / 2 * 3 + i % 2] = values[i];
            values = std::move(wide);
        },
        array.values);
    array.components = 3;
}

/// A single letter may mean something else: a mass is positive.
bool can_be(const PointArray& array, const Quantity& quantity) {
    const auto components = static_cast<std::size_t>(array.components);
    if (quantity.ours == "mass" && array.name.size() == 1) {
        const std::vector<double> values = as_doubles(array);
        if (!std::all_of(values.begin(), values.end(), [](double mass) { return mass > 0; }))
            return false;
    }
    return components == quantity.components || (quantity.components == 3 && components == 2);
}

void rename_array(Snapshot& snapshot, const Quantity& quantity) {
    if (find_array(snapshot, quantity.ours) != nullptr)
        return;
    for (const std::string_view name : quantity.names) {
        for (PointArray& array : snapshot.point_data) {
            if (!name.empty() && lowered(array.name) == name && can_be(array, quantity)) {
                array.name = quantity.ours;
                return;
            }
        }
    }
}

} // namespace

std::optional<KnownName> known_name(std::string_view name) {
    const std::string plain = lowered(name);
    for (const Quantity& quantity : quantities) {
        const auto& names = quantity.names;
        const auto* found = std::find(names.begin(), names.end(), plain);
        if (!plain.empty() && found != names.end())
            return KnownName{quantity.ours, static_cast<std::size_t>(found - names.begin())};
    }
    return std::nullopt;
}

void use_our_names(Snapshot& snapshot) {
    for (const Quantity& quantity : quantities)
        rename_array(snapshot, quantity);
    if (find_array(snapshot, "velocity") == nullptr)
        join_components(snapshot);
    for (PointArray& array : snapshot.point_data)
        if (array.name == "velocity" && array.components == 2)
            widen(array);
}

} // namespace meniscus
