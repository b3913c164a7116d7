// Surface tension in a step, compiled for each instruction set.
#include "surface_step.hpp"

#include <meniscus/runtime/simd/begin_kernel.hpp>

#include <meniscus/runtime/features/check_neighborhood.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Offsets of either width and the indices that they cut into rows.
struct HostRows {
    const void* offsets;
    bool wide; ///< 64 bits an offset
    const std::uint32_t* neighbors;

    [[nodiscard]] std::size_t begin(std::size_t i) const {
        return wide ? static_cast<std::size_t>(static_cast<const std::uint64_t*>(offsets)[i])
                    : static_cast<const std::uint32_t*>(offsets)[i];
    }
};

/// View over the lists of the fluid, in a stride known at run time.
template <class Real, int Dimension>
struct HostLists {
    const Real* positions; ///< of the particles in the rows
    std::size_t stride;
    const Real* masses;
    HostRows rows;
    const Real* centers; ///< positions of the particles that have the rows

    template <class Visit>
    void operator()(std::size_t i, Visit&& visit) const {
        const Real* center = centers + i * stride;
        const std::size_t end = rows.begin(i + 1);
        for (std::size_t n = rows.begin(i); n < end; ++n) {
            const std::size_t j = rows.neighbors[n];
            std::array<Real, Dimension> displacement;
            for (int axis = 0; axis < Dimension; ++axis)
                displacement[axis] = positions[j * stride + axis] - center[axis];
            visit(j, displacement, masses != nullptr ? masses[j] : Real(1));
        }
    }
};

template <class Offset, int Stride, class Real, int Dimension>
CsrNeighborhood<Real, Dimension, Stride, Offset> as_csr(const HostLists<Real, Dimension>& view) {
    return {view.positions, view.masses, static_cast<const Offset*>(view.rows.offsets),
            view.rows.neighbors};
}

/// The features by the fast pass over compressed rows, in the strides that it is compiled for.
template <class Real, int Dimension>
FeatureSum<Real, Dimension> sum_features(const HostLists<Real, Dimension>& view, std::size_t i,
                                         const NeighborRange<Real>& range) {
    const bool wide = view.rows.wide;
    switch (view.stride) {
    case Dimension:
        return wide ? sum_features(as_csr<std::uint64_t, Dimension>(view), i, range)
                    : sum_features(as_csr<std::uint32_t, Dimension>(view), i, range);
    case Dimension + 1: // padded, or a plane in three dimensions
        return wide ? sum_features(as_csr<std::uint64_t, Dimension + 1>(view), i, range)
                    : sum_features(as_csr<std::uint32_t, Dimension + 1>(view), i, range);
    default:
        return sum_features_reference<Real, Dimension>(view, i, range);
    }
}

/// View over the boundary, which may be none: known at run time only. Weights take the place of
/// masses.
template <class Real, int Dimension>
struct HostBoundary {
    static constexpr bool is_there = true;
    HostLists<Real, Dimension> lists;
    const float* contact_angles;

    template <class Visit>
    void operator()(std::size_t i, Visit&& visit) const {
        if (lists.rows.offsets != nullptr)
            lists(i, visit);
    }
};

template <class Real, int Dimension>
double contact_angle_at(const HostBoundary<Real, Dimension>& boundary, std::size_t b,
                        double usual) {
    return boundary.contact_angles != nullptr ? static_cast<double>(boundary.contact_angles[b])
                                              : usual;
}

template <class Real, int Dimension>
class SurfaceStepKernel final : public SurfaceStep {
public:
    SurfaceStepKernel(const SurfaceTensionOptions& options, int threads)
        : tension(options), loop{threads > 0 ? threads : omp_get_max_threads()} {}

    void reserve(std::size_t particles, std::size_t neighbors) override {
        tension.reserve(particles, neighbors, loop.workers());
        row_lengths.reserve(particles);
        packed.reserve(particles * Dimension);
    }

    void set_samples(std::size_t samples) override { tension.set_samples(samples); }

    void set_line(double k, double d) override { tension.set_line({k, d}); }

    void step(const StepParticles& particles) override {
        with_radii(particles, [&](const auto& radii) { step_with(particles, radii); });
    }

    void check(const StepParticles& particles) const override {
        with_radii(particles, [&](const auto& radii) {
            const Lists view = fluid(particles);
            check_lists<Real, Dimension>(view, particles.count, radii);
            check_spacing_ratio<Real, Dimension>(view, particles.count, radii,
                                                 tension.options().spacing_ratio);
        });
    }

    void balance_momentum(const StepParticles& particles) override {
        with_radii(particles, [&](const auto& radii) {
            tension.template balance_momentum<Dimension>(fluid(particles), boundary(particles),
                                                         radii, packed_positions(particles), loop);
        });
    }

    [[nodiscard]] SurfaceStepResults results() const override {
        const auto& found = tension.surface();
        static_assert(sizeof(SurfaceClass) == 1);
        return {found.size(),
                found.slot_of.size(),
                found.particle.data(),
                found.slot_of.data(),
                reinterpret_cast<const std::uint8_t*>(found.surface_class.data()),
                found.uncovered_fraction.data(),
                found.normal.data(),
                found.curvature.data(),
                found.force.data()};
    }

private:
    using Lists = HostLists<Real, Dimension>;

    SurfaceTension<Real, Dimension> tension;
    OpenMpLoop loop;
    std::vector<std::uint32_t> row_lengths; ///< of each particle
    std::vector<Real> packed;               ///< positions without padding

    static std::size_t stride_of(const StepParticles& particles) {
        return particles.stride != 0 ? particles.stride : Dimension;
    }

    static Lists fluid(const StepParticles& particles) {
        const auto* positions = static_cast<const Real*>(particles.positions);
        return {positions, stride_of(particles), static_cast<const Real*>(particles.masses),
                HostRows{particles.offsets, particles.wide_offsets, particles.neighbors},
                positions};
    }

    static HostBoundary<Real, Dimension> boundary(const StepParticles& particles) {
        const void* offsets =
            particles.boundary_positions != nullptr ? particles.boundary_offsets : nullptr;
        return {Lists{static_cast<const Real*>(particles.boundary_positions), stride_of(particles),
                      static_cast<const Real*>(particles.boundary_weights),
                      HostRows{offsets, particles.wide_offsets, particles.boundary_neighbors},
                      static_cast<const Real*>(particles.positions)},
                particles.boundary_contact_angles};
    }

    template <class Do>
    static void with_radii(const StepParticles& particles, const Do& act) {
        if (particles.support_radii != nullptr)
            act(VaryingRadii<Real>{static_cast<const Real*>(particles.support_radii)});
        else
            act(UniformRadius<Real>{static_cast<Real>(particles.support_radius)});
    }

    template <class Radii>
    void step_with(const StepParticles& particles, const Radii& radii) {
        const Lists view = fluid(particles);
        const auto walls = boundary(particles);
        if (particles.candidates != nullptr) {
            row_lengths.resize(particles.count); // no particle has more neighbors than that
            for (std::size_t i = 0; i < particles.count; ++i)
                row_lengths[i] =
                    static_cast<std::uint32_t>(view.rows.begin(i + 1) - view.rows.begin(i));
            tension.step(view, walls, particles.count, radii, particles.ids, particles.candidates,
                         row_lengths.data(), loop);
        } else {
            tension.step(view, walls, particles.count, radii, particles.ids, loop);
        }
    }

    const Real* packed_positions(const StepParticles& particles) {
        const auto* positions = static_cast<const Real*>(particles.positions);
        const std::size_t stride = stride_of(particles);
        if (stride == Dimension)
            return positions;
        packed.resize(particles.count * Dimension);
        for (std::size_t i = 0; i < particles.count; ++i)
            std::copy_n(positions + i * stride, Dimension, packed.data() + i * Dimension);
        return packed.data();
    }
};

template <class Real>
std::unique_ptr<SurfaceStep> make_surface_step(const SurfaceTensionOptions& options,
                                               const StepSetup& setup) {
    if (setup.dimension == 2)
        return std::unique_ptr<SurfaceStep>(new SurfaceStepKernel<Real, 2>(options, setup.threads));
    return std::unique_ptr<SurfaceStep>(new SurfaceStepKernel<Real, 3>(options, setup.threads));
}

} // namespace MENISCUS_INSTRUCTION_SET

std::unique_ptr<SurfaceStep> surface_step(MENISCUS_KERNEL_SET, const SurfaceTensionOptions& options,
                                          const StepSetup& setup) {
    return setup.is_double ? make_surface_step<double>(options, setup)
                           : make_surface_step<float>(options, setup);
}

} // namespace meniscus

#include <meniscus/runtime/simd/end_kernel.hpp>
