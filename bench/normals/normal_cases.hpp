// Particles whose normals are known, to measure estimates of them against: clouds of data/ with
// neighbor lists and candidates, as a solver hands them to the runtime, and a state of a solver.
#pragma once

#include "support/statistics.hpp"

#include <meniscus/data/clouds/clouds.hpp>
#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/runtime/surface/normals.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace meniscus {

/// Arrays have one entry a particle.
struct NormalCase {
    Cloud cloud;
    NeighborLists lists; ///< of candidates; those of others are empty
    std::vector<std::uint8_t> candidate;
    std::vector<std::int32_t> neighbor_count;
    std::vector<std::uint8_t> outermost; ///< 1 in the outermost layer, which must not be lost
    std::vector<std::uint8_t> measured;  ///< 1 where the errors of normals are taken
};

/// A case of clouds in three dimensions measures the trusted particles less than this many spacings
/// below the surface, which are the outermost layer, ...
inline constexpr double outermost_depth = 0.7;
/// ... where lambda (exact, for a radius ratio of 0.8) is above this: what is less is a pinhole
/// between neighbors, and its normal that of chance.
inline constexpr double min_measured_fraction = 0.02;

/// The 2019 preprint's case: a disc of independent points, some of them on the circle, about a
/// thousand neighbors a particle inside. Measured are the points on the circle. `radius` in support
/// radii.
NormalCase circle_case(double radius, std::uint64_t seed);

/// The preprint's Table 1: mean |n - n_a| by samples a particle and smoothing passes (0, 1, 2).
inline constexpr std::array<std::size_t, 5> circle_sample_counts = {10, 20, 50, 100, 500};
inline constexpr std::size_t circle_passes = 3;
inline constexpr std::array<std::array<double, circle_passes>, 5> preprint_circle_errors = {
    {{0.290, 0.171, 0.131},
     {0.201, 0.115, 0.085},
     {0.120, 0.068, 0.051},
     {0.088, 0.049, 0.035},
     {0.038, 0.021, 0.017}}};

/// The 2020 article's case: a saddle as a solver leaves it, z = a (x^2 - y^2) with the fluid above,
/// with principal curvatures of +-0.25 / h at its middle; `radius_in_spacings` is h.
NormalCase saddle_case(double radius_in_spacings, std::uint64_t seed);

/// A ball with a radius of five support radii, of two spacings each.
NormalCase ball_case(std::uint64_t seed);

/// A state in three dimensions with a stored support radius, without known normals; all are
/// candidates. Outermost are particles that touch a ball of the support radius with no particle in
/// it. Throws as read_snapshot does.
NormalCase state_case(const std::filesystem::path& file);

template <int Dimension>
CsrNeighborhood<double, Dimension, 3> view_of(const NormalCase& some) {
    return {some.cloud.positions[0].data(), nullptr, some.lists.offsets.data(),
            some.lists.neighbors.data()};
}

/// Sets the list to the candidates and all that find_exposure finds out about them; particles keep
/// their index as id.
template <int Dimension, class Loop = SerialLoop>
void expose(const NormalCase& some, const SampleDirections& directions,
            const SurfaceTensionOptions& options, SurfaceParticles<double, Dimension>& list,
            const Loop& loop = {}) {
    static const HeldCells cells;
    thread_local ExposureMemory memory;
    take_candidates(some.candidate.data(), some.neighbor_count.data(), some.cloud.size(), list);
    find_exposure<double, Dimension>(view_of<Dimension>(some), NoBoundary{},
                                     UniformRadius<double>{some.cloud.support_radius}, nullptr,
                                     directions, cells, options, loop, &memory, list);
}

/// Mean distance |n - n_a| (2019 preprint, Table 1) of the measured normals from the known ones: 1
/// where there is none.
template <int Dimension>
Spread distance_error(const NormalCase& some, const SurfaceParticles<double, Dimension>& list) {
    Spread error;
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        const std::size_t i = list.particle[slot];
        double squared = 0;
        for (int axis = 0; axis < Dimension; ++axis) {
            const double difference = list.normal[slot][axis] - some.cloud.normal[i][axis];
            squared += difference * difference;
        }
        if (some.measured[i] != 0)
            error.add(std::sqrt(squared));
    }
    return error;
}

/// Mean angle in degrees (2020 paper, section 3.2) between the measured normals and the known ones;
/// particles without a normal are left out.
template <int Dimension>
Spread angular_error(const NormalCase& some, const SurfaceParticles<double, Dimension>& list) {
    Spread error;
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        const std::size_t i = list.particle[slot];
        double cosine = 0;
        double squared = 0;
        for (int axis = 0; axis < Dimension; ++axis) {
            cosine += list.normal[slot][axis] * some.cloud.normal[i][axis];
            squared += list.normal[slot][axis] * list.normal[slot][axis];
        }
        if (some.measured[i] != 0 && squared > 0)
            error.add(std::acos(std::min(cosine, 1.0)) * 180 / pi);
    }
    return error;
}

} // namespace meniscus
