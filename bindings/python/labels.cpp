// Ground truth: neighbor lists, features and labels.
#include "module.hpp"
#include "snapshots.hpp"

#include <pybind11/stl.h>

#include <meniscus/bindings/step/surface_step.hpp>
#include <meniscus/classifier/model/classify_snapshot.hpp>
#include <meniscus/data/particles/feature_names.hpp>
#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/labeler/labeler.hpp>
#include <meniscus/labeler/sampling/directions.hpp>

#include <algorithm>

namespace meniscus {
namespace {

using namespace py::literals;

/// What `work` returns, done without the interpreter's lock.
template <class Work>
auto unlocked(const Work& work) {
    const py::gil_scoped_release released;
    return work();
}

py::tuple neighbors(const py::object& object, bool skip_invalid, int threads) {
    const Snapshot snapshot = snapshot_from_python(object);
    NeighborLists lists = unlocked([&] {
        const SupportRadii radii = support_radii(snapshot);
        const auto valid = checked_positions(snapshot, radii, skip_invalid);
        const auto phases = integer_values(snapshot, "phase", valid);
        return find_neighbors(snapshot.positions, radii,
                              {&valid, phases.empty() ? nullptr : &phases}, threads);
    });
    return py::make_tuple(array_of(std::move(lists.offsets)), array_of(std::move(lists.neighbors)));
}

py::tuple boundary_neighbors(const py::object& object, bool skip_invalid, int threads) {
    const Snapshot snapshot = snapshot_from_python(object);
    NeighborLists lists = unlocked([&] {
        const SupportRadii radii = support_radii(snapshot);
        const auto valid = checked_positions(snapshot, radii, skip_invalid);
        return find_boundary_neighbors(snapshot, radii, valid, threads);
    });
    lists.offsets.resize(snapshot.size() + 1); // of no boundary it is a single one
    return py::make_tuple(array_of(std::move(lists.offsets)), array_of(std::move(lists.neighbors)));
}

/// Of the surface particles three values each, zeros for others: from the uncovered part of the
/// sphere in closed form, as the runtime finds them, but not smoothed.
std::vector<double> surface_normals(const Snapshot& snapshot, const SupportRadii& radii,
                                    const Labels& labels, const LabelOptions& given) {
    const auto fluid = find_neighborhoods(snapshot, radii, labels.valid, 0, given.threads);
    const auto walls = find_boundary_neighbors(snapshot, radii, labels.valid, given.threads);
    SurfaceTensionOptions options;
    options.k = options.d = 0; // the labels decide
    options.coverage = CoverageMethod::exact;
    options.radius_ratio = given.radius_ratio;
    options.normal_passes = 0;
    StepParticles particles;
    particles.count = snapshot.size();
    particles.positions = snapshot.positions.data();
    particles.stride = 3;
    particles.support_radius = radii.max;
    particles.support_radii = radii.vary() ? radii.each.data() : nullptr;
    particles.offsets = fluid.lists.offsets.data();
    particles.neighbors = fluid.lists.neighbors.data();
    particles.candidates = labels.surface.data();
    if (!snapshot.boundary.empty()) {
        particles.boundary_positions = snapshot.boundary.data();
        particles.boundary_offsets = walls.offsets.data();
        particles.boundary_neighbors = walls.neighbors.data();
    }
    const auto step = surface_step(options, {snapshot.dimension, true, given.threads});
    step->step(particles);
    const SurfaceStepResults found = step->results();
    const auto axes = static_cast<std::size_t>(snapshot.dimension);
    const auto* of_slots = static_cast<const double*>(found.normal);
    std::vector<double> normals(3 * snapshot.size());
    for (std::size_t slot = 0; slot < found.slots; ++slot)
        std::copy_n(of_slots + slot * axes, axes, &normals[3 * std::size_t{found.particle[slot]}]);
    return normals;
}

LabelOptions label_options(const py::dict& given) {
    LabelOptions options;
    options.method = given["exact"].cast<bool>() ? LabelMethod::exact : LabelMethod::monte_carlo;
    options.samples = given["samples"].cast<std::size_t>();
    options.scheme = given["scheme"].cast<std::string>();
    options.seed = given["seed"].cast<std::uint64_t>();
    options.radius_ratio = given["radius_ratio"].cast<double>();
    options.boundary_weight = given["boundary_weight"].cast<double>();
    for (const auto& name : given["features"].cast<std::vector<std::string>>())
        options.features.push_back(feature_named(name));
    options.skip_invalid = given["skip_invalid"].cast<bool>();
    options.threads = given["threads"].cast<int>();
    return options;
}

/// By name; those of the paper as they are stored, from sums of their own.
py::dict feature_arrays(const Labels& labels, const LabelOptions& options) {
    py::dict features;
    for (std::size_t f = 0; f < options.features.size(); ++f) {
        const std::size_t feature = options.features[f];
        std::vector<double> values = feature == FeaturePair{}.first    ? labels.mass_offset
                                     : feature == FeaturePair{}.second ? labels.neighbor_count
                                                                       : labels.features[f];
        features[feature_list[feature].name] = array_of(std::move(values));
    }
    return features;
}

py::dict label(const py::object& object, const py::dict& given, bool wants_normals) {
    Snapshot snapshot = snapshot_from_python(object);
    const LabelOptions options = label_options(given);
    std::vector<double> normals;
    Labels labels = unlocked([&] {
        const SupportRadii radii = support_radii(snapshot);
        Labels made = label_particles(snapshot, radii, options);
        if (wants_normals)
            normals = surface_normals(snapshot, radii, made, options);
        add_labels(snapshot, made, radii, options);
        return made;
    });
    const double mean = mean_neighbor_count(labels);
    const py::dict features = feature_arrays(labels, options);
    py::object normal = py::none();
    if (wants_normals)
        normal = array_of(std::move(normals), 3);
    return py::dict("uncovered_fraction"_a = array_of(std::move(labels.uncovered_fraction)),
                    "surface"_a = array_of(std::move(labels.surface)),
                    "valid"_a = array_of(std::move(labels.valid)),
                    "mass_offset"_a = array_of(std::move(labels.mass_offset)),
                    "neighbor_count"_a = array_of(std::move(labels.neighbor_count)),
                    "features"_a = features, "normal"_a = normal,
                    "spacing_ratio"_a = labels.spacing_ratio,
                    "snapshot"_a = snapshot_to_python(std::move(snapshot)),
                    "mean_neighbor_count"_a = mean, "warnings"_a = labels.warnings);
}

/// The labeler's own pass, so that the values are those that it stores.
py::dict features(const py::object& object, const py::dict& given) {
    const Snapshot snapshot = snapshot_from_python(object);
    LabelOptions options = label_options(given);
    options.method = LabelMethod::features_only;
    const Labels labels =
        unlocked([&] { return label_particles(snapshot, support_radii(snapshot), options); });
    return feature_arrays(labels, options);
}

} // namespace

void add_labels(py::module_& module) {
    module.def("neighbors", neighbors);
    module.def("boundary_neighbors", boundary_neighbors);
    module.def("label", label);
    module.def("features", features);
    module.def("plausible_neighbor_counts", plausible_neighbor_counts);
    module.attr("sampling_schemes") = sampling_scheme_names();
    py::dict meanings;
    for (const FeatureRow& row : feature_list)
        meanings[row.name] = row.meaning;
    module.attr("feature_meanings") = meanings;
}

} // namespace meniscus
