#include "classify_snapshot.hpp"

#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/runtime/features/classifier.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

/// The model's line, scaled to the state where it is relative.
template <class Real>
SurfaceLine<Real> line_for(const Model& model, const std::vector<double>& counts,
                           const std::vector<std::uint8_t>& valid) {
    if (model.reference_neighbor_count == 0)
        return {static_cast<Real>(model.line.k), static_cast<Real>(model.line.d)};
    std::vector<double> of_valid;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (valid[i] != 0)
            of_valid.push_back(counts[i]);
    return scaled_line<Real>(model.line.k, model.line.d,
                             median_neighbor_count(of_valid.data(), of_valid.size()),
                             model.reference_neighbor_count);
}

/// By a line in any two features, over UniformRadius or VaryingRadii.
template <class Real, int Dimension, class View, class Radii>
Predictions predict_by_features(const View& view, const Model& model, const Radii& radii,
                                std::size_t count) {
    const auto range = range_of(radii, model.radius_ratio);
    Predictions predictions;
    predictions.surface.resize(count);
    predictions.neighbor_count.resize(count);
    std::vector<FeatureNeighbor<Real, Dimension>> neighbors;
    const auto value = [&](std::size_t feature) {
        return feature_value<Real, Dimension>(feature, neighbors.data(), neighbors.size());
    };
    for (std::size_t i = 0; i < count; ++i) {
        neighbors.clear();
        view(i, [&](std::size_t j, const auto& displacement, Real mass) {
            visit_if_in_range<Dimension>(displacement, mass, i, j, radii, range,
                                         [&](const auto& one) { neighbors.push_back(one); });
        });
        predictions.neighbor_count[i] = static_cast<double>(value(FeaturePair{}.second));
        const bool surface =
            neighbors.empty() ||
            is_on_surface_side(value(model.features.first), value(model.features.second),
                               static_cast<Real>(model.line.k), static_cast<Real>(model.line.d),
                               model.line.above);
        predictions.surface[i] = static_cast<std::uint8_t>(surface);
    }
    return predictions;
}

/// Three values a particle.
template <class Real>
std::vector<Real> coordinates_of(const Positions& positions) {
    std::vector<Real> coordinates(positions.size() * 3);
    for (std::size_t i = 0; i < coordinates.size(); ++i)
        coordinates[i] = static_cast<Real>(positions[i / 3][i % 3]);
    return coordinates;
}

/// The view of a host with two point sets: the neighbors in the fluid, then those in the boundary.
/// These have no support radius of their own; as number j they are given particle i's, whose radius
/// then holds for the pair.
template <class Real, int Dimension>
struct FluidAndBoundary {
    CsrNeighborhood<Real, Dimension, 3> fluid;
    const Real* boundary;       ///< coordinates, as those of the fluid
    const NeighborLists& lists; ///< boundary neighbors of the fluid particles
    Real boundary_mass;         ///< kg; 0: that of particle i

    template <class Visit>
    void operator()(std::size_t i, Visit&& visit) const {
        fluid(i, visit);
        const Real* center = fluid.positions + 3 * i;
        const Real own_mass = fluid.masses != nullptr ? fluid.masses[i] : Real(1);
        for (std::size_t n = lists.offsets[i]; n < lists.offsets[i + 1]; ++n) {
            const Real* position = boundary + std::size_t{3} * lists.neighbors[n];
            std::array<Real, Dimension> displacement;
            for (int axis = 0; axis < Dimension; ++axis)
                displacement[axis] = position[axis] - center[axis];
            visit(i, displacement, boundary_mass == 0 ? own_mass : boundary_mass);
        }
    }
};

template <class Real, int Dimension, class View>
Predictions predict_over(const View& view, const Model& model, const Neighborhoods& neighborhoods) {
    if (!is_of_paper(model.features))
        return predict_by_features<Real, Dimension>(
            view, model, UniformRadius<Real>{static_cast<Real>(neighborhoods.radii.max)},
            neighborhoods.valid.size());
    const auto range = neighbor_range<Real>(neighborhoods.radii.max, model.radius_ratio);
    const auto support_radius = static_cast<Real>(neighborhoods.radii.max);
    const std::size_t count = neighborhoods.valid.size();
    Predictions predictions;
    predictions.surface.resize(count);
    predictions.neighbor_count.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        predictions.neighbor_count[i] = sum_features<Real, Dimension>(view, i, range).count;
    const auto line = line_for<Real>(model, predictions.neighbor_count, neighborhoods.valid);
    classify<Real, Dimension>(view, 0, count, support_radius, line, range,
                              predictions.surface.data());
    return predictions;
}

/// The same where radii vary.
template <class Real, int Dimension, class View>
Predictions predict_scaled(const View& view, const Model& model,
                           const Neighborhoods& neighborhoods) {
    const std::vector<Real> each(neighborhoods.radii.each.begin(), neighborhoods.radii.each.end());
    const VaryingRadii<Real> radii{each.data()};
    if (!is_of_paper(model.features))
        return predict_by_features<Real, Dimension>(view, model, radii, each.size());
    const auto range = neighbor_range<Real>(1, model.radius_ratio);
    Predictions predictions;
    predictions.surface.resize(each.size());
    for (std::size_t i = 0; i < each.size(); ++i)
        predictions.neighbor_count.push_back(
            static_cast<double>(sum_features<Real, Dimension>(view, i, radii, range).count));
    const auto line = line_for<Real>(model, predictions.neighbor_count, neighborhoods.valid);
    classify<Real, Dimension>(view, 0, each.size(), radii, line, model.radius_ratio,
                              predictions.surface.data());
    return predictions;
}

template <class Real, int Dimension>
Predictions predict_as(const Model& model, const Snapshot& snapshot,
                       const Neighborhoods& neighborhoods) {
    const auto coordinates = coordinates_of<Real>(snapshot.positions);
    const std::vector<Real> masses(neighborhoods.masses.begin(), neighborhoods.masses.end());
    const CsrNeighborhood<Real, Dimension, 3> fluid{
        coordinates.data(), masses.empty() ? nullptr : masses.data(),
        neighborhoods.lists.offsets.data(), neighborhoods.lists.neighbors.data()};
    const bool vary = neighborhoods.radii.vary();
    if (neighborhoods.boundary_lists.offsets.empty())
        return vary ? predict_scaled<Real, Dimension>(fluid, model, neighborhoods)
                    : predict_over<Real, Dimension>(fluid, model, neighborhoods);
    const auto boundary = coordinates_of<Real>(snapshot.boundary);
    const FluidAndBoundary<Real, Dimension> both{fluid, boundary.data(),
                                                 neighborhoods.boundary_lists,
                                                 static_cast<Real>(neighborhoods.boundary_mass)};
    return vary ? predict_scaled<Real, Dimension>(both, model, neighborhoods)
                : predict_over<Real, Dimension>(both, model, neighborhoods);
}

template <class Real>
Predictions predict_as(const Model& model, const Snapshot& snapshot,
                       const Neighborhoods& neighborhoods) {
    return snapshot.dimension == 2 ? predict_as<Real, 2>(model, snapshot, neighborhoods)
                                   : predict_as<Real, 3>(model, snapshot, neighborhoods);
}

/// Typical neighbor count of the particles taken for interior ones.
std::optional<double> interior_neighbor_count(const Classes& classes) {
    std::vector<double> counts;
    for (std::size_t i = 0; i < classes.surface.size(); ++i)
        if (classes.valid[i] != 0 && classes.surface[i] == 0)
            counts.push_back(classes.neighbor_count[i]);
    if (counts.empty())
        return {};
    return median_neighbor_count(counts.data(), counts.size());
}

} // namespace

NeighborLists find_boundary_neighbors(const Snapshot& snapshot, const SupportRadii& radii,
                                      const std::vector<std::uint8_t>& valid, int threads) {
    NeighborLists lists{{0}, {}};
    if (snapshot.boundary.empty())
        return lists;
    check_boundary(snapshot);
    const NeighborGrid grid(snapshot.boundary, radii.min, {}, threads);
    FoundNeighbors found;
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
        found.clear();
        if (valid[i] != 0)
            grid.find_around(snapshot.positions[i], radii.of(i), found);
        lists.neighbors.insert(lists.neighbors.end(), found.particles.begin(),
                               found.particles.end());
        lists.offsets.push_back(lists.neighbors.size());
    }
    return lists;
}

Neighborhoods find_neighborhoods(const Snapshot& snapshot, const SupportRadii& radii,
                                 const std::vector<std::uint8_t>& valid, bool boundary_counts,
                                 int threads) {
    const auto phases = integer_values(snapshot, "phase", valid);
    Neighborhoods result;
    result.masses = checked_masses(snapshot, valid);
    result.radii = radii;
    result.valid = valid;
    result.lists = find_neighbors(snapshot.positions, radii,
                                  {&valid, phases.empty() ? nullptr : &phases}, threads);
    if (boundary_counts && !snapshot.boundary.empty()) {
        result.boundary_lists = find_boundary_neighbors(snapshot, radii, valid, threads);
        result.boundary_mass = radii.vary() ? 0 : mean_mass(result.masses, valid);
    }
    return result;
}

Predictions predict(const Model& model, const Snapshot& snapshot,
                    const Neighborhoods& neighborhoods, Precision precision) {
    return precision == Precision::float32 ? predict_as<float>(model, snapshot, neighborhoods)
                                           : predict_as<double>(model, snapshot, neighborhoods);
}

Classes classify_snapshot(const Snapshot& snapshot, const Model& model,
                          const ClassifyOptions& options) {
    check_dimension(model, snapshot.dimension, "the snapshot");
    const SupportRadii radii = support_radii(snapshot);
    Classes classes;
    classes.valid = checked_positions(snapshot, radii, options.skip_invalid);
    classes.neighborhoods =
        find_neighborhoods(snapshot, radii, classes.valid, model.boundary_counts, options.threads);
    auto predictions = predict(model, snapshot, classes.neighborhoods, Precision::float64);
    classes.surface = std::move(predictions.surface);
    classes.neighbor_count = std::move(predictions.neighbor_count);
    for (std::size_t i = 0; i < classes.surface.size(); ++i)
        if (classes.valid[i] == 0)
            classes.surface[i] = 0;
    if (auto doubt = doubtful_positions(snapshot, radii, classes.valid); !doubt.empty())
        classes.warnings.push_back(std::move(doubt));
    if (model.boundary_counts && snapshot.boundary.empty())
        classes.warnings.emplace_back(
            "the model counts boundary particles and there are none; give them with --boundary");
    ModelUse use{"", {}, interior_neighbor_count(classes)};
    if (snapshot.particle_spacing && !radii.vary())
        use.spacing_ratio = radii.max / *snapshot.particle_spacing;
    const std::string warning = outside_trained_range(model, {use});
    if (!warning.empty())
        classes.warnings.push_back(warning);
    return classes;
}

} // namespace meniscus
