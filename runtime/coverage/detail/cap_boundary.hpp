// The boundary of what caps cover: on the circle of each cap the arcs that no other cap covers.
// - Two circles cut in the same two points, to the bit, from either one's view (Cut). Arcs then
//   meet end to end however badly the cut is conditioned.
// - Places on a circle are put in order by turn_order, without an arc tangent.
// - What the caps cover of one circle is found for several caps at a time (cover_circle). The cap
//   that covers most comes first; most others then only move one end of what it leaves open.
#pragma once

#include "../../math/angles.hpp"
#include "../../math/vector3.hpp"
#include "../../simd/vector.hpp"
#include "covering_caps.hpp"

#include <cstdint>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// A stretch of a circle that no cap covers, counterclockwise seen from outside. Places are
/// turn_orders from the base of its circle.
struct OpenArc {
    double begin, end;
    std::uint32_t after, before; ///< the caps that it begins after and ends before
};

/// Arcs of one circle after another, and working memory for them.
struct CircleMemory {
    std::vector<OpenArc> arcs;
    std::vector<double> entry, length; ///< for each cap, what it covers of the circle
    std::vector<double> begin, reach;  ///< the same from the base on

    void resize(std::size_t count) {
        for (auto* values : {&entry, &length, &begin, &reach})
            values->resize(count);
    }

    /// Room for so many caps: between n arcs that are covered lie at most n open ones.
    void reserve(std::size_t capacity) {
        arcs.reserve(capacity + 1);
        for (auto* values : {&entry, &length, &begin, &reach})
            values->reserve(padded_to_wide(capacity));
    }
};

/// Where a circle lies open.
struct OpenCircle {
    bool whole;  ///< no cap covers any of it
    double base; ///< turn_order that its arcs count from
};

namespace cap_boundary {

/// Shorter arcs are rounding.
inline constexpr double shortest_arc = 1e-13;

/// Caps whose middles are closer than about 4e-5 are cut with more care.
inline constexpr double nearly_the_same = 1 - 1e-9;

/// The frame that two middles span, and the plane in which their circles cut. Stays good where the
/// middles all but coincide; undefined where they do.
struct Axes {
    Vector3 ahead; ///< unit vector halfway between the middles
    Vector3 aside; ///< unit vector from middle i towards middle j, at right angles to it
    double to_middle, to_apart; ///< 1 / length of the sum and of the difference of the middles
    double along, across;       ///< of the points of the cut

    Axes(const CoveringCaps& caps, std::size_t i, std::size_t j) {
        const Vector3 together = sum(caps.middle(j), caps.middle(i));
        to_middle = 1 / std::sqrt(dot(together, together));
        ahead = scaled(to_middle, together);
        // Rounding leaves the middles not quite of one length, which counts where they are close.
        const Vector3 between = difference(caps.middle(j), caps.middle(i));
        const Vector3 apart = difference(between, scaled(dot(between, ahead), ahead));
        to_apart = 1 / std::sqrt(dot(apart, apart));
        aside = scaled(to_apart, apart);
        along = (caps.cosine[i] + caps.cosine[j]) * to_middle;
        across = (caps.cosine[j] - caps.cosine[i]) * to_apart;
    }
};

/// How the circles of two caps lie to each other; the same to the bit in either order.
struct Pair {
    double between;       ///< cosine of the angle between the middles
    double past_touching; ///< not positive where the caps are apart
    double before_inside; ///< not positive where one cap lies inside the other

    Pair(const CoveringCaps& caps, std::size_t i, std::size_t j)
        : between(dot(caps.middle(i), caps.middle(j))) {
        const double cosines = caps.cosine[i] * caps.cosine[j];
        const double sines = caps.sine[i] * caps.sine[j];
        past_touching = between - (cosines - sines);
        before_inside = cosines + sines - between;
        if (between > nearly_the_same) { // a difference of numbers that are nearly 1
            const Axes axes(caps, i, j);
            const double product = axes.to_middle * axes.to_apart;
            before_inside = (1 - axes.along * axes.along - axes.across * axes.across) /
                            (4 * product * product * past_touching);
        }
    }

    /// Volume that the middles and a point of the cut span; 0 where there is no cut.
    [[nodiscard]] double volume() const {
        return std::sqrt(larger(past_touching, 0) * larger(before_inside, 0));
    }
};

/// The points where the circles of caps i and j cut: where that of i, counterclockwise, enters and
/// leaves the cap j. Undefined where the middles coincide.
struct Cut {
    Vector3 entry, exit;

    Cut(const CoveringCaps& caps, std::size_t i, std::size_t j) {
        const Axes axes(caps, i, j);
        const Vector3 base = sum(scaled(axes.along, axes.ahead), scaled(axes.across, axes.aside));
        const double half = 2 * Pair(caps, i, j).volume() * axes.to_middle * axes.to_apart;
        const Vector3 up = scaled(half, cross(axes.ahead, axes.aside));
        entry = difference(base, up);
        exit = sum(base, up);
    }
};

/// From entry to exit of a circle with another cap, 0 to 4. It is more than half the circle where
/// `center` is negative: the circle's center then lies inside the cap. That decides where entry and
/// exit all but coincide.
MENISCUS_INLINE Wide covered_length(Wide entry, Wide exit, Wide center) {
    const Wide turn = exit - entry;
    const Wide length =
        turn + 2 - with_sign(all_lanes<Wide>(2), turn + with_sign(all_lanes<Wide>(1), center));
    return smaller(larger(length, Wide{}), all_lanes<Wide>(4));
}

/// What cap j covers of the circle of cap i, where their middles all but coincide. Of two equal
/// caps, the first covers the other.
inline double careful_cover(const CoveringCaps& caps, std::size_t i, std::size_t j,
                            const Frame& frame, double& entry) {
    const Pair pair(caps, i, j);
    const Vector3 apart = difference(caps.middle(j), caps.middle(i));
    if (dot(apart, apart) < 1e-29 || !(pair.before_inside > 0)) {
        const bool covers =
            caps.cosine[j] != caps.cosine[i] ? caps.cosine[j] < caps.cosine[i] : j < i;
        return covers ? 4 : 0;
    }
    const Cut cut(caps, i, j);
    entry = turn_order(dot(cut.entry, frame.first), dot(cut.entry, frame.second));
    const double exit = turn_order(dot(cut.exit, frame.first), dot(cut.exit, frame.second));
    const double center = caps.cosine[j] - caps.cosine[i] * pair.between;
    return covered_length(all_lanes<Wide>(entry), all_lanes<Wide>(exit),
                          all_lanes<Wide>(center))[0];
}

MENISCUS_INLINE Wide wide_turn_order(Wide x, Wide y) {
    return with_sign(1 - x / (absolute(x) + absolute(y) + 1e-300), y);
}

/// Fills memory.entry and memory.length with what each cap covers of the circle of cap i. The
/// arithmetic is Pair's, several caps at a time and without a branch; only caps that all but
/// coincide with this one are looked at again.
inline void cover_circle(const CoveringCaps& caps, std::size_t i, const Frame& frame,
                         CircleMemory& memory) {
    const Vector3 axis = caps.middle(i);
    const double cosine = caps.cosine[i];
    const double sine = caps.sine[i];
    Wide nearly_same = {};
    for (std::size_t j = 0; j < caps.padded_size(); j += wide_count) {
        const Wide x = load<Wide>(&caps.x[j]);
        const Wide y = load<Wide>(&caps.y[j]);
        const Wide z = load<Wide>(&caps.z[j]);
        const Wide between = axis[0] * x + axis[1] * y + axis[2] * z;
        const Wide cosines = cosine * load<Wide>(&caps.cosine[j]);
        const Wide sines = sine * load<Wide>(&caps.sine[j]);
        const Wide past_touching = between - (cosines - sines);
        const Wide volume =
            square_root(larger(past_touching, Wide{}) * larger(cosines + sines - between, Wide{}));
        const Wide center = load<Wide>(&caps.cosine[j]) - cosine * between;
        const Wide ahead = x * frame.first[0] + y * frame.first[1] + z * frame.first[2];
        const Wide aside = x * frame.second[0] + y * frame.second[1] + z * frame.second[2];
        const Wide entry =
            wide_turn_order(ahead * center + aside * volume, aside * center - ahead * volume);
        const Wide exit =
            wide_turn_order(ahead * center - aside * volume, aside * center + ahead * volume);
        const Wide length = covered_length(entry, exit, center);
        store(entry, &memory.entry[j]);
        store(past_touching > 0 ? length : Wide{}, &memory.length[j]);
        nearly_same += between > nearly_the_same ? all_lanes<Wide>(1) : Wide{};
    }
    memory.length[i] = 0;
    double count = 0;
    for (std::size_t lane = 0; lane < wide_count; ++lane)
        count += nearly_same[lane];
    if (count < 1.5) // the cap itself
        return;
    for (std::size_t j = 0; j < caps.size(); ++j)
        if (j != i && Pair(caps, i, j).between > nearly_the_same)
            memory.length[j] = careful_cover(caps, i, j, frame, memory.entry[j]);
}

/// Takes the stretch that a cap covers from the open arcs.
inline void close_stretch(double begin, double end, std::uint32_t cap, std::vector<OpenArc>& arcs) {
    for (std::size_t n = 0; n < arcs.size();) {
        OpenArc& arc = arcs[n];
        if (begin >= arc.end || end <= arc.begin) {
            ++n;
            continue;
        }
        const OpenArc rest{end, arc.end, cap, arc.before};
        const bool open_before = begin - arc.begin > shortest_arc;
        const bool open_after = arc.end - end > shortest_arc;
        if (open_before) {
            arc.end = begin;
            arc.before = cap;
            if (open_after)
                arcs.push_back(rest); // the loop will find it clear of the stretch
            ++n;
        } else if (open_after) {
            arc = rest;
            ++n;
        } else {
            arc = arcs.back();
            arcs.pop_back();
        }
    }
}

/// The place of a value that is there.
inline std::uint32_t place_of(double value, const std::vector<double>& values) {
    std::uint32_t place = 0;
    while (values[place] != value)
        ++place;
    return place;
}

/// Closes what lies between the ends of the one open arc, which caps across its ends have set.
inline void close_inner_stretches(std::size_t padded, double longest, CircleMemory& memory) {
    const double open_from = memory.arcs[0].begin;
    const double open_to = memory.arcs[0].end;
    for (std::size_t j = 0; j < padded; j += wide_count) {
        const Wide begin = load<Wide>(&memory.begin[j]);
        const Wide end = begin + load<Wide>(&memory.length[j]);
        const WideMask inside =
            (begin > longest) & (begin < open_to) & (end > open_from) & (end > begin);
        if (!any_lane(inside))
            continue;
        for (std::size_t lane = 0; lane < wide_count; ++lane)
            if (inside[lane] != 0)
                close_stretch(begin[lane], end[lane], static_cast<std::uint32_t>(j + lane),
                              memory.arcs);
    }
}

/// Leaves in memory.arcs what the stretches of memory.entry and memory.length leave open.
inline OpenCircle find_open_arcs(std::size_t count, CircleMemory& memory) {
    memory.arcs.clear();
    const std::size_t padded = padded_to_wide(count);
    Wide max = {};
    for (std::size_t j = 0; j < padded; j += wide_count)
        max = larger(max, load<Wide>(&memory.length[j]));
    const double longest = max_lane(max, 0);
    if (longest <= 0)
        return {true, 0};
    const std::uint32_t first = place_of(longest, memory.length);
    const double base = memory.entry[first];
    Wide low = all_lanes<Wide>(longest);
    Wide high = all_lanes<Wide>(4);
    for (std::size_t j = 0; j < padded; j += wide_count) {
        const Wide turn = load<Wide>(&memory.entry[j]) - base;
        const Wide begin = turn + 2 - with_sign(all_lanes<Wide>(2), turn);
        const Wide end = begin + load<Wide>(&memory.length[j]);
        const Wide reach = begin <= longest ? end : end - 4;
        store(begin, &memory.begin[j]);
        store(reach, &memory.reach[j]);
        low = larger(low, reach);
        high = smaller(high, end >= 4 ? begin : all_lanes<Wide>(4));
    }
    const double open_from = max_lane(low, longest);
    const double open_to = min_lane(high, 4);
    if (open_to - open_from <= shortest_arc)
        return {false, base};
    memory.arcs.push_back({open_from, open_to,
                           open_from > longest ? place_of(open_from, memory.reach) : first,
                           open_to < 4 ? place_of(open_to, memory.begin) : first});
    close_inner_stretches(padded, longest, memory);
    return {false, base};
}

/// The point of a cap's circle at a turn_order, which may be up to a turn beyond 2.
inline Vector3 point_on_circle(const CoveringCaps& caps, std::size_t i, const Frame& frame,
                               double turn) {
    const Vector3 place = unit_vector(turn);
    const double scale = caps.sine[i];
    return sum(scaled(caps.cosine[i], caps.middle(i)),
               sum(scaled(place[0] * scale, frame.first), scaled(place[1] * scale, frame.second)));
}

} // namespace cap_boundary
} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
