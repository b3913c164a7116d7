// The directions in which normals are sampled, scheme by scheme, as the runtime takes them. All but
// its own outward ones lie as they are, turned with no particle.
#pragma once

#include "normal_cases.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace meniscus {

/// Sets of `samples` directions of a scheme of the labeler, each with a seed of its own.
void fill_from_scheme(const std::string& scheme, int dimension, std::size_t samples,
                      std::uint64_t seed, SampleDirections& directions);

/// Random directions in place of the first set, a stream of its own for each slot: what the 2019
/// preprint draws for each particle and step.
template <int Dimension>
void draw_directions(std::uint64_t seed, std::size_t slot, SampleDirections& directions) {
    RandomDirections random(seed, slot);
    std::array<double, Dimension> direction{};
    for (std::size_t k = 0; k < directions.stride; ++k) {
        if (k < directions.samples) // the rest are copies of the last
            direction = random.next<Dimension>();
        directions.x[k] = static_cast<float>(direction[0]);
        directions.y[k] = static_cast<float>(direction[1]);
        if constexpr (Dimension == 3)
            directions.z[k] = static_cast<float>(direction[2]);
    }
}

/// A loop over the slots from `begin` to `end`, or to their last, that draws new directions before
/// each. `directions` must be what is sampled from, and hold one set.
template <int Dimension>
struct RandomEachTime {
    std::uint64_t seed;
    SampleDirections& directions;
    std::size_t begin = 0;
    std::size_t end = std::numeric_limits<std::size_t>::max();

    [[nodiscard]] static int workers() { return 1; }

    template <class Body>
    void operator()(std::size_t count, Body&& body) const {
        for (std::size_t slot = begin; slot < std::min(end, count); ++slot) {
            draw_directions<Dimension>(seed, slot, directions);
            body(slot, slot + 1, 0);
        }
    }
};

/// One way to find normals: how its directions are made, once, and how the candidates of a case are
/// sampled in them.
struct NormalScheme {
    std::string name;
    std::function<void(std::size_t samples, std::uint64_t seed, SampleDirections&)> fill;
    std::function<void(const NormalCase&, std::uint64_t seed, SampleDirections&,
                       SurfaceParticles<double, 3>&)>
        expose;
    CoverageMethod method = CoverageMethod::sampled;
};

/// Those that are compared in three dimensions. Whatever the directions, the exact test decides
/// about particles that no sample finds uncovered.
const std::vector<NormalScheme>& normal_schemes();

/// The scheme of that name, which must be one of them.
const NormalScheme& normal_scheme(const std::string& name);

} // namespace meniscus
