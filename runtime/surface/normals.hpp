// Normals of the surface particles. The uncovered part of a particle's sphere points out of the
// fluid: its first moment, normalized, is the normal (2020 paper, eq. 3), which find_exposure
// leaves in the list. Here they are made smoother: each is blended with the weighted sum of its
// neighbors' (eqs. 4 to 6), any number of times. Or taken from the positions alone: the direction
// in which the surface particles around spread least, the minor eigenvector of their covariance
// (eq. 7), which has no side of its own and takes that of the sampled normal.
#pragma once

#include "../math/coordinates.hpp"
#include "../math/cubic_spline.hpp"
#include "surface_particles.hpp"
#include "wall_images.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

template <class Real, int Dimension>
MENISCUS_INLINE Real product(const Coordinates<Real, Dimension>& a,
                             const Coordinates<Real, Dimension>& b) {
    Real sum = 0;
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        sum += a[axis] * b[axis];
    return sum;
}

/// The vector divided by its length; zero where that is too small to have a direction.
template <class Real, int Dimension>
MENISCUS_INLINE Coordinates<Real, Dimension>
normalized(const Coordinates<Real, Dimension>& vector) {
    const Real length = std::sqrt(product<Real, Dimension>(vector, vector));
    const Real scale = length > static_cast<Real>(min_exposure) ? 1 / length : 0;
    Coordinates<Real, Dimension> unit;
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        unit[axis] = vector[axis] * scale;
    return unit;
}

/// One smoothing pass (eqs. 4 to 6): (1 - tau) n_i + tau sum_j W n_j, normalized; `tau` in [0, 1].
/// Normals that are zero stay so. `before` is working memory.
template <class Real, int Dimension, class Loop>
void smooth_normals(double tau, const Loop& loop, SurfaceParticles<Real, Dimension>& list,
                    std::vector<Coordinates<Real, Dimension>>& before) {
    before.resize(list.size());
    before.swap(list.normal);
    const auto share = static_cast<Real>(tau);
    loop(list.size(), [&](std::size_t begin, std::size_t end, int /*worker*/) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            Coordinates<Real, Dimension> sum = {};
            const auto* pair = list.pairs.data() + list.pairs_begin[slot];
            for (const auto* last = pair + list.pairs_count[slot]; pair != last; ++pair)
                for (std::size_t axis = 0; axis < Dimension; ++axis)
                    sum[axis] += pair->weight * before[pair->slot][axis];
            if (list.contact[slot].is_there())
                visit_wall_images(list, slot, before, [&](const auto& image) {
                    for (std::size_t axis = 0; axis < Dimension; ++axis)
                        sum[axis] += image.weight * image.normal[axis];
                });
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                sum[axis] = (1 - share) * before[slot][axis] + share * sum[axis];
            const bool has_normal = list.exposure[slot] > static_cast<Real>(min_exposure);
            list.normal[slot] = has_normal ? normalized<Real, Dimension>(sum) : before[slot];
        }
    });
}

namespace normals {

/// The unit eigenvector of the smallest eigenvalue of a symmetric matrix, by Jacobi rotations.
template <int Dimension>
Vector3 minor_eigenvector(Coordinates<Coordinates<double, Dimension>, Dimension> matrix) {
    std::array<Vector3, 3> vectors = {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
    for (int sweep = 0; sweep < 8; ++sweep)
        for (std::size_t a = 0; a < Dimension; ++a)
            for (std::size_t b = a + 1; b < Dimension; ++b) {
                if (matrix[a][b] == 0)
                    continue;
                const double half = (matrix[b][b] - matrix[a][a]) / (2 * matrix[a][b]);
                const double tangent =
                    std::copysign(1, half) / (std::fabs(half) + std::sqrt(half * half + 1));
                const double cosine = 1 / std::sqrt(tangent * tangent + 1);
                const double sine = tangent * cosine;
                for (std::size_t k = 0; k < Dimension; ++k) {
                    const double of_a = matrix[k][a];
                    matrix[k][a] = cosine * of_a - sine * matrix[k][b];
                    matrix[k][b] = sine * of_a + cosine * matrix[k][b];
                }
                for (std::size_t k = 0; k < Dimension; ++k) {
                    const double of_a = matrix[a][k];
                    matrix[a][k] = cosine * of_a - sine * matrix[b][k];
                    matrix[b][k] = sine * of_a + cosine * matrix[b][k];
                }
                const Vector3 of_a = vectors[a];
                vectors[a] = difference(scaled(cosine, of_a), scaled(sine, vectors[b]));
                vectors[b] = sum(scaled(sine, of_a), scaled(cosine, vectors[b]));
            }
    std::size_t min = 0;
    for (std::size_t a = 1; a < Dimension; ++a)
        if (matrix[a][a] < matrix[min][min])
            min = a;
    return vectors[min];
}

/// How many surface particles are around the one in a slot.
template <class Real, int Dimension>
int surface_neighbors(const SurfaceParticles<Real, Dimension>& list, std::size_t slot) {
    const auto* pair = list.pairs.data() + list.pairs_begin[slot];
    int count = 0;
    for (const auto* last = pair + list.pairs_count[slot]; pair != last; ++pair)
        count += list.weight[pair->slot] > 0 ? 1 : 0;
    return count;
}

/// The direction in which the surface particles around a slot, itself included, spread least: minor
/// eigenvector of their weighted covariance (eq. 7). Each counts by its own weight, since pinholes
/// below the outermost layer do not lie on the surface.
template <class Real, int Dimension>
Vector3 flattest_direction(const SurfaceParticles<Real, Dimension>& list, std::size_t slot) {
    using Step = Coordinates<double, Dimension>;
    const auto* first = list.pairs.data() + list.pairs_begin[slot];
    const auto* last = first + list.pairs_count[slot];
    const auto for_each = [&](const auto& visit) {
        visit(Step{}, static_cast<double>(list.weight[slot]));
        for (const auto* pair = first; pair != last; ++pair) {
            Step step;
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                step[axis] = static_cast<double>(pair->step[axis]);
            visit(step, static_cast<double>(list.weight[pair->slot]));
        }
    };
    Step center = {};
    double weights = 0;
    for_each([&](const Step& step, double weight) {
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            center[axis] += weight * step[axis];
        weights += weight;
    });
    Coordinates<Step, Dimension> covariance = {};
    for_each([&](const Step& step, double weight) {
        Step v;
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            v[axis] = step[axis] - center[axis] / weights;
        const double share = weight * cubic_spline(std::sqrt(product<double, Dimension>(v, v)));
        for (std::size_t a = 0; a < Dimension; ++a)
            for (std::size_t b = 0; b < Dimension; ++b)
                covariance[a][b] += share * v[a] * v[b];
    });
    return minor_eigenvector<Dimension>(covariance);
}

} // namespace normals

/// Mixes normals from the positions of the surface particles (eq. 7) into the sampled ones:
/// (1 - share) of these, `share` in [0, 1]. A particle with fewer surface particles around than
/// there are dimensions keeps its own. Apply before smoothing.
template <class Real, int Dimension, class Loop>
void mix_in_covariance_normals(double share, const Loop& loop,
                               SurfaceParticles<Real, Dimension>& list) {
    loop(list.size(), [&](std::size_t begin, std::size_t end, int /*worker*/) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            if (!(list.exposure[slot] > static_cast<Real>(min_exposure)) ||
                normals::surface_neighbors(list, slot) < Dimension)
                continue;
            const Vector3 flattest = normals::flattest_direction(list, slot);
            auto& normal = list.normal[slot];
            double side = 0;
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                side += flattest[axis] * static_cast<double>(normal[axis]);
            const double part = std::copysign(share, side);
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                normal[axis] = static_cast<Real>((1 - share) * static_cast<double>(normal[axis]) +
                                                 part * flattest[axis]);
            normal = normalized<Real, Dimension>(normal);
        }
    });
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
