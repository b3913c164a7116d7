#include "particle_roles.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>

namespace meniscus {
namespace {

enum class Role : std::uint8_t { unsaid, fluid, wall, ignored };

std::string joined(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts)
        all += (all.empty() ? "" : ", ") + text;
    return all;
}

std::string names_of_scalars(const Snapshot& snapshot) {
    std::vector<std::string> names;
    for (const PointArray& array : snapshot.point_data)
        if (array.components == 1 && names.size() < 12)
            names.push_back(array.name);
    return names.empty() ? "none" : joined(names);
}

/// Scalar point data of that name, in letters of any case where none is written the same.
const PointArray* find_scalar(const Snapshot& snapshot, const std::string& name) {
    const PointArray* exact = find_array(snapshot, name);
    if (exact != nullptr && exact->components == 1)
        return exact;
    for (const PointArray& array : snapshot.point_data)
        if (array.components == 1 && lowered(array.name) == lowered(name))
            return &array;
    return nullptr;
}

/// Gives a role to the particles that a choice such as "Type=3" means; returns how many.
std::size_t assign(const Snapshot& snapshot, const std::string& choice, Role role,
                   std::vector<Role>& roles) {
    const std::size_t sign = choice.find('=');
    if (sign == std::string::npos) {
        throw InputError("choice '" + choice + "': expected point data and a value, such as " +
                         "Type=3, since the file has no arrays of particles by names; it has " +
                         names_of_scalars(snapshot));
    }
    const PointArray* array = find_scalar(snapshot, choice.substr(0, sign));
    if (array == nullptr) {
        throw InputError("choice '" + choice + "': expected point data of one value a particle, " +
                         "found none of that name; the file has " + names_of_scalars(snapshot));
    }
    const auto value = number_from_text(choice.substr(sign + 1));
    if (!value)
        throw InputError("choice '" + choice + "': expected a number behind the =");
    const std::vector<double> values = as_doubles(*array);
    std::size_t count = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] != *value)
            continue;
        if (roles[i] != Role::unsaid && roles[i] != role)
            throw InputError("choice '" + choice + "': particle " + std::to_string(i) +
                             " is chosen by another option too");
        roles[i] = role;
        ++count;
    }
    return count;
}

std::size_t assign_all(const Snapshot& snapshot, const std::vector<std::string>& choices, Role role,
                       std::vector<Role>& roles) {
    std::size_t count = 0;
    for (const std::string& choice : choices)
        count += assign(snapshot, choice, role, roles);
    return count;
}

/// What is not chosen is fluid, unless it is said what is.
std::vector<Role> chosen_roles(const Snapshot& snapshot, const ReadChoices& choices) {
    std::vector<Role> roles(snapshot.size(), Role::unsaid);
    assign_all(snapshot, choices.fluid, Role::fluid, roles);
    assign_all(snapshot, choices.walls, Role::wall, roles);
    assign_all(snapshot, choices.ignored, Role::ignored, roles);
    std::replace(roles.begin(), roles.end(), Role::unsaid,
                 choices.fluid.empty() ? Role::fluid : Role::ignored);
    return roles;
}

std::set<double> distinct(const std::vector<double>& values) {
    std::set<double> all;
    for (const double value : values)
        if (all.size() <= 8)
            all.insert(value);
    return all;
}

// DualSPHysics numbers its particles so: fixed, moving and floating ones are of walls and bodies.
constexpr double dualsphysics_fluid = 3;

/// Whether `Type` is DualSPHysics', which stores numbers or densities of particles beside it.
bool is_of_dualsphysics(const Snapshot& snapshot, const std::set<double>& types) {
    const auto has = [&](const char* name) { return find_array(snapshot, name) != nullptr; };
    const bool has_its_data =
        has("Mk") || has("Idp") || has("Rhop") ||
        (types.count(dualsphysics_fluid) > 0 && (has("id") || has("density")));
    return has_its_data && std::all_of(types.begin(), types.end(), [](double type) {
               return type == 0 || type == 1 || type == 2 || type == dualsphysics_fluid;
           });
}

/// By DualSPHysics' types; all fluid where there are none, or only one.
std::vector<Role> roles_by_type(Snapshot& snapshot) {
    std::vector<Role> roles(snapshot.size(), Role::fluid);
    const PointArray* array = find_scalar(snapshot, "Type");
    if (array == nullptr)
        return roles;
    const std::vector<double> values = as_doubles(*array);
    const std::set<double> types = distinct(values);
    if (array->name == "Type" && is_of_dualsphysics(snapshot, types)) {
        if (types.count(dualsphysics_fluid) == 0) {
            throw InputError("expected fluid particles, found only walls and bodies by "
                             "DualSPHysics' Type (0, 1, 2; fluid is 3); give the file as "
                             "--boundary, or choose with --fluid, as in --fluid Type=" +
                             rounded_text(*types.begin(), 3));
        }
        std::transform(values.begin(), values.end(), roles.begin(), [](double type) {
            return type == dualsphysics_fluid ? Role::fluid : Role::wall;
        });
    } else if (types.size() > 1) {
        snapshot.notes.push_back("all values of " + array->name +
                                 " are taken as fluid; --fluid, --walls and --ignore choose, as "
                                 "in --walls " +
                                 array->name + "=" + rounded_text(*types.begin(), 3));
    }
    return roles;
}

void split(Snapshot& snapshot, const std::vector<Role>& roles, const std::string& by) {
    std::vector<std::size_t> fluid;
    std::size_t walls = 0;
    for (std::size_t i = 0; i < roles.size(); ++i) {
        if (roles[i] == Role::fluid) {
            fluid.push_back(i);
        } else if (roles[i] == Role::wall) {
            snapshot.boundary.push_back(snapshot.positions[i]);
            ++walls;
        }
    }
    const std::size_t ignored = roles.size() - fluid.size() - walls;
    if (fluid.size() == roles.size())
        return;
    for (std::size_t i = 0; i < fluid.size(); ++i)
        snapshot.positions[i] = snapshot.positions[fluid[i]];
    snapshot.positions.resize(fluid.size());
    for (PointArray& array : snapshot.point_data)
        keep_rows(array, fluid);
    snapshot.notes.push_back(by + ": " + std::to_string(fluid.size()) + " particles are fluid, " +
                             std::to_string(walls) + " walls" +
                             (ignored > 0 ? ", " + std::to_string(ignored) + " ignored" : ""));
    if (walls > 0)
        snapshot.provenance["boundary_arrays"] = by;
}

std::string words_of(const ReadChoices& choices) {
    std::string words;
    const std::array<std::pair<const char*, const std::vector<std::string>*>, 3> all = {
        {{"fluid", &choices.fluid}, {"walls", &choices.walls}, {"ignore", &choices.ignored}}};
    for (const auto& [option, chosen] : all)
        if (!chosen->empty())
            words += (words.empty() ? "--" : " --") + std::string(option) + " " + joined(*chosen);
    return words;
}

} // namespace

void keep_rows(PointArray& array, const std::vector<std::size_t>& rows) {
    const auto components = static_cast<std::size_t>(array.components);
    std::visit(
        [&](auto& values) {
            auto end = values.begin(); // rows ascend, so what is kept moves down
            for (const std::size_t row : rows)
                end = std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(row * components),
                                  components, end);
            values.erase(end, values.end());
        },
        array.values);
}

void choose_particles(Snapshot& snapshot, const ReadChoices& choices) {
    // Told by name as the file was read, or when the file was made by us.
    const bool is_ours = snapshot.provenance.count("program") > 0;
    const bool by_name = snapshot.provenance.count("fluid_arrays") > 0 && !is_ours;
    if (choices.is_boundary || by_name)
        return;
    if (choices.choose_particles()) {
        split(snapshot, chosen_roles(snapshot, choices), words_of(choices));
        if (snapshot.positions.empty())
            throw InputError("expected fluid particles, found none by " + words_of(choices));
    } else if (!is_ours) {
        split(snapshot, roles_by_type(snapshot), "by Type");
    }
}

} // namespace meniscus
