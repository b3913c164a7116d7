// PySPH's `.hdf5` output: under /particles a group for each of its particle arrays ("fluid",
// "boundary", ...), whose arrays of coordinates and properties it names by letters, and the time in
// /solver_data. What such a file leaves open is taken as follows, and the snapshot's provenance
// says so:
//   - Which arrays are walls is told by their names (boundary, solid, wall, tank, ...), and rigid
//     bodies by their property `body_id`; fluid, water and the like are fluid, each one a phase
//     where there are several, and inlets and outlets are more of it. One array by another name is
//     the fluid where there is no other, and else has to be chosen by whoever reads the file. An
//     array that is alone is fluid whatever its name. (`fluid_arrays`, `boundary_arrays`)
//   - Ghosts, which are copies across a periodic box or a mirror, cover as walls do.
//   - PySPH's h is a smoothing length; the support radius is 2 h, as for its cubic spline and
//     Wendland kernels. (`support_radius_from`)
#include "detail/hdf5_formats.hpp"
#include "detail/particle_roles.hpp"
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace meniscus {

namespace {

using Names = std::vector<std::string>;
using Indices = std::vector<std::size_t>;

// Words of the names that walls and bodies have in PySPH's examples, those that only a fluid has,
// whatever else ("tank_water"), and those of fluid that comes and goes.
constexpr std::string_view wall_words[] = {"boundary", "solid",   "wall",      "tank",
                                           "obstacle", "channel", "container", "vessel",
                                           "rigid",    "body",    "gate",      "cylinder"};
constexpr std::string_view fluid_words[] = {"fluid", "liquid", "water"};
constexpr std::string_view short_fluid_words[] = {"oil", "gas", "air"}; // not those in "airfoil"
constexpr std::string_view opening_words[] = {"inlet", "outlet"};

enum class Role { fluid, opening, wall, ignored, unknown };

/// Arrays by what they are.
struct Roles {
    Names fluids;   ///< each a phase
    Names openings; ///< more of the first fluid
    Names walls;
    Names ignored;
};

std::string folder_of(const std::string& array) {
    return "/particles/" + array + "/arrays";
}

template <std::size_t Count>
bool contains_any(const std::string& name, const std::string_view (&words)[Count]) {
    std::string lower = name;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::any_of(std::begin(words), std::end(words), [&](std::string_view word) {
        return lower.find(word) != std::string::npos;
    });
}

/// Whether a word of the name, between underscores or digits, is one of these.
bool has_fluid_word(const std::string& name) {
    std::string words = lowered(name);
    std::replace_if(
        words.begin(), words.end(), [](unsigned char c) { return std::isalpha(c) == 0; }, ' ');
    words = " " + words + " ";
    return std::any_of(std::begin(short_fluid_words), std::end(short_fluid_words),
                       [&](std::string_view word) {
                           return words.find(" " + std::string(word) + " ") != std::string::npos;
                       });
}

Role role_by_name(const Hdf5Source& source, const std::string& array) {
    if (contains_any(array, opening_words))
        return Role::opening;
    if (contains_any(array, fluid_words) || has_fluid_word(array))
        return Role::fluid;
    if (contains_any(array, wall_words) || exists(source, folder_of(array) + "/body_id"))
        return Role::wall;
    return Role::unknown;
}

std::string joined(const Names& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

bool holds(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// As the person says who reads the file; where fluids are chosen, others are ignored.
Role role_of(const Hdf5Source& source, const std::string& array, const ReadChoices& choices) {
    if (holds(choices.fluid, array))
        return Role::fluid;
    if (holds(choices.walls, array))
        return Role::wall;
    if (holds(choices.ignored, array))
        return Role::ignored;
    const Role role = role_by_name(source, array);
    return !choices.fluid.empty() && role != Role::wall ? Role::ignored : role;
}

void check_choices(const Hdf5Source& source, const Names& arrays, const ReadChoices& choices) {
    for (const Names* chosen : {&choices.fluid, &choices.walls, &choices.ignored})
        for (const std::string& name : *chosen)
            if (!holds(arrays, name))
                fail(source, "/particles", "an array '" + name + "', as chosen",
                     "none but " + joined(arrays));
}

Roles roles_of(const Hdf5Source& source, const ReadChoices& choices) {
    const Names arrays = array_names_in(source, "/particles");
    check_choices(source, arrays, choices);
    Roles roles;
    Names unknown;
    for (const std::string& array : arrays) {
        const Role role = role_of(source, array, choices);
        (role == Role::fluid     ? roles.fluids
         : role == Role::opening ? roles.openings
         : role == Role::wall    ? roles.walls
         : role == Role::ignored ? roles.ignored
                                 : unknown)
            .push_back(array);
    }
    if (roles.fluids.empty() && unknown.size() == 1)
        std::swap(roles.fluids, unknown);
    if (roles.fluids.empty() && (arrays.size() == 1 || !roles.openings.empty()))
        std::swap(roles.fluids, roles.openings.empty() ? roles.walls : roles.openings);
    if (!unknown.empty()) {
        const std::string& name = unknown.front();
        fail(source, "/particles/" + name, "a name that says fluid or wall",
             "neither; give --fluid " + name + ", --walls " + name + " or --ignore " + name);
    }
    return roles;
}

/// The property of all particles, real or not; nothing where the file does not store it, which
/// PySPH also writes as no values at all.
std::optional<PointArray> read_property(const Hdf5Source& source, const std::string& folder,
                                        const std::string& name, std::size_t particles) {
    if (!exists(source, folder + "/" + name))
        return std::nullopt;
    const Dataset dataset = open_dataset(source, folder + "/" + name);
    const std::size_t count = value_count(dataset);
    if (count == 0)
        return std::nullopt;
    const std::size_t components = particles == 0 ? 0 : count / particles;
    if (dataset.dimensions.size() != 1 || components * particles != count || components > 1000) {
        fail(source, dataset.path,
             "one or more values for each of " + std::to_string(particles) + " particles",
             shown(dataset.dimensions) + " values");
    }
    return PointArray{name, static_cast<int>(components), read_numbers(source, dataset)};
}

/// One value a particle, or none at all.
std::vector<double> read_scalars(const Hdf5Source& source, const std::string& folder,
                                 const std::string& name, std::size_t particles) {
    const auto property = read_property(source, folder, name, particles);
    if (!property)
        return {};
    if (property->components != 1) {
        fail(source, folder + "/" + name, "one value a particle",
             std::to_string(property->components));
    }
    return as_doubles(*property);
}

// PySPH's tags of particles.
constexpr double real_tag = 0;
constexpr double ghost_tag = 2; // 1 is a copy of another process's

/// The particles with that tag, which without tags are all real.
Indices tagged_particles(const Hdf5Source& source, const std::string& folder, std::size_t particles,
                         double tag) {
    const std::vector<double> tags = read_scalars(source, folder, "tag", particles);
    Indices tagged;
    for (std::size_t i = 0; i < particles; ++i)
        if ((tags.empty() ? real_tag : tags[i]) == tag)
            tagged.push_back(i);
    return tagged;
}

Positions read_positions(const Hdf5Source& source, const std::string& folder, std::size_t particles,
                         const Indices& rows) {
    Positions positions(rows.size());
    for (const std::size_t axis : {0, 1, 2}) {
        const std::string name(1, "xyz"[axis]);
        const std::vector<double> values = read_scalars(source, folder, name, particles);
        for (std::size_t i = 0; i < rows.size() && !values.empty(); ++i) // else 0, as in a plane
            positions[i][axis] = values[rows[i]];
    }
    return positions;
}

/// The real particles of one array, its ghosts being the boundary. With `properties`, all that is
/// stored of them, under PySPH's names.
Snapshot read_array(const Hdf5Source& source, const std::string& array, bool properties) {
    const std::string folder = folder_of(array);
    if (!exists(source, "/particles/" + array) || !exists(source, folder))
        fail(source, folder, "a group of properties", "none");
    const Dataset x = open_dataset(source, folder + "/x");
    const std::size_t particles = value_count(x);
    const Indices real = tagged_particles(source, folder, particles, real_tag);
    Snapshot state;
    state.positions = read_positions(source, folder, particles, real);
    state.boundary = read_positions(source, folder, particles,
                                    tagged_particles(source, folder, particles, ghost_tag));
    if (std::holds_alternative<std::vector<float>>(empty_values(source, x)))
        state.position_precision = Precision::float32;
    for (const std::string& name : properties ? array_names_in(source, folder) : Names()) {
        std::optional<PointArray> property;
        if (name != "x" && name != "y" && name != "z" && name != "tag")
            property = read_property(source, folder, name, particles);
        if (property) {
            keep_rows(*property, real);
            state.point_data.push_back(std::move(*property));
        }
    }
    return state;
}

/// Adds the values to those of the array of the same name; false where the two do not match.
bool append(PointArray& array, const PointArray* more) {
    if (more == nullptr || array.components != more->components ||
        array.values.index() != more->values.index())
        return false;
    std::visit(
        [&](auto& values) {
            const auto& added = std::get<std::decay_t<decltype(values)>>(more->values);
            values.insert(values.end(), added.begin(), added.end());
        },
        array.values);
    return true;
}

/// Adds particles, and keeps the properties that both have.
void append(Snapshot& state, Snapshot more) {
    if (!state.positions.empty())
        state.boundary.insert(state.boundary.end(), more.boundary.begin(), more.boundary.end());
    if (state.positions.empty()) {
        state = std::move(more);
    } else if (!more.positions.empty()) {
        state.positions.insert(state.positions.end(), more.positions.begin(), more.positions.end());
        auto& arrays = state.point_data;
        arrays.erase(std::remove_if(arrays.begin(), arrays.end(),
                                    [&](PointArray& array) {
                                        return !append(array, find_array(more, array.name));
                                    }),
                     arrays.end());
    }
}

/// Removes the array from the snapshot and returns it.
std::optional<PointArray> take(Snapshot& snapshot, std::string_view name) {
    for (auto array = snapshot.point_data.begin(); array != snapshot.point_data.end(); ++array) {
        if (array->name == name) {
            PointArray taken = std::move(*array);
            snapshot.point_data.erase(array);
            return taken;
        }
    }
    return std::nullopt;
}

/// Particles of a run on one process all have the same id, which says nothing.
bool tells_apart(const PointArray& id) {
    const std::vector<double> ids = as_doubles(id);
    return std::any_of(ids.begin(), ids.end(), [](double number) {
        return number != std::numeric_limits<std::uint32_t>::max();
    });
}

void rename_properties(Snapshot& snapshot) {
    constexpr std::pair<const char*, const char*> our_names[] = {{"p", "pressure"}, {"gid", "id"}};
    for (const auto& [name, ours] : our_names) {
        auto property = take(snapshot, name);
        if (property && (name != std::string_view("gid") || tells_apart(*property))) {
            property->name = ours;
            set_array(snapshot, std::move(*property));
        }
    }
}

/// 2 h, as one number or as point data. Nothing where a particle has no length that is positive.
void take_support_radius(Snapshot& snapshot) {
    const auto smoothing_length = take(snapshot, "h");
    if (!smoothing_length || smoothing_length->components != 1)
        return;
    std::vector<double> h = as_doubles(*smoothing_length);
    if (!std::all_of(h.begin(), h.end(), [](double x) { return x > 0 && std::isfinite(2 * x); }))
        return;
    const auto [min, max] = std::minmax_element(h.begin(), h.end());
    std::string range = rounded_text(*min, 3);
    if (*min == *max) {
        snapshot.support_radius = 2 * h[0];
    } else {
        range += " to " + rounded_text(*max, 3);
        std::for_each(h.begin(), h.end(), [](double& x) { x *= 2; });
        set_array(snapshot, {"support_radius", 1, std::move(h)});
    }
    snapshot.provenance["support_radius_from"] =
        "2 x PySPH's smoothing length h of " + range +
        " m; give --support-radius where the kernel's radius is not 2 h";
}

/// The fluid arrays' particles one after another, each array a phase where there are several, with
/// those of inlets and outlets in the phase of the first.
Snapshot read_fluids(const Hdf5Source& source, const Roles& roles) {
    Snapshot snapshot;
    std::vector<std::int32_t> phases;
    const auto add = [&](const std::string& array, std::size_t phase) {
        Snapshot more = read_array(source, array, true);
        phases.insert(phases.end(), more.size(), static_cast<std::int32_t>(phase));
        append(snapshot, std::move(more));
    };
    for (std::size_t phase = 0; phase < roles.fluids.size(); ++phase)
        add(roles.fluids[phase], phase);
    for (const std::string& opening : roles.openings)
        add(opening, 0);
    if (roles.fluids.size() > 1)
        set_array(snapshot, {"phase", 1, std::move(phases)});
    return snapshot;
}

std::string shown(const char* what, const Names& arrays) {
    return arrays.empty() ? "" : std::string("; ") + what + ": " + joined(arrays);
}

/// What the arrays were taken for.
std::string roles_note(const Roles& roles, std::size_t ghosts) {
    std::string note = "arrays of fluid: " + joined(roles.fluids);
    if (!roles.openings.empty())
        note += " with " + joined(roles.openings) + " as more of " + roles.fluids.front();
    return note + shown("walls", roles.walls) + shown("ignored", roles.ignored) +
           (ghosts > 0 ? "; " + std::to_string(ghosts) + " ghosts cover as walls do" : "");
}

bool holds_pysph(const Hdf5Source& source) {
    return exists(source, "/particles") && exists(source, "/solver_data");
}

/// The real particles (`tag` 0) of the fluids. Properties that all fluid arrays store keep their
/// names, but for `pressure` and `id`. A support radius that varies is point data `support_radius`.
/// Throws InputError where there is no fluid particle, and where an array may be fluid or wall.
Snapshot pysph_snapshot(const Hdf5Source& source, const ReadChoices& choices) {
    const Roles roles = roles_of(source, choices);
    Snapshot snapshot = read_fluids(source, roles);
    if (snapshot.positions.empty()) {
        fail(source, "/particles", "fluid particles",
             "none in the arrays " + joined(roles.fluids.empty() ? roles.walls : roles.fluids) +
                 (roles.fluids.empty() ? ", which are walls by their names" : ""));
    }
    const std::size_t ghosts = snapshot.boundary.size();
    for (const std::string& wall : roles.walls) {
        const Snapshot more = read_array(source, wall, false);
        for (const Positions* positions : {&more.positions, &more.boundary})
            snapshot.boundary.insert(snapshot.boundary.end(), positions->begin(), positions->end());
    }
    rename_properties(snapshot);
    take_support_radius(snapshot);
    const auto time = number_attribute<double>(source, "/solver_data", "t", 1);
    if (!time.empty() && std::isfinite(time[0]))
        snapshot.time = time[0];
    Positions all = snapshot.positions;
    all.insert(all.end(), snapshot.boundary.begin(), snapshot.boundary.end());
    snapshot.dimension = dimension_of(all);
    Names fluids = roles.fluids;
    fluids.insert(fluids.end(), roles.openings.begin(), roles.openings.end());
    snapshot.provenance["fluid_arrays"] = joined(fluids);
    if (!roles.walls.empty())
        snapshot.provenance["boundary_arrays"] = joined(roles.walls);
    if (fluids.size() > 1 || !roles.walls.empty() || !roles.ignored.empty() || ghosts > 0)
        snapshot.notes.push_back(roles_note(roles, ghosts));
    return snapshot;
}

} // namespace

Hdf5Format pysph_format() {
    return {"PySPH", holds_pysph, pysph_snapshot};
}

} // namespace meniscus
