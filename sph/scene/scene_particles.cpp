#include "scene_size.hpp"

#include "detail/scene_limits.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/boundary_sampling.hpp>
#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

constexpr double min_distance = 0.1; // of two fluid particles, over the spacing
constexpr double rounding = 1e-6;    // of lengths that should be whole spacings
const NeighborFilter crowds_cut = {nullptr, nullptr,
                                   usual_max_crowd}; // one neighbor shows an overlap

/// The places first + spacing (i, j, k) below `count` that `holds` is true for.
template <class Holds>
Positions lattice_places(const Place& first, const std::array<double, 3>& count, double spacing,
                         const Holds& holds) {
    if (!(count[0] * count[1] * count[2] <= max_particles))
        throw InputError("would have about " + rounded_text(count[0] * count[1] * count[2], 2) +
                         " particles; make it smaller or take a larger particle_spacing");
    Positions places;
    if (count[0] * count[1] * count[2] == 0)
        return places; // one of the others may be larger than any int
    for (int i = 0; i < count[0]; ++i)
        for (int j = 0; j < count[1]; ++j)
            for (int k = 0; k < count[2]; ++k) {
                const Place place{first[0] + i * spacing, first[1] + j * spacing,
                                  first[2] + k * spacing};
                if (holds(place))
                    places.push_back(place);
            }
    return places;
}

bool everywhere(const Place&) {
    return true;
}

Positions fluid_places(const LatticeShape& shape, const Scene& scene) {
    return lattice_places(shape.first,
                          {double(shape.count[0]), double(shape.count[1]), double(shape.count[2])},
                          scene.particle_spacing, everywhere);
}

Positions fluid_places(const BoxShape& shape, const Scene& scene) {
    Place first{};
    std::array<double, 3> count{1, 1, 1};
    for (int axis = 0; axis < scene.dimension; ++axis) {
        first[axis] = shape.low[axis] + scene.particle_spacing / 2;
        count[axis] =
            std::floor((shape.high[axis] - shape.low[axis]) / scene.particle_spacing + rounding);
    }
    return lattice_places(first, count, scene.particle_spacing, everywhere);
}

Positions fluid_places(const SphereShape& shape, const Scene& scene) {
    Place first = shape.center;
    std::array<double, 3> count{1, 1, 1};
    for (int axis = 0; axis < scene.dimension; ++axis) {
        const double reach = std::floor(shape.half_axes[axis] / scene.particle_spacing + rounding);
        first[axis] -= reach * scene.particle_spacing;
        count[axis] = 2 * reach + 1;
    }
    return lattice_places(first, count, scene.particle_spacing, [&](const Place& place) {
        double sum = 0;
        for (int axis = 0; axis < scene.dimension; ++axis) {
            const double offset = (place[axis] - shape.center[axis]) / shape.half_axes[axis];
            sum += offset * offset;
        }
        return sum <= 1 + rounding;
    });
}

void check_place(const Place& place, std::size_t particle, int dimension, const char* what) {
    const bool finite =
        std::all_of(place.begin(), place.end(), [](double x) { return std::isfinite(x); });
    if (!finite || (dimension == 2 && place[2] != 0))
        throw InputError(std::string(what) + " of particle " + std::to_string(particle) +
                         (finite ? " is not in the plane z = 0" : " is not finite") +
                         "; a scene cannot start from it");
}

/// The stored velocities; zero where there are none.
std::vector<Place> snapshot_velocities(const Snapshot& snapshot) {
    std::vector<Place> velocities(snapshot.size());
    const PointArray* array = find_array(snapshot, "velocity");
    if (array == nullptr)
        return velocities;
    if (array->components != 3)
        throw InputError("array 'velocity' must have 3 components, found " +
                         std::to_string(array->components));
    const std::vector<double> values = as_doubles(*array);
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        velocities[i] = {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
        check_place(velocities[i], i, snapshot.dimension, "velocity");
    }
    return velocities;
}

/// The step knows one fluid of equal particles.
void check_equal(const Snapshot& snapshot, const char* name) {
    constexpr double tolerance = 1e-3;
    if (find_array(snapshot, name) == nullptr)
        return;
    const std::vector<double> values = scalar_values(snapshot, name);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!(std::abs(values[i] - values[0]) <= tolerance * std::abs(values[0])))
            throw InputError(std::string("particle ") + std::to_string(i) + " has " + name + " " +
                             number_text(values[i]) + " and particle 0 " + number_text(values[0]) +
                             "; the fluid of a scene has particles of one mass and phase, so keep "
                             "those alone");
}

/// Single precision keeps seven digits of a coordinate, whatever the spacing is.
void check_stored_precision(const Snapshot& snapshot, const Scene& scene) {
    constexpr double share = 0.01; // of a spacing
    if (snapshot.position_precision != Precision::float32)
        return;
    for (std::size_t i = 0; i < snapshot.size(); ++i)
        for (const double coordinate : snapshot.positions[i])
            if (0x1p-24 * std::abs(coordinate) > share * scene.particle_spacing)
                throw InputError("particle " + std::to_string(i) + " has a coordinate of " +
                                 number_text(coordinate) +
                                 " m in single precision, which far out does not hold a hundredth "
                                 "of a spacing; store positions in double, or nearer to the "
                                 "origin");
}

/// Positions and velocities of one body.
struct Filled {
    Positions positions;
    std::vector<Place> velocities;
};

template <class Shape>
Filled fill(const Shape& shape, const Scene& scene) {
    Filled filled{fluid_places(shape, scene), {}};
    filled.velocities.resize(filled.positions.size());
    return filled;
}

Filled fill(const SnapshotShape& shape, const Scene& scene) {
    return naming_file(shape.file, [&] {
        const Snapshot snapshot = read_snapshot(shape.file);
        if (snapshot.dimension != scene.dimension)
            throw InputError("has " + std::to_string(snapshot.dimension) +
                             " dimensions, the scene has " + std::to_string(scene.dimension));
        check_equal(snapshot, "mass");
        check_equal(snapshot, "phase");
        check_stored_precision(snapshot, scene);
        Filled filled{snapshot.positions, snapshot_velocities(snapshot)};
        for (std::size_t i = 0; i < filled.positions.size(); ++i) {
            for (int axis = 0; axis < 3; ++axis)
                filled.positions[i][axis] += shape.translation[axis];
            check_place(filled.positions[i], i, scene.dimension, "position");
        }
        return filled;
    });
}

void check_total(double particles, const char* of_what) {
    if (particles > max_particles)
        throw InputError("the scene would have " + rounded_text(particles, 3) + " " + of_what +
                         " particles; take a larger particle_spacing");
}

/// "fluid[0]", where bodies (or walls) begin at these particles.
std::string entry_of(const char* list, std::size_t particle,
                     const std::vector<std::size_t>& starts) {
    const auto next = std::upper_bound(starts.begin(), starts.end(), particle);
    return std::string(list) + "[" + std::to_string(next - starts.begin() - 1) + "]";
}

[[noreturn]] void refuse_overlap(const Scene& scene, std::size_t i, const std::string& of_i,
                                 std::size_t j, const std::string& of_j, double distance,
                                 const char* advice) {
    throw InputError("scene '" + scene.name + "': particles " + std::to_string(i) + " of " + of_i +
                     " and " + std::to_string(j) + " of " + of_j + " lie " +
                     rounded_text(distance / scene.particle_spacing, 2) + " spacings apart; " +
                     advice);
}

double distance_of(const Place& a, const Place& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Refuses particles that all but coincide, and bodies that overlap: a particle of one that lies
/// among those of another.
void check_distances(const Scene& scene, const SceneParticles& particles,
                     const std::vector<std::size_t>& starts) {
    constexpr double inside = 0.51; // one on the middle of an edge of the other's lattice
    constexpr double among = 0.9;   // one anywhere in the other's lattice has several so near
    const Positions& places = particles.positions;
    const double spacing = scene.particle_spacing;
    const NeighborLists lists = find_neighbors(places, among * spacing, crowds_cut);
    for (std::size_t i = 0; i < places.size(); ++i) {
        int others = 0;
        for (std::size_t n = lists.offsets[i]; n < lists.offsets[i + 1]; ++n) {
            const std::size_t j = lists.neighbors[n];
            const double distance = distance_of(places[i], places[j]) / spacing;
            const std::string of_i = entry_of("fluid", i, starts);
            const std::string of_j = entry_of("fluid", j, starts);
            others += of_i == of_j ? 0 : 1;
            if (distance < min_distance || (of_i != of_j && distance < inside) ||
                others > scene.dimension - 1)
                refuse_overlap(scene, i, of_i, j, of_j, distance * spacing,
                               "bodies overlap there: move them apart");
        }
    }
}

/// Refuses fluid in a wall. A start half a spacing away is common, and the step makes room for it.
void check_wall_distances(const Scene& scene, const SceneParticles& particles,
                          const std::vector<std::size_t>& fluid_starts,
                          const std::vector<std::size_t>& wall_starts) {
    constexpr double inside = 0.4;
    Positions places = particles.positions;
    const std::size_t fluid = places.size();
    places.insert(places.end(), particles.walls.begin(), particles.walls.end());
    const NeighborLists lists = find_neighbors(places, inside * scene.particle_spacing, crowds_cut);
    for (std::size_t i = 0; i < fluid; ++i)
        for (std::size_t n = lists.offsets[i]; n < lists.offsets[i + 1]; ++n) {
            const std::size_t j = lists.neighbors[n];
            if (j >= fluid)
                refuse_overlap(scene, i, entry_of("fluid", i, fluid_starts), j - fluid,
                               entry_of("walls", j - fluid, wall_starts),
                               distance_of(places[i], places[j]),
                               "fluid lies in the wall there: move one of them, or cut the fluid");
        }
}

void check_domain(const Scene& scene, const SceneParticles& particles) {
    if (!scene.domain)
        return;
    const auto& [low, high] = *scene.domain;
    for (std::size_t i = 0; i < particles.positions.size(); ++i)
        for (int axis = 0; axis < scene.dimension; ++axis) {
            const double x = particles.positions[i][axis];
            if (x < low[axis] || x > high[axis])
                throw InputError("scene '" + scene.name + "': particle " + std::to_string(i) +
                                 " starts outside the domain, at " + "xyz"[axis] + " = " +
                                 number_text(x) + "; make the domain larger");
        }
}

Positions wall_places(const BoxShape& shape, const Scene& scene) {
    BoxSides sides{shape.low, shape.high, {}};
    const std::array<std::string, 6> names{"-x", "+x", "-y", "+y", "-z", "+z"};
    for (const std::string& open : shape.open)
        sides.open[std::find(names.begin(), names.end(), open) - names.begin()] = true;
    return sample_box(sides, scene.particle_spacing, scene.dimension);
}

Positions wall_places(const SphereShape& shape, const Scene& scene) {
    return sample_ellipsoid(shape.center, shape.half_axes, irregular_share * scene.particle_spacing,
                            scene.dimension);
}

Positions wall_places(const MeshShape& shape, const Scene& scene) {
    TriangleMesh mesh = read_obj(shape.file);
    for (Place& vertex : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis)
            vertex[axis] = shape.scale * vertex[axis] + shape.translation[axis];
    return naming_file(shape.file,
                       [&] { return sample_mesh(mesh, irregular_share * scene.particle_spacing); });
}

/// Calls `work()`; an InputError from it gets the scene and the entry in front.
template <class Work>
auto naming_entry(const Scene& scene, const char* list, std::size_t entry, Work&& work) {
    try {
        return work();
    } catch (const InputError& error) {
        throw InputError("scene '" + scene.name + "', " + list + "[" + std::to_string(entry) +
                         "]: " + error.what());
    }
}

/// Returns where the bodies begin.
std::vector<std::size_t> add_fluid(const Scene& scene, SceneParticles& particles) {
    std::vector<std::size_t> starts;
    for (std::size_t b = 0; b < scene.fluid.size(); ++b) {
        const FluidBody& body = scene.fluid[b];
        Filled filled = naming_entry(scene, "fluid", b, [&] {
            Filled result =
                std::visit([&](const auto& shape) { return fill(shape, scene); }, body.shape);
            if (result.positions.empty())
                throw InputError("holds no particle; make it larger than particle_spacing");
            return result;
        });
        for (Place& velocity : filled.velocities)
            for (int axis = 0; axis < 3; ++axis)
                velocity[axis] += body.velocity[axis];
        starts.push_back(particles.positions.size());
        check_total(double(starts.back()) + double(filled.positions.size()), "fluid");
        particles.positions.insert(particles.positions.end(), filled.positions.begin(),
                                   filled.positions.end());
        particles.velocities.insert(particles.velocities.end(), filled.velocities.begin(),
                                    filled.velocities.end());
    }
    if (particles.positions.empty())
        throw InputError("scene '" + scene.name + "' has no fluid; name a body under 'fluid'");
    const std::string what = "scene '" + scene.name + "': particle ";
    for (std::size_t i = 0; i < particles.positions.size(); ++i)
        check_resolution(particles.positions[i], scene, what.c_str(), i);
    check_distances(scene, particles, starts);
    check_domain(scene, particles);
    return starts;
}

} // namespace

void check_resolution(const Place& place, const Scene& scene, const char* what,
                      std::size_t number) {
    constexpr double share = 1e-6; // of a spacing
    for (int axis = 0; axis < scene.dimension; ++axis)
        if (std::abs(place[axis]) * 0x1p-53 > share * scene.particle_spacing)
            throw InputError(what + std::to_string(number) + " is at " + "xyz"[axis] + " = " +
                             number_text(place[axis]) +
                             " m, where numbers in double precision no longer hold a millionth of "
                             "a spacing; move the scene closer to the origin");
}

SceneParticles fill_scene(const Scene& scene) {
    check_size(scene);
    SceneParticles particles;
    const std::vector<std::size_t> fluid_starts = add_fluid(scene, particles);
    std::vector<std::size_t> wall_starts;
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
        const Positions places = naming_entry(scene, "walls", w, [&] {
            return std::visit([&](const auto& shape) { return wall_places(shape, scene); },
                              scene.walls[w].shape);
        });
        check_total(double(particles.walls.size()) + double(places.size()), "wall");
        wall_starts.push_back(particles.walls.size());
        particles.walls.insert(particles.walls.end(), places.begin(), places.end());
        particles.wall_contact_angles.resize(
            particles.walls.size(), static_cast<float>(scene.walls[w].contact_angle.value_or(
                                        scene.surface_tension.surface.contact_angle)));
    }
    check_wall_distances(scene, particles, fluid_starts, wall_starts);
    particles.mass = scene.rest_density * scene.volume_share;
    for (int axis = 0; axis < scene.dimension; ++axis)
        particles.mass *= scene.particle_spacing;
    return particles;
}

double particle_volume(const Scene& scene) {
    double volume = scene.volume_share;
    for (int axis = 0; axis < scene.dimension; ++axis)
        volume *= scene.particle_spacing;
    return volume;
}

double spacing_ratio(const Scene& scene) {
    return scene.support_radius / scene.particle_spacing /
           std::pow(scene.volume_share, 1.0 / scene.dimension);
}

std::array<Place, 2> scene_domain(const Scene& scene, const SceneParticles& particles) {
    if (scene.domain)
        return *scene.domain;
    std::array<Place, 2> box{particles.positions.at(0), particles.positions.at(0)};
    for (const Positions* places : {&particles.positions, &particles.walls})
        for (const Place& place : *places)
            for (int axis = 0; axis < 3; ++axis) {
                box[0][axis] = std::min(box[0][axis], place[axis]);
                box[1][axis] = std::max(box[1][axis], place[axis]);
            }
    double longest = scene.particle_spacing; // of a single particle
    for (int axis = 0; axis < 3; ++axis)
        longest = std::max(longest, box[1][axis] - box[0][axis]);
    for (int axis = 0; axis < scene.dimension; ++axis) {
        box[0][axis] -= longest;
        box[1][axis] += longest;
    }
    return box;
}

} // namespace meniscus
