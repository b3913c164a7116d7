// Marrone et al. 2010, Fast free-surface detection and level-set function definition in SPH
// solvers: first the smallest eigenvalue of the renormalization matrix, which tells particles
// inside from those near the surface, then for the latter a look along the normal: a particle is at
// the surface where none lies in the umbrella in front of it, a cone of 45 degrees that ends in a
// ball.
//
// Where the paper leaves room:
//  - Its lengths are in smoothing lengths. Here one is half the support radius (cones.hpp).
//  - In the plane the paper writes the cone by the distances along the normal and across; within
//    sqrt(2) smoothing lengths both say the same, so one formula serves for both dimensions.
//  - The normal is the renormalized gradient of the eigenvalue, which falls towards the surface. A
//    second detector takes that of the constant 1, as DualSPHysics does, which spares a pass.
//  - The normal may vanish (a film of one layer). The particle is then surface: it cannot be shown
//    to be covered.
#include "cones.hpp"
#include "detector.hpp"

#include <meniscus/runtime/neighbors/parallel_loop.hpp>

#include <memory>

namespace meniscus {
namespace {

/// Particles with a smallest eigenvalue up to the first are surface, from the second on interior.
constexpr double certain_surface = 0.20;
constexpr double certain_interior = 0.75;

/// Whether all eigenvalues of a symmetric matrix are above a limit: by the signs of the leading
/// minors of the matrix less the limit (Sylvester), which costs no root and no angle.
template <class Real>
bool all_eigenvalues_above(Real limit, const SquareMatrix<Real, 2>& m) {
    const Real a = m(0, 0) - limit;
    const Real b = m(1, 1) - limit;
    return a > 0 && a * b > m(0, 1) * m(0, 1);
}

template <class Real>
bool all_eigenvalues_above(Real limit, const SquareMatrix<Real, 3>& m) {
    const Real a = m(0, 0) - limit;
    const Real b = m(1, 1) - limit;
    const Real c = m(2, 2) - limit;
    const Real minor = a * b - m(0, 1) * m(0, 1);
    const Real determinant = c * minor + m(0, 2) * (m(0, 1) * m(1, 2) - b * m(0, 2)) -
                             m(1, 2) * (a * m(1, 2) - m(0, 1) * m(0, 2));
    return a > 0 && minor > 0 && determinant > 0;
}

template <class Real, int Dimension>
Detection detect_by_eigenvalue(const FluidState<Real>& state, int threads) {
    return [&state, threads](std::vector<std::uint8_t>& surface) {
        const OpenMpLoop loop{threads};
        surface.resize(state.size());
        const GradientSums<Real, Dimension> sums{state};
        loop(state.size(), [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto matrix = renormalization_matrix(sums, i);
                surface[i] = static_cast<std::uint8_t>(
                    !all_eigenvalues_above(static_cast<Real>(certain_interior), matrix));
            }
        });
    };
}

/// Both steps in one pass, with the normal from the gradient of the constant 1.
template <class Real, int Dimension>
Detection detect_by_umbrella(const FluidState<Real>& state, int threads) {
    return [&state, threads](std::vector<std::uint8_t>& surface) {
        const OpenMpLoop loop{threads};
        surface.resize(state.size());
        const GradientSums<Real, Dimension> sums{state};
        const auto is_surface = [&](std::size_t i) {
            const auto around = renormalization(
                sums, i, [](const auto&) { return all_lanes<Pack<Real>>(Real(1)); });
            if (all_eigenvalues_above(static_cast<Real>(certain_interior), around.matrix))
                return false;
            if (!all_eigenvalues_above(static_cast<Real>(certain_surface), around.matrix))
                return true;
            return !is_covered<Real, Dimension>(
                state, i, around.matrix.inverse() * -around.gradient, umbrella(state));
        };
        loop(state.size(), [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t i = begin; i < end; ++i)
                surface[i] = static_cast<std::uint8_t>(is_surface(i));
        });
    };
}

/// Two passes: the eigenvalues of all, then the normals and the umbrellas of those in between.
template <class Real, int Dimension>
Detection detect_by_eigenvalue_gradient(const FluidState<Real>& state, int threads) {
    auto eigenvalues = std::make_shared<std::vector<Real>>();
    return [&state, threads, eigenvalues](std::vector<std::uint8_t>& surface) {
        const OpenMpLoop loop{threads};
        surface.resize(state.size());
        eigenvalues->resize(state.size());
        const GradientSums<Real, Dimension> sums{state};
        Real* lambda = eigenvalues->data();
        loop(state.size(), [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t i = begin; i < end; ++i)
                lambda[i] = min_eigenvalue<Real, Dimension>(renormalization_matrix(sums, i));
        });
        const auto is_surface = [&](std::size_t i) {
            if (lambda[i] >= static_cast<Real>(certain_interior))
                return false;
            if (lambda[i] <= static_cast<Real>(certain_surface))
                return true;
            const auto around = renormalization(sums, i, [&](const auto& pairs) {
                return gather<Pack<Real>>(lambda, pairs.index) - lambda[i];
            });
            return !is_covered<Real, Dimension>(
                state, i, around.matrix.inverse() * -around.gradient, umbrella(state));
        };
        loop(state.size(), [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t i = begin; i < end; ++i)
                surface[i] = static_cast<std::uint8_t>(is_surface(i));
        });
    };
}

template <class Real, int Dimension>
void add(std::vector<Detector<Real>>& all) {
    const std::string paper = "Marrone et al. 2010";
    all.push_back({"eigenvalue below 0.75", "eigenvalue", paper + ", first step",
                   detect_by_eigenvalue<Real, Dimension>});
    all.push_back({"eigenvalue, then cone along its gradient", "eigenvalue", paper,
                   detect_by_eigenvalue_gradient<Real, Dimension>});
    all.push_back({"eigenvalue, then cone along the kernel's gradient", "eigenvalue",
                   paper + ", normal as in DualSPHysics", detect_by_umbrella<Real, Dimension>});
}

} // namespace

template <class Real>
void add_eigenvalue_detectors(int dimension, std::vector<Detector<Real>>& all) {
    if (dimension == 2)
        add<Real, 2>(all);
    else
        add<Real, 3>(all);
}

template void add_eigenvalue_detectors(int, std::vector<Detector<float>>&);
template void add_eigenvalue_detectors(int, std::vector<Detector<double>>&);

} // namespace meniscus
