#include "scene_size.hpp"

#include "detail/scene_limits.hpp"

#include <meniscus/data/particles/boundary_sampling.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/math/angles.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace meniscus {
namespace {

// By how much the largest resident size of a run (DFSPH, h of two spacings) grows with each
// particle of a kind, rounded down: what is refused must be too large indeed.
constexpr double bytes_of_fluid = 650; // without neighbor lists
constexpr double bytes_of_neighbor = 4;
constexpr double bytes_on_box = 180;
constexpr double bytes_on_irregular_wall = 280;

double fluid_in(const LatticeShape& shape, const Scene& /*scene*/) {
    return double(shape.count[0]) * double(shape.count[1]) * double(shape.count[2]);
}

double fluid_in(const BoxShape& shape, const Scene& scene) {
    double count = 1;
    for (int axis = 0; axis < scene.dimension; ++axis)
        count *= std::floor((shape.high[axis] - shape.low[axis]) / scene.particle_spacing);
    return count;
}

double fluid_in(const SphereShape& shape, const Scene& scene) {
    double count = scene.dimension == 2 ? pi : 4 * pi / 3;
    for (int axis = 0; axis < scene.dimension; ++axis)
        count *= shape.half_axes[axis] / scene.particle_spacing;
    return count;
}

double fluid_in(const SnapshotShape& /*shape*/, const Scene& /*scene*/) {
    return 0;
}

double walls_on(const BoxShape& shape, const Scene& scene) {
    std::array<double, 3> parts{};
    for (int axis = 0; axis < scene.dimension; ++axis)
        parts[axis] = (shape.high[axis] - shape.low[axis]) / scene.particle_spacing;
    if (scene.dimension == 2)
        return 2 * (parts[0] + parts[1]);
    return 2 * (parts[0] * parts[1] + parts[1] * parts[2] + parts[2] * parts[0]);
}

double walls_on(const SphereShape& shape, const Scene& scene) {
    const double spacing = irregular_share * scene.particle_spacing;
    const double longest = *std::max_element(shape.half_axes.begin(), shape.half_axes.end());
    return scene.dimension == 2 ? 4 * longest / spacing
                                : 2 * pi * longest * longest / (spacing * spacing);
}

double walls_on(const MeshShape& shape, const Scene& scene) {
    try {
        return expected_points(read_obj(shape.file),
                               irregular_share * scene.particle_spacing / std::abs(shape.scale));
    } catch (const InputError&) { // whoever fills the scene says which entry it is
        return 0;
    }
}

double neighbors_of(const Scene& scene) {
    const double h = spacing_ratio(scene);
    return scene.dimension == 2 ? pi * h * h : 4 * pi / 3 * h * h * h;
}

double bytes_from(const char* file) {
    std::ifstream stream(file);
    double bytes = 0;
    return stream >> bytes ? bytes : INFINITY; // "max" is none
}

/// The count, unless nobody can mean it.
double checked(double count, const Scene& scene, const char* list, std::size_t entry) {
    if (count > max_particles)
        throw InputError("scene '" + scene.name + "', " + list + "[" + std::to_string(entry) +
                         "]: would have about " + rounded_text(count, 2) +
                         (list == std::string("walls") ? " wall" : "") +
                         " particles, expected at most " + rounded_text(max_particles, 2) +
                         "; make it smaller or take a larger particle_spacing");
    return count;
}

} // namespace

SceneSize expected_size(const Scene& scene) {
    SceneSize size;
    for (std::size_t b = 0; b < scene.fluid.size(); ++b)
        size.fluid += checked(std::visit([&](const auto& shape) { return fluid_in(shape, scene); },
                                         scene.fluid[b].shape),
                              scene, "fluid", b);
    size.memory = size.fluid *
                  (bytes_of_fluid + bytes_of_neighbor * std::min(neighbors_of(scene), size.fluid));
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
        const WallShape& wall = scene.walls[w].shape;
        const double count =
            checked(std::visit([&](const auto& shape) { return walls_on(shape, scene); }, wall),
                    scene, "walls", w);
        size.walls += count;
        size.memory += count * (std::holds_alternative<BoxShape>(wall) ? bytes_on_box
                                                                       : bytes_on_irregular_wall);
    }
    return size;
}

double memory_limit() {
    double bytes = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        bytes = std::min(bytes, double(limit.rlim_cur));
    for (const char* file :
         {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
        bytes = std::min(bytes, bytes_from(file));
    return bytes;
}

void check_size(const Scene& scene) {
    const SceneSize size = expected_size(scene);
    const double limit = memory_limit();
    if (size.memory > limit)
        throw FailureError(
            "scene '" + scene.name + "' would have about " + rounded_text(size.fluid, 3) +
            " fluid and " + rounded_text(size.walls, 3) + " wall particles, which take about " +
            rounded_text(size.memory / 1e9, 3) + " GB; there are " + rounded_text(limit / 1e9, 3) +
            " GB. Take a larger particle_spacing, or a larger machine");
}

} // namespace meniscus
