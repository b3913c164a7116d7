// Surface tension in a step (runtime/surface/surface_tension.hpp) behind one class without
// templates, compiled for several instruction sets (surface_step_kernel.cpp), of which the best is
// picked at run time. All give the same bits. For programs of C++ that are built for every machine,
// and for bindings. What goes in and out is plain data that means the same whatever the instruction
// set.
#pragma once

#include "host_threads.hpp"

#include <meniscus/runtime/simd/dispatch.hpp>
#include <meniscus/runtime/surface/surface_options.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace meniscus {

/// What a step works with, besides its options.
struct StepSetup {
    int dimension = 3;     ///< 2 or 3
    bool is_double = true; ///< number type of all arrays of reals that go in and out; else float
    int threads = 0;       ///< 0: all that OpenMP offers, at most max_threads
};

/// The particles of one step, all of one phase or with lists that hold neighbors of the same phase
/// alone. Lists are compressed rows: the neighbors of i are neighbors[offsets[i]] to
/// neighbors[offsets[i + 1] - 1], symmetric. They may hold i itself and particles beyond its
/// support radius.
struct StepParticles {
    std::size_t count = 0;               ///< below 2^31
    const void* positions = nullptr;     ///< real, `stride` values each, coordinates first, m
    std::size_t stride = 0;              ///< 0: as many as there are dimensions
    const void* masses = nullptr;        ///< real, kg; nullptr where all are equal
    double support_radius = 0;           ///< h in m, where support_radii is nullptr
    const void* support_radii = nullptr; ///< real, one a particle, m
    const std::uint32_t* ids = nullptr;  ///< one of its own each, where the host sorts them
    const void* offsets = nullptr;       ///< count + 1, ascending
    const std::uint32_t* neighbors = nullptr;
    bool wide_offsets = true; ///< offsets and boundary_offsets are uint64_t, else uint32_t
    // Boundary particles cover, count where the options say so, and fluid that has one within h
    // touches a wall.
    const void* boundary_positions = nullptr; ///< real, `stride` values each; nullptr: none
    std::size_t boundary_count = 0;           ///< needed with walls alone
    const void* boundary_offsets = nullptr;
    const std::uint32_t* boundary_neighbors = nullptr; ///< around each fluid particle
    /// real, how many fluid particles each stands for (runtime/neighbors/boundary.hpp); nullptr: 1
    const void* boundary_weights = nullptr;
    const float* boundary_contact_angles = nullptr; ///< degrees; nullptr: that of the options
    /// Walls that are not particles (runtime/neighbors/wall_planes.hpp): wall_count of them for
    /// each fluid particle.
    std::size_t wall_count = 0;
    const void* wall_distances = nullptr;       ///< real, wall_count a particle, m
    const void* wall_normals = nullptr;         ///< real, wall_count vectors a particle, not padded
    const float* wall_contact_angles = nullptr; ///< wall_count, degrees; nullptr: of the options
    /// The host's own classification: not 0 for what the first line lets through. nullptr: the line
    /// decides.
    const std::uint8_t* candidates = nullptr;
};

/// What the last step found, in slots: one for each particle that the line let through, in the
/// order of particles. Pointers hold until the next call that changes the step.
struct SurfaceStepResults {
    std::size_t slots;
    std::size_t count;                 ///< particles of the step
    const std::uint32_t* particle;     ///< of each slot
    const std::int32_t* slot_of;       ///< of each particle; -1: interior
    const std::uint8_t* surface_class; ///< of each slot: 1 covered, 2 surface
    const void* uncovered_fraction;    ///< real, lambda
    const void* normal;                ///< real, `dimension` values each, out of the fluid
    const void* curvature;             ///< real, mean curvature in 1/m
    const void* force;                 ///< real, `dimension` values each, N
};

/// One fluid and its memory; for one caller at a time. Particles are not checked, but for support
/// radii that the number type cannot calculate with, which throw std::invalid_argument. Hosts may
/// trap floating-point exceptions.
class SurfaceStep {
public:
    virtual ~SurfaceStep() = default;

    /// As the members of SurfaceTension of the same names do.
    virtual void reserve(std::size_t particles, std::size_t neighbors) = 0;
    virtual void set_samples(std::size_t samples) = 0;
    virtual void set_line(double k, double d) = 0;
    virtual void set_surface_tension(double sigma) = 0;
    virtual void set_contact_angle(double angle) = 0;
    virtual void set_fade(double fade) = 0;
    virtual void set_smoothing(int normal_passes, int curvature_passes) = 0;
    virtual void step(const StepParticles& particles) = 0;
    /// Throws std::invalid_argument as check_lists(), check_support_radius() and
    /// check_spacing_ratio() do (runtime/features/check_neighborhood.hpp).
    virtual void check(const StepParticles& particles) const = 0;
    /// After a step, with the same particles.
    virtual void balance_momentum(const StepParticles& particles) = 0;
    [[nodiscard]] virtual SurfaceStepResults results() const = 0;
};

/// The one for this machine, of no wider instruction set than `widest`. Throws
/// std::invalid_argument, naming it and its range, where an option or a part of the setup is out of
/// range; std::runtime_error where so many threads cannot be started.
std::unique_ptr<SurfaceStep> surface_step(const SurfaceTensionOptions& options,
                                          const StepSetup& setup,
                                          InstructionSet widest = widest_instruction_set);
MENISCUS_KERNEL(std::unique_ptr<SurfaceStep>, surface_step, const SurfaceTensionOptions& options,
                const StepSetup& setup);

} // namespace meniscus
