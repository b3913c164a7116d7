#include "classify_snapshot.hpp"

#include "labelled_state.hpp"

#include <meniscus/data/errors.hpp>
#include <meniscus/data/particle_arrays.hpp>
#include <meniscus/runtime/classifier.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

/// The model's line, scaled to the state where it is relative.
template <class Real>
SurfaceLine<Real> line_for(const Model& model, const std::vector<std::uint32_t>& counts,
                           const std::vector<std::uint8_t>& valid) {
    if (model.reference_neighbor_count == 0)
        return {static_cast<Real>(model.line.k), static_cast<Real>(model.line.d)};
    std::vector<std::uint32_t> of_valid;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (valid[i] != 0)
            of_valid.push_back(counts[i]);
    return scaled_line<Real>(model.line.k, model.line.d,
                             median_neighbor_count(of_valid.data(), of_valid.size()),
                             model.reference_neighbor_count);
}

template <class Real, int Dimension>
Predictions predict_as(const Model& model, const Positions& positions,
                       const Neighborhoods& neighborhoods) {
    std::vector<Real> coordinates(positions.size() * 3);
    for (std::size_t i = 0; i < coordinates.size(); ++i)
        coordinates[i] = static_cast<Real>(positions[i / 3][i % 3]);
    const std::vector<Real> masses(neighborhoods.masses.begin(), neighborhoods.masses.end());
    const CsrNeighborhood<Real, Dimension, 3> view{
        coordinates.data(), masses.empty() ? nullptr : masses.data(),
        neighborhoods.lists.offsets.data(), neighborhoods.lists.neighbors.data()};
    const auto range = neighbor_range<Real>(neighborhoods.support_radius, model.radius_ratio);
    const auto support_radius = static_cast<Real>(neighborhoods.support_radius);
    Predictions predictions;
    predictions.surface.resize(positions.size());
    predictions.neighbor_count.resize(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
        predictions.neighbor_count[i] =
            static_cast<std::uint32_t>(sum_features<Real, Dimension>(view, i, range).count);
    const auto line = line_for<Real>(model, predictions.neighbor_count, neighborhoods.valid);
    classify<Real, Dimension>(view, 0, positions.size(), support_radius, line, range,
                              predictions.surface.data());
    return predictions;
}

template <class Real>
Predictions predict_as(const Model& model, const Snapshot& snapshot,
                       const Neighborhoods& neighborhoods) {
    return snapshot.dimension == 2 ? predict_as<Real, 2>(model, snapshot.positions, neighborhoods)
                                   : predict_as<Real, 3>(model, snapshot.positions, neighborhoods);
}

/// Typical neighbor count of the particles taken for interior ones.
std::optional<double> interior_neighbor_count(const Classes& classes) {
    std::vector<std::uint32_t> counts;
    for (std::size_t i = 0; i < classes.surface.size(); ++i)
        if (classes.valid[i] != 0 && classes.surface[i] == 0)
            counts.push_back(classes.neighbor_count[i]);
    if (counts.empty())
        return {};
    return median_neighbor_count(counts.data(), counts.size());
}

} // namespace

Neighborhoods find_neighborhoods(const Snapshot& snapshot, double support_radius,
                                 const std::vector<std::uint8_t>& valid, int threads) {
    const auto phases = integer_values(snapshot, "phase", valid);
    Neighborhoods result;
    result.masses = checked_masses(snapshot, valid);
    result.support_radius = support_radius;
    result.valid = valid;
    result.lists = find_neighbors(snapshot.positions, support_radius,
                                  {&valid, phases.empty() ? nullptr : &phases}, threads);
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
    if (!snapshot.support_radius)
        throw InputError("no support radius is stored; give --support-radius");
    Classes classes;
    classes.valid = checked_positions(snapshot, options.skip_invalid);
    auto predictions = predict(
        model, snapshot,
        find_neighborhoods(snapshot, *snapshot.support_radius, classes.valid, options.threads),
        Precision::float64);
    classes.surface = std::move(predictions.surface);
    classes.neighbor_count = std::move(predictions.neighbor_count);
    for (std::size_t i = 0; i < classes.surface.size(); ++i)
        if (classes.valid[i] == 0)
            classes.surface[i] = 0;
    ModelUse use{"", {}, interior_neighbor_count(classes)};
    if (snapshot.particle_spacing)
        use.spacing_ratio = *snapshot.support_radius / *snapshot.particle_spacing;
    const std::string warning = outside_trained_range(model, {use});
    if (!warning.empty())
        classes.warnings.push_back(warning);
    return classes;
}

} // namespace meniscus
