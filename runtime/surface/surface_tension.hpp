// Surface tension in an SPH step, whole: which particles are surface, their normals and curvatures,
// and the force on each (2020 paper, sections 3.1 to 3.4). One call a step over the host's own
// neighbor lists; the stages stand in headers of their own, for hosts that want only some.
//
//     meniscus::SurfaceTension<float, 3> tension(options);      // once; {}: the defaults
//     tension.step(view, particles, radii, loop);               // each step
//     for (std::size_t k = 0; k < tension.surface().size(); ++k)
//         ... surface().particle[k], surface().force[k] ...
//
// It keeps working memory from step to step and allocates nothing once that has grown, or after
// reserve(). Results do not depend on the loop.
#pragma once

#include "../errors.hpp"
#include "../math/coordinates.hpp"
#include "../neighbors/position_resolution.hpp"
#include "connected_components.hpp"
#include "momentum.hpp"
#include "option_table.hpp"
#include "shipped_classifier.hpp"
#include "shipped_curvature_map.hpp"
#include "surface_force.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

static_assert(option_ranges::samples.min == min_samples &&
              option_ranges::samples.max == max_samples);

/// The options with the classifier and the map that ship for the dimension where they name none.
inline SurfaceTensionOptions completed(SurfaceTensionOptions options, int dimension) {
    if (takes_shipped_line(options))
        set_shipped_classifier(options, dimension);
    if (options.curvature_map.dimension == 0)
        options.curvature_map = shipped_curvature_map(dimension);
    return options;
}

/// Surface tension of one fluid, with the memory that it needs: one for each concurrent caller.
template <class Real, int Dimension>
class SurfaceTension {
public:
    /// Throws std::invalid_argument as check() does.
    explicit SurfaceTension(const SurfaceTensionOptions& options = {})
        : settings(completed(options, Dimension)) {
        check(options, Dimension);
        set_samples(options.samples);
    }

    /// The host's memory of curvatures, for smoothing over time steps; nullptr: none. It outlives
    /// the steps, and the host reorders it together with its particles.
    TemporalCurvature<Real>* history = nullptr;

    /// What the last step found.
    [[nodiscard]] const SurfaceParticles<Real, Dimension>& surface() const { return list; }

    /// As given, but for the classifier and the map where those that ship were asked for.
    [[nodiscard]] const SurfaceTensionOptions& options() const { return settings; }

    /// Room for so many particles, neighbors a particle and workers of the loop: steps with no more
    /// allocate nothing. Where it is not called they grow with the first steps.
    void reserve(std::size_t particles, std::size_t neighbors, int workers) {
        list.slot_of.reserve(particles);
        list.reserve_slots(particles, particles * neighbors);
        normals_before.reserve(particles);
        curvatures_before.reserve(particles);
        make_memory(workers);
        for (ExposureMemory& one : memory)
            one.reserve(neighbors);
        components.resize((std::max)(components.size(), particles));
        at_wall.resize((std::max)(at_wall.size(), particles));
        finder.reserve(particles);
        balance.reserve(particles, particles);
    }

    /// Samples a particle from now on, as for a new time step (samples_for_time_step): filled up to
    /// a multiple of 16, so that a step that changes little makes no new directions.
    void set_samples(std::size_t samples) {
        const std::size_t wanted =
            samples < 16 ? samples : (std::min)((samples + 15) / 16 * 16, max_samples);
        if (settings.coverage == CoverageMethod::sampled && wanted != directions.samples)
            fill_outward_directions<Dimension>(wanted, settings.seed, directions);
    }

    /// Another first line from now on; the second, where there is one, stays.
    void set_line(const SurfaceLine<double>& line) {
        settings.k = line.k;
        settings.d = line.d;
    }

    /// One step over `count` particles: classes, normals, curvatures and forces of the surface.
    /// `view` delivers neighbors of the same phase; `boundary` is a BoundaryView or NoBoundary;
    /// `radii` a UniformRadius or VaryingRadii; `ids` one number a particle that stays its own, or
    /// nullptr where particles keep their index. Never NaN from finite input. Throws
    /// std::invalid_argument, with the last step's results as they were, where one radius serves
    /// all and Real cannot calculate with it (position_resolution.hpp), or the history's share is
    /// out of its range.
    template <class View, class Boundary, class Radii, class Loop>
    void step(const View& view, const Boundary& boundary, std::size_t count, const Radii& radii,
              const std::uint32_t* ids, const Loop& loop) {
        check_step(radii, count);
        make_memory(loop.workers());
        find_candidates<Real, Dimension>(view, boundary, count, radii, settings, loop,
                                         memory.data(), list);
        step_from_candidates(view, boundary, radii, ids, loop);
    }

    /// The same without a boundary, and with particles that keep their index.
    template <class View, class Radii, class Loop>
    void step(const View& view, std::size_t count, const Radii& radii, const Loop& loop) {
        step(view, NoBoundary{}, count, radii, nullptr, loop);
    }

    /// The same after a host's own classification in its density loop: candidate[i] not 0 for those
    /// that the first line lets through, and FeatureSum::count of each particle in the fluid. The
    /// second line, where the options have one, then keeps fewer of them.
    template <class View, class Boundary, class Radii, class Count, class Loop>
    void step(const View& view, const Boundary& boundary, std::size_t count, const Radii& radii,
              const std::uint32_t* ids, const std::uint8_t* candidate, const Count* neighbor_count,
              const Loop& loop) {
        check_step(radii, count);
        make_memory(loop.workers());
        if (settings.second_line.is_there)
            thin_candidates<Real, Dimension>(view, boundary, candidate, neighbor_count, count,
                                             radii, settings, loop, memory.data(), list);
        else
            take_candidates(candidate, neighbor_count, count, list);
        step_from_candidates(view, boundary, radii, ids, loop);
    }

    /// Removes net force and net torque of each connected component of fluid that touches no wall,
    /// after a step over the same view. `positions` holds Stride values a particle, of which the
    /// first Dimension are coordinates in m, not wrapped at periodic ends.
    template <int Stride, class View, class Boundary, class Radii, class Loop>
    void balance_momentum(const View& view, const Boundary& boundary, const Radii& radii,
                          const Real* positions, const Loop& loop) {
        const std::size_t count = list.slot_of.size();
        components.resize((std::max)(components.size(), count));
        finder.template find<Real, Dimension>(view, count, radii, loop, components.data());
        const std::uint8_t* walls = nullptr;
        if constexpr (Boundary::is_there) {
            at_wall.resize((std::max)(at_wall.size(), count));
            find_wall_contact(boundary, count, radii, loop);
            finder.spread_wall_contact(components.data(), at_wall.data(), count, loop,
                                       at_wall.data());
            walls = at_wall.data();
        }
        balance.remove_net_force(
            ComponentParticles<Real, Dimension, Stride>{positions, components.data(), walls},
            ComponentForces<Real>{list.particle.data(), list.size(), list.weight.data(),
                                  list.size() > 0 ? list.force[0].data() : nullptr},
            loop);
    }

    /// What the walls get back, N (in two dimensions N/m): the forces on fluid that touches them,
    /// with the sign turned, so that fluid and walls together keep their momentum. After
    /// balance_momentum() with a boundary.
    [[nodiscard]] Coordinates<double, Dimension> wall_reaction() const {
        Coordinates<double, Dimension> sum = {};
        for (std::size_t slot = 0; slot < list.size(); ++slot)
            if (list.particle[slot] < at_wall.size() && at_wall[list.particle[slot]] != 0)
                for (std::size_t axis = 0; axis < Dimension; ++axis)
                    sum[axis] -= static_cast<double>(list.force[slot][axis]);
        return sum;
    }

private:
    SurfaceTensionOptions settings;
    SurfaceParticles<Real, Dimension> list;
    SampleDirections directions;
    HeldCells cells;
    std::vector<ExposureMemory> memory;
    std::vector<Coordinates<Real, Dimension>> normals_before;
    std::vector<Real> curvatures_before;
    ComponentFinder finder;
    MomentumBalance balance;
    std::vector<std::uint32_t> components;
    std::vector<std::uint8_t> at_wall;

    void make_memory(int workers) {
        memory.resize((std::max)(memory.size(), static_cast<std::size_t>(workers)));
    }

    template <class Radii>
    void check_step(const Radii& radii, std::size_t count) const {
        if constexpr (!Radii::varies)
            if (count > 0 && !is_usable_radius<Real>(static_cast<double>(radii.radius)))
                refuse("the support radius must be positive, and its square "
                       "within the range of the number type; is it in m?");
        if (history != nullptr &&
            !(is_finite(history->share) && history->share >= 0 && history->share < 1))
            refuse("the history's share must be at least 0 and below 1");
    }

    template <class View, class Boundary, class Radii, class Loop>
    void step_from_candidates(const View& view, const Boundary& boundary, const Radii& radii,
                              const std::uint32_t* ids, const Loop& loop) {
        find_exposure<Real, Dimension>(view, boundary, radii, ids, directions, cells, settings,
                                       loop, memory.data(), list);
        if (settings.covariance_share > 0)
            mix_in_covariance_normals<Real, Dimension>(settings.covariance_share, loop, list);
        for (int pass = 0; pass < settings.normal_passes; ++pass)
            smooth_normals<Real, Dimension>(settings.tau, loop, list, normals_before);
        const double ratio = settings.radius_ratio;
        if (settings.curvature == CurvatureForm::mapped) {
            find_mapped_curvature<Real, Dimension>(settings.curvature_map, ratio, radii, loop, list,
                                                   curvatures_before);
        } else {
            find_curvature<Real, Dimension>(ratio, radii, loop, list);
            if (settings.force == ForceForm::calibrated)
                find_turning<Real, Dimension>(radii, loop, list);
        }
        for (int pass = 0; pass < settings.curvature_passes; ++pass)
            smooth_curvature<Real, Dimension>(settings.tau, loop, list, curvatures_before);
        if (history != nullptr)
            history->smooth(list);
        find_force<Real, Dimension>(settings, radii, loop, list);
    }

    template <class Boundary, class Radii, class Loop>
    void find_wall_contact(const Boundary& boundary, std::size_t count, const Radii& radii,
                           const Loop& loop) {
        loop(count, [&](std::size_t begin, std::size_t end, int /*worker*/) {
            for (std::size_t i = begin; i < end; ++i) {
                const Real radius = radii.of(i);
                at_wall[i] = 0;
                boundary(i, [&](std::size_t /*j*/, const auto& displacement, Real /*mass*/) {
                    if (squared_length<Real, Dimension>(displacement) < radius * radius)
                        at_wall[i] = 1;
                });
            }
        });
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
