// Small fluids with neighbor lists, for tests of the runtime as a whole. Lists by comparing all
// pairs: nothing that is tested takes part.
#pragma once

#include <meniscus/runtime/surface/shipped_curvature_map.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace meniscus {

template <class Real, int Dimension>
struct Fluid {
    using Vector = std::array<Real, Dimension>;

    std::vector<Vector> positions;
    Real radius = 1; ///< h
    std::vector<std::size_t> offsets{0};
    std::vector<std::uint32_t> neighbors;

    Fluid() = default;
    Fluid(std::vector<Vector> places, Real radius) : positions(std::move(places)), radius(radius) {
        for (std::size_t i = 0; i < size(); ++i) {
            for (std::size_t j = 0; j < size(); ++j)
                if (i != j && is_close(positions[i], positions[j]))
                    neighbors.push_back(static_cast<std::uint32_t>(j));
            offsets.push_back(neighbors.size());
        }
    }

    [[nodiscard]] std::size_t size() const { return positions.size(); }
    [[nodiscard]] const Real* coordinates() const {
        return reinterpret_cast<const Real*>(positions.data());
    }
    [[nodiscard]] CsrNeighborhood<Real, Dimension> view() const {
        return {coordinates(), nullptr, offsets.data(), neighbors.data()};
    }
    [[nodiscard]] UniformRadius<Real> radii() const { return {radius}; }

    /// A little beyond h, as hosts do it that search with a margin.
    [[nodiscard]] bool is_close(const Vector& a, const Vector& b) const {
        double sum = 0;
        for (int axis = 0; axis < Dimension; ++axis) {
            const double step = (static_cast<double>(b[axis]) - static_cast<double>(a[axis])) /
                                static_cast<double>(radius);
            sum += step * step;
        }
        return sum < 1.01;
    }
};

/// Numbers in [0, 1), the same on every machine.
class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : state(mix_bits(seed)) {}
    double next() { return static_cast<double>(mix_bits(state++) >> 11) * 0x1p-53; }

private:
    std::uint64_t state;
};

/// Lattice points within `reach` lattice steps of the middle, each moved by up to `jitter` steps.
/// The support radius is two steps.
template <class Real, int Dimension>
Fluid<Real, Dimension> ball(int reach, double jitter, double radius = 1) {
    Numbers numbers(7);
    std::vector<std::array<Real, Dimension>> places;
    const int depth = Dimension == 3 ? reach : 0;
    for (int z = -depth; z <= depth; ++z)
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                if (x * x + y * y + z * z > reach * reach)
                    continue;
                const int step[3] = {x, y, z};
                std::array<Real, Dimension> place;
                for (int axis = 0; axis < Dimension; ++axis)
                    place[axis] = static_cast<Real>(
                        (step[axis] + jitter * (2 * numbers.next() - 1)) * radius / 2);
                places.push_back(place);
            }
    return {std::move(places), static_cast<Real>(radius)};
}

/// A block of the lattice, `counts` particles along each axis.
template <class Real, int Dimension>
Fluid<Real, Dimension> block(std::array<int, 3> counts, double radius = 1) {
    std::vector<std::array<Real, Dimension>> places;
    for (int z = 0; z < (Dimension == 3 ? counts[2] : 1); ++z)
        for (int y = 0; y < counts[1]; ++y)
            for (int x = 0; x < counts[0]; ++x) {
                const double step[3] = {x * radius / 2, y * radius / 2, z * radius / 2};
                std::array<Real, Dimension> place;
                for (int axis = 0; axis < Dimension; ++axis)
                    place[axis] = static_cast<Real>(step[axis]);
                places.push_back(place);
            }
    return {std::move(places), static_cast<Real>(radius)};
}

/// Options for those fluids, whose spacing is half the radius. The line is one for both dimensions:
/// lets through whoever has fewer neighbors than there are inside.
template <int Dimension>
SurfaceTensionOptions options_for(SurfaceTensionOptions options = {}) {
    options.k = Dimension == 3 ? 40 : 15;
    options.d = Dimension == 3 ? 18 : 6;
    options.samples = 64;
    options.curvature_map = shipped_curvature_map(Dimension);
    options.spacing_ratio = 2;
    return options;
}

} // namespace meniscus
