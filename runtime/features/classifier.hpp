// The surface classifier that runs inside the SPH step: a particle is taken for surface where its
// neighbor count y lies on or below a straight line over its mass offset x, y <= k x + d (2020
// paper, section 3.1). k and d come from a coefficient header that `meniscus export` writes; the
// line is fitted so that no surface particle of the training set is missed, and lets some interior
// particles through, which costs time but no correctness.
//
// Either fuse it into the density loop (FeatureSum::add for each neighbor, is_surface at the end)
// or run classify() over a neighborhood view. A coefficient header of other features than these two
// names them, and classify() adds those up (line_features.hpp).
//
// A fluid that is compressed has more neighbors everywhere: about 26 on the lattice that a scene
// starts from, 40 in developed flow. A line for counts as they are pays for that range in false
// positives. A *relative* line is trained on counts measured by the state's median; the host
// passes the median of its last step, and the line follows the fluid.
#pragma once

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

/// The line of an exported coefficient struct (see coefficients/surface_3d.hpp for one) whose
/// counts are as they are. Refuses a relative line at compile time.
template <class Coefficients, class Real>
constexpr SurfaceLine<Real> surface_line() {
    static_assert(has_features_of_paper<Coefficients>,
                  "this line is in other features than mass_offset and neighbor_count: give the "
                  "coefficients to classify(), or add up a LineSum of them");
    static_assert(Coefficients::reference_neighbor_count == 0,
                  "this line is relative: call surface_line(median neighbor count)");
    return {static_cast<Real>(Coefficients::k), static_cast<Real>(Coefficients::d)};
}

/// The line y = k x + d for a state whose median neighbor count is `median_count`, from one for a
/// median of `reference_count`.
template <class Real>
constexpr SurfaceLine<Real> scaled_line(double k, double d, double median_count,
                                        double reference_count) {
    const double scale = median_count / reference_count;
    return {static_cast<Real>(k * scale), static_cast<Real>(d * scale)};
}

/// The line of a relative coefficient struct for a state of that median neighbor count (see
/// median_neighbor_count; the one of the last step will do, since it changes slowly).
template <class Coefficients, class Real>
constexpr SurfaceLine<Real> surface_line(double median_count) {
    static_assert(Coefficients::reference_neighbor_count > 0,
                  "this line is not relative: call surface_line() without a count");
    return scaled_line<Real>(Coefficients::k, Coefficients::d, median_count,
                             Coefficients::reference_neighbor_count);
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
bool is_surface(const FeatureSum<Real, Dimension, Count>& sum, const SurfaceLine<Real>& line,
                Real support_radius) {
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

/// The same with features, line and radius ratio of an exported coefficient struct. Refuses
/// coefficients of another dimension at compile time.
template <class Coefficients, class Real, int Dimension, class View>
std::size_t classify(const View& view, std::size_t begin, std::size_t end, Real support_radius,
                     std::uint8_t* surface) {
    static_assert(Coefficients::dimension == Dimension,
                  "these coefficients were trained in another dimension");
    if constexpr (has_features_of_paper<Coefficients>)
        return classify<Real, Dimension>(
            view, begin, end, support_radius, surface_line<Coefficients, Real>(),
            neighbor_range<Real>(support_radius, Coefficients::radius_ratio), surface);
    else
        return classify_by_features<Coefficients, Real, Dimension>(
            view, begin, end, UniformRadius<Real>{support_radius}, surface);
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

/// The same with features, line and radius ratio of an exported coefficient struct.
template <class Coefficients, class Real, int Dimension, class View>
std::size_t classify(const View& view, std::size_t begin, std::size_t end,
                     const VaryingRadii<Real>& radii, std::uint8_t* surface) {
    static_assert(Coefficients::dimension == Dimension,
                  "these coefficients were trained in another dimension");
    if constexpr (has_features_of_paper<Coefficients>)
        return classify<Real, Dimension>(view, begin, end, radii,
                                         surface_line<Coefficients, Real>(),
                                         Coefficients::radius_ratio, surface);
    else
        return classify_by_features<Coefficients, Real, Dimension>(view, begin, end, radii,
                                                                   surface);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
