// Which particles hang together: a component is a set of particles that neighbor relations connect
// (same phase, closer than h), like one droplet of a splash. What holds for a component as a whole,
// as that its surface tension cannot push it (momentum.hpp), is summed over one.
//
// Components are the trees of a union-find forest (Tarjan 1975, Efficiency of a good but not linear
// set union algorithm). All threads link trees at one time without locks, always the larger root
// below the smaller, so the label of a component is its smallest particle, whoever linked first.
// Most lists are never read: those of every eighth particle connect nearly all of a component, and
// inside the component that is then the largest no list can tell anything new, since a pair with
// one particle outside stands in the list of that one too (Sutton et al. 2018, Optimizing parallel
// graph connectivity computation via subgraph sampling, skip edges likewise).
#pragma once

#include "../features/features.hpp"
#include "../neighbors/parallel_loop.hpp"
#include "../neighbors/support_radius.hpp"

#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Finds components, with memory of its own: one for each concurrent caller.
class ComponentFinder {
public:
    /// Makes room for so many particles; calls for no more of them allocate nothing. Throws
    /// std::bad_alloc.
    void reserve(std::size_t particles) {
        if (particles > entries.size())
            entries = std::vector<std::atomic<std::uint32_t>>(particles);
    }

    /// Labels particles 0 to `count` - 1 (fewer than 2^32), components[i] becoming the smallest
    /// particle of the component of i. `view` (neighborhood.hpp) must deliver i to j where it
    /// delivers j to i, and no particle of another phase; what it delivers from `count` on (ghosts
    /// with indices of their own) is ignored. Neighbors are closer than the support radius of the
    /// pair (support_radius.hpp), less the neighbor band; unlike for features, particles nearly in
    /// one place are too. `loop` as in parallel_loop.hpp.
    template <class Real, int Dimension, class View, class Radius, class Loop>
    void find(const View& view, std::size_t count, const Radius& radius, const Loop& loop,
              std::uint32_t* components) {
        reserve(count);
        const auto connect = [&](std::size_t i) {
            connect_neighbors<Real, Dimension>(view, i, count, radius);
        };
        each(count, loop, [&](std::size_t i) {
            components[i] = static_cast<std::uint32_t>(i);
            set(i, components[i]);
        });
        each(count / sampled_of, loop, [&](std::size_t block) { connect(sample_of(block)); });
        label(count, loop, components);
        const std::uint32_t max = frequent_label(components, count);
        each(count, loop, [&](std::size_t i) {
            if (components[i] != max)
                connect(i);
        });
        label(count, loop, components);
    }

    /// Sets at_wall[i] to 1 where any particle j of the component of i has touches_wall[j] not 0,
    /// else to 0. `components` as find() left it; `at_wall` may be `touches_wall` itself.
    template <class Loop>
    void spread_wall_contact(const std::uint32_t* components, const std::uint8_t* touches_wall,
                             std::size_t count, const Loop& loop, std::uint8_t* at_wall) {
        reserve(count);
        each(count, loop, [&](std::size_t i) { set(i, 0); });
        each(count, loop, [&](std::size_t i) {
            if (touches_wall[i] != 0)
                set(components[i], 1);
        });
        each(count, loop,
             [&](std::size_t i) { at_wall[i] = static_cast<std::uint8_t>(get(components[i])); });
    }

private:
    /// While components are sought, the parent of each particle, the particle itself for a root; a
    /// parent is always smaller. No order among memory accesses is needed: an old parent is still
    /// an ancestor, and the loop's end makes all known.
    std::vector<std::atomic<std::uint32_t>> entries;

    [[nodiscard]] std::uint32_t get(std::size_t i) const {
        return entries[i].load(std::memory_order_relaxed);
    }
    void set(std::size_t i, std::uint32_t value) {
        entries[i].store(value, std::memory_order_relaxed);
    }

    template <class Loop, class Component>
    static void each(std::size_t count, const Loop& loop, const Component& component) {
        loop(count, [&](std::size_t begin, std::size_t end, int /*worker*/) {
            for (std::size_t i = begin; i < end; ++i)
                component(i);
        });
    }

    static constexpr std::size_t sampled_of = 8;

    /// One particle of a block of `sampled_of`, as good as drawn at random: at even distances they
    /// could form planes on a lattice.
    static std::size_t sample_of(std::size_t block) {
        auto mixed = static_cast<std::uint32_t>(block) * 0x9E3779B9U;
        mixed = (mixed ^ mixed >> 15U) * 0x85EBCA6BU;
        return block * sampled_of + (mixed >> 16U) % sampled_of;
    }

    /// The most frequent label of some particles that are spread over all.
    static std::uint32_t frequent_label(const std::uint32_t* components, std::size_t count) {
        constexpr std::size_t samples = 32;
        std::uint32_t best = 0;
        int max = 0;
        for (std::size_t s = 0; s < samples && count > 0; ++s) {
            const std::uint32_t candidate = components[s * count / samples];
            int votes = 0;
            for (std::size_t t = 0; t < samples; ++t)
                votes += int{components[t * count / samples] == candidate};
            if (votes > max) {
                max = votes;
                best = candidate;
            }
        }
        return best;
    }

    template <class Loop>
    void label(std::size_t count, const Loop& loop, std::uint32_t* components) {
        each(count, loop, [&](std::size_t i) {
            components[i] = root_of(static_cast<std::uint32_t>(i));
            set(i, components[i]);
        });
    }

    template <class Real, int Dimension, class View, class Radius>
    void connect_neighbors(const View& view, std::size_t i, std::size_t count,
                           const Radius& radius) {
        constexpr auto limit = static_cast<Real>((1 - neighbor_band) * (1 - neighbor_band));
        std::uint32_t root = root_of(static_cast<std::uint32_t>(i));
        view(i, [&](std::size_t j, const auto& displacement, const auto& /*mass*/) {
            if (j >= count || get(j) == root)
                return;
            const std::uint32_t other = root_of(static_cast<std::uint32_t>(j));
            if (other == root)
                return;
            const Real inverse = radius.inverse_of_pair(i, j);
            const Real ratio_squared =
                squared_length<Real, Dimension>(displacement) * inverse * inverse;
            if (bits_of(ratio_squared) < bits_of(limit)) // not NaN, even under -ffast-math
                root = unite(root, other);
        });
    }

    /// The root above i, which gets every other particle on the way closer to it.
    std::uint32_t root_of(std::uint32_t i) {
        for (;;) {
            const std::uint32_t parent = get(i);
            if (parent == i)
                return i;
            const std::uint32_t grandparent = get(parent);
            if (grandparent == parent)
                return parent;
            set(i, grandparent);
            i = grandparent;
        }
    }

    /// Makes one tree of those of a and b and returns its root.
    std::uint32_t unite(std::uint32_t a, std::uint32_t b) {
        for (;;) {
            if (a == b)
                return a;
            if (a < b)
                std::swap(a, b);
            std::uint32_t expected = a;
            if (entries[a].compare_exchange_strong(expected, b, std::memory_order_relaxed))
                return b;
            a = root_of(a); // linked by another thread meanwhile
            b = root_of(b);
        }
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
