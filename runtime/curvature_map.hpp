// Mean curvature from how normals turn along the surface, calibrated. Two surface particles a step
// u apart have normals that differ by the curvature times u, so the ratio
//     sum_j w_j W (n_j - n_i) . u_j / sum_j w_j W |u_j|^2
// is the mean of the normal curvatures around particle i, which is the mean curvature (Euler's
// theorem). Its scatter is a tenth of that of the closed form from lambda (eqs. 14 and 17), because
// normals see whole neighborhoods and the steps between particles are known. What it measures is
// the sheet through the outermost particles, half a spacing inside; a map that is trained on clouds
// of known curvature (`meniscus calibrate`) takes that to the surface of the fluid, and corrects
// what else is left. Coefficients come as a header, like those of the line.
#pragma once

#include "curvature.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// A polynomial in the turning of normals t and the closed form's curvature q, both averaged over
/// the surface particles around: h kappa = sum of coefficients times 1, t, t^2, t^3, q, t q.
struct CurvatureMap {
    static constexpr int terms = 6;
    int dimension;
    double coefficients[terms];
    double least; ///< of t in training; beyond it goes on along the tangent
    double largest;
};

/// The map of an exported coefficient struct (curvature_coefficients.hpp is one).
template <class Coefficients>
CurvatureMap curvature_map() {
    CurvatureMap map{};
    map.dimension = Coefficients::dimension;
    for (int term = 0; term < CurvatureMap::terms; ++term)
        map.coefficients[term] = Coefficients::coefficients[term];
    map.least = Coefficients::least;
    map.largest = Coefficients::largest;
    return map;
}

/// h kappa from the two; within the range of training a polynomial, beyond it straight on.
inline double curvature_of(const CurvatureMap& map, double turning, double closed_form) {
    const double t = smaller(larger(turning, map.least), map.largest);
    const auto& [constant, first, second, third, of_closed, of_product] = map.coefficients;
    const double slope = first + t * (2 * second + t * 3 * third) + of_product * closed_form;
    return constant + t * (first + t * (second + t * third)) +
           closed_form * (of_closed + of_product * t) + slope * (turning - t);
}

/// Sets the turning of the normals at each surface particle, in 1/m: 0 where no other is around.
template <class Real, int Dimension, class Radii, class Loop>
void find_turning(const Radii& radii, const Loop& loop, SurfaceParticles<Real, Dimension>& list) {
    loop(list.size(), [&](std::size_t begin, std::size_t end, int /*worker*/) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            Real along = 0;
            Real squares = 0;
            const auto& normal = list.normal[slot];
            const auto* pair = list.pairs.data() + list.pairs_begin[slot];
            for (const auto* last = pair + list.pairs_count[slot]; pair != last; ++pair) {
                const Real weight = list.weight[pair->slot] * pair->weight;
                const auto& other = list.normal[pair->slot];
                Real turn = 0;
                Real square = 0;
                for (int axis = 0; axis < Dimension; ++axis) {
                    turn += (other[axis] - normal[axis]) * pair->step[axis];
                    square += pair->step[axis] * pair->step[axis];
                }
                along += weight * turn;
                squares += weight * square;
            }
            list.turning[slot] =
                squares > 0 ? along / (squares * radii.of(list.particle[slot])) : 0;
        }
    });
}

/// Sets the curvature of each surface particle by the map; 0 where covered. After find_turning.
template <class Real, int Dimension, class Radii, class Loop>
void find_mapped_curvature(const CurvatureMap& map, double radius_ratio, const Radii& radii,
                           const Loop& loop, SurfaceParticles<Real, Dimension>& list,
                           std::vector<Real>& closed_form) {
    find_curvature<Real, Dimension>(radius_ratio, radii, loop, list);
    closed_form.resize(list.size());
    closed_form.swap(list.curvature);
    loop(list.size(), [&](std::size_t begin, std::size_t end, int /*worker*/) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            Real weights = list.weight[slot];
            Real turning = weights * list.turning[slot];
            Real closed = weights * closed_form[slot];
            const auto* pair = list.pairs.data() + list.pairs_begin[slot];
            for (const auto* last = pair + list.pairs_count[slot]; pair != last; ++pair) {
                const Real weight = list.weight[pair->slot] * pair->weight;
                turning += weight * list.turning[pair->slot];
                closed += weight * closed_form[pair->slot];
                weights += weight;
            }
            const bool is_surface =
                weights > 0 && list.surface_class[slot] == SurfaceClass::surface;
            const Real to_own = radii.of(list.particle[slot]) / (is_surface ? weights : 1);
            const double curvature = curvature_of(map, static_cast<double>(turning * to_own),
                                                  static_cast<double>(closed * to_own));
            list.curvature[slot] =
                is_surface ? static_cast<Real>(curvature) / radii.of(list.particle[slot]) : 0;
        }
    });
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
