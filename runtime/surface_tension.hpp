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

#include "connected_bodies.hpp"
#include "momentum.hpp"
#include "position_resolution.hpp"
#include "shipped_curvature_map.hpp"
#include "shipped_surface_line.hpp"
#include "surface_force.hpp"

#include <stdexcept>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// How curvature is found.
enum class CurvatureForm { closed, mapped };

/// What a scene needs. The defaults are the project's own choices in three dimensions;
/// `shipped_options` has them for each, and `paper_options` gives the paper's.
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
    CurvatureMap map{};         ///< where it is mapped
    int curvature_passes = 0;   ///< smoothing of the curvature
    double history_share = 0.5; ///< of the last step's curvature, where the host keeps a history
    ForceOptions force;
};

/// Sets the line of the classifier.
inline void set_line(SurfaceTensionOptions& options, const SurfaceLine<double>& line) {
    options.k = line.k;
    options.d = line.d;
}

/// The 2020 paper's method as published: sampled coverage alone, the closed form smoothed once,
/// every surface particle with weight 1, and its force times the face of a particle. The line is
/// the one that ships for the dimension.
template <int Dimension = 3>
SurfaceTensionOptions paper_options() {
    SurfaceTensionOptions options;
    set_line(options, shipped_surface_line(Dimension));
    options.exposure.verification = Verification::drop;
    options.exposure.fade = 0;
    options.curvature = CurvatureForm::closed;
    options.curvature_passes = 1;
    options.force.form = ForceForm::paper;
    return options;
}

/// The project's own choices with the line and the curvature map that ship for the dimension.
template <int Dimension>
SurfaceTensionOptions shipped_options() {
    SurfaceTensionOptions options;
    set_line(options, shipped_surface_line(Dimension));
    options.map = shipped_curvature_map(Dimension);
    return options;
}

/// Throws std::invalid_argument, naming the option, where one is out of its range.
inline void check(const SurfaceTensionOptions& options, int dimension) {
    const auto demand = [](bool holds, const char* what) {
        if (!holds)
            throw std::invalid_argument(what);
    };
    const auto is_share = [](double value) { return is_finite(value) && value >= 0 && value <= 1; };
    const double ratio = options.exposure.radius_ratio;
    demand(is_finite(options.k) && is_finite(options.d), "k and d must be finite");
    demand(is_share(ratio) && ratio > 0 && ratio < 1, "radius_ratio must be between 0 and 1");
    demand(options.samples >= fewest_samples && options.samples <= most_samples,
           "samples must be between 4 and 16384");
    demand(is_share(options.exposure.fade), "fade must be between 0 and 1");
    demand(is_share(options.tau), "tau must be between 0 and 1");
    demand(options.normal_passes >= 0, "normal_passes must not be negative");
    demand(is_share(options.covariance_share), "covariance_share must be between 0 and 1");
    demand(options.curvature_passes >= 0, "curvature_passes must not be negative");
    demand(is_share(options.history_share) && options.history_share < 1,
           "history_share must be at least 0 and below 1");
    demand(is_finite(options.force.surface_tension), "surface_tension must be finite");
    demand(is_positive_and_finite(options.force.spacing_ratio),
           "spacing_ratio must be positive: support radius over particle spacing");
    demand(options.curvature != CurvatureForm::mapped || options.map.dimension == dimension,
           "map is missing or of another dimension: shipped_options() sets the curvature map");
}

/// Surface tension of one fluid, with the memory that it needs: one for each concurrent caller.
template <class Real, int Dimension>
class SurfaceTension {
public:
    /// Throws std::invalid_argument as check() does.
    explicit SurfaceTension(const SurfaceTensionOptions& options) : settings(options) {
        check(options, Dimension);
        set_samples(options.samples);
    }

    /// The host's memory of curvatures, for smoothing over time steps; nullptr: none. It outlives
    /// the steps, and the host reorders it together with its particles.
    TemporalCurvature<Real>* history = nullptr;

    /// What the last step found.
    [[nodiscard]] const SurfaceParticles<Real, Dimension>& surface() const { return list; }
    [[nodiscard]] const SurfaceTensionOptions& options() const { return settings; }

    /// Room for so many particles, neighbors a particle and workers of the loop: steps with no more
    /// allocate nothing. Where it is not called they grow with the first steps.
    void reserve(std::size_t particles, std::size_t neighbors, int workers) {
        list.slot_of.reserve(particles);
        list.reserve_slots(particles, particles * neighbors);
        normals_before.reserve(particles);
        curvatures_before.reserve(particles);
        memory.resize(std::max(memory.size(), static_cast<std::size_t>(workers)));
        for (ExposureMemory& one : memory)
            one.reserve(neighbors);
        bodies.resize(std::max(bodies.size(), particles));
        at_wall.resize(std::max(at_wall.size(), particles));
        finder.reserve(particles);
        balance.reserve(particles, particles);
    }

    /// Samples a particle from now on, as for a new time step (samples_for_time_step): filled up to
    /// a multiple of 16, so that a step that changes little makes no new directions.
    void set_samples(std::size_t samples) {
        const std::size_t wanted =
            samples < 16 ? samples : std::min((samples + 15) / 16 * 16, most_samples);
        if (settings.exposure.method == CoverageMethod::sampled && wanted != directions.samples)
            fill_outward_directions<Dimension>(wanted, settings.seed, directions);
    }

    /// The relative line for another median neighbor count, as for a new step (classifier.hpp).
    void set_line(const SurfaceLine<double>& line) {
        settings.k = line.k;
        settings.d = line.d;
    }

    /// One step over `count` particles: classes, normals, curvatures and forces of the surface.
    /// `view` delivers neighbors of the same phase; `boundary` is a BoundaryView or NoBoundary;
    /// `radii` a UniformRadius or VaryingRadii; `ids` one number a particle that stays its own, or
    /// nullptr where particles keep their index. Never NaN from finite input. Throws
    /// std::invalid_argument, with the last step's results as they were, where one radius serves
    /// all and Real cannot calculate with it (position_resolution.hpp).
    template <class View, class Boundary, class Radii, class Loop>
    void step(const View& view, const Boundary& boundary, std::size_t count, const Radii& radii,
              const std::uint32_t* ids, const Loop& loop) {
        check_radius(radii, count);
        find_candidates<Real, Dimension>(
            view, count, radii,
            SurfaceLine<Real>{static_cast<Real>(settings.k), static_cast<Real>(settings.d)},
            settings.exposure.radius_ratio, loop, list);
        step_from_candidates(view, boundary, radii, ids, loop);
    }

    /// The same without a boundary, and with particles that keep their index.
    template <class View, class Radii, class Loop>
    void step(const View& view, std::size_t count, const Radii& radii, const Loop& loop) {
        step(view, NoBoundary{}, count, radii, nullptr, loop);
    }

    /// The same after a host's own classification: candidate[i] not 0, and FeatureSum::count of
    /// each particle, from its density loop.
    template <class View, class Boundary, class Radii, class Count, class Loop>
    void step(const View& view, const Boundary& boundary, std::size_t count, const Radii& radii,
              const std::uint32_t* ids, const std::uint8_t* candidate, const Count* neighbor_count,
              const Loop& loop) {
        check_radius(radii, count);
        take_candidates(candidate, neighbor_count, count, list);
        step_from_candidates(view, boundary, radii, ids, loop);
    }

    /// Removes net force and net torque of each connected body of fluid that touches no wall, after
    /// a step over the same view. `positions` holds Stride values a particle, of which the first
    /// Dimension are coordinates in m, not wrapped at periodic ends.
    template <int Stride, class View, class Boundary, class Radii, class Loop>
    void balance_momentum(const View& view, const Boundary& boundary, const Radii& radii,
                          const Real* positions, const Loop& loop) {
        const std::size_t count = list.slot_of.size();
        bodies.resize(std::max(bodies.size(), count));
        finder.template find<Real, Dimension>(view, count, radii, loop, bodies.data());
        const std::uint8_t* walls = nullptr;
        if constexpr (Boundary::is_there) {
            at_wall.resize(std::max(at_wall.size(), count));
            find_wall_contact(boundary, count, radii, loop);
            finder.spread_wall_contact(bodies.data(), at_wall.data(), count, loop, at_wall.data());
            walls = at_wall.data();
        }
        balance.remove_net_force(
            BodyParticles<Real, Dimension, Stride>{positions, bodies.data(), walls},
            BodyForces<Real>{list.particle.data(), list.size(), list.weight.data(),
                             list.size() > 0 ? list.force[0].data() : nullptr},
            loop);
    }

private:
    SurfaceTensionOptions settings;
    SurfaceParticles<Real, Dimension> list;
    SampleDirections directions;
    HeldCells cells;
    std::vector<ExposureMemory> memory;
    std::vector<std::array<Real, Dimension>> normals_before;
    std::vector<Real> curvatures_before;
    BodyFinder finder;
    MomentumBalance balance;
    std::vector<std::uint32_t> bodies;
    std::vector<std::uint8_t> at_wall;

    template <class Radii>
    static void check_radius(const Radii& radii, std::size_t count) {
        if constexpr (!Radii::varies)
            if (count > 0 && !is_usable_radius<Real>(static_cast<double>(radii.radius)))
                throw std::invalid_argument("the support radius must be positive, and its square "
                                            "within the range of the number type; is it in m?");
    }

    template <class View, class Boundary, class Radii, class Loop>
    void step_from_candidates(const View& view, const Boundary& boundary, const Radii& radii,
                              const std::uint32_t* ids, const Loop& loop) {
        memory.resize(std::max(memory.size(), static_cast<std::size_t>(loop.workers())));
        find_exposure<Real, Dimension>(view, boundary, radii, ids, directions, cells,
                                       settings.exposure, loop, memory.data(), list);
        if (settings.covariance_share > 0)
            mix_in_covariance_normals<Real, Dimension>(settings.covariance_share, loop, list);
        for (int pass = 0; pass < settings.normal_passes; ++pass)
            smooth_normals<Real, Dimension>(settings.tau, loop, list, normals_before);
        const double ratio = settings.exposure.radius_ratio;
        if (settings.curvature == CurvatureForm::mapped) {
            find_mapped_curvature<Real, Dimension>(settings.map, ratio, radii, loop, list,
                                                   curvatures_before);
        } else {
            find_curvature<Real, Dimension>(ratio, radii, loop, list);
            if (settings.force.form == ForceForm::calibrated)
                find_turning<Real, Dimension>(radii, loop, list);
        }
        for (int pass = 0; pass < settings.curvature_passes; ++pass)
            smooth_curvature<Real, Dimension>(settings.tau, loop, list, curvatures_before);
        if (history != nullptr)
            history->smooth(settings.history_share, list);
        find_force<Real, Dimension>(settings.force, radii, loop, list);
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
