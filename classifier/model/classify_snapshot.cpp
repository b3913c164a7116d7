#include "classify_snapshot.hpp"

#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/surface/option_table.hpp>
#include <meniscus/runtime/surface/surface_particles.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

/// Three values a particle.
template <class Real>
std::vector<Real> coordinates_of(const Positions& positions) {
    std::vector<Real> coordinates(positions.size() * 3);
    for (std::size_t i = 0; i < coordinates.size(); ++i)
        coordinates[i] = static_cast<Real>(positions[i / 3][i % 3]);
    return coordinates;
}

/// A host's view of its boundary, with the weights of its particles.
template <class Real, int Dimension>
struct StoredBoundary {
    const Real* centers;  ///< coordinates of the fluid
    const Real* boundary; ///< coordinates, as those of the fluid
    const Neighborhoods& neighborhoods;

    template <class Visit>
    void operator()(std::size_t i, Visit&& visit) const {
        const Real* center = centers + 3 * i;
        const NeighborLists& lists = neighborhoods.boundary_lists;
        for (std::size_t n = lists.offsets[i]; n < lists.offsets[i + 1]; ++n) {
            const std::size_t b = lists.neighbors[n];
            std::array<Real, Dimension> displacement;
            for (int axis = 0; axis < Dimension; ++axis)
                displacement[axis] = boundary[3 * b + axis] - center[axis];
            visit(b, displacement,
                  static_cast<Real>(
                      neighborhoods.boundary_weights.of(b, neighborhoods.radii.of(i), Dimension)));
        }
    }
};

/// Feature y of each particle.
template <class Real, int Dimension, class View, class Boundary>
std::vector<double> neighbor_counts(const View& view, const Boundary& boundary, std::size_t count,
                                    const UniformRadius<Real>& radii, double radius_ratio) {
    const auto range = range_of(radii, radius_ratio);
    std::vector<double> counts(count);
    for (std::size_t i = 0; i < count; ++i)
        counts[i] = static_cast<double>(
            with_boundary(sum_features<Real, Dimension>(view, i, range), boundary, i, range).count);
    return counts;
}

template <class Real, int Dimension, class View, class Boundary>
std::vector<double> neighbor_counts(const View& view, const Boundary& boundary, std::size_t count,
                                    const VaryingRadii<Real>& radii, double radius_ratio) {
    const auto range = range_of(radii, radius_ratio);
    std::vector<double> counts(count);
    for (std::size_t i = 0; i < count; ++i) {
        auto sum = sum_features<Real, Dimension>(view, i, radii, range);
        add_scaled_boundary(boundary, i, radii, range, sum);
        counts[i] = static_cast<double>(sum.count);
    }
    return counts;
}

template <class Real, int Dimension, class View, class Boundary, class Radii>
Predictions predict_over(const View& view, const Boundary& boundary, const Radii& radii,
                         const Model& model, const Neighborhoods& neighborhoods) {
    const std::size_t count = neighborhoods.valid.size();
    Predictions predictions;
    predictions.neighbor_count = neighbor_counts<Real, Dimension>(
        view, times_weight(boundary, static_cast<Real>(model.boundary_weight)), count, radii,
        model.radius_ratio);
    SurfaceTensionOptions options;
    options.spacing_ratio = neighborhoods.spacing_ratio;
    set_classifier(options, model);
    ExposureMemory memory;
    SurfaceParticles<Real, Dimension> list;
    find_candidates<Real, Dimension>(view, boundary, count, radii, options, SerialLoop{}, &memory,
                                     list);
    predictions.surface.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        predictions.surface[i] = static_cast<std::uint8_t>(list.slot_of[i] >= 0);
    return predictions;
}

template <class Real, int Dimension, class Boundary>
Predictions predict_with(const CsrNeighborhood<Real, Dimension, 3>& fluid, const Boundary& boundary,
                         const Model& model, const Neighborhoods& neighborhoods) {
    const SupportRadii& radii = neighborhoods.radii;
    if (!radii.vary())
        return predict_over<Real, Dimension>(fluid, boundary,
                                             UniformRadius<Real>{static_cast<Real>(radii.max)},
                                             model, neighborhoods);
    const std::vector<Real> each(radii.each.begin(), radii.each.end());
    return predict_over<Real, Dimension>(fluid, boundary, VaryingRadii<Real>{each.data()}, model,
                                         neighborhoods);
}

template <class Real, int Dimension>
Predictions predict_as(const Model& model, const Snapshot& snapshot,
                       const Neighborhoods& neighborhoods) {
    const auto coordinates = coordinates_of<Real>(snapshot.positions);
    const std::vector<Real> masses(neighborhoods.masses.begin(), neighborhoods.masses.end());
    const CsrNeighborhood<Real, Dimension, 3> fluid{
        coordinates.data(), masses.empty() ? nullptr : masses.data(),
        neighborhoods.lists.offsets.data(), neighborhoods.lists.neighbors.data()};
    if (neighborhoods.boundary_lists.offsets.empty())
        return predict_with<Real, Dimension>(fluid, NoBoundary{}, model, neighborhoods);
    const auto boundary = coordinates_of<Real>(snapshot.boundary);
    using Stored = StoredBoundary<Real, Dimension>;
    return predict_with<Real, Dimension>(
        fluid, BoundaryView<Stored>{{coordinates.data(), boundary.data(), neighborhoods}}, model,
        neighborhoods);
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
        if (lists.neighbors.size() > max_listed_neighbors * snapshot.size())
            throw InputError("a support radius of " + rounded_text(radii.max, 4) +
                             " m gives more than " + std::to_string(max_listed_neighbors) +
                             " boundary particles as neighbors of a particle on average; is it in "
                             "m, as the positions are?");
    }
    return lists;
}

namespace {

/// All but the lists and what goes with the boundary.
Neighborhoods without_lists(const Snapshot& snapshot, const SupportRadii& radii,
                            const std::vector<std::uint8_t>& valid) {
    Neighborhoods result;
    result.masses = checked_masses(snapshot, valid);
    result.radii = radii;
    result.valid = valid;
    return result;
}

void add_boundary(const Snapshot& snapshot, double boundary_weight, int threads,
                  Neighborhoods& result) {
    if (!(boundary_weight > 0) || snapshot.boundary.empty())
        return;
    result.boundary_lists = find_boundary_neighbors(snapshot, result.radii, result.valid, threads);
    result.boundary_weights =
        boundary_weights(snapshot, result.radii, result.valid, result.spacing_ratio, threads);
}

NeighborFilter filter_of(const std::vector<std::uint8_t>& valid,
                         const std::vector<std::int64_t>& phases) {
    return {&valid, phases.empty() ? nullptr : &phases, usual_max_crowd};
}

} // namespace

Neighborhoods find_neighborhoods(const Snapshot& snapshot, const SupportRadii& radii,
                                 const std::vector<std::uint8_t>& valid, double boundary_weight,
                                 int threads) {
    const auto phases = integer_values(snapshot, "phase", valid);
    Neighborhoods result = without_lists(snapshot, radii, valid);
    result.lists = find_neighbors(snapshot.positions, radii, filter_of(valid, phases), threads);
    result.spacing_ratio = measured_spacing_ratio(snapshot, radii, valid, threads);
    add_boundary(snapshot, boundary_weight, threads, result);
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
        find_neighborhoods(snapshot, radii, classes.valid, model.boundary_weight, options.threads);
    auto predictions = predict(model, snapshot, classes.neighborhoods, Precision::float64);
    classes.surface = std::move(predictions.surface);
    classes.neighbor_count = std::move(predictions.neighbor_count);
    for (std::size_t i = 0; i < classes.surface.size(); ++i)
        if (classes.valid[i] == 0)
            classes.surface[i] = 0;
    if (auto doubt = doubtful_positions(snapshot, radii, classes.valid); !doubt.empty())
        classes.warnings.push_back(std::move(doubt));
    std::string warning =
        range_warning(model, classes.neighborhoods.spacing_ratio, interior_neighbor_count(classes));
    if (!warning.empty())
        classes.warnings.push_back(std::move(warning));
    return classes;
}

Classes classify_part(const Snapshot& snapshot, const PartOfState& part, const Model& model,
                      double spacing_ratio, int threads) {
    Classes classes;
    classes.valid.assign(snapshot.size(), 1);
    const auto phases = integer_values(snapshot, "phase", classes.valid);
    Neighborhoods& neighborhoods = classes.neighborhoods;
    neighborhoods = without_lists(snapshot, part.layout.radius, classes.valid);
    neighborhoods.lists =
        find_neighbors(snapshot.positions, part.layout, filter_of(classes.valid, phases), threads);
    neighborhoods.spacing_ratio = spacing_ratio;
    add_boundary(snapshot, model.boundary_weight, threads, neighborhoods);
    auto predictions = predict(model, snapshot, neighborhoods, Precision::float64);
    classes.surface = std::move(predictions.surface);
    classes.neighbor_count = std::move(predictions.neighbor_count);
    return classes;
}

std::string range_warning(const Model& model, double spacing_ratio,
                          std::optional<double> interior_neighbor_count) {
    ModelUse use{"", spacing_ratio, interior_neighbor_count};
    if (use.bulk_neighbor_count && model.reference_spacing_ratio > 0)
        *use.bulk_neighbor_count *=
            std::pow(model.reference_spacing_ratio / spacing_ratio, model.dimension);
    return outside_trained_range(model, {use});
}

} // namespace meniscus
