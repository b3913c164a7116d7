#include "bodies.hpp"

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/runtime/math/min_eigenvalue.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace meniscus {
namespace {

/// Bodies as trees: each particle points to one of its body that comes before it, or to itself.
class Trees {
public:
    explicit Trees(std::size_t count) : parent(count) {
        std::iota(parent.begin(), parent.end(), 0U);
    }

    std::uint32_t root(std::uint32_t particle) {
        while (parent[particle] != particle)
            particle = parent[particle] = parent[parent[particle]];
        return particle;
    }

    void join(std::uint32_t one, std::uint32_t other) {
        const auto [low, high] = std::minmax({root(one), root(other)});
        parent[high] = low;
    }

private:
    std::vector<std::uint32_t> parent;
};

/// From the second moments, in the order that min_eigenvalue() has.
template <int Dimension>
double aspect_of(const std::vector<Place>& arms) {
    constexpr int entries = Dimension * (Dimension + 1) / 2;
    double moments[entries] = {};
    double turned[entries] = {}; // of which the smallest eigenvalue is minus the largest
    for (const Place& arm : arms)
        for (int row = 0, entry = 0; row < Dimension; ++row)
            for (int column = 0; column <= row; ++column, ++entry)
                moments[entry] += arm[row] * arm[column];
    for (int entry = 0; entry < entries; ++entry)
        turned[entry] = -moments[entry];
    const double smallest = min_eigenvalue<Dimension>(moments);
    const double largest = -min_eigenvalue<Dimension>(turned);
    return smallest > 1e-12 * largest ? std::sqrt(largest / smallest)
                                      : 0; // a sheet, but for rounding
}

void measure(const Positions& body, int dimension, Bodies& bodies) {
    Place center{};
    const auto count = static_cast<double>(body.size());
    for (const Place& place : body)
        for (int axis = 0; axis < 3; ++axis)
            center[axis] += place[axis] / count;
    bodies.top = body[0][1];
    std::vector<Place> arms = body;
    for (Place& arm : arms) {
        bodies.top = std::max(bodies.top, arm[1]);
        for (int axis = 0; axis < 3; ++axis)
            arm[axis] -= center[axis];
        bodies.radius = std::max(bodies.radius, std::hypot(arm[0], arm[1], arm[2]));
    }
    bodies.aspect = dimension == 2 ? aspect_of<2>(arms) : aspect_of<3>(arms);
}

} // namespace

Bodies find_bodies(const Positions& positions, double support_radius, int dimension) {
    const NeighborLists lists = find_neighbors(positions, support_radius);
    Trees trees(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        for (std::size_t n = lists.offsets[i]; n < lists.offsets[i + 1]; ++n)
            trees.join(i, lists.neighbors[n]);
    std::vector<std::size_t> sizes(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        ++sizes[trees.root(i)];
    const auto largest = std::max_element(sizes.begin(), sizes.end());
    Bodies bodies;
    if (largest == sizes.end())
        return bodies;
    bodies.count = static_cast<std::size_t>(std::count_if(
        sizes.begin(), sizes.end(), [](std::size_t particles) { return particles > 0; }));
    bodies.largest = *largest;
    Positions body;
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        if (trees.root(i) == static_cast<std::uint32_t>(largest - sizes.begin()))
            body.push_back(positions[i]);
    measure(body, dimension, bodies);
    return bodies;
}

} // namespace meniscus
