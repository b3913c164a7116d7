// Random neighborhoods of one particle, many of them degenerate: on lattices, on the limits of what
// counts, in a plane, mirrored, in bunches. A neighborhood is remembered by its number, so one that
// once went wrong stays (found_failures.hpp).
#pragma once

#include <meniscus/runtime/math/vector3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace meniscus::test {

/// Displacements of neighbors in support radii; z is 0 in two dimensions.
struct Neighborhood {
    std::uint64_t number = 0;
    int dimension = 3;
    std::vector<Vector3> neighbors;

    [[nodiscard]] std::string name() const {
        return "neighborhood " + std::to_string(number) + " in " + std::to_string(dimension) + "D";
    }
};

/// The neighborhood of that number, the same on every machine but for the last bits of a sine.
class NeighborhoodMaker {
public:
    NeighborhoodMaker(int its_dimension, std::uint64_t number)
        : generator(number), dimension(its_dimension), result{number, its_dimension, {}} {}

    Neighborhood make() {
        const std::size_t count = generator() % 81;
        switch (generator() % 6) {
        case 0:
            spread(count);
            break;
        case 1:
            on_lattice(count);
            break;
        case 2:
            on_limits(count);
            break;
        case 3:
            in_a_plane(count);
            break;
        case 4:
            mirrored(count);
            break;
        default:
            in_bunches(count);
            break;
        }
        return std::move(result);
    }

private:
    std::mt19937_64 generator;
    int dimension;
    Neighborhood result;

    double share() { return static_cast<double>(generator() >> 11) * 0x1p-53; }
    double between(double min, double max) { return min + (max - min) * share(); }

    Vector3 direction() {
        for (;;) {
            const Vector3 x{between(-1, 1), between(-1, 1), dimension == 2 ? 0 : between(-1, 1)};
            const double square = dot(x, x);
            if (square > 1e-4 && square < 1)
                return scaled(1 / std::sqrt(square), x);
        }
    }

    void add(const Vector3& x) { result.neighbors.push_back(x); }

    /// Anywhere, some beyond h or too close to count; often on one side only.
    void spread(std::size_t count) {
        const double cut = between(-0.4, 2);
        while (result.neighbors.size() < count) {
            const Vector3 x = scaled(between(0.05, 1.1), direction());
            if (x[0] < cut)
                add(x);
        }
    }

    /// On a lattice with the particle on it, each moved by next to nothing or a little.
    void on_lattice(std::size_t count) {
        const double spacing = generator() % 2 == 0 ? 0.5 : between(0.3, 0.7);
        const double jitter = std::pow(10.0, -between(1, 17)) * spacing;
        const int reach = static_cast<int>(1.1 / spacing);
        const int depth = dimension == 3 ? reach : 0;
        for (int z = -depth; z <= depth; ++z)
            for (int y = -reach; y <= reach; ++y)
                for (int x = -reach; x <= reach; ++x)
                    if (x != 0 || y != 0 || z != 0)
                        add(sum({x * spacing, y * spacing, z * spacing},
                                scaled(jitter, direction())));
        shuffle();
        result.neighbors.resize(std::min(count, result.neighbors.size()));
    }

    /// At h or at r1 - r2, or off it by some units in the last place.
    void on_limits(std::size_t count) {
        while (result.neighbors.size() < count) {
            const double limit = generator() % 4 == 0 ? 0.2 : 1;
            const double off = (share() - 0.5) * std::pow(10.0, -between(2, 16));
            add(scaled(limit * (1 + off), direction()));
        }
    }

    void in_a_plane(std::size_t count) {
        const double height = generator() % 2 == 0 ? 0 : between(-0.5, 0.5);
        while (result.neighbors.size() < count) {
            Vector3 x = scaled(between(0.2, 1), direction());
            x[static_cast<std::size_t>(dimension - 1)] = height;
            add(x);
        }
    }

    /// Each with its image through the particle or behind a plane, so that circles touch.
    void mirrored(std::size_t count) {
        const bool through_particle = generator() % 2 == 0;
        while (result.neighbors.size() + 1 < count) {
            const Vector3 x = scaled(between(0.2, 1), direction());
            add(x);
            add(through_particle ? scaled(-1, x) : Vector3{-x[0], x[1], x[2]});
        }
    }

    void in_bunches(std::size_t count) {
        const double width = std::pow(10.0, -between(1, 17));
        while (result.neighbors.size() < count) {
            const Vector3 middle = scaled(between(0.2, 1), direction());
            for (std::size_t n = 1 + generator() % 12; n > 0; --n)
                add(sum(middle, scaled(width * share(), direction())));
        }
    }

    void shuffle() {
        for (std::size_t n = result.neighbors.size(); n > 1; --n)
            std::swap(result.neighbors[n - 1], result.neighbors[generator() % n]);
    }
};

inline Neighborhood neighborhood(int dimension, std::uint64_t number) {
    return NeighborhoodMaker(dimension, number).make();
}

} // namespace meniscus::test
