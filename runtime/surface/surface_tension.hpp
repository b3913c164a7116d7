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

#include <limits>

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

    /// As given and set since, but for the classifier and the map where those that ship were asked
    /// for.
    [[nodiscard]] const SurfaceTensionOptions& options() const { return settings; }

    /// Room for so many particles, neighbors a particle and workers of the loop: steps with no more
    /// allocate nothing. Where it is not called they grow with the first steps. Throws
    /// std::bad_alloc or std::length_error where that is more than there can be.
    void reserve(std::size_t particles, std::size_t neighbors, int workers) {
        // A product that overflows becomes one that vectors refuse; below, sums cannot then.
        const std::size_t most = (std::numeric_limits<std::size_t>::max)() - particles;
        const std::size_t rows = (std::max)(particles, std::size_t{1});
        list.reserve_slots(particles, neighbors > most / rows ? most : rows * neighbors);
        list.slot_of.reserve(particles);
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

    // What follows changes options from now on. Each throws std::invalid_argument (errors.hpp),
    // naming the option and its range (option_table.hpp), and changes nothing then. Others are for
    // an object of their own.

    /// Samples a particle, as for a new time step (samples_for_time_step): filled up to a multiple
    /// of 16, so that a step that changes little makes no new directions.
    void set_samples(std::size_t samples) {
        set(&SurfaceTensionOptions::samples, samples);
        const std::size_t wanted =
            samples < 16 ? samples : (std::min)((samples + 15) / 16 * 16, max_samples);
        if (settings.coverage == CoverageMethod::sampled && wanted != directions.samples)
            fill_outward_directions<Dimension>(wanted, settings.seed, directions);
    }

    /// Another first line; the second, where there is one, stays.
    void set_line(const SurfaceLine<double>& line) {
        check_option(&SurfaceTensionOptions::d, line.d);
        set(&SurfaceTensionOptions::k, line.k);
        settings.d = line.d;
    }

    /// Sigma in N/m.
    void set_surface_tension(double sigma) { set(&SurfaceTensionOptions::surface_tension, sigma); }

    /// Of walls, degrees.
    void set_contact_angle(double angle) { set(&SurfaceTensionOptions::contact_angle, angle); }

    void set_fade(double fade) { set(&SurfaceTensionOptions::fade, fade); }

    /// Passes over normals and curvatures.
    void set_smoothing(int normal_passes, int curvature_passes) {
        check_option(&SurfaceTensionOptions::curvature_passes, curvature_passes);
        set(&SurfaceTensionOptions::normal_passes, normal_passes);
        settings.curvature_passes = curvature_passes;
    }

    /// One step over `count` particles: classes, normals, curvatures and forces of the surface.
    /// `view` delivers neighbors of the same phase; `boundary` is a BoundaryView, WallPlanes
    /// (wall_planes.hpp) or NoBoundary; `radii` a UniformRadius or VaryingRadii; `ids` one number a
    /// particle that stays its own, or nullptr where particles keep their index. Never NaN from
    /// finite input. Throws std::invalid_argument, with the last step's results as they were, where
    /// Real cannot calculate with a support radius, or with two of them together
    /// (position_resolution.hpp), or with forces of such a sigma at such radii, where radii differ
    /// in spite of an ambient pressure, or the history's share is out of its range.
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

    template <class Value>
    void set(Value SurfaceTensionOptions::*member, Value value) {
        check_option(member, value);
        settings.*member = value;
    }

    template <class Radii>
    void check_step(const Radii& radii, std::size_t count) const {
        if (count > 0)
            check_radii(radii, count);
        if (history != nullptr &&
            !(is_finite(history->share) && history->share >= 0 && history->share < 1))
            refuse("the history's share must be at least 0 and below 1");
    }

    template <class Radii>
    void check_radii(const Radii& radii, std::size_t count) const {
        const auto extent = extent_of(radii, count);
        const auto min = static_cast<double>(extent.min);
        const auto max = static_cast<double>(extent.max);
        if (!is_usable_radius<Real>(min) || !is_usable_radius<Real>(max))
            refuse_radius(radii, count);
        if (max / min > max_radius_contrast)
            refuse("the largest support radius is more than 1000000 times the smallest: are all "
                   "in m?");
        if (settings.ambient_pressure > 0 && min < max)
            refuse("ambient_pressure is over sigma / h: it must be 0 where support radii differ");
        check_forces(min, max);
    }

    /// Whether forces stay within the range of Real, by bounds of what each factor can be.
    void check_forces(double min_radius, double max_radius) const {
        constexpr auto most = static_cast<double>((std::numeric_limits<Real>::max)());
        const double ratio = settings.radius_ratio;
        const double curvature =
            2 / std::sqrt((1 - ratio) * (1 + ratio)) + settings.ambient_pressure; // times h
        const double stretch = 1 + 1 / ((1 - ratio) * settings.spacing_ratio);
        // Divided one after another, so that nothing overflows here.
        const double max_sigma = most / (4 * stretch * stretch * curvature);
        const double contrast = max_radius / min_radius;
        const double to_pressure = (std::max)(1 / min_radius, 1.0);
        const double to_force = (std::max)(Dimension == 2 ? contrast : max_radius * contrast, 1.0);
        const double sigma = std::fabs(settings.surface_tension);
        if (sigma > max_sigma / to_pressure || sigma > max_sigma / to_force ||
            max_radius * stretch > std::sqrt(most))
            refuse("surface_tension is so large for these support radii that forces leave the "
                   "range of the number type; is all in SI units?");
    }

    /// Names the first particle whose radius is not usable.
    template <class Radii>
    [[noreturn]] static void refuse_radius(const Radii& radii, std::size_t count) {
        char text[200] = "";
        if (Radii::varies)
            for (std::size_t i = 0; i < count && text[0] == 0; ++i)
                if (!is_usable_radius<Real>(static_cast<double>(radii.of(i))))
                    std::snprintf(text, sizeof text, " (that of particle %zu is %.9g)", i,
                                  static_cast<double>(radii.of(i)));
        char whole[400];
        std::snprintf(whole, sizeof whole,
                      "the support radius must be positive, and its square within the range of "
                      "the number type%s; is it in m?",
                      text);
        refuse(whole);
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
