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

// Of the largest resident size of runs, per particle, and then some less: what is refused must be
// too large indeed.
constexpr double bytes_of_fluid = 900;
constexpr double bytes_of_wall = 350;

double fluid_in(const LatticeShape& shape, const Scene& /*scene*/) {
    return double(shape.count[0]) * double(shape.count[1]) * double(shape.count[2]);
}

double fluid_in(const BoxShape& shape, const Scene& scene) {
    double count = 1;
    for (int axis = 0; axis < scene.dimension; ++axis)
        count *= std::max(0.0, (shape.high[axis] - shape.low[axis]) / scene.particle_spacing);
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

double bytes_from(const char* file) {
    std::ifstream stream(file);
    double bytes = 0;
    return stream >> bytes ? bytes : INFINITY; // "max" is none
}

std::string count_text(const SceneSize& size) {
    return rounded_text(size.fluid, 3) + " fluid and " + rounded_text(size.walls, 3) +
           " wall particles";
}

} // namespace

SceneSize expected_size(const Scene& scene) {
    SceneSize size;
    for (const FluidBody& body : scene.fluid)
        size.fluid +=
            std::visit([&](const auto& shape) { return fluid_in(shape, scene); }, body.shape);
    for (const Wall& wall : scene.walls)
        size.walls +=
            std::visit([&](const auto& shape) { return walls_on(shape, scene); }, wall.shape);
    size.memory = bytes_of_fluid * size.fluid + bytes_of_wall * size.walls;
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
    const std::string what = "scene '" + scene.name + "' would have about " + count_text(size);
    if (size.fluid > max_particles || size.walls > max_particles)
        throw InputError(what + ", expected at most " + rounded_text(max_particles, 3) +
                         " of each; take a larger particle_spacing");
    const double limit = memory_limit();
    if (size.memory > limit)
        throw FailureError(what + ", which take about " + rounded_text(size.memory / 1e9, 3) +
                           " GB; there are " + rounded_text(limit / 1e9, 3) +
                           " GB. Take a larger particle_spacing, or a larger machine");
}

} // namespace meniscus
