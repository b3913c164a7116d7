// The surface classifier that runs inside the SPH step: a particle is taken for surface where its
// neighbor count y lies on or below a straight line over its mass offset x, y <= k x + d (2020
// paper, section 3.1). k and d come from a coefficient header that `meniscus export` writes; the
// line is fitted so that no surface particle of the training set is missed, and lets some interior
// particles through, which costs time but no correctness.
//
// Either fuse it into the density loop (FeatureSum::add for each neighbor, is_surface at the end)
// or run classify() over a neighborhood view. A coefficient header of other features than these two
// names them, and classify() adds those up (line_features.hpp). A header may have a second line
// for what the first lets through, and may ask that boundary particles count
// (neighbors/boundary.hpp): classify() follows it.
//
// Counts grow with the support radius. The lines of a header that says for which ratio of support
// radius and particle spacing it has its numbers (reference_spacing_ratio) follow the host's; the
// spacing is that of particles at rest, the cube root (in 2D the square root) of m / rho_0.
#pragma once

#include "../neighbors/boundary.hpp"
#include "classifier_options.hpp"
#include "features.hpp"
#include "line_features.hpp"
#include "scaled_features.hpp"

#include <cstdint>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The line y = k x + d: y in neighbors, x without unit.
template <class Real>
struct SurfaceLine {
    Real k;
    Real d;
};

/// The line of an exported coefficient struct (see coefficients/surface_3d.hpp for one) for a
/// support radius of so many particle spacings, which plays no part where the struct's counts are
/// taken as they are.
template <class Coefficients, class Real>
constexpr SurfaceLine<Real> surface_line(double spacing_ratio) {
    static_assert(has_features_of_paper<Coefficients>,
                  "this line is in other features than mass_offset and neighbor_count: give the "
                  "coefficients to classify(), or add up a LineSum of them");
    const double scale = count_scale<Coefficients>(spacing_ratio);
    return {static_cast<Real>(Coefficients::k * scale), static_cast<Real>(Coefficients::d * scale)};
}

/// The same where the counts are taken as they are; refuses others at compile time.
template <class Coefficients, class Real>
constexpr SurfaceLine<Real> surface_line() {
    static_assert(home_spacing_ratio<Coefficients> == 0,
                  "this line follows the support radius over particle spacing: give it");
    return surface_line<Coefficients, Real>(1);
}

/// The median of `size` neighbor counts (feature y of all particles): the smallest count that at
/// least half of them do not exceed. Counts of 1023 and more count as 1023. 0 where there are none.
template <class Count>
int median_neighbor_count(const Count* counts, std::size_t size) {
    constexpr std::size_t max = 1023;
    std::array<std::size_t, max + 1> particles_with{};
    for (std::size_t i = 0; i < size; ++i) {
        const auto count = static_cast<std::size_t>(counts[i]);
        ++particles_with[count < max ? count : max];
    }
    std::size_t below = 0;
    for (std::size_t count = 0; count <= max; ++count) {
        below += particles_with[count];
        if (2 * below >= size)
            return static_cast<int>(count);
    }
    return 0;
}

/// True for surface. A particle without neighbors is surface, and so is one whose features are
/// not finite: a false positive costs time, a false negative corrupts the physics.
template <class Real, int Dimension, class Count>
MENISCUS_HOST_DEVICE bool is_surface(const FeatureSum<Real, Dimension, Count>& sum,
                                     const SurfaceLine<Real>& line, Real support_radius) {
    // y - d <= k x, both sides squared: that saves the square root in x. Dividing first keeps
    // small masses and radii from underflowing. | and & in place of || and &&, because whether a
    // particle is surface is what a branch cannot be predicted on.
    const Real above = static_cast<Real>(sum.count) - line.d;
    const Real inverse = 1 / (support_radius * sum.total_mass());
    Real right_squared = 0;
    for (std::size_t axis = 0; axis < Dimension; ++axis) {
        const Real term = line.k * (sum.moment[axis] * inverse);
        right_squared += term * term;
    }
    const Real left_squared = above * above;
    const int below = line.k >= 0 ? int{above <= 0} | int{left_squared <= right_squared}
                                  : int{above <= 0} & int{left_squared >= right_squared};
    // The inverse is 0 where the product overflowed; by bits, as fast mathematics knows no
    // infinity.
    const int is_lost = int{bits_of(inverse) == 0} | int{!is_finite(right_squared)};
    return (below | int{sum.count == 0} | is_lost) != 0;
}

/// Classifies particles `begin` to `end - 1` of a neighborhood view: surface[i] becomes 1 or 0.
/// Returns how many are surface. Ranges that do not overlap may run concurrently.
template <class Real, int Dimension, class View>
std::size_t classify(const View& view, std::size_t begin, std::size_t end, Real support_radius,
                     const SurfaceLine<Real>& line, const NeighborRange<Real>& range,
                     std::uint8_t* surface) {
    std::size_t found = 0;
    for (std::size_t i = begin; i < end; ++i) {
        const auto sum = sum_features<Real, Dimension>(view, i, range);
        surface[i] = static_cast<std::uint8_t>(is_surface(sum, line, support_radius));
        found += surface[i];
    }
    return found;
}

/// Classifies particles of which each has its own support radius (scaled_features.hpp), which every
/// j that the view delivers must have. A line that was trained on states of one radius each holds
/// for them too.
template <class Real, int Dimension, class View>
std::size_t classify(const View& view, std::size_t begin, std::size_t end,
                     const VaryingRadii<Real>& radii, const SurfaceLine<Real>& line,
                     double radius_ratio, std::uint8_t* surface) {
    const auto range = neighbor_range<Real>(1, radius_ratio);
    std::size_t found = 0;
    for (std::size_t i = begin; i < end; ++i) {
        const auto sum = sum_features<Real, Dimension>(view, i, radii, range);
        surface[i] = static_cast<std::uint8_t>(is_surface(sum, line, Real(1)));
        found += surface[i];
    }
    return found;
}

/// Whether particle i is surface by a first line.
template <class Real, int Dimension, class View, class Boundary>
bool is_surface_by_first_line(const View& view, const Boundary& boundary, std::size_t i,
                              const UniformRadius<Real>& radii, const NeighborRange<Real>& range,
                              const SurfaceLine<Real>& line) {
    const auto sum = sum_features<Real, Dimension>(view, i, range);
    if constexpr (Boundary::is_there)
        return is_surface(with_boundary(sum, boundary, i, range), line, radii.radius);
    else
        return is_surface(sum, line, radii.radius);
}

template <class Real, int Dimension, class View, class Boundary>
bool is_surface_by_first_line(const View& view, const Boundary& boundary, std::size_t i,
                              const VaryingRadii<Real>& radii, const NeighborRange<Real>& range,
                              const SurfaceLine<Real>& line) {
    auto sum = sum_features<Real, Dimension>(view, i, radii, range);
    add_scaled_boundary(boundary, i, radii, range, sum);
    return is_surface(sum, line, Real(1));
}

/// Classifies with features, lines, boundary weight and radius ratio of an exported coefficient
/// struct, over UniformRadius or VaryingRadii, for a support radius of `spacing_ratio` particle
/// spacings. `boundary` is a BoundaryView, or NoBoundary where there is none; it plays no part
/// where the coefficients were trained without. Refuses coefficients of another dimension at
/// compile time.
template <class Coefficients, class Real, int Dimension, class View, class Boundary, class Radii>
std::size_t classify(const View& view, const Boundary& boundary, std::size_t begin, std::size_t end,
                     const Radii& radii, double spacing_ratio, std::uint8_t* surface) {
    static_assert(Coefficients::dimension == Dimension,
                  "these coefficients were trained in another dimension");
    constexpr auto share = static_cast<Real>(boundary_weight<Coefficients>);
    if constexpr (Boundary::is_there && share == 0) {
        return classify<Coefficients, Real, Dimension>(view, NoBoundary{}, begin, end, radii,
                                                       spacing_ratio, surface);
    } else if constexpr (!has_features_of_paper<Coefficients>) {
        return classify_by_features<Coefficients, Real, Dimension>(
            view, times_weight(boundary, share), begin, end, radii, spacing_ratio, surface);
    } else {
        const auto weighted = times_weight(boundary, share);
        const auto range = range_of(radii, Coefficients::radius_ratio);
        const auto line = surface_line<Coefficients, Real>(spacing_ratio);
        std::size_t found = 0;
        for (std::size_t i = begin; i < end; ++i) {
            bool stays =
                is_surface_by_first_line<Real, Dimension>(view, weighted, i, radii, range, line);
            if constexpr (has_second_line<Coefficients>)
                stays =
                    stays &&
                    is_surface_by_features<typename Coefficients::SecondLine, Real, Dimension>(
                        view, weighted, i, radii, range, count_scale<Coefficients>(spacing_ratio));
            surface[i] = static_cast<std::uint8_t>(stays);
            found += surface[i];
        }
        return found;
    }
}

/// The same without a boundary, by lines that take counts as they are; `radii` may be the support
/// radius of all in m, too.
template <class Coefficients, class Real, int Dimension, class View>
std::size_t classify(const View& view, std::size_t begin, std::size_t end, Real support_radius,
                     std::uint8_t* surface) {
    return classify<Coefficients, Real, Dimension>(view, begin, end,
                                                   UniformRadius<Real>{support_radius}, surface);
}
template <class Coefficients, class Real, int Dimension, class View, class Radii,
          bool = Radii::varies>
std::size_t classify(const View& view, std::size_t begin, std::size_t end, const Radii& radii,
                     std::uint8_t* surface) {
    static_assert(home_spacing_ratio<Coefficients> == 0,
                  "these lines follow the support radius over particle spacing: give it");
    return classify<Coefficients, Real, Dimension>(view, NoBoundary{}, begin, end, radii, 1.0,
                                                   surface);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
