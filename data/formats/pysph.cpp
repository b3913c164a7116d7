// PySPH's `.hdf5` output: under /particles a group for each of its particle arrays ("fluid",
// "boundary", ...), whose arrays of coordinates and properties it names by letters, and the time in
// /solver_data. What such a file leaves open is taken as follows, and the snapshot's provenance
// says so:
//   - Which arrays are walls is told by their names (boundary, solid, wall, tank, ...), and rigid
//     bodies by their property `body_id`; all others are fluid, each one a phase where there are
//     several. An array that is alone is fluid whatever its name. (`fluid_arrays`,
//     `boundary_arrays`)
//   - PySPH's h is a smoothing length; the support radius is 2 h, as for its cubic spline and
//     Wendland kernels. (`support_radius_from`)
#include "detail/hdf5_formats.hpp"
#include <meniscus/data/text/errors.hpp>
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

// Words of the names that walls and bodies have in PySPH's examples, and of those that only a fluid
// has, whatever else ("tank_water").
constexpr std::string_view wall_words[] = {"boundary", "solid",   "wall",      "tank",
                                           "obstacle", "channel", "container", "vessel",
                                           "rigid",    "body",    "gate",      "cylinder"};
constexpr std::string_view fluid_words[] = {"fluid", "liquid", "water"};

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

bool is_boundary(const Hdf5Source& source, const std::string& array) {
    return !contains_any(array, fluid_words) &&
           (contains_any(array, wall_words) || exists(source, folder_of(array) + "/body_id"));
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

/// Particles that are not copies of others, such as ghosts and those of another process.
Indices real_particles(const Hdf5Source& source, const std::string& folder, std::size_t particles) {
    const std::vector<double> tags = read_scalars(source, folder, "tag", particles);
    Indices real;
    for (std::size_t i = 0; i < particles; ++i)
        if (tags.empty() || tags[i] == 0)
            real.push_back(i);
    return real;
}

void keep_rows(PointArray& array, const Indices& rows) {
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

/// The real particles of one array. With `properties`, all that is stored of them, under PySPH's
/// names.
Snapshot read_array(const Hdf5Source& source, const std::string& array, bool properties) {
    const std::string folder = folder_of(array);
    if (!exists(source, "/particles/" + array) || !exists(source, folder))
        fail(source, folder, "a group of properties", "none");
    const Dataset x = open_dataset(source, folder + "/x");
    const std::size_t particles = value_count(x);
    const Indices real = real_particles(source, folder, particles);
    Snapshot state;
    state.positions.resize(real.size());
    for (const std::size_t axis : {0, 1, 2}) {
        const std::string name(1, "xyz"[axis]);
        const std::vector<double> values = read_scalars(source, folder, name, particles);
        for (std::size_t i = 0; i < real.size() && !values.empty(); ++i) // else 0, as in a plane
            state.positions[i][axis] = values[real[i]];
    }
    if (std::holds_alternative<std::vector<float>>(empty_values(source, x)))
        state.position_precision = Precision::float32;
    for (const std::string& name : properties ? names_in(source, folder) : Names()) {
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

void take_velocity(Snapshot& snapshot) {
    const auto is_stored = [&](const char* name) {
        const PointArray* array = find_array(snapshot, name);
        return array != nullptr && array->components == 1;
    };
    if (!is_stored("u") || !is_stored("v"))
        return;
    std::vector<double> velocity(3 * snapshot.size());
    for (const std::size_t axis : {0, 1, 2}) {
        const std::string name(1, "uvw"[axis]);
        if (is_stored(name.c_str())) { // w need not be, in two dimensions
            const std::vector<double> values = as_doubles(*take(snapshot, name));
            for (std::size_t i = 0; i < values.size(); ++i)
                velocity[3 * i + axis] = values[i];
        }
    }
    set_array(snapshot, {"velocity", 3, std::move(velocity)});
}

/// Particles of a run on one process all have the same id, which says nothing.
bool tells_apart(const PointArray& id) {
    const std::vector<double> ids = as_doubles(id);
    return std::any_of(ids.begin(), ids.end(), [](double number) {
        return number != std::numeric_limits<std::uint32_t>::max();
    });
}

void rename_properties(Snapshot& snapshot) {
    constexpr std::pair<const char*, const char*> our_names[] = {
        {"rho", "density"}, {"m", "mass"}, {"p", "pressure"}, {"gid", "id"}};
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

/// The fluid arrays' particles one after another, each array a phase where there are several.
Snapshot read_fluids(const Hdf5Source& source, const Names& fluids) {
    Snapshot snapshot;
    std::vector<std::int32_t> phases;
    for (const std::string& fluid : fluids) {
        Snapshot more = read_array(source, fluid, true);
        phases.insert(phases.end(), more.size(), static_cast<std::int32_t>(&fluid - fluids.data()));
        append(snapshot, std::move(more));
    }
    if (fluids.size() > 1)
        set_array(snapshot, {"phase", 1, std::move(phases)});
    return snapshot;
}

std::string joined(const Names& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

bool holds_pysph(const Hdf5Source& source) {
    return exists(source, "/particles") && exists(source, "/solver_data");
}

/// The real particles (`tag` 0). Names become ours: `velocity`, `density`, `mass`, `pressure`,
/// `id`; other properties that all fluid arrays store keep theirs. A support radius that varies is
/// point data `support_radius`. Throws InputError where there is no fluid particle.
Snapshot pysph_snapshot(const Hdf5Source& source) {
    Names fluids = names_in(source, "/particles");
    Names boundaries;
    if (fluids.size() > 1) {
        const auto first_boundary =
            std::stable_partition(fluids.begin(), fluids.end(), [&](const std::string& array) {
                return !is_boundary(source, array);
            });
        boundaries.assign(first_boundary, fluids.end());
        fluids.erase(first_boundary, fluids.end());
    }
    Snapshot snapshot = read_fluids(source, fluids);
    if (snapshot.positions.empty()) {
        fail(source, "/particles", "fluid particles",
             "none in the arrays " + joined(fluids.empty() ? boundaries : fluids) +
                 (fluids.empty() ? ", which are walls by their names" : ""));
    }
    for (const std::string& boundary : boundaries) {
        const Positions more = read_array(source, boundary, false).positions;
        snapshot.boundary.insert(snapshot.boundary.end(), more.begin(), more.end());
    }
    take_velocity(snapshot);
    rename_properties(snapshot);
    take_support_radius(snapshot);
    const auto time = number_attribute<double>(source, "/solver_data", "t", 1);
    if (!time.empty() && std::isfinite(time[0]))
        snapshot.time = time[0];
    Positions all = snapshot.positions;
    all.insert(all.end(), snapshot.boundary.begin(), snapshot.boundary.end());
    snapshot.dimension = dimension_of(all);
    snapshot.provenance["fluid_arrays"] = joined(fluids);
    if (!boundaries.empty())
        snapshot.provenance["boundary_arrays"] = joined(boundaries);
    return snapshot;
}

} // namespace

Hdf5Format pysph_format() {
    return {"PySPH", holds_pysph, pysph_snapshot};
}

} // namespace meniscus
