#include "known_state.hpp"

namespace meniscus {

CloudOptions known_cloud(double jitter, double spacing_ratio) {
    CloudOptions options;
    options.support_radius = 1;
    options.spacing = 1 / spacing_ratio;
    options.jitter = jitter;
    options.seed = 1;
    return options;
}

template <class Real>
KnownState<Real> known_state(const std::string& name, const Shape& shape,
                             const CloudOptions& options) {
    KnownState<Real> known;
    known.cloud = fill(shape, options);
    Snapshot snapshot;
    snapshot.dimension = shape.dimension;
    snapshot.positions = known.cloud.positions;
    snapshot.support_radius = options.support_radius;
    snapshot.particle_spacing = options.spacing;
    known.state = fluid_state<Real>(snapshot, name);
    known.state.scene = name;
    return known;
}

template KnownState<float> known_state(const std::string&, const Shape&, const CloudOptions&);
template KnownState<double> known_state(const std::string&, const Shape&, const CloudOptions&);

bool is_outermost(const Cloud& cloud, std::size_t i) {
    // The outermost layer lies half a spacing deep, the next one and a half.
    constexpr double depth_in_spacings = 0.7;
    return cloud.trusted[i] != 0 && cloud.depth[i] < depth_in_spacings * cloud.spacing;
}

} // namespace meniscus
