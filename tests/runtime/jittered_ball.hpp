// A ball (in two dimensions a disk) of particles on a lattice of spacing 1, each moved at random,
// with support radius 2 and neighbor lists found the plain way.
#pragma once

#include <meniscus/runtime/neighbors/neighborhood.hpp>
#include <meniscus/runtime/neighbors/support_radius.hpp>

#include <cstdint>
#include <random>
#include <vector>

namespace meniscus {

template <class Real, int Dimension>
struct JitteredBall {
    static constexpr double support_radius = 2;

    std::vector<Real> positions; ///< Dimension values a particle
    std::vector<std::size_t> offsets = {0};
    std::vector<std::uint32_t> neighbors;

    JitteredBall(double ball_radius, double jitter, unsigned seed = 1) {
        fill(ball_radius, jitter, seed);
        for (std::size_t i = 0; i < size(); ++i) {
            for (std::size_t j = 0; j < size(); ++j)
                if (j != i && distance_squared(i, j) < support_radius * support_radius)
                    neighbors.push_back(static_cast<std::uint32_t>(j));
            offsets.push_back(neighbors.size());
        }
    }

    [[nodiscard]] std::size_t size() const { return positions.size() / Dimension; }
    [[nodiscard]] CsrNeighborhood<Real, Dimension> view() const {
        return {positions.data(), nullptr, offsets.data(), neighbors.data()};
    }
    [[nodiscard]] UniformRadius<Real> radii() const { return {static_cast<Real>(support_radius)}; }

private:
    void fill(double ball_radius, double jitter, unsigned seed) {
        std::mt19937_64 generator(seed);
        std::uniform_real_distribution<double> move(-jitter, jitter);
        const int max = static_cast<int>(ball_radius) + 1;
        const int depth = Dimension == 3 ? max : 0;
        for (int x = -max; x <= max; ++x)
            for (int y = -max; y <= max; ++y)
                for (int z = -depth; z <= depth; ++z)
                    if (x * x + y * y + z * z <= ball_radius * ball_radius)
                        for (int axis = 0; axis < Dimension; ++axis)
                            positions.push_back(static_cast<Real>((axis == 0   ? x
                                                                   : axis == 1 ? y
                                                                               : z) +
                                                                  move(generator)));
    }

    [[nodiscard]] double distance_squared(std::size_t i, std::size_t j) const {
        double sum = 0;
        for (int axis = 0; axis < Dimension; ++axis) {
            const auto step = static_cast<double>(positions[j * Dimension + axis]) -
                              static_cast<double>(positions[i * Dimension + axis]);
            sum += step * step;
        }
        return sum;
    }
};

} // namespace meniscus
