// A labelled snapshot small enough to work out by hand.
#pragma once

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/math/angles.hpp>

#include <limits>

namespace meniscus::test {

/// Five particles in a row, half a support radius apart, one far away and one that is not valid.
/// With h = 1 the row has 1 2 2 2 1 neighbors, at mass offsets 0.5 0 0 0 0.5.
inline Snapshot chain() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Snapshot snapshot;
    snapshot.positions = {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0},  {1.5, 0, 0},
                          {2, 0, 0}, {10, 0, 0},  {nan, 0, 0}};
    snapshot.support_radius = 1;
    snapshot.particle_volume = 0.125; // h is two spacings of particles at rest
    snapshot.scene = "chain";
    snapshot.provenance["radius_ratio"] = "0.8";
    snapshot.provenance["boundary_weight"] = "0";
    set_array(snapshot,
              {"uncovered_fraction", 1, std::vector<double>{0.3, 0.005, 0.01, 0, 0, 1, 0}});
    set_array(snapshot, {"valid", 1, std::vector<std::uint8_t>{1, 1, 1, 1, 1, 1, 0}});
    set_array(snapshot, {"mass_offset", 1, std::vector<double>{0.5, 0, 0, 0, 0.5, 0, 0}});
    set_array(snapshot, {"neighbor_count", 1, std::vector<std::uint32_t>{1, 2, 2, 2, 1, 0, 0}});
    return snapshot;
}

/// With it a boundary particle that is alone, of volume pi / 8 h^3, counts as one of the chain.
inline constexpr double weight_of_one = 1 / pi;

/// The same between two walls that count, half a support radius off its ends: 2 2 2 2 2 neighbors
/// at no mass offset.
inline Snapshot chain_between_walls() {
    Snapshot snapshot = chain();
    snapshot.boundary = {{-0.5, 0, 0}, {2.5, 0, 0}};
    snapshot.provenance["boundary_weight"] = number_text(weight_of_one);
    set_array(snapshot, {"mass_offset", 1, std::vector<double>{0, 0, 0, 0, 0, 0, 0}});
    set_array(snapshot, {"neighbor_count", 1, std::vector<double>{2, 2, 2, 2, 2, 0, 0}});
    return snapshot;
}

/// Takes the ends of the row and the particle far away for surface.
inline Model chain_model() {
    Model model;
    model.line = {1, 1};
    model.objective = "by hand";
    return model;
}

} // namespace meniscus::test
