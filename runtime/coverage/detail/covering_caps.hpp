// What the neighbors cover of the sphere around a particle. The particle's sphere has radius r1, a
// neighbor's at distance d the radius r2; where r1 - r2 < d < r1 + r2 they cut in a circle, and the
// neighbor covers the cap inside it, whose angular radius theta has
//     cos theta = (d^2 + r1^2 - r2^2) / (2 d r1)
// (2020 paper, section 3.2). In two dimensions caps are arcs of a circle. Caps are always smaller
// than half the sphere, because r2 < r1.
#pragma once

#include "../../math/vector3.hpp"
#include "../../neighbors/neighborhood.hpp"
#include "../../simd/vector.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The caps of one particle. Reused from particle to particle, it allocates only where a particle
/// has more neighbors than any before.
struct CoveringCaps {
    /// One entry a cap, and beyond the last as many as fill a vector, of caps that are empty.
    std::vector<double> x, y, z;      ///< unit vector to the middle; z is 0 in two dimensions
    std::vector<double> cosine, sine; ///< of the angular radius

    [[nodiscard]] std::size_t size() const { return count; }
    [[nodiscard]] std::size_t padded_size() const { return padded_to_wide(count); }
    [[nodiscard]] Vector3 middle(std::size_t n) const { return {x[n], y[n], z[n]}; }

    void clear() { count = 0; }

    /// Room for so many.
    void reserve(std::size_t capacity) {
        if (capacity + wide_count >= x.size())
            for (auto* values : {&x, &y, &z, &cosine, &sine})
                values->resize(capacity + wide_count + 1);
    }

    void add(const Vector3& middle, double cosine_of_radius, double sine_of_radius) {
        if (count + wide_count >= x.size())
            reserve(2 * count + 64);
        set(count++, middle, cosine_of_radius, sine_of_radius);
    }

    /// After the last cap, and before vectors are read.
    void pad() {
        for (std::size_t n = count; n < padded_size(); ++n)
            set(n, {0, 0, 0}, 1, 0);
    }

private:
    void set(std::size_t n, const Vector3& middle, double cosine_of_radius, double sine_of_radius) {
        x[n] = middle[0];
        y[n] = middle[1];
        z[n] = middle[2];
        cosine[n] = cosine_of_radius;
        sine[n] = sine_of_radius;
    }

    std::size_t count = 0;
};

/// Adds the cap that a neighbor at `displacement` (Dimension coordinates, m) covers; nothing where
/// it covers none: too close (d <= r1 - r2), too far (d >= r1 + r2), or not at a finite place.
/// `particle_radius` r1 and `neighbor_radius` r2 < r1 in m. Which neighbors count at all is for
/// NeighborRange to say.
template <int Dimension, class Displacement>
void add_cap(CoveringCaps& caps, const Displacement& displacement, double particle_radius,
             double neighbor_radius) {
    const double scale = 1 / particle_radius; // so that no square leaves the range of double
    Vector3 place = {0, 0, 0};
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        place[axis] = static_cast<double>(displacement[axis]) * scale;
    const double distance = std::sqrt(dot(place, place));
    const double ratio = neighbor_radius * scale;
    const double overlap = (ratio - 1 + distance) * (ratio + 1 - distance);
    if (!is_positive_and_finite(overlap))
        return;
    const double to_unit = 1 / distance;
    const double depth = overlap * to_unit * 0.5; // 1 - cos theta
    caps.add(scaled(to_unit, place), 1 - depth, std::sqrt(depth * (2 - depth)));
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
