// The project's own surface tension in the step: runtime/ over the step's neighbor lists. The
// classifier's features come from the same lists, eight neighbors at a time.
#pragma once

#include "tension_model.hpp"

#include <meniscus/runtime/coefficients/surface_2d_wide.hpp>
#include <meniscus/runtime/coefficients/surface_3d_wide.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The step's lists as a view of the runtime. Places are rows of four.
template <class Real, int Dimension>
struct LaneListView {
    const Row<Real>* rows;    ///< those in the lists
    const Row<Real>* centers; ///< those that have lists
    const LaneLists* lists;

    template <class Visit>
    MENISCUS_INLINE void operator()(std::size_t i, Visit&& visit) const {
        const Row<Real> center = centers[i];
        const std::uint32_t* const list = lists->begin[i];
        for (std::uint32_t n = 0; n < lists->count[i]; ++n) {
            const Row<Real>& other = rows[list[n]];
            std::array<Real, Dimension> displacement;
            displacement[0] = other.x - center.x;
            displacement[1] = other.y - center.y;
            if constexpr (Dimension == 3)
                displacement[Dimension - 1] = other.z - center.z;
            visit(list[n], displacement, Real(1));
        }
    }
};

/// The line that ships for the dimension and the support radius: those trained on h = 2 spacings
/// miss particles at 2.5, those trained there let most of a fluid with h = 2 spacings through.
template <int Dimension>
SurfaceLine<double> line_for_spacing(double spacing) {
    constexpr double widest = 1 / 2.25;
    if (spacing > widest)
        return shipped_surface_line(Dimension);
    return Dimension == 3 ? surface_line<Surface3DWide, double>()
                          : surface_line<Surface2DWide, double>();
}

/// The options of the runtime that a scene asks for; sigma in the units of a step.
template <int Dimension>
SurfaceTensionOptions tension_settings(const TensionOptions& options, const StepUnits& units,
                                       double spacing) {
    SurfaceTensionOptions settings = options.surface;
    if (takes_shipped_line(settings))
        set_line(settings, line_for_spacing<Dimension>(spacing));
    const double h = units.support_radius;
    settings.surface_tension = options.coefficient / (units.rest_density * h * h * h);
    settings.spacing_ratio = 1 / spacing;
    return settings;
}

/// Candidates by the classifier's line, from the step's lists.
template <class Real, int Dimension>
void find_candidates_in_lanes(const Fluid<Real, Dimension>& fluid, const SurfaceLine<Real>& line,
                              double radius_ratio, std::vector<std::uint8_t>& candidate) {
    const auto range = neighbor_range<Real>(1, radius_ratio);
    candidate.resize(fluid.count);
    fluid.loop.each(fluid.count, [&](std::size_t i) {
        VectorSum<Real, Dimension> moment;
        Lanes<Real> count{};
        const Lanes<Real> zero{};
        visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
            const Lanes<Real> near =
                lanes.distance_squared < range.outer_squared ? zero + Real(1) : zero;
            const Lanes<Real> counts = lanes.distance_squared > range.inner_squared ? near : zero;
            count += counts;
            moment.add(counts, lanes.step);
        });
        const Row<Real> total = moment.total();
        FeatureSum<Real, Dimension> sum;
        sum.count = static_cast<int>(sum_of_lanes(count));
        sum.moment[0] = total.x;
        sum.moment[1] = total.y;
        if constexpr (Dimension == 3)
            sum.moment[Dimension - 1] = total.z;
        candidate[i] = is_surface(sum, line, Real(1)) ? 1 : 0;
    });
}

template <class Real, int Dimension>
class MonteCarloTension : public SurfaceTensionModel<Real, Dimension> {
public:
    using FluidType = Fluid<Real, Dimension>;

    static TensionModelRow row() {
        return {"meniscus", meniscus_option_keys(), read_meniscus_options, true, true};
    }

    /// `spacing`: of the particles at rest, in support radii.
    MonteCarloTension(const TensionOptions& model_options, const StepUnits& units, double spacing)
        : MonteCarloTension(model_options,
                            tension_settings<Dimension>(model_options, units, spacing)) {}

    /// With the runtime's options as they are; of the model's, balance_momentum alone counts.
    MonteCarloTension(const TensionOptions& model_options, const SurfaceTensionOptions& settings)
        : SurfaceTensionModel<Real, Dimension>(model_options, {}, 1 / settings.spacing_ratio),
          tension(settings) {}

    void add_accelerations(FluidType& fluid) override {
        find_surface_forces(fluid);
        const auto& surface = tension.surface();
        const Real inverse_mass = 1 / fluid.mass;
        fluid.loop.each(surface.size(), [&](std::size_t slot) {
            const auto& force = surface.force[slot];
            Row<Real> row{force[0], force[1], Dimension == 3 ? force[Dimension - 1] : Real(0), 0};
            Row<Real>& sum = fluid.acceleration[surface.particle[slot]];
            sum = plus(sum, inverse_mass, row);
        });
    }

    [[nodiscard]] SurfaceResults results(const FluidType& fluid) const override {
        const auto& surface = tension.surface();
        const double h = fluid.units.support_radius;
        SurfaceResults found;
        found.surface_class.assign(fluid.count, 0);
        found.curvature.assign(fluid.count, 0);
        found.normal.assign(fluid.count, Place{});
        for (std::size_t slot = 0; slot < surface.size(); ++slot) {
            const std::size_t i = surface.particle[slot];
            found.surface_class[i] = static_cast<std::uint8_t>(surface.surface_class[slot]);
            found.curvature[i] = static_cast<double>(surface.curvature[slot]) / h;
            for (int axis = 0; axis < Dimension; ++axis)
                found.normal[i][axis] = static_cast<double>(surface.normal[slot][axis]);
            found.area += static_cast<double>(surface_force::sheet_area(surface, slot));
        }
        found.area *= Dimension == 3 ? h * h : h;
        return found;
    }

    [[nodiscard]] std::size_t surface_particles() const override {
        const auto& classes = tension.surface().surface_class;
        return static_cast<std::size_t>(
            std::count(classes.begin(), classes.end(), SurfaceClass::surface));
    }

private:
    SurfaceTension<Real, Dimension> tension;
    std::vector<std::uint8_t> candidate;

    void find_surface_forces(FluidType& fluid) {
        const auto& settings = tension.options();
        find_candidates_in_lanes(
            fluid, SurfaceLine<Real>{static_cast<Real>(settings.k), static_cast<Real>(settings.d)},
            settings.radius_ratio, candidate);
        const LaneListView<Real, Dimension> view{fluid.place.data(), fluid.place.data(),
                                                 &fluid.neighbors};
        if (fluid.wall_place.size() > 1) {
            const LaneListView<Real, Dimension> walls{fluid.wall_place.data(), fluid.place.data(),
                                                      &fluid.wall_neighbors};
            find_forces(fluid, view, BoundaryView<LaneListView<Real, Dimension>>{walls});
        } else {
            find_forces(fluid, view, NoBoundary{});
        }
    }

    template <class View, class Boundary>
    void find_forces(FluidType& fluid, const View& view, const Boundary& boundary) {
        const UniformRadius<Real> radius{1};
        tension.step(view, boundary, fluid.count, radius, fluid.id.data(), candidate.data(),
                     fluid.neighbors.count.data(), fluid.loop.loop);
        if (this->options.balance_momentum)
            tension.template balance_momentum<4>(view, boundary, radius, &fluid.place[0].x,
                                                 fluid.loop.loop);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
