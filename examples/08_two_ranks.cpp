// Surface tension in a solver that is spread over processes of MPI: each has the particles of its
// part of the domain and, as a halo, those of others that lie within a few support radii. With a
// halo of (2 + normal passes + curvature passes) h the own particles get the forces of one process,
// bit for bit:
//     h  the features and the coverage test of a particle ask for its neighbors,
//     h  its curvature for the normals of these,
//     h  for each pass that smooths normals or curvatures, for the neighbors' once more.
// What one process knows as the order of neighbors is here the order of numbers that particles
// keep; sums in another order would differ in their last digits.
// Run with two processes: mpirun -n 2 example_two_ranks
#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

namespace {

constexpr double spacing = 0.05;  // m
constexpr double h = 2 * spacing; // support radius, m

struct Particle {
    std::uint32_t number; // its own, whoever has it
    std::array<double, 3> position;
};

struct Force {
    std::uint32_t number;
    std::array<double, 3> force;
};

/// A drop whose surface is not at rest.
std::vector<Particle> whole_drop() {
    std::vector<Particle> drop;
    std::uint32_t number = 0;
    for (int i = -12; i <= 12; ++i)
        for (int j = -12; j <= 12; ++j)
            for (int k = -12; k <= 12; ++k, ++number) {
                const std::array<double, 3> at = {spacing * i + 0.003 * std::sin(7.0 * j),
                                                  spacing * j + 0.003 * std::sin(5.0 * k),
                                                  spacing * k + 0.003 * std::sin(3.0 * i)};
                if (std::hypot(at[0] / 0.6, at[1] / 0.45, at[2] / 0.5) <= 1)
                    drop.push_back({number, at});
            }
    return drop;
}

/// Those with x from `low` up to `high`.
std::vector<Particle> part_of(const std::vector<Particle>& particles, double low, double high) {
    std::vector<Particle> part;
    for (const Particle& particle : particles)
        if (particle.position[0] >= low && particle.position[0] < high)
            part.push_back(particle);
    return part;
}

/// Gives the other process those of ours that lie within `depth` of x = 0, where the two parts
/// meet, and returns what it gives.
std::vector<Particle> exchange_halo(const std::vector<Particle>& own, double depth, int other) {
    const std::vector<Particle> given = part_of(own, -depth, depth);
    auto given_bytes = static_cast<int>(given.size() * sizeof(Particle));
    int bytes = 0;
    MPI_Sendrecv(&given_bytes, 1, MPI_INT, other, 0, &bytes, 1, MPI_INT, other, 0, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
    std::vector<Particle> halo(static_cast<std::size_t>(bytes) / sizeof(Particle));
    MPI_Sendrecv(given.data(), given_bytes, MPI_BYTE, other, 1, halo.data(), bytes, MPI_BYTE, other,
                 1, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return halo;
}

/// Forces on the surface particles among these, as a solver that has no others finds them.
std::vector<Force> forces_of(std::vector<Particle> particles,
                             const meniscus::SurfaceTensionOptions& options) {
    std::sort(particles.begin(), particles.end(),
              [](const Particle& a, const Particle& b) { return a.number < b.number; });
    meniscus::Positions positions;
    std::vector<std::uint32_t> numbers; // that random directions go by
    for (const Particle& particle : particles) {
        positions.push_back(particle.position);
        numbers.push_back(particle.number);
    }
    meniscus::NeighborLists lists = meniscus::find_neighbors(positions, h, {}, 1);
    for (std::size_t i = 0; i < particles.size(); ++i)
        std::sort(lists.neighbors.begin() + static_cast<std::ptrdiff_t>(lists.offsets[i]),
                  lists.neighbors.begin() + static_cast<std::ptrdiff_t>(lists.offsets[i + 1]));
    const meniscus::CsrNeighborhood<double, 3, 3> view{
        positions[0].data(), nullptr, lists.offsets.data(), lists.neighbors.data()};
    meniscus::SurfaceTension<double, 3> tension(options);
    tension.step(view, meniscus::NoBoundary{}, particles.size(), meniscus::UniformRadius<double>{h},
                 numbers.data(), meniscus::SerialLoop{});
    std::vector<Force> forces;
    const auto& surface = tension.surface();
    for (std::size_t slot = 0; slot < surface.size(); ++slot)
        forces.push_back(
            {particles[surface.particle[slot]].number,
             {surface.force[slot][0], surface.force[slot][1], surface.force[slot][2]}});
    return forces;
}

/// How many forces are on these particles, and how many of those are the same among `others`.
std::array<std::size_t, 2> compare(const std::vector<Particle>& own,
                                   const std::vector<Force>& forces,
                                   const std::vector<Force>& others) {
    std::array<std::size_t, 2> counts = {};
    for (const Particle& particle : own) {
        const auto is_it = [&](const Force& force) { return force.number == particle.number; };
        const auto one = std::find_if(forces.begin(), forces.end(), is_it);
        const auto other = std::find_if(others.begin(), others.end(), is_it);
        if (one == forces.end() && other == others.end())
            continue; // inside, by both
        ++counts[0];
        if (one != forces.end() && other != others.end() &&
            std::memcmp(&one->force, &other->force, sizeof one->force) == 0)
            ++counts[1];
    }
    return counts;
}

} // namespace

int main(int argument_count, char** arguments) { // NOLINT(bugprone-exception-escape)
    MPI_Init(&argument_count, &arguments);
    int rank = 0;
    int ranks = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    if (ranks != 2) {
        std::fprintf(stderr, "start two processes: mpirun -n 2 %s\n", arguments[0]);
        MPI_Abort(MPI_COMM_WORLD, 2);
    }
    meniscus::SurfaceTensionOptions options;
    options.surface_tension = 0.07;
    options.spacing_ratio = h / spacing;
    options.curvature_passes = 1;
    const double depth = (2 + options.normal_passes + options.curvature_passes) * h;

    // A solver has its own particles from the step before.
    const std::vector<Particle> own =
        rank == 0 ? part_of(whole_drop(), -1, 0) : part_of(whole_drop(), 0, 1);
    std::vector<Particle> with_halo = own;
    const std::vector<Particle> halo = exchange_halo(own, depth, 1 - rank);
    with_halo.insert(with_halo.end(), halo.begin(), halo.end());
    const std::vector<Force> forces = forces_of(with_halo, options);

    // And what one process finds.
    const auto [all, same] = compare(own, forces, forces_of(whole_drop(), options));
    std::printf("rank %d: %zu particles and a halo of %zu (%zu bytes); of %zu forces %zu are those "
                "of one process\n",
                rank, own.size(), halo.size(), halo.size() * sizeof(Particle), all, same);
    const int is_same = all > 0 && same == all ? 1 : 0;
    int all_same = 0;
    MPI_Allreduce(&is_same, &all_same, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    MPI_Finalize();
    return all_same == 1 ? 0 : 1;
}
