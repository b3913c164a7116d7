// The project's own surface tension in the step: runtime/ over the step's neighbor lists. The
// classifier's features come from the same lists, eight neighbors at a time.
#pragma once

#include "ripples.hpp"
#include "tension_model.hpp"

#include <meniscus/runtime/surface/surface_tension.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// What makes of psi_b, the w of a wall particle's place, its V_b / V_0.
template <class Real, int Dimension>
Real over_wall_volume(const Fluid<Real, Dimension>& fluid) {
    return 1 / (fluid.wall_volume_share * fluid.mass);
}

/// The step's lists as a view of the runtime. Places are rows of four. All of the fluid have the
/// same mass; wall particles weigh V_b / V_0.
template <class Real, int Dimension, bool Fluids>
struct LaneListView {
    const Row<Real>* rows;    ///< those in the lists
    const Row<Real>* centers; ///< those that have lists
    const LaneLists* lists;
    Real wall_weight; ///< over_wall_volume()

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
            visit(list[n], displacement, Fluids ? Real(1) : other.w * wall_weight);
        }
    }
};

/// Lanes of the step as the second line has them.
template <class V>
MENISCUS_INLINE Lanes<float> as_floats(V values) {
    return __builtin_convertvector(values, Lanes<float>);
}

/// What the second line looks at, eight neighbors at a time. Those that do not count stay, without
/// a weight.
template <int Dimension, class Real>
void gather_fluid(const LaneListView<Real, Dimension, true>& view, std::size_t i,
                  const UniformRadius<Real>& /*radii*/, const NeighborRange<Real>& range,
                  GatheredNeighbors& gathered) {
    gathered.reserve(view.lists->padded_count(i));
    visit_lists<Real, Dimension>(view.rows, view.centers[i], *view.lists, i,
                                 [&](const NeighborLanes<Real, Dimension>& lanes) {
                                     const Lanes<Real> zero{};
                                     const Lanes<Real> one = all_lanes<Lanes<Real>>(1);
                                     const Lanes<Real> near =
                                         lanes.distance_squared < range.outer_squared ? one : zero;
                                     const Lanes<Real> counts =
                                         lanes.distance_squared > range.inner_squared ? near : zero;
                                     for (int axis = 0; axis < Dimension; ++axis) {
                                         const Lanes<Real> safe = axis == 0 ? one : zero;
                                         store(as_floats(counts > zero ? -lanes.step[axis] : safe),
                                               &gathered.step[axis][gathered.size]);
                                     }
                                     store(as_floats(counts), &gathered.mass[gathered.size]);
                                     store(as_floats(counts), &gathered.count[gathered.size]);
                                     gathered.size += lane_count;
                                 });
}

/// The options of the runtime that a scene asks for; sigma in the units of a step.
inline SurfaceTensionOptions tension_settings(const TensionOptions& options, const StepUnits& units,
                                              double spacing) {
    SurfaceTensionOptions settings = options.surface;
    const double h = units.support_radius;
    settings.surface_tension = options.coefficient / (units.rest_density * h * h * h);
    settings.spacing_ratio = 1 / spacing;
    return settings;
}

/// Candidates by the classifier's first line, from the step's lists; walls count where the options
/// say so.
template <class Real, int Dimension>
void find_candidates_in_lanes(const Fluid<Real, Dimension>& fluid,
                              const SurfaceTensionOptions& options,
                              std::vector<std::uint8_t>& candidate) {
    const auto range = neighbor_range<Real>(1, options.radius_ratio);
    const SurfaceLine<Real> line{static_cast<Real>(options.k), static_cast<Real>(options.d)};
    const bool walls_count = options.boundary_weight > 0 && fluid.wall_place.size() > 1;
    const Real weight = static_cast<Real>(options.boundary_weight) * over_wall_volume(fluid);
    candidate.resize(fluid.count);
    fluid.loop.each(fluid.count, [&](std::size_t i) {
        VectorSum<Real, Dimension> moment;
        Lanes<Real> count{};
        const auto add = [&](const NeighborLanes<Real, Dimension>& lanes, Lanes<Real> weight) {
            const Lanes<Real> zero{};
            const Lanes<Real> near = lanes.distance_squared < range.outer_squared ? weight : zero;
            const Lanes<Real> counts = lanes.distance_squared > range.inner_squared ? near : zero;
            count += counts;
            moment.add(counts, lanes.step);
        };
        visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
            add(lanes, all_lanes<Lanes<Real>>(1));
        });
        if (walls_count)
            visit_walls(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
                add(lanes, lanes.w * weight);
            });
        const Row<Real> total = moment.total();
        FeatureSum<Real, Dimension, Real> sum;
        sum.count = sum_of_lanes(count);
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
        : MonteCarloTension(model_options, tension_settings(model_options, units, spacing)) {}

    /// With the runtime's options as they are; of the model's, balance_momentum alone counts.
    MonteCarloTension(const TensionOptions& model_options, const SurfaceTensionOptions& settings)
        : SurfaceTensionModel<Real, Dimension>(model_options, {}, 1 / settings.spacing_ratio),
          tension(settings) {}

    void take_time_step(double seconds) override {
        const double density = this->options.sampling_density;
        if (density > 0)
            tension.set_samples(samples_for_time_step(
                seconds, density, static_cast<std::size_t>(this->options.min_samples)));
    }

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
        slow_contact_lines(fluid);
        damp_ripples(surface, this->options.ripple_damping, tension.options().surface_tension,
                     1 / tension.options().spacing_ratio, fluid, speeds);
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

    [[nodiscard]] double ambient_pressure() const override {
        const SurfaceTensionOptions& settings = tension.options();
        return settings.ambient_pressure * (Dimension - 1) * settings.surface_tension; // h is 1
    }

private:
    SurfaceTension<Real, Dimension> tension;
    std::vector<std::uint8_t> candidate;
    std::vector<Real> speeds; ///< of ripples

    void find_surface_forces(FluidType& fluid) {
        find_candidates_in_lanes(fluid, tension.options(), candidate);
        const Real wall_weight = over_wall_volume(fluid);
        const LaneListView<Real, Dimension, true> view{fluid.place.data(), fluid.place.data(),
                                                       &fluid.neighbors, wall_weight};
        if (fluid.wall_place.size() > 1) {
            using Walls = LaneListView<Real, Dimension, false>;
            const Walls walls{fluid.wall_place.data(), fluid.place.data(), &fluid.wall_neighbors,
                              wall_weight};
            const auto& angles = fluid.wall_contact_angle;
            find_forces(fluid, view,
                        BoundaryView<Walls>{walls, angles.empty() ? nullptr : angles.data()});
        } else {
            find_forces(fluid, view, NoBoundary{});
        }
    }

    /// Friction of contact lines: -f sqrt(sigma / (rho spacing^3)) v for each particle of one,
    /// walls being at rest. It says how fast a drop comes to rest and not where; real lines have
    /// friction, too (Blake 2006). Within the step of capillary waves, sqrt(rho spacing^3 / (2 pi
    /// sigma)), it is stable for all f that a scene may have.
    void slow_contact_lines(FluidType& fluid) const {
        const auto& surface = tension.surface();
        const SurfaceTensionOptions& settings = tension.options();
        const double spacing_cubed = 1 / std::pow(settings.spacing_ratio, 3);
        const auto rate = static_cast<Real>(this->options.contact_friction *
                                            std::sqrt(settings.surface_tension / spacing_cubed));
        fluid.loop.each(surface.size(), [&](std::size_t slot) {
            if (!surface.contact[slot].is_there())
                return;
            const std::size_t i = surface.particle[slot];
            fluid.acceleration[i] = plus(fluid.acceleration[i], -rate, fluid.velocity[i]);
        });
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
