// Which part of the sphere around a particle no neighbor covers, in closed form, from the arcs that
// bound it (cap_boundary.hpp):
// - Its area is that of the sectors between the arcs and the middles of their caps, less the
//   triangles there, plus the triangles between the arcs' ends and one reference point. That is the
//   Gauss-Bonnet theorem without loops to be counted: a stray arc of length e, as rounding leaves
//   on lattices, changes the area by about e at most.
// - Its first moment, the integral of the direction over it, is half the integral of p x dp along
//   the arcs. It points out of the fluid, as the sum of uncovered directions does (2020 paper,
//   eq. 3).
// In two dimensions the uncovered part is itself made of arcs of the circle.
//
// Where more than two circles all but coincide, rounding may put their cuts in the wrong order. The
// steps from the beginning to the end of each arc then do not add up to zero, and the caps are
// enlarged by different fractions of 1e-10, or up to 1e-8, which sets such circles apart.
#pragma once

#include "detail/cap_boundary.hpp"
#include "detail/coverage_cells.hpp"

#include <algorithm>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Uncovered fractions up to this are zero: a particle is surface where lambda exceeds it.
inline constexpr double zero_uncovered_fraction = 1e-9;

/// What no neighbor covers of a particle's sphere, or of its circle in two dimensions.
struct UncoveredPart {
    double fraction = 1;        ///< lambda, in [0, 1]
    Vector3 moment = {0, 0, 0}; ///< integral of the direction over it, per area of the whole
};

/// The caps of one particle after another, and working memory; one for each concurrent caller. The
/// caller fills `caps` (clear, add_cap) and asks.
struct ExactCoverage {
    CoveringCaps caps;
    CellTests tests;
    CoveringCaps near, far; ///< the caps that meet a cell not held, and the others
    CircleMemory circle;

    /// Room for so many caps; up to that nothing is allocated.
    void reserve(std::size_t capacity) {
        for (CoveringCaps* some : {&caps, &near, &far})
            some->reserve(capacity);
        tests.reserve(capacity);
        circle.reserve(capacity);
    }
};

namespace exact_coverage {

/// Sums over the boundary of the covered part.
struct BoundarySum {
    Vector3 reference;              ///< a unit vector
    double sectors = 0;             ///< area between arcs and the middles of their caps
    double real = 1, imaginary = 0; ///< half the area of the triangles is this number's angle
    Vector3 moment = {0, 0, 0};     ///< integral of p x dp
    Vector3 gap = {0, 0, 0};        ///< sum of steps along the arcs; 0 where they meet end to end

    /// Part of the circle of a cap, `length` (rad) long.
    void add_stretch(const CoveringCaps& caps, std::size_t i, double length, const Vector3& step) {
        const Vector3 axis = caps.middle(i);
        sectors += (1 - caps.cosine[i]) * length;
        moment = sum(moment, scaled(caps.sine[i] * caps.sine[i] * length, axis));
        moment = sum(moment, scaled(caps.cosine[i], cross(axis, step)));
        gap = sum(gap, step);
    }

    /// An arc of the circle of a cap, about `turn` (turn_order) long.
    void add_arc(const CoveringCaps& caps, std::size_t i, const Vector3& from, const Vector3& to,
                 double turn) {
        const double cosine = caps.cosine[i];
        const Vector3 normal = cross(from, to);
        const double ends = dot(from, to);
        const double turned = dot(caps.middle(i), normal);
        // Of the angles that the ends allow, the one that their order says.
        double length = arctangent(turned, ends - cosine * cosine);
        if (turn * (pi / 2) - length > pi)
            length += 2 * pi;
        add_stretch(caps, i, length, difference(to, from));
        // The angle of each factor is half the area of a triangle (Van Oosterom, Strackee 1983).
        multiply(1 + 2 * cosine + ends, -turned);
        multiply(1 + dot(reference, from) + ends + dot(reference, to), dot(reference, normal));
        const double scale = 1 / (std::fabs(real) + std::fabs(imaginary));
        real *= scale;
        imaginary *= scale;
    }

    /// Area of the covered part, up to multiples of 4 pi.
    [[nodiscard]] double area() const { return sectors + 2 * arctangent(imaginary, real); }

private:
    void multiply(double by_real, double by_imaginary) {
        const double product = real * by_real - imaginary * by_imaginary;
        imaginary = real * by_imaginary + imaginary * by_real;
        real = product;
    }
};

/// True where the point lies inside one of the caps.
inline bool is_inside_one(const CoveringCaps& caps, const Vector3& point) {
    WideMask inside = {};
    for (std::size_t n = 0; n < caps.padded_size(); n += wide_count) {
        const Wide along = point[0] * load<Wide>(&caps.x[n]) + point[1] * load<Wide>(&caps.y[n]) +
                           point[2] * load<Wide>(&caps.z[n]);
        inside |= along > load<Wide>(&caps.cosine[n]);
    }
    return any_lane(inside);
}

/// Adds what no cap covers of the circle of near cap i. Far caps do not meet the uncovered part, so
/// each stretch that the near caps leave open is either open altogether or covered altogether.
inline void add_open_arcs(std::size_t i, ExactCoverage& coverage, BoundarySum& boundary) {
    using namespace cap_boundary;
    const CoveringCaps& caps = coverage.near;
    const Frame frame(caps.middle(i));
    cover_circle(caps, i, frame, coverage.circle);
    const OpenCircle circle = find_open_arcs(caps.size(), coverage.circle);
    const auto is_open = [&](double turn) {
        return !is_inside_one(coverage.far, point_on_circle(caps, i, frame, turn));
    };
    if (circle.whole && is_open(0))
        boundary.add_stretch(caps, i, 2 * pi, {0, 0, 0});
    for (const OpenArc& arc : coverage.circle.arcs)
        if (is_open(circle.base + (arc.begin + arc.end) / 2))
            boundary.add_arc(caps, i, Cut(caps, i, arc.after).exit, Cut(caps, i, arc.before).entry,
                             arc.end - arc.begin);
}

/// `covered` is a covered direction that no arc comes near.
inline BoundarySum sum_boundary(const Vector3& covered, ExactCoverage& coverage) {
    BoundarySum boundary;
    boundary.reference = scaled(-1, covered);
    coverage.circle.resize(coverage.near.padded_size());
    for (std::size_t i = 0; i < coverage.near.size(); ++i)
        add_open_arcs(i, coverage, boundary);
    return boundary;
}

inline void part_near_and_far(ExactCoverage& coverage) {
    const CoveringCaps& caps = coverage.caps;
    coverage.near.clear();
    coverage.far.clear();
    for (std::size_t n = 0; n < caps.size(); ++n)
        (coverage.tests.is_near[n] != 0 ? coverage.near : coverage.far)
            .add(caps.middle(n), caps.cosine[n], caps.sine[n]);
    coverage.near.pad();
    coverage.far.pad();
}

/// Enlarges each cap by its own fraction of `max` (rad).
inline void enlarge(double max, CoveringCaps& caps) {
    std::uint32_t bits = 1;
    for (std::size_t n = 0; n < caps.size(); ++n) {
        bits = bits * 1664525U + 1013904223U; // any well spread numbers do
        const double angle = max * (0.5 + 0x1p-33 * bits);
        const double cosine = caps.cosine[n];
        caps.cosine[n] -= angle * caps.sine[n];
        caps.sine[n] += angle * cosine;
    }
}

/// The uncovered part by its boundary, after `settle` to the end.
inline UncoveredPart part_by_boundary(ExactCoverage& coverage) {
    const CoveringCaps& caps = coverage.caps;
    part_near_and_far(coverage);
    const auto largest = static_cast<std::size_t>(std::distance(
        caps.cosine.begin(),
        std::min_element(caps.cosine.begin(),
                         caps.cosine.begin() + static_cast<std::ptrdiff_t>(caps.size()))));
    BoundarySum boundary = sum_boundary(caps.middle(largest), coverage);
    for (double max = 1e-10; dot(boundary.gap, boundary.gap) > 1e-20 && max < 2e-8; max *= 10) {
        enlarge(max, coverage.near);
        boundary = sum_boundary(caps.middle(largest), coverage);
    }
    double fraction = -boundary.area() / (4 * pi);
    fraction -= std::floor(fraction);
    // Less than nothing by rounding, not all but everything: the largest cap at least is covered.
    if (fraction > 1 - (1 - caps.cosine[largest]) / 4)
        fraction -= 1;
    return {larger(fraction, 0), scaled(-0.5 / (4 * pi), boundary.moment)};
}

/// What the caps leave of a circle in two dimensions.
inline UncoveredPart part_of_circle(ExactCoverage& coverage) {
    using namespace cap_boundary;
    const CoveringCaps& caps = coverage.caps;
    CircleMemory& memory = coverage.circle;
    memory.resize(caps.padded_size());
    for (std::size_t n = 0; n < caps.padded_size(); n += wide_count) {
        const Wide x = load<Wide>(&caps.x[n]);
        const Wide y = load<Wide>(&caps.y[n]);
        const Wide along = load<Wide>(&caps.cosine[n]);
        const Wide aside = load<Wide>(&caps.sine[n]);
        const Wide entry = wide_turn_order(x * along + y * aside, y * along - x * aside);
        const Wide exit = wide_turn_order(x * along - y * aside, y * along + x * aside);
        store(entry, &memory.entry[n]);
        store(covered_length(entry, exit, all_lanes<Wide>(1)), &memory.length[n]);
    }
    const OpenCircle circle = find_open_arcs(caps.size(), memory);
    if (circle.whole)
        return {};
    UncoveredPart part{0, {0, 0, 0}};
    for (const OpenArc& arc : memory.arcs) {
        const Vector3 from = unit_vector(circle.base + arc.begin);
        const Vector3 to = unit_vector(circle.base + arc.end);
        double length = arctangent(from[0] * to[1] - from[1] * to[0], dot(from, to));
        if ((arc.end - arc.begin) * (pi / 2) - length > pi)
            length += 2 * pi;
        part.fraction += length / (2 * pi);
        part.moment = sum(part.moment, {to[1] - from[1], from[0] - to[0], 0});
    }
    part.fraction = smaller(larger(part.fraction, 0), 1);
    part.moment = scaled(1 / (2 * pi), part.moment);
    return part;
}

} // namespace exact_coverage

/// What the caps leave uncovered, exact but for rounding: within 1e-12, 1e-9 on lattices, 1e-7
/// where many circles all but coincide. All of it where there is no cap.
template <int Dimension>
MENISCUS_INLINE UncoveredPart uncovered_part(const CoverageCells& cells, ExactCoverage& coverage) {
    static_assert(Dimension == 2 || Dimension == 3);
    coverage.caps.pad();
    if (coverage.caps.size() == 0)
        return {};
    if constexpr (Dimension == 2)
        return exact_coverage::part_of_circle(coverage);
    else if (settle(cells, coverage.caps, coverage.tests, true) == Settled::covered)
        return {0, {0, 0, 0}};
    else
        return exact_coverage::part_by_boundary(coverage);
}

/// True where more than zero_uncovered_fraction is uncovered; faster than uncovered_part where that
/// is all that is asked.
template <int Dimension>
MENISCUS_INLINE bool is_uncovered(const CoverageCells& cells, ExactCoverage& coverage) {
    static_assert(Dimension == 2 || Dimension == 3);
    if constexpr (Dimension == 3) {
        const Settled settled = settle(cells, coverage.caps, coverage.tests, false);
        if (settled != Settled::undecided || coverage.caps.size() == 0)
            return settled == Settled::uncovered || coverage.caps.size() == 0;
    }
    coverage.caps.pad();
    const UncoveredPart part = Dimension == 2 ? exact_coverage::part_of_circle(coverage)
                                              : exact_coverage::part_by_boundary(coverage);
    return part.fraction > zero_uncovered_fraction;
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
