#include "clouds.hpp"

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/data/threads/threads.hpp>

#include <meniscus/runtime/math/angles.hpp>
#include <meniscus/runtime/math/random_directions.hpp>
#include <meniscus/runtime/math/vector3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double max_count = 5e8;

/// A stream of numbers in [0, 1), the same on every machine.
class RandomNumbers {
public:
    RandomNumbers(std::uint64_t seed, std::uint64_t stream) : key_(mix_bits(seed) ^ stream) {
        key_ = mix_bits(key_);
    }

    double next() { return static_cast<double>(mix_bits(key_ + drawn_++) >> 11) * 0x1p-53; }

    /// Evenly distributed in a box.
    Vector3 next_in(const Box& box) {
        Vector3 place{};
        for (int axis = 0; axis < 3; ++axis)
            if (box.low[axis] < box.high[axis])
                place[axis] = box.low[axis] + next() * (box.high[axis] - box.low[axis]);
        return place;
    }

private:
    std::uint64_t key_;
    std::uint64_t drawn_ = 0;
};

/// What random numbers are drawn for.
enum Stream : std::uint64_t { in_volume, on_surface, turning, scattering, shaking };

/// The part of a shape's fluid that is filled.
struct Region {
    const Shape& shape;
    double thickness; ///< infinite where all is filled
    Box box;          ///< holds it
};

Box common_part(const Box& a, const Box& b) {
    Box part;
    for (int axis = 0; axis < 3; ++axis) {
        part.low[axis] = std::max(a.low[axis], b.low[axis]);
        part.high[axis] = std::min(a.high[axis], b.high[axis]);
    }
    return part;
}

Region region_of(const Shape& shape, const CloudOptions& options) {
    const bool endless = shape.side == Side::outside || !shape.bounded;
    const double thickness =
        options.thickness.value_or(endless ? 4 * options.support_radius : infinity);
    return {shape, thickness, common_part(shape.box_around(endless ? thickness : 0), shape.patch)};
}

/// Number of particles that the box would hold.
double count_in(const Box& box, double spacing, int dimension) {
    double count = 1;
    for (int axis = 0; axis < dimension; ++axis)
        count *= (box.high[axis] - box.low[axis]) / spacing;
    return count;
}

/// How far it is to the nearest side of a box from a place in it; negative outside.
double distance_to_sides(const Box& box, const Vector3& place) {
    double distance = infinity;
    for (int axis = 0; axis < 3; ++axis)
        distance = std::min({distance, place[axis] - box.low[axis], box.high[axis] - place[axis]});
    return distance;
}

bool is_in(const Region& region, const Vector3& place) {
    return in_fluid(region.shape, place) && distance_to_sides(region.shape.patch, place) >= 0 &&
           (region.thickness == infinity ||
            -nearest_surface_point(region.shape, place).signed_distance < region.thickness);
}

void check_length(double value, const std::string& what) {
    if (!(value > 0) || !std::isfinite(value))
        throw InputError(what + " must be positive and finite, found " + number_text(value));
}

void check_share(double value, const std::string& what) {
    if (!(value >= 0 && value < 1))
        throw InputError(what + " must be at least 0 and below 1, found " + number_text(value));
}

/// Counts at least one particle along each axis, however thin the box.
void check_count(Box box, const std::string& what, double spacing, int dimension) {
    for (int axis = 0; axis < dimension; ++axis)
        box.high[axis] = std::max(box.high[axis], box.low[axis] + spacing);
    const double count = count_in(box, spacing, dimension);
    if (!(count <= max_count))
        throw InputError("the box around the " + what + " holds " + rounded_text(count, 3) +
                         " particles of spacing " + number_text(spacing) +
                         " m, at most 5e8 are filled; are both in m?");
}

void check_options(const Shape& shape, const CloudOptions& options) {
    check_length(options.spacing, "particle spacing");
    check_length(options.support_radius, "support radius");
    if (options.thickness)
        check_length(*options.thickness, "thickness of the fluid");
    check_share(options.surface_share, "share of particles on the surface");
    check_share(options.jitter, "jitter");
    if (options.surface_share > 0 && options.arrangement != Arrangement::random)
        throw InputError("particles on the surface are only there in a random arrangement; leave "
                         "their share 0 in others");
    if (shape.min_extent < options.spacing)
        throw InputError("the " + shape.name + " is " + number_text(shape.min_extent) +
                         " m wide, less than one particle spacing of " +
                         number_text(options.spacing) + " m");
}

/// Points of the surface, evenly distributed over it: those of a thin layer on both its sides, of
/// which curvature holds as much more on one side as less on the other.
void add_on_surface(const Region& region, std::size_t count, const CloudOptions& options,
                    Positions& positions) {
    const double reach = options.spacing / 2;
    const Box box = common_part(region.shape.box_around(reach), region.shape.patch);
    RandomNumbers random(options.seed, on_surface);
    for (const std::size_t end = positions.size() + count; positions.size() < end;) {
        const SurfacePoint point = nearest_surface_point(region.shape, random.next_in(box));
        if (std::fabs(point.signed_distance) < reach &&
            distance_to_sides(region.shape.patch, point.position) >= 0)
            positions.push_back(point.position);
    }
}

Positions random_positions(const Region& region, const CloudOptions& options) {
    const double count = count_in(region.box, options.spacing, region.shape.dimension);
    RandomNumbers random(options.seed, in_volume);
    Positions positions;
    for (auto left = std::llround(count); left > 0; --left) {
        const Vector3 place = random.next_in(region.box);
        if (is_in(region, place))
            positions.push_back(place);
    }
    const auto on_surface_count = static_cast<std::size_t>(
        std::llround(options.surface_share * static_cast<double>(positions.size())));
    positions.resize(positions.size() - on_surface_count);
    add_on_surface(region, on_surface_count, options, positions);
    return positions;
}

/// A lattice around the center of a box.
struct Lattice {
    std::array<Vector3, 3> step; ///< m
    Vector3 origin;              ///< one of its points
};

Lattice random_lattice(const Box& box, const CloudOptions& options, int dimension) {
    RandomDirections directions(options.seed, turning);
    std::array<Vector3, 3> axes{};
    if (dimension == 2) {
        const auto axis = directions.next<2>();
        axes = {Vector3{axis[0], axis[1], 0}, Vector3{-axis[1], axis[0], 0}, Vector3{}};
    } else {
        axes[0] = directions.next<3>();
        const Frame frame(axes[0]);
        const auto turn = directions.next<2>();
        axes[1] = sum(scaled(turn[0], frame.first), scaled(turn[1], frame.second));
        axes[2] = cross(axes[0], axes[1]);
    }
    RandomNumbers random(options.seed, turning);
    Lattice lattice{axes, scaled(0.5, sum(box.low, box.high))};
    for (int axis = 0; axis < dimension; ++axis) {
        lattice.step[axis] = scaled(options.spacing, axes[axis]);
        lattice.origin = sum(lattice.origin, scaled(random.next() - 0.5, lattice.step[axis]));
    }
    return lattice;
}

/// Which points of a line, start + k step with k from `first` to `last`, may lie in the box.
struct LinePart {
    std::int64_t first, last;
};

LinePart whole_numbers(double first, double last) {
    if (!(first <= last))
        return {0, -1};
    return {static_cast<std::int64_t>(std::floor(first)),
            static_cast<std::int64_t>(std::ceil(last))};
}

LinePart part_in(const Box& box, const Vector3& start, const Vector3& step, int dimension) {
    double first = -infinity;
    double last = infinity;
    for (int axis = 0; axis < dimension; ++axis) {
        const double a = (box.low[axis] - start[axis]) / step[axis];
        const double b = (box.high[axis] - start[axis]) / step[axis];
        if (step[axis] != 0) {
            first = std::max(first, std::min(a, b));
            last = std::min(last, std::max(a, b));
        } else if (start[axis] < box.low[axis] || start[axis] > box.high[axis]) {
            return {0, -1};
        }
    }
    return whole_numbers(first, last);
}

/// Whether a place lies in a box, its lower sides included and its upper ones not, so that it lies
/// in one of two boxes side by side.
bool holds(const Box& box, const Vector3& place, int dimension) {
    for (int axis = 0; axis < dimension; ++axis)
        if (!(place[axis] >= box.low[axis] && place[axis] < box.high[axis]))
            return false;
    return true;
}

/// Calls visit(point) with the points of the lattice in a box that is about as wide as long.
template <class Visit>
void visit_lattice_in_block(const Lattice& lattice, const Box& block, int dimension,
                            const Visit& visit) {
    const Vector3 center = scaled(0.5, sum(block.low, block.high));
    const Vector3 half = difference(block.high, center);
    const auto range_along = [&](int axis) -> LinePart {
        const Vector3& step = lattice.step[axis];
        const double square = dot(step, step);
        if (square == 0)
            return {0, 0};
        const double middle = dot(difference(center, lattice.origin), step) / square;
        const double reach = std::sqrt(dot(half, half) / square);
        return whole_numbers(middle - reach, middle + reach);
    };
    const LinePart layers = range_along(2);
    const LinePart lines = range_along(1);
    for (std::int64_t layer = layers.first; layer <= layers.last; ++layer)
        for (std::int64_t line = lines.first; line <= lines.last; ++line) {
            const Vector3 start =
                sum(lattice.origin, sum(scaled(static_cast<double>(line), lattice.step[1]),
                                        scaled(static_cast<double>(layer), lattice.step[2])));
            const LinePart part = part_in(block, start, lattice.step[0], dimension);
            for (std::int64_t k = part.first; k <= part.last; ++k) {
                const Vector3 point = sum(start, scaled(static_cast<double>(k), lattice.step[0]));
                if (holds(block, point, dimension))
                    visit(point);
            }
        }
}

/// The same for any box, block by block: a long one turned against the lattice would otherwise have
/// far more lines to look at than points.
template <class Visit>
void visit_lattice(const Lattice& lattice, const Box& box, double spacing, int dimension,
                   const Visit& visit) {
    const double width = 16 * spacing;
    std::array<std::int64_t, 3> blocks{1, 1, 1};
    for (int axis = 0; axis < dimension; ++axis)
        blocks[axis] = 1 + static_cast<std::int64_t>((box.high[axis] - box.low[axis]) / width);
    for (std::int64_t z = 0; z < blocks[2]; ++z)
        for (std::int64_t y = 0; y < blocks[1]; ++y)
            for (std::int64_t x = 0; x < blocks[0]; ++x) {
                const std::array<std::int64_t, 3> place{x, y, z};
                Box block = box;
                for (int axis = 0; axis < dimension; ++axis) {
                    block.low[axis] = box.low[axis] + static_cast<double>(place[axis]) * width;
                    block.high[axis] = box.low[axis] + static_cast<double>(place[axis] + 1) * width;
                }
                visit_lattice_in_block(lattice, block, dimension, visit);
            }
}

/// The lattice, each point moved within `scatter` cells of it.
Positions lattice_positions(const Region& region, const CloudOptions& options, double scatter) {
    const int dimension = region.shape.dimension;
    const Lattice lattice = random_lattice(region.box, options, dimension);
    RandomNumbers random(options.seed, scattering);
    Box box = region.box; // with what scatter brings in
    const double margin = 2 * scatter * options.spacing;
    for (int axis = 0; axis < dimension; ++axis) {
        box.low[axis] -= margin;
        box.high[axis] += margin;
    }
    Positions positions;
    visit_lattice(lattice, box, options.spacing, dimension, [&](Vector3 place) {
        for (int axis = 0; axis < dimension && scatter > 0; ++axis)
            place = sum(place, scaled(scatter * (random.next() - 0.5), lattice.step[axis]));
        if (is_in(region, place))
            positions.push_back(place);
    });
    return positions;
}

/// A side of the filled region near a place: its surface, or where it is cut off.
struct Wall {
    double distance; ///< m; negative beyond it
    Vector3 outward;
};

struct Walls {
    double depth; ///< of the place below the surface, m
    std::array<Wall, 8> walls;
    int count = 0; ///< of walls within reach
};

Walls walls_near(const Region& region, const Vector3& place, double reach) {
    const SurfacePoint point = nearest_surface_point(region.shape, place);
    Walls near{-point.signed_distance, {}, 0};
    const auto add = [&](double distance, const Vector3& outward) {
        if (distance < reach)
            near.walls[near.count++] = {distance, outward};
    };
    add(near.depth, point.normal);
    add(region.thickness - near.depth, scaled(-1, point.normal));
    for (int axis = 0; axis < 3; ++axis) {
        Vector3 outward{};
        outward[axis] = 1;
        add(region.shape.patch.high[axis] - place[axis], outward);
        add(place[axis] - region.shape.patch.low[axis], scaled(-1, outward));
    }
    return near;
}

// Particles relax by pushing each other apart, and are kept inside by their images behind the
// walls. More sweeps would leave them in better order than solvers do. Next to the surface they
// push less, as in a solver: it finds a density too low there, so that surface tension packs the
// outermost layer more densely than the rest. All measured against the droplets in data/samples.
constexpr int relax_sweeps = 20;
constexpr double push_reach = 1.5;       // spacings
constexpr double push_step = 0.25;       // spacings, of two particles in one place
constexpr double surface_layer = 1;      // spacings
constexpr double surface_push = 0.5;     // against 1 inside, of each of the two
constexpr double closest_to_wall = 0.25; // spacings

/// What pushes in one sweep.
struct Pushers {
    Positions positions;          ///< the particles, then their images
    std::vector<double> strength; ///< of the particles
};

Pushers pushers_of(const Region& region, const Positions& positions, double spacing) {
    Pushers pushers{positions, {}};
    for (const Vector3& place : positions) {
        const Walls near = walls_near(region, place, push_reach * spacing);
        pushers.strength.push_back(near.depth < surface_layer * spacing ? surface_push : 1);
        for (int k = 0; k < near.count; ++k)
            pushers.positions.push_back(
                sum(place, scaled(2 * near.walls[k].distance, near.walls[k].outward)));
    }
    return pushers;
}

/// How far a particle is pushed, m.
Vector3 push_on(std::uint32_t particle, const FoundNeighbors& found, const Pushers& pushers,
                double spacing) {
    Vector3 push{};
    for (std::size_t k = 0; k < found.size(); ++k) {
        const Vector3& displacement = found.displacements[k];
        const double distance = std::sqrt(dot(displacement, displacement));
        if (distance == 0)
            continue;
        const std::uint32_t other = found.particles[k];
        const bool image = other >= pushers.strength.size();
        const double strength = image ? 1 : pushers.strength[particle] * pushers.strength[other];
        const double closeness = 1 - distance / (push_reach * spacing);
        const double step = push_step * spacing * strength * closeness * closeness;
        push = sum(push, scaled(-step / distance, displacement));
    }
    return push;
}

/// The place, moved off the walls where it is too close to them.
Vector3 kept_inside(const Region& region, Vector3 place, double closest) {
    const Walls near = walls_near(region, place, closest);
    for (int k = 0; k < near.count; ++k)
        place = sum(place, scaled(near.walls[k].distance - closest, near.walls[k].outward));
    return place;
}

void relax_once(const Region& region, double spacing, int threads, Positions& positions) {
    const Pushers pushers = pushers_of(region, positions, spacing);
    const NeighborGrid grid(pushers.positions, push_reach * spacing, {}, threads);
    const auto loop = loop_over(threads, 1024);
    std::vector<FoundNeighbors> found_by(loop.workers());
    loop(grid.size(), [&](std::size_t begin, std::size_t end, int worker) {
        FoundNeighbors& found = found_by[worker];
        for (std::size_t place = begin; place < end; ++place) {
            const std::uint32_t particle = grid.particle(place);
            if (particle >= positions.size())
                continue;
            grid.find(place, found);
            const Vector3 moved =
                sum(positions[particle], push_on(particle, found, pushers, spacing));
            positions[particle] = kept_inside(region, moved, closest_to_wall * spacing);
        }
    });
}

Positions relaxed_positions(const Region& region, const CloudOptions& options) {
    Positions positions = lattice_positions(region, options, 1);
    for (int sweep = 0; sweep < relax_sweeps; ++sweep)
        relax_once(region, options.spacing, options.threads, positions);
    // Where walls meet, one may push through the other.
    positions.erase(std::remove_if(positions.begin(), positions.end(),
                                   [&](const Vector3& place) { return !is_in(region, place); }),
                    positions.end());
    return positions;
}

Positions arranged(const Region& region, const CloudOptions& options) {
    switch (options.arrangement) {
    case Arrangement::random:
        return random_positions(region, options);
    case Arrangement::lattice:
        return lattice_positions(region, options, 0);
    default:
        return relaxed_positions(region, options);
    }
}

/// Moves particles at random, save those that would leave the region.
void shake(const Region& region, const CloudOptions& options, Positions& positions) {
    RandomNumbers random(options.seed, shaking);
    for (Vector3& place : positions) {
        Vector3 moved = place;
        for (int axis = 0; axis < region.shape.dimension; ++axis)
            moved[axis] += options.jitter * options.spacing * (2 * random.next() - 1);
        if (is_in(region, moved))
            place = moved;
    }
}

/// Fills in what is known of the particles.
void describe(const Region& region, Cloud& cloud) {
    for (const Vector3& place : cloud.positions) {
        const SurfacePoint point = nearest_surface_point(region.shape, place);
        const double depth = std::max(0.0, -point.signed_distance);
        cloud.normal.push_back(point.normal);
        cloud.mean_curvature.push_back(point.mean_curvature);
        cloud.depth.push_back(depth);
        const double cut = std::min({distance_to_sides(region.shape.patch, place),
                                     region.thickness - depth, point.edge_distance});
        cloud.trusted.push_back(cut >= 2 * cloud.support_radius ? 1 : 0);
    }
}

/// By Newton's method from above; the C library's differs in the last bit between machines.
double cube_root(double value) {
    double root = std::max(value, 1.0);
    for (;;) {
        const double next = (2 * root + value / root / root) / 3;
        if (!(next < root))
            return root;
        root = next;
    }
}

} // namespace

double support_radius_in_spacings(double mean_neighbors, int dimension, Arrangement arrangement) {
    check_length(mean_neighbors, "mean number of neighbors");
    if (dimension != 2 && dimension != 3)
        throw InputError("dimension must be 2 or 3, found " + std::to_string(dimension));
    const double volume = mean_neighbors + (arrangement == Arrangement::random ? 0 : 1);
    return dimension == 2 ? std::sqrt(volume / pi) : cube_root(3 * volume / (4 * pi));
}

Cloud fill(const Shape& shape, const CloudOptions& options) {
    check_options(shape, options);
    const Region region = region_of(shape, options);
    check_count(region.box, shape.name, options.spacing, shape.dimension);
    Cloud cloud;
    cloud.dimension = shape.dimension;
    cloud.spacing = options.spacing;
    cloud.support_radius = options.support_radius;
    cloud.positions = arranged(region, options);
    if (options.jitter > 0)
        shake(region, options, cloud.positions);
    describe(region, cloud);
    return cloud;
}

Positions random_neighborhood(const Shape& shape, const std::array<double, 3>& place, double radius,
                              double spacing, std::uint64_t seed) {
    check_length(radius, "radius of the neighborhood");
    check_length(spacing, "particle spacing");
    for (const double coordinate : place)
        if (!std::isfinite(coordinate))
            throw InputError("place of the neighborhood must be finite, found " +
                             number_text(coordinate));
    const Vector3 half{radius, radius, shape.dimension == 3 ? radius : 0};
    const Box box{scaled(-1, half), half};
    check_count(box, "neighborhood", spacing, shape.dimension);
    RandomNumbers random(seed, in_volume);
    Positions positions{place};
    for (auto left = std::llround(count_in(box, spacing, shape.dimension)); left > 0; --left) {
        const Vector3 step = random.next_in(box);
        const Vector3 there = sum(place, step);
        if (dot(step, step) < radius * radius && in_fluid(shape, there))
            positions.push_back(there);
    }
    return positions;
}

} // namespace meniscus
