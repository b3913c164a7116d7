// Shells of one, two and three layers of particles, and balls. A film has two surfaces, so that
// what cuts it in half must hold 2 pi (R + r) sigma, R and r being its outer and inner radius: 4
// sigma / R, not 2 sigma / R, is the pressure in a soap bubble. A ball has 2 pi R sigma.
#include "framework/measures.hpp"
#include "framework/run_tables.hpp"
#include "studies.hpp"

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/runtime/math/angles.hpp>
#include <meniscus/runtime/neighbors/parallel_loop.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <cmath>

namespace meniscus {
namespace {

/// Layers one spacing (1 m) apart, the outermost half a spacing inside of R, each with a particle
/// to a square spacing, spread along a spiral; layers are turned against each other.
Positions shell(double outer_radius, int layers) {
    const double golden_angle = pi * (3 - std::sqrt(5.0));
    Positions positions;
    for (int layer = 0; layer < layers && layer + 0.5 < outer_radius; ++layer) {
        const double radius = outer_radius - layer - 0.5;
        const auto count = static_cast<int>(std::lround(4 * pi * radius * radius));
        for (int n = 0; n < count; ++n) {
            const double z = 1 - (2 * n + 1.0) / count;
            const double width = std::sqrt(1 - z * z);
            const double angle = n * golden_angle + layer;
            positions.push_back(
                {radius * width * std::cos(angle), radius * width * std::sin(angle), radius * z});
        }
    }
    return positions;
}

/// Mean over the halves along the axes of their force along the axis, inward.
double force_on_half(const Positions& positions, const SurfaceParticles<double, 3>& surface) {
    double sum_of_halves = 0;
    for (std::size_t slot = 0; slot < surface.size(); ++slot)
        for (int axis = 0; axis < 3; ++axis)
            sum_of_halves -=
                surface.force[slot][axis] * (positions[surface.particle[slot]][axis] < 0 ? -1 : 1);
    return sum_of_halves / 6;
}

Json measure(const StudyRun& run, const Workplace& /*place*/) {
    const double outer = run.numbers.at("radius");
    const double layers = run.numbers.at("layers");
    const double ratio = 2;
    const Positions positions = shell(outer, static_cast<int>(layers));
    const NeighborLists lists = find_neighbors(positions, ratio);
    SurfaceTensionOptions options;
    options.surface_tension = 1;
    options.spacing_ratio = ratio;
    options.coverage = CoverageMethod::exact;
    SurfaceTension<double, 3> tension(options);
    const CsrNeighborhood<double, 3> view{positions[0].data(), nullptr, lists.offsets.data(),
                                          lists.neighbors.data()};
    tension.step(view, positions.size(), UniformRadius<double>{ratio}, SerialLoop{});
    const double inner = layers < outer ? outer - layers : 0;
    Json figures;
    figures["particles"] = positions.size();
    figures["surface, %"] =
        100 * static_cast<double>(tension.surface().size()) / static_cast<double>(positions.size());
    figures["force over 2 pi (R + r) sigma"] =
        force_on_half(positions, tension.surface()) / (2 * pi * (outer + inner));
    return figures;
}

std::vector<Table> tables(const Json& result, const Json& /*reference*/) {
    return {table_of_runs("thin_shells", result, "R, spacings | layers",
                          "particles {:.0f} | surface, % {:.1f} | force over 2 pi (R + r) sigma "
                          "{:.3f}")};
}

} // namespace

Study thin_shells_study() {
    return {"thin_shells", "films of few layers beside the force that two surfaces have", measure,
            tables};
}

} // namespace meniscus
