// Surface tension in an SPH step, whole: which particles are surface, their normals and curvatures,
// and the force on each (2020 paper, sections 3.1 to 3.4). One call a step over the host's own
// neighbor lists; the stages stand in headers of their own, for hosts that want only some.
//
//     meniscus::SurfaceTension<float, 3> tension(options);      // once
//     tension.step(view, particles, radii, loop);               // each step
//     for (std::size_t k = 0; k < tension.surface().size(); ++k)
//         ... surface().particle[k], surface().force[k] ...
//
// It keeps working memory from step to step and allocates nothing once that has grown, or after
// reserve(). Results do not depend on the loop.
#pragma once

#include "surface_coefficients.hpp"
#include "surface_force.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// How curvature is found.
enum class CurvatureForm { closed, mapped };

/// What a scene needs. The defaults are the project's own choices; `paper_options` gives the
/// paper's.
struct SurfaceTensionOptions {
    double k = SurfaceCoefficients::k; ///< line of the classifier, y <= k x + d
    double d = SurfaceCoefficients::d;
    std::size_t samples = 128; ///< a particle (samples_for_time_step), for sampled coverage
    std::uint64_t seed = 0;    ///< of the directions
    ExposureOptions exposure;
    double tau = 0.5; ///< share of the neighbors in smoothing (eq. 6)
    int normal_passes = 1;
    double covariance_share = 0; ///< of normals from positions (eq. 7), 0 to 1
    CurvatureForm curvature = CurvatureForm::mapped;
    CurvatureMap map{};       ///< where it is mapped
    int curvature_passes = 0; ///< smoothing of the curvature
    ForceOptions force;
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
