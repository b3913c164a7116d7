// A snapshot as a solver holds it at the moment when it looks for its surface: positions, neighbor
// lists, support radius, and the volume that a particle stands for. What every method of the
// comparison works on, with the exact labels that it is judged by.
#pragma once

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/runtime/features/features.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace meniscus {

/// Particles all have the same mass, which is 1. Real is float or double; the lists are those of
/// the positions in double, whatever Real is.
template <class Real>
struct FluidState {
    std::string name;  ///< of the file, without folder and ending
    std::string scene; ///< scene_of()
    int dimension = 3;
    std::vector<Real> positions; ///< m; `dimension` values a particle
    NeighborLists lists;         ///< of particles closer than the support radius
    Real support_radius = 0;     ///< h in m
    double spacing = 0;          ///< of particles at rest, m (data/particles/particle_volumes.hpp)
    /// What a host knows as mass over density, m^dimension: 1 over the median of the sums
    /// sum_j W(x_ij), i itself among them, W the cubic spline of radius h.
    Real particle_volume = 0;
    std::vector<double> uncovered_fraction; ///< lambda, exact
    std::vector<std::uint8_t> surface;      ///< 1 where lambda > zero_uncovered_fraction

    [[nodiscard]] std::size_t size() const { return surface.size(); }

    /// The neighborhood view for the state's dimension, which must be `Dimension`.
    template <int Dimension>
    [[nodiscard]] CsrNeighborhood<Real, Dimension> view() const {
        return {positions.data(), nullptr, lists.offsets.data(), lists.neighbors.data()};
    }
};

/// Takes a snapshot over and labels it by exact coverage (radius ratio 0.8), boundary particles
/// left out. Throws InputError, naming `name`, where the snapshot has no particle, stores no
/// support radius or one for each particle, or has a position that is not finite; and as
/// label_particles does.
template <class Real>
FluidState<Real> fluid_state(const Snapshot& snapshot, const std::string& name);

/// The state of a snapshot file; throws as read_snapshot and fluid_state do.
template <class Real>
FluidState<Real> read_fluid_state(const std::filesystem::path& file);

/// The same, or the snapshot alone, of files in 3D; for others throws InputError, too.
template <class Real>
FluidState<Real> read_fluid_state_in_3d(const std::filesystem::path& file);
Snapshot read_snapshot_in_3d(const std::filesystem::path& file);

} // namespace meniscus
