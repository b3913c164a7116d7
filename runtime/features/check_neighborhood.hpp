// A look at a host's neighbor lists while a solver is written: what every pass over them takes for
// granted, that j is in the list of i as often as i in that of j, which is once, that they hold
// what is closer than the support radius, and that this has as many spacings as the host says. Half
// lists (each pair once), lists that hold each neighbor twice, lists of half the radius, and a
// radius in another unit give no error by themselves but another surface. Takes about as long as a
// step with a few hundred samples.
#pragma once

#include "../errors.hpp"
#include "../math/angles.hpp"
#include "feature_neighbor.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

namespace neighborhood_check {

/// How many times j is in the list of i, within `range` of their radius.
template <class Real, int Dimension, class View, class Radii>
int times_listed(const View& view, std::size_t i, std::size_t j, const Radii& radii,
                 const NeighborRange<Real>& range) {
    int times = 0;
    view(i, [&](std::size_t other, const auto& displacement, Real mass) {
        if (other == j)
            visit_if_in_range<Dimension>(displacement, mass, i, j, radii, range,
                                         [&](const auto&) { ++times; });
    });
    return times;
}

/// What lists hold, over all particles.
struct ListedDistances {
    std::size_t pairs = 0;
    std::size_t beyond = 0; ///< of them not closer than the support radius
    double farthest = 0;    ///< in support radii of the pair
};

/// The length of a displacement, in radii of the pair; infinite where it leaves the range of Real.
template <class Real, int Dimension, class Displacement, class Radii>
double length_in_radii(const Displacement& displacement, std::size_t i, std::size_t j,
                       const Radii& radii) {
    double squared = 0;
    for (std::size_t axis = 0; axis < Dimension; ++axis) {
        const double step = static_cast<double>(displacement[axis]) *
                            static_cast<double>(radii.inverse_of_pair(i, j));
        squared += step * step;
    }
    return std::sqrt(squared);
}

template <class Real, int Dimension, class View, class Radii>
ListedDistances listed_distances(const View& view, std::size_t count, const Radii& radii) {
    ListedDistances found;
    for (std::size_t i = 0; i < count; ++i)
        view(i, [&](std::size_t j, const auto& displacement, Real /*mass*/) {
            if (j == i)
                return;
            const double length = length_in_radii<Real, Dimension>(displacement, i, j, radii);
            ++found.pairs;
            found.beyond += static_cast<std::size_t>(!(length < 1));
            found.farthest = (std::max)(found.farthest, length);
        });
    return found;
}

/// Throws where a neighbor of a neighbor of particle i is farther than `min` support radii from i,
/// closer than one, and not in its list, which is working memory. Of long lists some 64 neighbors
/// are asked.
template <class Real, int Dimension, class View, class Radii>
void check_completeness(const View& view, std::size_t i, const Radii& radii, double min,
                        std::vector<std::size_t>& list) {
    constexpr double max = 0.99; // two displacements round
    list.assign(1, i);
    view(i, [&](std::size_t j, const auto&, Real) { list.push_back(j); });
    std::sort(list.begin(), list.end());
    std::size_t place = 0;
    view(i, [&](std::size_t j, const auto& first, Real) {
        if (place++ % (list.size() / 64 + 1) != 0)
            return;
        view(j, [&](std::size_t k, const auto& second, Real) {
            Coordinates<Real, Dimension> displacement;
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                displacement[axis] = first[axis] + second[axis];
            const double length = length_in_radii<Real, Dimension>(displacement, i, k, radii);
            if (!(length < max && length > min) || std::binary_search(list.begin(), list.end(), k))
                return;
            char text[240];
            std::snprintf(text, sizeof text,
                          "neighbors: particle %zu has %zu at %.2g of its support radius, but not "
                          "in its list; lists hold all particles within it, so they end too early "
                          "or the radius, %.4g, is too large",
                          i, k, length, static_cast<double>(radii.of(i)));
            refuse(text);
        });
    });
}

} // namespace neighborhood_check

/// Throws std::invalid_argument (errors.hpp), naming the first pair, where a neighbor is listed
/// twice or only one way. Particles beyond the support radius, particles so close that they do not
/// count, and i itself may be there or not.
template <class Real, int Dimension, class View, class Radii>
void check_lists(const View& view, std::size_t count, const Radii& radii) {
    using namespace neighborhood_check;
    const auto range = range_of(radii, 0.8);
    const auto fail = [](std::size_t i, std::size_t j, const char* what) {
        char text[200];
        std::snprintf(text, sizeof text,
                      "neighbors: particle %zu has %zu in its list %s; lists are whole, each pair "
                      "in both and once",
                      i, j, what);
        refuse(text);
    };
    for (std::size_t i = 0; i < count; ++i)
        view(i, [&](std::size_t j, const auto& displacement, Real mass) {
            if (j >= count)
                fail(i, j, "which is no particle");
            visit_if_in_range<Dimension>(displacement, mass, i, j, radii, range, [&](const auto&) {
                if (times_listed<Real, Dimension>(view, i, j, radii, range) != 1)
                    fail(i, j, "more than once");
                if (times_listed<Real, Dimension>(view, j, i, radii, range) == 0)
                    fail(i, j, "and is not in that of the other");
            });
        });
}

/// Throws std::invalid_argument (errors.hpp) where radius and lists contradict each other: where
/// nine in ten of what is listed, and of a dozen at least, are not closer than the support radius,
/// and some farther than 1.4 of it; or where one of up to 256 particles lacks a neighbor that
/// neighbors of it have. Where all that is listed is within half the support radius, particles so
/// close that they do not count may not be missing either. After check_lists().
template <class Real, int Dimension, class View, class Radii>
void check_support_radius(const View& view, std::size_t count, const Radii& radii) {
    using namespace neighborhood_check;
    const ListedDistances found = listed_distances<Real, Dimension>(view, count, radii);
    constexpr double most_that_searches_add = 1.4; // a margin for particles that move
    if (found.pairs >= 12 && 10 * found.beyond > 9 * found.pairs &&
        found.farthest > most_that_searches_add) {
        char text[240];
        std::snprintf(text, sizeof text,
                      "neighbors: %zu of the %zu that the lists hold are beyond the support radius "
                      "of their particle (that of particle 0 is %.4g): is it that at which the "
                      "kernel ends, in the unit of positions?",
                      found.beyond, found.pairs, static_cast<double>(radii.of(0)));
        refuse(text);
    }
    constexpr std::size_t looked_at = 256;
    const double min = found.farthest < 0.5 ? 0 : 0.21;
    std::vector<std::size_t> list;
    for (std::size_t i = 0; i < count; i += count / looked_at + 1)
        check_completeness<Real, Dimension>(view, i, radii, min, list);
}

/// Throws std::invalid_argument (errors.hpp) where the support radius has more than 1.4 times as
/// many spacings as `spacing_ratio` by the numbers of neighbors, of which a quarter of the
/// particles has more; or fewer than over 1.4 by the distance to the nearest neighbor, than which a
/// tenth of those that have one are farther. Says nothing of fewer than 20 particles with
/// neighbors.
template <class Real, int Dimension, class View, class Radii>
void check_spacing_ratio(const View& view, std::size_t count, const Radii& radii,
                         double spacing_ratio) {
    const auto range = range_of(radii, 0.8);
    std::vector<double> counts, nearest;
    for (std::size_t i = 0; i < count; ++i) {
        double number = 0;
        double squared = 1;
        view(i, [&](std::size_t j, const auto& displacement, Real mass) {
            visit_if_in_range<Dimension>(
                displacement, mass, i, j, radii, range, [&](const auto& neighbor) {
                    number += static_cast<double>(neighbor.count);
                    squared = (std::min)(squared, static_cast<double>(neighbor.squared));
                });
        });
        if (number == 0)
            continue;
        counts.push_back(number);
        nearest.push_back(squared);
    }
    if (counts.size() < 20)
        return;
    const auto quantile = [](std::vector<double>& values, double share) {
        const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
        std::nth_element(values.begin(), values.begin() + place, values.end());
        return values[static_cast<std::size_t>(place)];
    };
    constexpr double unit = Dimension == 2 ? pi : 4 * pi / 3; // of a ball, in its radius
    const double by_count = std::pow((quantile(counts, 0.75) + 1) / unit, 1.0 / Dimension);
    const double by_distance = 1 / std::sqrt(quantile(nearest, 0.9));
    if (by_count < 1.4 * spacing_ratio && spacing_ratio < 1.4 * by_distance)
        return;
    char text[240];
    std::snprintf(text, sizeof text,
                  "spacing_ratio is %.3g, and the lists look like those of a support radius of "
                  "%.2g spacings: one of the two is wrong, is the radius that at which the kernel "
                  "ends?",
                  spacing_ratio, by_count < 1.4 * spacing_ratio ? by_distance : by_count);
    refuse(text);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
