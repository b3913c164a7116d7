// A second line, in the plane of any two features (list.hpp), for the candidates of a first one: a
// cascade. The first line is in features that cost next to nothing in the density loop and lets
// many through; the second asks more of each neighbor, but of those few particles alone. Neither
// misses a surface particle of the training set, so together they miss none.
//
// The neighbors of a candidate are gathered in float and lanes of four, whatever the number type
// of the host and the instruction set; the margin in d covers that (docs/training.md). "The
// smallest eigenvalue is at most t" is asked without one: three pivots (in two dimensions two)
// tell.
#pragma once

#include "../neighbors/boundary.hpp"
#include "../simd/vector.hpp"
#include "classifier_options.hpp"
#include "line_features.hpp"

#include <algorithm>
#include <vector>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

template <>
struct SquareRoot<Pack<float>> {
    static MENISCUS_INLINE Pack<float> of(Pack<float> a) { return square_root(a); }
};

inline constexpr std::size_t feature_lanes = lanes_in<Pack<float>>;

/// The neighbors of one particle that count, as features see them, one a lane. Reused from particle
/// to particle, it allocates only where one has more neighbors than any before.
struct GatheredNeighbors {
    std::vector<float> step[3]; ///< in support radii; the last is unused in two dimensions
    std::vector<float> mass;    ///< relative to that of the first neighbor
    std::vector<float> count;
    std::size_t size = 0;

    /// Room for so many, and lanes to fill up.
    void reserve(std::size_t capacity) {
        if (capacity + feature_lanes <= mass.size())
            return;
        for (auto* values : {&step[0], &step[1], &step[2], &mass, &count})
            values->resize(capacity + feature_lanes);
    }

    template <class Real, int Dimension>
    MENISCUS_INLINE void add(const FeatureNeighbor<Real, Dimension>& neighbor) {
        if (size + feature_lanes >= mass.size())
            reserve(2 * size + feature_lanes);
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            step[axis][size] = static_cast<float>(neighbor.step[axis]);
        mass[size] = static_cast<float>(neighbor.mass);
        count[size] = static_cast<float>(neighbor.count);
        ++size;
    }

    /// Makes the last lanes whole with neighbors that do not count.
    void fill_up() {
        for (std::size_t n = size; n % feature_lanes != 0; ++n) {
            step[0][n] = 1;
            step[1][n] = step[2][n] = 0;
            mass[n] = count[n] = 0;
        }
    }
};

/// A feature's sums over the gathered neighbors: the same bits with every instruction set.
template <class Feature, int Dimension>
void sum_gathered(const GatheredNeighbors& gathered, float* sums) {
    constexpr std::size_t terms{Feature::template terms<Dimension>};
    Pack<float> sum[terms] = {};
    for (std::size_t n = 0; n < gathered.size; n += feature_lanes) {
        FeatureNeighbor<Pack<float>, Dimension> neighbor;
        neighbor.squared = Pack<float>{};
        for (std::size_t axis = 0; axis < Dimension; ++axis) {
            neighbor.step[axis] = load<Pack<float>>(&gathered.step[axis][n]);
            neighbor.squared += neighbor.step[axis] * neighbor.step[axis];
        }
        neighbor.mass = load<Pack<float>>(&gathered.mass[n]);
        neighbor.count = load<Pack<float>>(&gathered.count[n]);
        Feature::template add<float>(neighbor, sum);
    }
    for (std::size_t term = 0; term < terms; ++term)
        sums[term] = sum_of_lanes(sum[term]);
}

/// Whether a feature is at most a limit.
template <class Feature, int Dimension>
bool is_at_most(const GatheredNeighbors& gathered, float limit) {
    float sums[Feature::template terms<Dimension>];
    sum_gathered<Feature, Dimension>(gathered, sums);
    if constexpr (Feature::is_eigenvalue) {
        for (const float sum : sums)
            if (!is_finite(sum))
                return true;
        return !is_min_eigenvalue_above<Dimension>(sums, limit);
    } else {
        const float value = Feature::template value<Dimension>(sums);
        return !is_finite(value) || value <= limit;
    }
}

template <class Feature, int Dimension>
float gathered_value(const GatheredNeighbors& gathered) {
    float sums[Feature::template terms<Dimension>];
    sum_gathered<Feature, Dimension>(gathered, sums);
    return Feature::template value<Dimension>(sums);
}

/// The two questions that lines ask of a feature.
struct GatheredFeature {
    float (*value)(const GatheredNeighbors&);
    bool (*is_at_most)(const GatheredNeighbors&, float limit);
};

template <int Dimension, std::size_t... Features>
GatheredFeature gathered_feature(std::size_t feature, std::index_sequence<Features...>) {
    static constexpr GatheredFeature table[] = {{gathered_value<FeatureAt<Features>, Dimension>,
                                                 is_at_most<FeatureAt<Features>, Dimension>}...};
    return table[feature];
}

/// Whether the gathered neighbors make a particle a candidate by the line; without any they do.
template <int Dimension>
bool is_surface(const GatheredNeighbors& gathered, const SecondLine& line) {
    if (gathered.size == 0)
        return true;
    constexpr auto all = std::make_index_sequence<feature_count>{};
    const float x = gathered_feature<Dimension>(line.x, all).value(gathered);
    if (!is_finite(x))
        return true;
    const auto limit = static_cast<float>(line.k * static_cast<double>(x) + line.d);
    const GatheredFeature y = gathered_feature<Dimension>(line.y, all);
    return line.above ? is_on_surface_side(0.0F, y.value(gathered), 0.0F, limit, true)
                      : y.is_at_most(gathered, limit);
}

/// Gathers the neighbors in the fluid of particle i that count. Hosts whose lists are at hand in
/// vectors have an overload of their own.
template <int Dimension, class View, class Radii, class Real>
void gather_fluid(const View& view, std::size_t i, const Radii& radii,
                  const NeighborRange<Real>& range, GatheredNeighbors& gathered) {
    Real unit = 0; // of mass: those of small particles are too small for float
    view(i, [&](std::size_t j, const auto& displacement, Real mass) {
        if (unit == 0)
            unit = 1 / mass;
        visit_if_in_range<Dimension>(displacement, mass * unit, i, j, radii, range,
                                     [&](const auto& neighbor) { gathered.add(neighbor); });
    });
}

/// The same over compressed rows: written without a branch, since the length is known.
template <int Dimension, class Real, int Stride, class Offset, class Index>
void gather_fluid(const CsrNeighborhood<Real, Dimension, Stride, Offset, Index>& view,
                  std::size_t i, const UniformRadius<Real>& radii, const NeighborRange<Real>& range,
                  GatheredNeighbors& gathered) {
    const auto begin = static_cast<std::size_t>(view.offsets[i]);
    const auto end = static_cast<std::size_t>(view.offsets[i + 1]);
    gathered.reserve(end - begin);
    float* const to[] = {gathered.step[0].data(), gathered.step[1].data(), gathered.step[2].data()};
    float* const mass = gathered.mass.data();
    float* const count = gathered.count.data();
    const Real* const center = view.positions + i * Stride;
    const Real unit = view.masses == nullptr || begin == end
                          ? Real(1)
                          : 1 / view.masses[static_cast<std::size_t>(view.neighbors[begin])];
    std::size_t size = 0;
    for (std::size_t n = begin; n < end; ++n) {
        const auto j = static_cast<std::size_t>(view.neighbors[n]);
        Real squared = 0;
        for (std::size_t axis = 0; axis < Dimension; ++axis) {
            const Real displacement = view.positions[j * Stride + axis] - center[axis];
            squared += displacement * displacement;
            to[axis][size] = static_cast<float>(displacement * radii.inverse);
        }
        mass[size] = static_cast<float>(view.masses == nullptr ? Real(1) : view.masses[j] * unit);
        count[size] = 1;
        size += static_cast<std::size_t>(range.contains(squared));
    }
    gathered.size = size;
}

/// Gathers the neighbors of particle i that count: those in the fluid, then the boundary particles
/// around it, each with the mean mass of the others.
template <int Dimension, class View, class Boundary, class Radii>
void gather_neighbors(const View& view, const Boundary& boundary, std::size_t i, const Radii& radii,
                      double radius_ratio, GatheredNeighbors& gathered) {
    using Real = decltype(radii.of(i));
    const auto range = range_of(radii, radius_ratio);
    gathered.size = 0;
    gather_fluid<Dimension>(view, i, radii, range, gathered);
    if constexpr (Boundary::is_there) {
        const std::size_t fluid = gathered.size;
        float mass = 0, count = 0;
        for (std::size_t n = 0; n < fluid; ++n) {
            mass += gathered.mass[n];
            count += gathered.count[n];
        }
        const Real mean_mass = count > 0 ? static_cast<Real>(mass / count) : Real(1);
        boundary(i, [&](std::size_t, const auto& displacement, Real weight) {
            visit_if_in_range<Dimension>(displacement, mean_mass * weight, i, i, radii, range,
                                         [&](auto neighbor) {
                                             neighbor.count = weight;
                                             gathered.add(neighbor);
                                         });
        });
    }
    gathered.fill_up();
}

/// Whether particle i is still a candidate by the second line. `boundary` has the boundary
/// particles that count, or is NoBoundary.
template <int Dimension, class View, class Boundary, class Radii>
bool is_surface(const View& view, const Boundary& boundary, std::size_t i, const Radii& radii,
                const SecondLine& line, double radius_ratio, GatheredNeighbors& gathered) {
    gather_neighbors<Dimension>(view, boundary, i, radii, radius_ratio, gathered);
    return is_surface<Dimension>(gathered, line);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
