// The C interface: checks what comes in, and lets no exception out.
#include "options.hpp"

#include <meniscus/bindings/step/surface_step.hpp>
#include <meniscus/runtime/coverage/sample_directions.hpp>
#include <meniscus/runtime/neighbors/position_resolution.hpp>
#include <meniscus/runtime/version.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

struct meniscus_surface {
    std::unique_ptr<meniscus::SurfaceStep> step;
    std::size_t dimension;
    bool is_double;
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

void demand(bool holds, const char* what) {
    if (!holds)
        throw std::invalid_argument(what);
}

template <class Struct>
void check_struct(const Struct* given, const char* name) {
    if (given == nullptr)
        throw std::invalid_argument(std::string(name) + " is NULL");
    if (given->size != sizeof(Struct))
        throw std::invalid_argument(
            std::string(name) + ".size is " + std::to_string(given->size) + ", expected " +
            std::to_string(sizeof(Struct)) +
            ": not set, or the program was built with the meniscus.h of another version");
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

bool is_positive(double value) {
    return value > 0 && std::isfinite(value);
}

/// Throws std::invalid_argument, naming the member, where the particles cannot be read.
void check_particles(const meniscus_surface& surface, const meniscus_particles* particles) {
    check_struct(particles, "particles");
    const auto& [size, count, positions, stride, masses, radius, radii, ids, offsets, neighbors,
                 offset_bits, boundary_count, boundary, boundary_offsets, boundary_neighbors,
                 boundary_weights, boundary_contact_angles, candidates] = *particles;
    demand(count <= std::size_t{std::numeric_limits<std::int32_t>::max()},
           "particles.count must be below 2^31");
    if (count == 0)
        return;
    demand(positions != nullptr, "particles.positions is NULL");
    demand(stride == 0 || stride >= surface.dimension,
           "particles.stride is less than the dimension");
    demand(radii != nullptr || (surface.is_double ? is_usable_radius<double>(radius)
                                                  : is_usable_radius<float>(radius)),
           "particles.support_radius must be positive and finite, and its square within the range "
           "of the number type, where support_radii is NULL");
    demand(offset_bits == 32 || offset_bits == 64, "particles.offset_bits must be 32 or 64");
    demand(offsets != nullptr, "particles.offsets is NULL");
    const auto is_empty = [&, bits = offset_bits, count = count](const void* some) {
        return bits == 64 ? static_cast<const std::uint64_t*>(some)[count] == 0
                          : static_cast<const std::uint32_t*>(some)[count] == 0;
    };
    demand(neighbors != nullptr || is_empty(offsets), "particles.neighbors is NULL");
    if (boundary == nullptr)
        return;
    demand(boundary_offsets != nullptr, "particles.boundary_offsets is NULL");
    demand(boundary_neighbors != nullptr || is_empty(boundary_offsets),
           "particles.boundary_neighbors is NULL");
}

/// Checked particles, as the step takes them.
StepParticles step_particles(const meniscus_particles& from) {
    StepParticles to;
    to.count = from.count;
    to.positions = from.positions;
    to.stride = from.stride;
    to.masses = from.masses;
    to.support_radius = from.support_radius;
    to.support_radii = from.support_radii;
    to.ids = from.ids;
    to.offsets = from.offsets;
    to.neighbors = from.neighbors;
    to.wide_offsets = from.offset_bits == 64;
    to.boundary_positions = from.boundary_positions;
    to.boundary_offsets = from.boundary_offsets;
    to.boundary_neighbors = from.boundary_neighbors;
    to.boundary_weights = from.boundary_weights;
    to.boundary_contact_angles = from.boundary_contact_angles;
    to.candidates = from.candidates;
    return to;
}

[[noreturn]] void fail_at(const char* member, std::size_t i, const char* what) {
    throw std::invalid_argument("particles." + std::string(member) + "[" + std::to_string(i) +
                                "] " + what);
}

template <class Real>
void check_vectors(const char* member, const void* values, std::size_t count, std::size_t stride,
                   std::size_t dimension) {
    const auto* real = static_cast<const Real*>(values);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t axis = 0; axis < dimension; ++axis)
            if (!std::isfinite(real[i * stride + axis]))
                fail_at(member, i, "is not finite");
}

template <class Real>
void check_positive(const char* member, const void* values, std::size_t count) {
    const auto* real = static_cast<const Real*>(values);
    for (std::size_t i = 0; real != nullptr && i < count; ++i)
        if (!is_positive(static_cast<double>(real[i])))
            fail_at(member, i, "is not positive and finite");
}

/// Throws where Real cannot tell a position from its neighbors'.
template <class Real>
void check_distances(const meniscus_particles& particles, std::size_t stride,
                     std::size_t dimension) {
    const auto* positions = static_cast<const Real*>(particles.positions);
    const auto* radii = static_cast<const Real*>(particles.support_radii);
    for (std::size_t i = 0; i < particles.count; ++i) {
        const double radius =
            radii != nullptr ? static_cast<double>(radii[i]) : particles.support_radius;
        if (position_step(positions + i * stride, static_cast<int>(dimension), radius,
                          std::numeric_limits<Real>::digits) >= coarsest_position_step)
            fail_at("positions", i,
                    "lies so far from the origin that the number type cannot tell it from "
                    "neighbors at its support radius");
    }
}

template <class Offset>
void check_rows(const char* member, const void* offsets, const std::uint32_t* neighbors,
                std::size_t count, std::size_t others) {
    const auto* row = static_cast<const Offset*>(offsets);
    for (std::size_t i = 0; i < count; ++i) {
        if (row[i + 1] < row[i])
            fail_at(member, i + 1, "is smaller than the one before");
        for (Offset n = row[i]; n < row[i + 1]; ++n)
            if (neighbors[n] >= others)
                fail_at(member, i, "begins neighbors of which one does not exist");
    }
}

void check_rows(const char* member, int bits, const void* offsets, const std::uint32_t* neighbors,
                std::size_t count, std::size_t others) {
    if (bits == 64)
        check_rows<std::uint64_t>(member, offsets, neighbors, count, others);
    else
        check_rows<std::uint32_t>(member, offsets, neighbors, count, others);
}

template <class Real>
void check_contents(const meniscus_particles& particles, std::size_t dimension) {
    const std::size_t count = particles.count;
    const std::size_t stride = particles.stride != 0 ? particles.stride : dimension;
    check_vectors<Real>("positions", particles.positions, count, stride, dimension);
    check_positive<Real>("masses", particles.masses, count);
    check_positive<Real>("support_radii", particles.support_radii, count);
    check_distances<Real>(particles, stride, dimension);
    if (count > 0)
        check_rows("offsets", particles.offset_bits, particles.offsets, particles.neighbors, count,
                   count);
    if (count == 0 || particles.boundary_positions == nullptr)
        return;
    check_vectors<Real>("boundary_positions", particles.boundary_positions,
                        particles.boundary_count, stride, dimension);
    check_positive<Real>("boundary_weights", particles.boundary_weights, particles.boundary_count);
    for (std::size_t b = 0;
         particles.boundary_contact_angles != nullptr && b < particles.boundary_count; ++b)
        if (!is_in_range(option_ranges::contact_angle,
                         static_cast<double>(particles.boundary_contact_angles[b])))
            fail_at("boundary_contact_angles", b, "must be between 10 and 170 degrees");
    check_rows("boundary_offsets", particles.offset_bits, particles.boundary_offsets,
               particles.boundary_neighbors, count, particles.boundary_count);
}

/// Calls act(float or double), which says what the arrays of a handle hold.
template <class Act>
void with_real(const meniscus_surface& surface, const Act& act) {
    if (surface.is_double)
        act(double{});
    else
        act(float{});
}

std::size_t checked_stride(const meniscus_surface& surface, std::size_t stride) {
    demand(stride == 0 || stride >= surface.dimension, "stride is less than the dimension");
    return stride != 0 ? stride : surface.dimension;
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

template <class Real>
void add_accelerations(const SurfaceStepResults& found, std::size_t dimension, const Real* masses,
                       Real mass, Real* accelerations, std::size_t stride) {
    const auto* forces = static_cast<const Real*>(found.force);
    for (std::size_t slot = 0; slot < found.slots; ++slot) {
        const std::size_t i = found.particle[slot];
        const Real of_particle = masses != nullptr ? masses[i] : mass;
        for (std::size_t axis = 0; axis < dimension; ++axis)
            accelerations[i * stride + axis] += forces[slot * dimension + axis] / of_particle;
    }
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
            new meniscus_surface{std::move(step), static_cast<std::size_t>(dimension), is_double};
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
        demand(is_positive(time_step), "time_step must be positive and finite");
        demand(is_positive(sampling_density), "sampling_density must be positive and finite");
        check_sample_count("minimum", minimum);
        surface->step->set_samples(samples_for_time_step(time_step, sampling_density, minimum));
    });
}

int meniscus_set_line(meniscus_surface* surface, double k, double d) {
    return changing(surface, [&] {
        check_option("k", option_ranges::line, k);
        check_option("d", option_ranges::line, d);
        surface->step->set_line(k, d);
    });
}

int meniscus_step(meniscus_surface* surface, const meniscus_particles* particles) {
    return changing(surface, [&] {
        check_particles(*surface, particles);
        surface->step->step(step_particles(*particles));
    });
}

int meniscus_check(const meniscus_surface* surface, const meniscus_particles* particles) {
    return guarded([&] {
        check_surface(surface);
        check_particles(*surface, particles);
        with_real(*surface, [&](auto real) {
            check_contents<decltype(real)>(*particles, surface->dimension);
        });
        surface->step->check(step_particles(*particles));
    });
}

int meniscus_balance_momentum(meniscus_surface* surface, const meniscus_particles* particles) {
    return changing(surface, [&] {
        check_particles(*surface, particles);
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
        const std::size_t step = checked_stride(*surface, stride);
        const auto found = surface->step->results();
        scatter<std::uint8_t>(found, found.surface_class, 1, surface_class, 1);
        with_real(*surface, [&](auto real) {
            using Real = decltype(real);
            scatter<Real>(found, found.uncovered_fraction, 1, uncovered_fraction, 1);
            scatter<Real>(found, found.normal, surface->dimension, normal, step);
            scatter<Real>(found, found.curvature, 1, curvature, 1);
            scatter<Real>(found, found.force, surface->dimension, force, step);
        });
    });
}

int meniscus_add_accelerations(const meniscus_surface* surface, const void* masses, double mass,
                               void* accelerations, size_t stride) {
    return guarded([&] {
        check_surface(surface);
        const std::size_t step = checked_stride(*surface, stride);
        const auto found = surface->step->results();
        if (found.count == 0)
            return;
        demand(accelerations != nullptr, "accelerations is NULL");
        demand(masses != nullptr || is_positive(mass),
               "mass must be positive and finite, where masses is NULL");
        with_real(*surface, [&](auto real) {
            using Real = decltype(real);
            add_accelerations(found, surface->dimension, static_cast<const Real*>(masses),
                              static_cast<Real>(mass), static_cast<Real*>(accelerations), step);
        });
    });
}
