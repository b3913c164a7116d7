// A case as a solver holds it: positions in its own number type, neighbor lists, and views of them.
#pragma once

#include "cases.hpp"

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <vector>

namespace meniscus::test {

/// Lists reach a little beyond h, as those of hosts that search with a margin.
inline constexpr double list_margin = 1.01;

/// The positions as Real holds them. By way of an array of Real: with the two conversions in one
/// expression, g++ 12.2 -O3 drops them for two coordinates of three.
template <class Real>
Positions rounded_to(const Positions& places) {
    std::vector<Real> coordinates;
    for (const auto& place : places)
        for (const double coordinate : place)
            coordinates.push_back(static_cast<Real>(coordinate));
    Positions rounded(places.size());
    for (std::size_t n = 0; n < coordinates.size(); ++n)
        rounded[n / 3][n % 3] = static_cast<double>(coordinates[n]);
    return rounded;
}

template <class Real, int Dimension>
struct HostState {
    using Csr = CsrNeighborhood<Real, Dimension>;

    std::vector<Real> positions; ///< m; Dimension values a particle
    std::vector<Real> masses;    ///< kg, or empty
    std::vector<Real> boundary;
    NeighborLists lists{{0}, {}};
    NeighborLists boundary_lists{{0}, {}};
    Real radius = 0; ///< h in m

    /// Throws InputError as find_neighbors does.
    explicit HostState(const HardCase& hard_case)
        : positions(rounded(hard_case.positions)),
          masses(hard_case.masses.begin(), hard_case.masses.end()),
          boundary(rounded(hard_case.boundary)),
          radius(static_cast<Real>(hard_case.support_radius)) {
        const double reach = list_margin * static_cast<double>(radius);
        lists = find_neighbors(places(positions), reach, {}, 1);
        if (boundary.empty())
            return;
        const NeighborGrid grid(places(boundary), reach, {}, 1);
        FoundNeighbors found;
        for (const auto& place : places(positions)) {
            grid.find_around(place, reach, found);
            boundary_lists.neighbors.insert(boundary_lists.neighbors.end(), found.particles.begin(),
                                            found.particles.end());
            boundary_lists.offsets.push_back(boundary_lists.neighbors.size());
        }
    }

    [[nodiscard]] std::size_t size() const { return positions.size() / Dimension; }
    [[nodiscard]] UniformRadius<Real> radii() const { return {radius}; }
    [[nodiscard]] Csr view() const {
        return {positions.data(), masses.empty() ? nullptr : masses.data(), lists.offsets.data(),
                lists.neighbors.data()};
    }

    /// Calls act with the view of the boundary, or NoBoundary where there is none.
    template <class Act>
    void with_boundary(const Act& act) const {
        if (boundary.empty())
            return act(NoBoundary{});
        const auto view = [this](std::size_t i, const auto& visit) {
            for (std::size_t n = boundary_lists.offsets[i]; n < boundary_lists.offsets[i + 1];
                 ++n) {
                const std::size_t j = boundary_lists.neighbors[n];
                std::array<Real, Dimension> displacement;
                for (int axis = 0; axis < Dimension; ++axis)
                    displacement[axis] =
                        boundary[j * Dimension + axis] - positions[i * Dimension + axis];
                visit(j, displacement, Real(1));
            }
        };
        act(BoundaryView<decltype(view)>{view});
    }

    static std::vector<Real> rounded(const Positions& places) {
        std::vector<Real> coordinates;
        for (const auto& place : places)
            for (int axis = 0; axis < Dimension; ++axis)
                coordinates.push_back(static_cast<Real>(place[axis]));
        return coordinates;
    }

    static Positions places(const std::vector<Real>& coordinates) {
        Positions result(coordinates.size() / Dimension);
        for (std::size_t n = 0; n < coordinates.size(); ++n)
            result[n / Dimension][n % Dimension] = static_cast<double>(coordinates[n]);
        return result;
    }
};

} // namespace meniscus::test
