// A fluid as the C interface takes it, for the tests.
#pragma once

#include <runtime/fluids.hpp>

#include <meniscus/bindings/step/surface_step.hpp>
#include <meniscus/meniscus.h>

#include <cstring>
#include <string>
#include <type_traits>

namespace meniscus {

template <class Real>
constexpr int precision_of = std::is_same_v<Real, double> ? MENISCUS_DOUBLE : MENISCUS_FLOAT;

/// Options of the interface that say what `options_for` says.
template <int Dimension>
meniscus_options host_options(bool paper = false) {
    meniscus_options options;
    (paper ? meniscus_options_paper : meniscus_options_init)(&options, sizeof options);
    const auto same = options_for<Dimension>();
    options.k = same.k;
    options.d = same.d;
    options.samples = same.samples;
    options.spacing_ratio = same.spacing_ratio;
    return options;
}

/// Arrays with a stride, and rows with offsets of either width.
template <class Real, int Dimension>
struct Host {
    std::size_t stride;
    std::size_t count;
    std::vector<Real> positions;
    std::vector<std::uint32_t> short_offsets;
    std::vector<std::uint64_t> long_offsets;
    std::vector<std::uint32_t> neighbors;
    Real radius;

    explicit Host(const Fluid<Real, Dimension>& fluid, std::size_t stride = Dimension)
        : stride(stride), count(fluid.size()), positions(count * stride, Real(1e9)),
          short_offsets(fluid.offsets.begin(), fluid.offsets.end()),
          long_offsets(fluid.offsets.begin(), fluid.offsets.end()), neighbors(fluid.neighbors),
          radius(fluid.radius) {
        for (std::size_t i = 0; i < count; ++i)
            for (int axis = 0; axis < Dimension; ++axis)
                positions[i * stride + axis] = fluid.positions[i][axis];
    }

    [[nodiscard]] meniscus_particles particles(int offset_bits = 64) const {
        meniscus_particles all{};
        all.size = sizeof all;
        all.count = count;
        all.positions = positions.data();
        all.stride = stride;
        all.support_radius = static_cast<double>(radius);
        all.offsets = offset_bits == 64 ? static_cast<const void*>(long_offsets.data())
                                        : static_cast<const void*>(short_offsets.data());
        all.neighbors = neighbors.data();
        all.offset_bits = offset_bits;
        return all;
    }

    [[nodiscard]] StepParticles step_particles() const {
        StepParticles all;
        all.count = count;
        all.positions = positions.data();
        all.stride = stride;
        all.support_radius = static_cast<double>(radius);
        all.offsets = long_offsets.data();
        all.neighbors = neighbors.data();
        return all;
    }
};

/// All that a step found, by value.
struct Found {
    std::vector<std::uint32_t> particle;
    std::vector<std::uint8_t> surface_class;
    std::string reals; ///< bytes of fraction, normal, curvature and force

    template <class Real, class Results>
    static Found of(const Results& results, std::size_t dimension) {
        const std::size_t slots = results.slots;
        Found found;
        found.particle.assign(results.particle, results.particle + slots);
        found.surface_class.assign(results.surface_class, results.surface_class + slots);
        const auto add = [&](const void* values, std::size_t components) {
            found.reals.append(static_cast<const char*>(values), slots * components * sizeof(Real));
        };
        add(results.uncovered_fraction, 1);
        add(results.normal, dimension);
        add(results.curvature, 1);
        add(results.force, dimension);
        return found;
    }

    bool operator==(const Found& other) const {
        return particle == other.particle && surface_class == other.surface_class &&
               reals == other.reals;
    }
};

} // namespace meniscus
