// Surface tension is an inner force: over a component that touches nothing it adds up to neither a
// force nor a torque. Forces from estimated normals and curvatures do not quite, so a droplet in
// zero gravity starts to drift and spin, which the 2020 paper's conclusions leave open. Here both
// are taken out of every free component by the smallest change: among all forces without net force
// and torque those with the least sum of |F_i' - F_i|^2 / w_i, which are
//     F_i' = F_i - w_i (a + b x (x_i - c)),
// c being the weighted mean position, a = sum F / sum w, and b the solution of I b = T with the
// weighted inertia I and the torque T about c. Weights say where the error is thought to lie; the
// magnitude of a particle's force or its area is a choice.
//
// Positions are taken as they are: a component that lies across a periodic boundary must be given
// in one piece, or its torque means nothing. One that closes upon itself through it has no torque.
#pragma once

#include "../math/vector3.hpp"
#include "../neighbors/neighborhood.hpp"
#include "../neighbors/parallel_loop.hpp"

#include <cstdint>
#include <vector>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Particles and their components, as arrays of the host's over all particles. `positions` holds
/// `Stride` values a particle, of which the first `Dimension` are coordinates in m.
template <class Real, int Dimension, int Stride = Dimension>
struct ComponentParticles {
    static_assert(Dimension == 2 || Dimension == 3);

    const Real* positions;
    const std::uint32_t*
        components;              ///< label of the component of each, any particle of it; BodyFinder
    const std::uint8_t* at_wall; ///< not 0: the component is not free; nullptr where all are

    [[nodiscard]] Vector3 position(std::size_t i) const {
        return vector_at(positions + i * Stride);
    }
    [[nodiscard]] bool is_free(std::size_t i) const {
        return at_wall == nullptr || at_wall[i] == 0;
    }

    static Vector3 vector_at(const Real* coordinates) {
        return {coordinates[0], coordinates[1], Dimension == 3 ? coordinates[Dimension - 1] : 0};
    }
};

/// A solution b of I b = T.
struct Rotation {
    Vector3 b{};
    double min_pivot = 1; ///< of those divided by, relative to the size of I's terms
};

/// One for a symmetric I (kg m^2, or with the unit of the weights in place of kg) without negative
/// eigenvalues, which is exact to the rounding of terms of size `scale`, and a T in its range. Axes
/// about which nothing has a lever arm (particles in a line or in one place) stay without rotation.
inline Rotation solve_rotation(std::array<Vector3, 3> inertia, double scale, Vector3 torque) {
    constexpr double rounding = 1e-12;
    Rotation rotation;
    bool solved[3] = {false, false, false};
    for (int step = 0; step < 3; ++step) { // largest pivot first
        std::size_t pivot = 3;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (!solved[axis] && (pivot == 3 || inertia[axis][axis] > inertia[pivot][pivot]))
                pivot = axis;
        if (!(inertia[pivot][pivot] > rounding * scale))
            break;
        solved[pivot] = true;
        rotation.min_pivot = inertia[pivot][pivot] / scale;
        for (std::size_t row = 0; row < 3; ++row) {
            if (row == pivot)
                continue;
            const double factor = inertia[row][pivot] / inertia[pivot][pivot];
            inertia[row] = difference(inertia[row], scaled(factor, inertia[pivot]));
            torque[row] -= factor * torque[pivot];
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (solved[axis])
            rotation.b[axis] = torque[axis] / inertia[axis][axis];
    return rotation;
}

/// The sums over one component, about one of its particles, so that a place far from the origin
/// costs no digits; then what balances them.
struct ComponentSums {
    std::uint32_t component = 0;
    Vector3 origin{}; ///< m; all below is relative to it
    double weight = 0;
    Vector3 moment{};                 ///< sum of w x
    std::array<double, 6> products{}; ///< sum of w x x^T: xx, yy, zz, xy, xz, yz
    Vector3 force{};                  ///< N
    Vector3 torque{};                 ///< N m
    Vector3 center{};                 ///< c, from balance() on
    Rotation rotation{};              ///< b

    void add_force(const Vector3& position, const Vector3& its_force) {
        force = sum(force, its_force);
        torque = sum(torque, cross(position, its_force));
    }

    void add_weight(const Vector3& position, double its_weight) {
        const Vector3 weighted = scaled(its_weight, position);
        weight += its_weight;
        moment = sum(moment, weighted);
        for (std::size_t axis = 0; axis < 3; ++axis)
            products[axis] += weighted[axis] * position[axis];
        products[3] += weighted[0] * position[1];
        products[4] += weighted[0] * position[2];
        products[5] += weighted[1] * position[2];
    }

    /// Sets center and rotation from the sums.
    void balance() {
        if (weight == 0)
            return;
        center = scaled(1 / weight, moment);
        const auto [xx, yy, zz, xy, xz, yz] = central_products();
        const double scale = 2 * (products[0] + products[1] + products[2]); // the trace about x = 0
        rotation = solve_rotation({{{yy + zz, -xy, -xz}, {-xy, xx + zz, -yz}, {-xz, -yz, xx + yy}}},
                                  scale, difference(torque, cross(center, force)));
    }

    /// True for a component so thin, below a few hundredths of its length, that rounding shows in
    /// the rotation about its axis.
    [[nodiscard]] bool is_needle() const { return rotation.min_pivot < 1e-3; }

    /// w (a + b x (x - c)) for a particle at x of weight w.
    [[nodiscard]] Vector3 correction(const Vector3& position, double its_weight) const {
        return sum(scaled(its_weight / weight, force), // all of it where there is one particle
                   scaled(its_weight, cross(rotation.b, difference(position, center))));
    }

private:
    [[nodiscard]] std::array<double, 6> central_products() const {
        return {products[0] - moment[0] * center[0], products[1] - moment[1] * center[1],
                products[2] - moment[2] * center[2], products[3] - moment[0] * center[1],
                products[4] - moment[0] * center[2], products[5] - moment[1] * center[2]};
    }
};

/// The particles that carry forces: one entry each, in the order of `particles`.
template <class Real>
struct ComponentForces {
    const std::uint32_t* particles; ///< each listed once; the others count as without force
    std::size_t size;
    const Real* weights; ///< in any unit; forces change where positive and finite
    Real* forces;        ///< N, one after another with Dimension values each

    [[nodiscard]] bool may_change(std::size_t n) const {
        return is_positive_and_finite(weights[n]);
    }
};

/// Takes net force and torque out of free components, with memory of its own: one for each
/// concurrent caller.
class MomentumBalance {
public:
    /// Makes room; calls with no more particles (the largest label + 1) and components among those
    /// listed allocate nothing. Throws std::bad_alloc.
    void reserve(std::size_t particles, std::size_t components) {
        if (particles > places.size())
            places.resize(particles, none);
        sums.reserve(components);
    }

    /// Changes listed.forces. Particles without weight keep theirs, but it counts. Net force and
    /// torque fall to the rounding of Real; only a component thinner than about 1e-6 of its length,
    /// which counts as a line, may keep a torque about it.
    template <class Real, int Dimension, int Stride, class Loop>
    void remove_net_force(const ComponentParticles<Real, Dimension, Stride>& particles,
                          const ComponentForces<Real>& listed, const Loop& loop) {
        constexpr int max_passes = 3;
        bool again = true;
        for (int pass = 0; again && pass < max_passes; ++pass)
            again = correct_all(particles, listed, loop);
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::vector<std::uint32_t> places; ///< of each label, where its sums are
    std::vector<ComponentSums> sums;

    template <class Real, int Dimension, int Stride>
    ComponentSums& sums_of(const ComponentParticles<Real, Dimension, Stride>& particles,
                           std::uint32_t i) {
        const std::uint32_t component = particles.components[i];
        if (component >= places.size())
            places.resize(std::size_t{component} + 1, none);
        if (places[component] == none) {
            places[component] = static_cast<std::uint32_t>(sums.size());
            sums.emplace_back();
            sums.back().component = component;
            sums.back().origin = particles.position(i);
        }
        return sums[places[component]];
    }

    /// Returns true where a second time would leave notably less.
    template <class Real, int Dimension, int Stride, class Loop>
    bool correct_all(const ComponentParticles<Real, Dimension, Stride>& particles,
                     const ComponentForces<Real>& listed, const Loop& loop) {
        add_up(particles, listed);
        bool needles = false;
        for (ComponentSums& component : sums) {
            component.balance();
            needles |= component.is_needle();
        }
        loop(listed.size, [&](std::size_t begin, std::size_t end, int /*worker*/) {
            for (std::size_t n = begin; n < end; ++n)
                if (particles.is_free(listed.particles[n]) && listed.may_change(n))
                    correct(particles, listed, n);
        });
        for (const ComponentSums& component : sums)
            places[component.component] = none;
        sums.clear();
        return needles;
    }

    /// In the order of the list and on one thread: it costs less than to divide it and add up parts
    /// in an order that does not depend on the threads.
    template <class Real, int Dimension, int Stride>
    void add_up(const ComponentParticles<Real, Dimension, Stride>& particles,
                const ComponentForces<Real>& listed) {
        for (std::size_t n = 0; n < listed.size; ++n) {
            const std::uint32_t i = listed.particles[n];
            if (!particles.is_free(i))
                continue;
            ComponentSums& component = sums_of(particles, i);
            const Vector3 position = difference(particles.position(i), component.origin);
            component.add_force(position, particles.vector_at(listed.forces + n * Dimension));
            if (listed.may_change(n))
                component.add_weight(position, listed.weights[n]);
        }
    }

    template <class Real, int Dimension, int Stride>
    void correct(const ComponentParticles<Real, Dimension, Stride>& particles,
                 const ComponentForces<Real>& listed, std::size_t n) const {
        const std::uint32_t i = listed.particles[n];
        const ComponentSums& component = sums[places[particles.components[i]]];
        const Vector3 position = difference(particles.position(i), component.origin);
        const Vector3 change = component.correction(position, listed.weights[n]);
        Real* force = listed.forces + n * Dimension;
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            force[axis] = static_cast<Real>(force[axis] - change[axis]);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
