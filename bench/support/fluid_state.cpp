#include "fluid_state.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/labeler/labeler.hpp>
#include <meniscus/runtime/math/cubic_spline.hpp>

#include <algorithm>

namespace meniscus {
namespace {

double median_volume(const Snapshot& snapshot, const NeighborLists& lists, double h) {
    const double scale = snapshot.dimension == 2 ? cubic_spline_scale<2> : cubic_spline_scale<3>;
    std::vector<double> sums(snapshot.size(), scale * cubic_spline(0.0));
    const CsrNeighborhood<double, 3> view{snapshot.positions[0].data(), nullptr,
                                          lists.offsets.data(), lists.neighbors.data()};
    for (std::size_t i = 0; i < snapshot.size(); ++i)
        view(i, [&](std::size_t, const auto& step, double) {
            const double distance = std::sqrt(squared_length<double, 3>(step)) / h;
            sums[i] += scale * cubic_spline(distance);
        });
    const auto middle = sums.begin() + static_cast<std::ptrdiff_t>(sums.size() / 2);
    std::nth_element(sums.begin(), middle, sums.end());
    return (snapshot.dimension == 2 ? h * h : h * h * h) / *middle;
}

/// Throws InputError where a snapshot cannot be compared on.
void check_state(const Snapshot& snapshot, const std::string& name) {
    if (snapshot.size() == 0)
        throw InputError(name + ": has no particles, so there is nothing to compare on it");
    if (!snapshot.support_radius)
        throw InputError(name + ": stores no support radius that serves all particles, which a "
                                "comparison needs; `meniscus label --support-radius H` stores one");
    const auto finite = finite_positions(snapshot);
    const auto first = std::find(finite.begin(), finite.end(), 0);
    if (first != finite.end())
        throw InputError(name + ": particle " + std::to_string(first - finite.begin()) +
                         " has a position that is not finite; a comparison needs files without "
                         "such particles");
}

/// Exact labels of the fluid alone; errors name the state.
Labels exact_labels_of(const Snapshot& snapshot, const std::string& name) {
    Snapshot fluid = snapshot;
    fluid.boundary.clear();
    try {
        return label_particles(fluid, *snapshot.support_radius, {});
    } catch (const InputError& error) {
        throw InputError(name + ": " + error.what());
    }
}

template <class Real>
FluidState<Real> state_of(const Snapshot& snapshot, const std::filesystem::path& file) {
    auto state = fluid_state<Real>(snapshot, file.string());
    state.name = file.stem().string();
    state.scene = scene_of(snapshot, file);
    return state;
}

} // namespace

template <class Real>
FluidState<Real> fluid_state(const Snapshot& snapshot, const std::string& name) {
    check_state(snapshot, name);
    const double h = *snapshot.support_radius;
    const Labels labels = exact_labels_of(snapshot, name);
    FluidState<Real> state;
    state.name = name;
    state.dimension = snapshot.dimension;
    state.lists = find_neighbors(snapshot.positions, h);
    state.support_radius = static_cast<Real>(h);
    state.spacing = h / labels.spacing_ratio;
    state.particle_volume = static_cast<Real>(median_volume(snapshot, state.lists, h));
    state.uncovered_fraction = labels.uncovered_fraction;
    state.surface = labels.surface;
    for (const auto& position : snapshot.positions)
        for (int axis = 0; axis < snapshot.dimension; ++axis)
            state.positions.push_back(static_cast<Real>(position[static_cast<std::size_t>(axis)]));
    return state;
}

template <class Real>
FluidState<Real> read_fluid_state(const std::filesystem::path& file) {
    return state_of<Real>(read_snapshot(file), file);
}

Snapshot read_snapshot_in_3d(const std::filesystem::path& file) {
    Snapshot snapshot = read_snapshot(file);
    check_state(snapshot, file.string());
    if (snapshot.dimension != 3)
        throw InputError(file.string() + ": is in 2D; this is measured on states in 3D");
    return snapshot;
}

template <class Real>
FluidState<Real> read_fluid_state_in_3d(const std::filesystem::path& file) {
    return state_of<Real>(read_snapshot_in_3d(file), file);
}

template FluidState<float> fluid_state(const Snapshot&, const std::string&);
template FluidState<double> fluid_state(const Snapshot&, const std::string&);
template FluidState<float> read_fluid_state(const std::filesystem::path&);
template FluidState<double> read_fluid_state(const std::filesystem::path&);
template FluidState<float> read_fluid_state_in_3d(const std::filesystem::path&);
template FluidState<double> read_fluid_state_in_3d(const std::filesystem::path&);

} // namespace meniscus
