// The options of the runtime as plain data.
#include "surface_step.hpp"

#include <meniscus/runtime/surface_tension.hpp>

#include <limits>

namespace meniscus {
namespace {

meniscus_options plain(const SurfaceTensionOptions& from) {
    meniscus_options to{};
    to.size = sizeof to;
    to.k = to.d = std::numeric_limits<double>::quiet_NaN(); // known with the dimension only
    to.radius_ratio = from.exposure.radius_ratio;
    to.samples = from.samples;
    to.seed = from.seed;
    to.fade = from.exposure.fade;
    to.tau = from.tau;
    to.covariance_share = from.covariance_share;
    to.surface_tension = from.force.surface_tension;
    to.spacing_ratio = from.force.spacing_ratio;
    to.coverage = from.exposure.method == CoverageMethod::exact ? MENISCUS_EXACT : MENISCUS_SAMPLED;
    to.verification =
        from.exposure.verification == Verification::drop ? MENISCUS_DROP : MENISCUS_VERIFY;
    to.curvature = from.curvature == CurvatureForm::closed ? MENISCUS_CLOSED_CURVATURE
                                                           : MENISCUS_MAPPED_CURVATURE;
    to.force =
        from.force.form == ForceForm::paper ? MENISCUS_PAPER_FORCE : MENISCUS_CALIBRATED_FORCE;
    to.normal_passes = from.normal_passes;
    to.curvature_passes = from.curvature_passes;
    return to;
}

} // namespace

meniscus_options default_options() {
    return plain({});
}

meniscus_options options_of_paper() {
    return plain(paper_options());
}

} // namespace meniscus
