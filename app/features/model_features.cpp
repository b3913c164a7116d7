#include "model_features.hpp"

#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <cmath>

namespace meniscus {
namespace {

std::vector<std::size_t> features_of(const Model& model) {
    std::vector<std::size_t> features = {model.features.first, model.features.second};
    if (model.second)
        features.insert(features.end(),
                        {model.second->features.first, model.second->features.second});
    return features;
}

} // namespace

std::map<std::size_t, std::vector<double>> feature_values(const Snapshot& snapshot,
                                                          const LabelledState& state,
                                                          const Model& model, int threads) {
    LabelOptions options;
    options.method = LabelMethod::features_only;
    options.radius_ratio = state.radius_ratio;
    options.boundary_weight = state.boundary_weight.value_or(0);
    options.skip_invalid = true;
    options.threads = threads;
    options.features = features_of(model);
    Labels labels = label_particles(snapshot, support_radii(snapshot), options);
    std::map<std::size_t, std::vector<double>> values;
    for (std::size_t f = 0; f < options.features.size(); ++f)
        values[options.features[f]] = std::move(labels.features[f]);
    values[FeaturePair{}.first] = std::move(labels.mass_offset);
    values[FeaturePair{}.second] = std::move(labels.neighbor_count);
    return values;
}

std::array<double, 2> feature_scales(const FeaturePair& pair, const LabelledState& state,
                                     const Model& model) {
    const bool follows = model.reference_spacing_ratio > 0 && state.spacing_ratio;
    const double scale =
        follows ? std::pow(*state.spacing_ratio / model.reference_spacing_ratio, model.dimension)
                : 1;
    const auto of = [&](std::size_t feature) {
        return feature_list[feature].is_fraction ? 1 : scale;
    };
    return {of(pair.first), of(pair.second)};
}

std::vector<std::size_t> places_of_valid(const Snapshot& snapshot) {
    const std::vector<double> flags = scalar_values(snapshot, "valid");
    std::vector<std::size_t> valid;
    for (std::size_t i = 0; i < flags.size(); ++i)
        if (flags[i] != 0)
            valid.push_back(i);
    return valid;
}

} // namespace meniscus
