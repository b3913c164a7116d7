// Small labelled states for tests: given particle by particle, or drawn at random.
#pragma once

#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <random>
#include <string>
#include <vector>

namespace meniscus::test {

struct LabelledParticle {
    double mass_offset;
    std::uint32_t neighbor_count;
    double uncovered_fraction;
};

inline LabelledState state_of(const std::string& scene,
                              const std::vector<LabelledParticle>& particles) {
    LabelledState state;
    state.file = scene + ".vtkhdf";
    state.scene = scene;
    state.support_radius = 0.1;
    state.radius_ratio = 0.8;
    state.spacing_ratio = 2;
    for (const LabelledParticle& particle : particles) {
        state.first.push_back(particle.mass_offset);
        state.neighbor_count.push_back(particle.neighbor_count);
        state.uncovered_fraction.push_back(particle.uncovered_fraction);
    }
    return state;
}

/// Two clouds of `particles` particles as real states have them: interior ones with many neighbors
/// all around, surface ones with fewer on one side. With `spread` 1 they overlap a little.
inline LabelledState two_clouds(const std::string& scene, std::size_t particles, double spread,
                                unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<LabelledParticle> drawn;
    for (std::size_t i = 0; i < particles; ++i) {
        const bool surface = i % 3 == 0;
        const double x =
            (surface ? 0.35 : 0.08) + (surface ? 0.06 : 0.02) * spread * normal(random);
        const double y = (surface ? 22 : 38) + (surface ? 4 : 2) * spread * normal(random);
        drawn.push_back({std::abs(x), static_cast<std::uint32_t>(std::max(1.0, y)),
                         surface ? 0.1 + 0.001 * static_cast<double>(i % 100) : 0});
    }
    return state_of(scene, drawn);
}

} // namespace meniscus::test
