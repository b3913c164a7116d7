// The C interface: checks what comes in, and lets no exception out.
#include "checks.hpp"
#include "options.hpp"

#include <meniscus/bindings/step/surface_step.hpp>
#include <meniscus/runtime/coverage/sample_directions.hpp>
#include <meniscus/runtime/neighbors/held_traps.hpp>
#include <meniscus/runtime/surface/host_quantities.hpp>
#include <meniscus/runtime/version.hpp>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <new>
#include <stdexcept>

struct meniscus_surface {
    std::unique_ptr<meniscus::SurfaceStep> step;
    meniscus::ArrayKind kind;
    bool is_broken = false; ///< an earlier call failed halfway
};

namespace meniscus {
namespace {

constexpr std::size_t longest_error = 512;
thread_local char last_error[longest_error] = "";

/// Remembers the error; what does not fit is cut.
int failed(int status, const char* message) {
    std::snprintf(last_error, longest_error, "%s", message);
    return status;
}

/// The status of what `act` does.
template <class Act>
int guarded(const Act& act) noexcept {
    try {
        act();
        return MENISCUS_OK;
    } catch (const std::invalid_argument& error) {
        return failed(MENISCUS_BAD_ARGUMENT, error.what());
    } catch (const std::bad_alloc&) {
        return failed(MENISCUS_OUT_OF_MEMORY, "out of memory");
    } catch (const std::length_error&) {
        return failed(MENISCUS_OUT_OF_MEMORY, "more memory needed than there can be");
    } catch (const std::exception& error) {
        return failed(MENISCUS_FAILURE, error.what());
    } catch (...) {
        return failed(MENISCUS_FAILURE, "unknown failure");
    }
}

void check_surface(const meniscus_surface* surface) {
    demand(surface != nullptr, "surface is NULL");
    if (surface->is_broken)
        throw std::runtime_error("an earlier call failed halfway; destroy this surface");
}

/// guarded() for what changes the memory of a handle.
template <class Act>
int changing(meniscus_surface* surface, const Act& act) noexcept {
    const int status = guarded([&] {
        check_surface(surface);
        act();
    });
    if (surface != nullptr && (status == MENISCUS_OUT_OF_MEMORY || status == MENISCUS_FAILURE))
        surface->is_broken = true;
    return status;
}

/// Calls act(float or double), which says what the arrays of a handle hold.
template <class Act>
void with_real(const meniscus_surface& surface, const Act& act) {
    if (surface.kind.is_double)
        act(double{});
    else
        act(float{});
}

/// Zeros for all particles, then the values of the slots.
template <class Value>
void scatter(const SurfaceStepResults& found, const void* from, std::size_t components, void* to,
             std::size_t stride) {
    if (to == nullptr)
        return;
    const auto* values = static_cast<const Value*>(from);
    auto* all = static_cast<Value*>(to);
    for (std::size_t i = 0; i < found.count; ++i)
        std::fill_n(all + i * stride, components, Value(0));
    for (std::size_t slot = 0; slot < found.slots; ++slot)
        std::copy_n(values + slot * components, components, all + found.particle[slot] * stride);
}

/// Throws before anything is changed.
template <class Real>
void add_accelerations(const SurfaceStepResults& found, std::size_t dimension, const Real* masses,
                       Real mass, Real* accelerations, std::size_t stride) {
    const auto* forces = static_cast<const Real*>(found.force);
    const auto for_each = [&](const auto& visit) {
        for (std::size_t slot = 0; slot < found.slots; ++slot) {
            const std::size_t i = found.particle[slot];
            const Real of_particle = masses != nullptr ? masses[i] : mass;
            for (std::size_t axis = 0; axis < dimension; ++axis)
                visit(i, axis, forces[slot * dimension + axis] / of_particle, of_particle);
        }
    };
    for_each([](std::size_t i, std::size_t /*axis*/, Real acceleration, Real its_mass) {
        if (!is_positive(static_cast<double>(its_mass)) || !std::isfinite(acceleration))
            throw std::invalid_argument("masses[" + std::to_string(i) + "] is " +
                                        std::to_string(its_mass) +
                                        ", with which accelerations leave the number type");
    });
    for_each([&](std::size_t i, std::size_t axis, Real acceleration, Real /*its_mass*/) {
        accelerations[i * stride + axis] += acceleration;
    });
}

void check_sample_count(const char* name, std::size_t samples) {
    check_option(name, option_ranges::samples, static_cast<double>(samples));
}

int set_options(meniscus_options* options, std::size_t size, const SurfaceTensionOptions& values) {
    return guarded([&] {
        demand(options != nullptr, "options is NULL");
        meniscus_options given{};
        given.size = size;
        check_struct(&given, "options");
        *options = to_c(values);
    });
}

} // namespace
} // namespace meniscus

using namespace meniscus;

const char* meniscus_version(void) {
    return program_version;
}

const char* meniscus_last_error(void) {
    return last_error;
}

int meniscus_options_init(meniscus_options* options, size_t size) {
    return set_options(options, size, {});
}

int meniscus_options_paper(meniscus_options* options, size_t size) {
    return set_options(options, size, paper_options());
}

int meniscus_create(meniscus_surface** surface, const meniscus_options* options, int dimension,
                    int precision) {
    return guarded([&] {
        demand(surface != nullptr, "surface is NULL");
        *surface = nullptr;
        check_struct(options, "options");
        demand(precision == MENISCUS_FLOAT || precision == MENISCUS_DOUBLE,
               "precision must be MENISCUS_FLOAT (0) or MENISCUS_DOUBLE (1)");
        const bool is_double = precision == MENISCUS_DOUBLE;
        auto step =
            surface_step(from_c(*options, dimension), {dimension, is_double, options->threads});
        *surface =
            new meniscus_surface{std::move(step), {static_cast<std::size_t>(dimension), is_double}};
    });
}

void meniscus_destroy(meniscus_surface* surface) {
    delete surface;
}

int meniscus_reserve(meniscus_surface* surface, size_t particles, size_t neighbors) {
    return changing(surface, [&] { surface->step->reserve(particles, neighbors); });
}

int meniscus_set_samples(meniscus_surface* surface, size_t samples) {
    return changing(surface, [&] {
        check_sample_count("samples", samples);
        surface->step->set_samples(samples);
    });
}

int meniscus_set_samples_for_time_step(meniscus_surface* surface, double time_step,
                                       double sampling_density, size_t minimum) {
    return changing(surface, [&] {
        const HeldTraps held;
        demand(is_positive(time_step), "time_step must be positive and finite");
        demand(is_positive(sampling_density), "sampling_density must be positive and finite");
        check_sample_count("minimum", minimum);
        surface->step->set_samples(samples_for_time_step(time_step, sampling_density, minimum));
    });
}

int meniscus_set_line(meniscus_surface* surface, double k, double d) {
    return changing(surface, [&] { surface->step->set_line(k, d); });
}

int meniscus_set_surface_tension(meniscus_surface* surface, double surface_tension) {
    return changing(surface, [&] { surface->step->set_surface_tension(surface_tension); });
}

int meniscus_set_contact_angle(meniscus_surface* surface, double contact_angle) {
    return changing(surface, [&] { surface->step->set_contact_angle(contact_angle); });
}

int meniscus_set_fade(meniscus_surface* surface, double fade) {
    return changing(surface, [&] { surface->step->set_fade(fade); });
}

int meniscus_set_smoothing(meniscus_surface* surface, int normal_passes, int curvature_passes) {
    return changing(surface,
                    [&] { surface->step->set_smoothing(normal_passes, curvature_passes); });
}

int meniscus_spacing_ratio(double support_radius, double volume, int dimension,
                           double* spacing_ratio) {
    return guarded([&] {
        const HeldTraps held;
        demand(spacing_ratio != nullptr, "spacing_ratio is NULL");
        *spacing_ratio = spacing_ratio_of(support_radius, volume, dimension);
    });
}

int meniscus_capillary_time_step(double surface_tension, double density, double spacing,
                                 double* time_step) {
    return guarded([&] {
        const HeldTraps held;
        demand(time_step != nullptr, "time_step is NULL");
        *time_step = capillary_time_step(surface_tension, density, spacing);
    });
}

int meniscus_step(meniscus_surface* surface, const meniscus_particles* particles) {
    return changing(surface, [&] {
        check_particles(particles, surface->kind);
        surface->step->step(step_particles(*particles));
    });
}

int meniscus_check(const meniscus_surface* surface, const meniscus_particles* particles) {
    return guarded([&] {
        const HeldTraps held;
        check_surface(surface);
        check_particles(particles, surface->kind);
        check_contents(*particles, surface->kind);
        surface->step->check(step_particles(*particles));
    });
}

int meniscus_balance_momentum(meniscus_surface* surface, const meniscus_particles* particles) {
    return changing(surface, [&] {
        check_particles(particles, surface->kind);
        demand(particles->count == surface->step->results().count,
               "particles.count is not that of the last step");
        surface->step->balance_momentum(step_particles(*particles));
    });
}

int meniscus_get_results(const meniscus_surface* surface, meniscus_results* results) {
    return guarded([&] {
        check_surface(surface);
        check_struct(results, "results");
        const SurfaceStepResults found = surface->step->results();
        *results = {sizeof *results,
                    found.slots,
                    found.count,
                    found.particle,
                    found.slot_of,
                    found.surface_class,
                    found.uncovered_fraction,
                    found.normal,
                    found.curvature,
                    found.force};
    });
}

int meniscus_scatter(const meniscus_surface* surface, uint8_t* surface_class,
                     void* uncovered_fraction, void* normal, void* curvature, void* force,
                     size_t stride) {
    return guarded([&] {
        check_surface(surface);
        const auto found = surface->step->results();
        const std::size_t dimension = surface->kind.dimension;
        const std::size_t step = checked_stride("stride", stride, dimension, found.count);
        scatter<std::uint8_t>(found, found.surface_class, 1, surface_class, 1);
        with_real(*surface, [&](auto real) {
            using Real = decltype(real);
            scatter<Real>(found, found.uncovered_fraction, 1, uncovered_fraction, 1);
            scatter<Real>(found, found.normal, dimension, normal, step);
            scatter<Real>(found, found.curvature, 1, curvature, 1);
            scatter<Real>(found, found.force, dimension, force, step);
        });
    });
}

int meniscus_add_accelerations(const meniscus_surface* surface, const void* masses, double mass,
                               void* accelerations, size_t stride) {
    return guarded([&] {
        const HeldTraps held;
        check_surface(surface);
        const auto found = surface->step->results();
        const std::size_t dimension = surface->kind.dimension;
        const std::size_t step = checked_stride("stride", stride, dimension, found.count);
        if (found.count == 0)
            return;
        demand(accelerations != nullptr, "accelerations is NULL");
        demand(masses != nullptr || is_positive(mass),
               "mass must be positive and finite, where masses is NULL");
        with_real(*surface, [&](auto real) {
            using Real = decltype(real);
            demand(masses != nullptr || is_positive(static_cast<double>(static_cast<Real>(mass))),
                   "mass is beyond the range of the number type");
            add_accelerations(found, dimension, static_cast<const Real*>(masses),
                              static_cast<Real>(mass), static_cast<Real*>(accelerations), step);
        });
    });
}
