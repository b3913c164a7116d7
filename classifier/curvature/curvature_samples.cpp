#include "curvature_samples.hpp"

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/data/threads/threads.hpp>
#include <meniscus/runtime/math/random_directions.hpp>
#include <meniscus/runtime/surface/curvature_map.hpp>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace meniscus {
namespace {

constexpr double fluid_thickness = 3.2;   ///< filled below the surface: trusted to a depth of 1.2 h
constexpr double candidate_depth = 1;     ///< no surface particle of a filled cloud lies deeper
constexpr int max_clouds = 10;            ///< of a group
constexpr double surface_layer = 2.0 / 3; ///< its volume on a disc is that of the half ball

/// Neighbor lists of candidates; those of others stay empty.
struct CandidateLists {
    std::vector<double> coordinates;
    std::vector<std::size_t> offsets;
    std::vector<std::uint32_t> neighbors;
    std::vector<std::uint32_t> counts;

    template <int Dimension>
    [[nodiscard]] CsrNeighborhood<double, Dimension> view() const {
        return {coordinates.data(), nullptr, offsets.data(), neighbors.data()};
    }
};

template <int Dimension>
CandidateLists candidate_lists(const Positions& positions,
                               const std::vector<std::uint8_t>& is_candidate) {
    const NeighborGrid grid(positions, 1, {}, 1);
    CandidateLists lists;
    FoundNeighbors found;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        lists.coordinates.insert(lists.coordinates.end(), positions[i].begin(),
                                 positions[i].begin() + Dimension);
        lists.offsets.push_back(lists.neighbors.size());
        if (is_candidate[i] != 0)
            grid.find_around(positions[i], 1, found);
        else
            found.clear();
        for (const std::uint32_t j : found.particles)
            if (j != i)
                lists.neighbors.push_back(j);
        lists.counts.push_back(
            static_cast<std::uint32_t>(lists.neighbors.size() - lists.offsets.back()));
    }
    lists.offsets.push_back(lists.neighbors.size());
    return lists;
}

/// What the runtime finds of the candidates, up to smoothed normals and the closed form.
template <int Dimension>
SurfaceParticles<double, Dimension>
surface_of(const Positions& positions, const std::vector<std::uint8_t>& is_candidate,
           const Calibration& calibration, int directions_count, std::uint64_t seed) {
    const CandidateLists lists = candidate_lists<Dimension>(positions, is_candidate);
    SurfaceParticles<double, Dimension> list;
    take_candidates<double, Dimension>(is_candidate.data(), lists.counts.data(), positions.size(),
                                       list);
    SurfaceTensionOptions options;
    options.radius_ratio = calibration.radius_ratio;
    options.fade = calibration.fade;
    options.coverage = directions_count == 0 ? CoverageMethod::exact : CoverageMethod::sampled;
    SampleDirections directions;
    if (directions_count > 0)
        fill_outward_directions<Dimension>(static_cast<std::size_t>(directions_count), seed,
                                           directions);
    const SerialLoop loop;
    ExposureMemory memory;
    const UniformRadius<double> radii{1};
    find_exposure<double, Dimension>(lists.view<Dimension>(), NoBoundary{}, radii, nullptr,
                                     directions, HeldCells(), options, loop, &memory, list);
    std::vector<std::array<double, Dimension>> before;
    for (int pass = 0; pass < calibration.normal_passes; ++pass)
        smooth_normals<double, Dimension>(calibration.tau, loop, list, before);
    find_curvature<double, Dimension>(calibration.radius_ratio, radii, loop, list);
    return list;
}

/// What a map would be given of the particle in a slot.
template <int Dimension>
struct MapInputs {
    const SurfaceParticles<double, Dimension>& list;
    bool averaged;
    std::vector<double> turning;
    std::vector<double> square;

    MapInputs(const SurfaceParticles<double, Dimension>& list, bool averaged)
        : list(list), averaged(averaged) {
        for (std::size_t slot = 0; slot < list.size(); ++slot) {
            const Turning around = turning_around(list, slot);
            turning.push_back(around.mean);
            square.push_back(around.square);
        }
    }

    [[nodiscard]] CurvatureSample sample(std::size_t slot) const {
        const auto value = [&](const std::vector<double>& values) {
            return averaged ? surface_average(list, slot, values) : values[slot];
        };
        return {value(turning), value(square), value(list.curvature), 0, list.weight[slot]};
    }
};

/// Adds the trusted surface particles of a filled cloud.
template <int Dimension>
void add_samples(const Cloud& cloud, const Calibration& calibration, CurvatureGroup& group) {
    std::vector<std::uint8_t> is_candidate(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i)
        is_candidate[i] = cloud.depth[i] < candidate_depth ? 1 : 0;
    const auto list = surface_of<Dimension>(cloud.positions, is_candidate, calibration,
                                            group.directions, calibration.seed);
    const MapInputs<Dimension> inputs(list, calibration.averaged);
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        const std::size_t i = list.particle[slot];
        if (cloud.trusted[i] == 0 || !(list.weight[slot] > 0))
            continue;
        group.samples.push_back(inputs.sample(slot));
        group.samples.back().curvature = cloud.mean_curvature[i];
    }
}

/// Leaves about `limit` samples, evenly taken.
void thin_out(std::vector<CurvatureSample>& samples, std::size_t limit) {
    const std::size_t stride = std::max<std::size_t>(samples.size() / limit, 1);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < samples.size(); i += stride)
        samples[kept++] = samples[i];
    samples.resize(kept);
}

/// Seeds of one stream for each group and cloud.
std::uint64_t seed_of(const Calibration& calibration, std::size_t group, int cloud) {
    return mix_bits(mix_bits(calibration.seed + group) + static_cast<std::uint64_t>(cloud));
}

void fill_group(const Calibration& calibration, const Shape& shape,
                const CalibrationArrangement& arrangement, std::size_t index,
                CurvatureGroup& group) {
    CloudOptions options;
    options.support_radius = 1;
    options.spacing = 1 / group.spacing_ratio;
    options.arrangement = arrangement.kind;
    options.jitter = arrangement.jitter;
    options.thickness = fluid_thickness;
    options.threads = 1;
    const auto wanted = static_cast<std::size_t>(calibration.filled.particles);
    while (group.clouds < max_clouds && group.samples.size() < wanted) {
        options.seed = seed_of(calibration, index, group.clouds++);
        const Cloud cloud = fill(shape, options);
        if (calibration.dimension == 2)
            add_samples<2>(cloud, calibration, group);
        else
            add_samples<3>(cloud, calibration, group);
    }
    thin_out(group.samples, wanted);
}

void fill_dense_group(const Calibration& calibration, const Shape& shape,
                      const std::array<double, 3>& place, std::size_t index,
                      CurvatureGroup& group) {
    const SurfacePoint point = nearest_surface_point(shape, place);
    for (; group.clouds < calibration.dense.repeats; ++group.clouds) {
        const std::uint64_t seed = seed_of(calibration, index, group.clouds);
        const DenseCloud cloud = dense_cloud(shape, point.position, calibration.dense, seed);
        CurvatureSample sample = dense_sample(cloud, calibration, group.directions, seed);
        sample.curvature = point.mean_curvature;
        sample.weight = 1;
        group.samples.push_back(sample);
    }
}

std::string arrangement_text(const CalibrationArrangement& arrangement) {
    const char* const names[] = {"random", "lattice", "relaxed"};
    return names[static_cast<int>(arrangement.kind)] +
           (arrangement.jitter > 0 ? ", jitter " + rounded_text(arrangement.jitter, 3) : "");
}

/// A group and how it is filled.
struct Task {
    CurvatureGroup group;
    std::function<void(std::size_t, CurvatureGroup&)> fill;
};

void add_filled_tasks(const Calibration& calibration, const CurvatureGroup& group,
                      const Shape& shape, std::vector<Task>& tasks) {
    for (const double ratio : calibration.filled.spacing_ratios)
        for (const CalibrationArrangement& arrangement : calibration.filled.arrangements) {
            Task task{group, [&calibration, shape, arrangement](std::size_t index,
                                                                CurvatureGroup& filled) {
                          fill_group(calibration, shape, arrangement, index, filled);
                      }};
            task.group.spacing_ratio = ratio;
            task.group.arrangement = arrangement_text(arrangement);
            tasks.push_back(task);
        }
}

void add_dense_tasks(const Calibration& calibration, const CurvatureGroup& group,
                     const Shape& shape, const std::vector<std::array<double, 3>>& places,
                     std::vector<Task>& tasks) {
    for (const auto& place : places) {
        const std::array<double, 3> at = scaled(1 / group.size, place);
        Task task{group, [&calibration, shape, at](std::size_t index, CurvatureGroup& filled) {
                      fill_dense_group(calibration, shape, at, index, filled);
                  }};
        task.group.arrangement = "dense";
        task.group.spacing_ratio = std::cbrt(calibration.dense.neighbors / (2 * pi / 3));
        tasks.push_back(task);
    }
}

std::vector<Task> tasks_of(const Calibration& calibration) {
    std::vector<Task> tasks;
    for (const CalibrationShape& shape : calibration.shapes)
        for (const double size : shape.sizes)
            for (const Side side : shape.sides)
                for (const int directions : calibration.samples) {
                    CurvatureGroup group;
                    group.shape = shape.kind;
                    group.side = side;
                    group.size = size;
                    group.directions = directions;
                    const Shape made = shape_of(shape, size, side, calibration.dimension);
                    if (calibration.is_dense)
                        add_dense_tasks(calibration, group, made, shape.places, tasks);
                    else
                        add_filled_tasks(calibration, group, made, tasks);
                }
    return tasks;
}

} // namespace

DenseCloud dense_cloud(const Shape& shape, const std::array<double, 3>& place,
                       const DenseClouds& clouds, std::uint64_t seed) {
    const double spacing = std::cbrt(2 * pi / 3 / clouds.neighbors);
    DenseCloud cloud{random_neighborhood(shape, place, 2, spacing, seed), {}};
    const std::size_t inside = cloud.positions.size();
    for (const auto& position : random_neighborhood(shape, place, 2, spacing, mix_bits(seed))) {
        const SurfacePoint point = nearest_surface_point(shape, position);
        if (-point.signed_distance < surface_layer)
            cloud.positions.push_back(point.position);
    }
    cloud.is_candidate.assign(cloud.positions.size(), 0);
    cloud.is_candidate[0] = 1;
    int left = clouds.candidates;
    for (std::size_t i = inside; i < cloud.positions.size() && left > 0; ++i) {
        const Vector3 step = difference(cloud.positions[i], place);
        const double distance_squared = dot(step, step);
        if (distance_squared > 0 && distance_squared < 1) {
            cloud.is_candidate[i] = 1;
            --left;
        }
    }
    return cloud;
}

CurvatureSample dense_sample(const DenseCloud& cloud, const Calibration& calibration,
                             int directions, std::uint64_t seed) {
    const auto list =
        surface_of<3>(cloud.positions, cloud.is_candidate, calibration, directions, seed);
    return MapInputs<3>(list, calibration.averaged).sample(0);
}

std::vector<CurvatureGroup>
curvature_groups(const Calibration& calibration,
                 const std::function<void(std::size_t, std::size_t)>& progress) {
    std::vector<Task> tasks = tasks_of(calibration);
    std::mutex one_at_a_time;
    std::size_t done = 0;
    loop_over(0, 1)(tasks.size(), [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t i = begin; i < end; ++i) {
            tasks[i].fill(i, tasks[i].group);
            const std::lock_guard<std::mutex> alone(one_at_a_time);
            progress(++done, tasks.size());
        }
    });
    std::vector<CurvatureGroup> groups;
    for (Task& task : tasks)
        if (!task.group.samples.empty())
            groups.push_back(std::move(task.group));
    return groups;
}

} // namespace meniscus
