#include "labelled_state.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/feature_names.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/features/classifier.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus {
namespace {

[[noreturn]] void not_labelled(const std::string& file, const std::string& missing) {
    throw InputError(file + " is not a labelled snapshot: it has no " + missing +
                     "; run `meniscus label` on it first");
}

[[noreturn]] void out_of_range(const std::string& file, const std::string& name,
                               std::size_t particle, double value, double max) {
    throw InputError(file + ": '" + name + "' of particle " + std::to_string(particle) + " is " +
                     number_text(value) + ", expected a number from 0 to " + number_text(max) +
                     "; label the snapshot again");
}

std::vector<double> label_array(const Snapshot& snapshot, const std::string& name,
                                const std::string& file) {
    if (find_array(snapshot, name) == nullptr)
        not_labelled(file, "array '" + name + "'");
    return naming_file(file, [&] { return scalar_values(snapshot, name); });
}

/// Values of the valid particles, each of which must lie in [0, largest].
std::vector<double> checked_values(const Snapshot& snapshot, const std::string& name,
                                   const std::vector<double>& valid, double max,
                                   const std::string& file) {
    auto values = label_array(snapshot, name, file);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (valid[i] == 0)
            continue;
        if (!(values[i] >= 0 && values[i] <= max))
            out_of_range(file, name, i, values[i], max);
        values[kept++] = values[i];
    }
    values.resize(kept);
    values.shrink_to_fit();
    return values;
}

/// Whole numbers, unless radii vary, where each neighbor counts up to 2^3 (scaled_features.hpp), or
/// a boundary counts, of which a particle may stand for many.
std::vector<double> neighbor_counts(const Snapshot& snapshot, double boundary_weight,
                                    bool radii_vary, const std::vector<double>& valid,
                                    const std::string& file) {
    const bool walls_count = boundary_weight > 0 && !snapshot.boundary.empty();
    const bool whole = !radii_vary && !walls_count;
    constexpr double most = std::numeric_limits<std::uint32_t>::max();
    const double particles = static_cast<double>(snapshot.size()) * (radii_vary ? 8 : 1);
    const double max = walls_count ? most : std::min(particles, most);
    auto counts = checked_values(snapshot, "neighbor_count", valid, max, file);
    for (const double count : counts)
        if (whole && count != std::trunc(count))
            throw InputError(file + ": 'neighbor_count' has the value " + number_text(count) +
                             ", expected whole numbers; label the snapshot again");
    return counts;
}

/// Values of the valid particles of a feature, which must be finite.
std::vector<double> feature_values(const Snapshot& snapshot, std::size_t feature,
                                   const std::vector<double>& valid, const std::string& file) {
    const std::string name = feature_list[feature].name;
    const bool of_every_label = feature == FeaturePair{}.first || feature == FeaturePair{}.second;
    if (!of_every_label && find_array(snapshot, name) == nullptr)
        throw InputError(file + " has no array '" + name + "'; run `meniscus label --features " +
                         name + "` on it first");
    if (feature == FeaturePair{}.first)
        return checked_values(snapshot, name, valid, 1, file);
    auto values = naming_file(file, [&] { return scalar_values(snapshot, name); });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (valid[i] == 0)
            continue;
        if (!std::isfinite(values[i]))
            throw InputError(file + ": '" + name + "' of particle " + std::to_string(i) + " is " +
                             number_text(values[i]) +
                             ", expected a finite number; label the snapshot again");
        values[kept++] = values[i];
    }
    values.resize(kept);
    return values;
}

double labelled_radius_ratio(const Snapshot& snapshot, const std::string& file) {
    const auto entry = snapshot.provenance.find("radius_ratio");
    if (entry == snapshot.provenance.end())
        not_labelled(file, "'radius_ratio' in its provenance");
    const auto ratio = number_from_text(entry->second);
    if (!ratio || !(*ratio > 0 && *ratio <= 1))
        throw InputError(file + ": 'radius_ratio' in its provenance is '" + entry->second +
                         "', expected a number above 0 and at most 1; label the snapshot again");
    return *ratio;
}

double labelled_boundary_weight(const Snapshot& snapshot, const std::string& file) {
    const auto entry = snapshot.provenance.find("boundary_weight");
    if (entry == snapshot.provenance.end())
        not_labelled(file, "'boundary_weight' in its provenance");
    const auto weight = number_from_text(entry->second);
    if (!weight || !(*weight >= 0 && *weight <= 10))
        throw InputError(file + ": 'boundary_weight' in its provenance is '" + entry->second +
                         "', expected a number from 0 to 10; label the snapshot again");
    return *weight;
}

/// Nothing where each particle has its own.
std::optional<double> checked_support_radius(const Snapshot& snapshot, const std::string& file) {
    if (!snapshot.support_radius && find_array(snapshot, "support_radius") != nullptr)
        return {};
    if (!snapshot.support_radius)
        not_labelled(file, "support radius");
    if (!(*snapshot.support_radius > 0 && std::isfinite(*snapshot.support_radius)))
        throw InputError(file + ": support radius is " + number_text(*snapshot.support_radius) +
                         ", expected a positive number; label the snapshot again");
    return snapshot.support_radius;
}

} // namespace

LabelledState labelled_state(const Snapshot& snapshot, const std::filesystem::path& file,
                             const FeaturePair& features) {
    LabelledState state;
    state.features = features;
    state.file = file.filename().string();
    state.scene = scene_of(snapshot, file);
    state.dimension = snapshot.dimension;
    const auto valid = label_array(snapshot, "valid", file.string());
    state.uncovered_fraction =
        checked_values(snapshot, "uncovered_fraction", valid, 1, file.string());
    state.radius_ratio = labelled_radius_ratio(snapshot, file.string());
    const double boundary_weight = labelled_boundary_weight(snapshot, file.string());
    if (!snapshot.boundary.empty())
        state.boundary_weight = boundary_weight;
    state.support_radius = checked_support_radius(snapshot, file.string());
    state.neighbor_count =
        neighbor_counts(snapshot, boundary_weight, !state.support_radius, valid, file.string());
    const std::size_t count = FeaturePair{}.second;
    state.first = features.first == count
                      ? state.neighbor_count
                      : feature_values(snapshot, features.first, valid, file.string());
    if (features.second != count)
        state.second = feature_values(snapshot, features.second, valid, file.string());
    if (!state.support_radius)
        return state;
    if (!snapshot.particle_volume)
        not_labelled(file.string(), "particle_volume");
    state.spacing_ratio =
        *state.support_radius / std::pow(*snapshot.particle_volume, 1.0 / state.dimension);
    state.count_scale = std::pow(reference_spacing_ratio / *state.spacing_ratio, state.dimension);
    return state;
}

std::string state_hash(const Snapshot& snapshot, const std::filesystem::path& file) {
    const auto of_input = snapshot.provenance.find("input_hash");
    return of_input == snapshot.provenance.end() ? file_hash(file) : of_input->second;
}

LabelledState read_labelled_state(const std::filesystem::path& file, const std::string& scene,
                                  const FeaturePair& features) {
    const Snapshot snapshot = read_snapshot(file);
    LabelledState state = labelled_state(snapshot, file, features);
    state.hash = state_hash(snapshot, file);
    if (!scene.empty())
        state.scene = scene;
    return state;
}

std::optional<double> bulk_neighbor_count(const LabelledState& state) {
    std::vector<double> counts;
    for (std::size_t i = 0; i < state.size(); ++i)
        if (state.uncovered_fraction[i] == 0)
            counts.push_back(state.count_scale * state.neighbor_count[i]);
    if (counts.empty())
        return {};
    return median_neighbor_count(counts.data(), counts.size());
}

void check_same_kind(const std::vector<LabelledState>& states) {
    common_boundary_weight(states);
    for (const LabelledState& state : states) {
        const LabelledState& first = states.front();
        if (state.dimension != first.dimension)
            throw InputError(first.file + " is " + std::to_string(first.dimension) + "D and " +
                             state.file + " is " + std::to_string(state.dimension) +
                             "D; give files of one dimension");
        if (names_of(state.features) != names_of(first.features))
            throw InputError(first.file + " has the features " + names_of(first.features) +
                             " and " + state.file + " has " + names_of(state.features) +
                             "; take the same ones of both");
        if (state.radius_ratio != first.radius_ratio)
            throw InputError(first.file + " was labelled with radius ratio " +
                             number_text(first.radius_ratio) + " and " + state.file + " with " +
                             number_text(state.radius_ratio) +
                             "; label them with the same --radius-ratio");
    }
}

double common_boundary_weight(const std::vector<LabelledState>& states) {
    const LabelledState* first = nullptr;
    for (const LabelledState& state : states) {
        if (!state.boundary_weight)
            continue;
        if (first == nullptr)
            first = &state;
        if (*state.boundary_weight != *first->boundary_weight)
            throw InputError(first->file + " was labelled with boundary weight " +
                             rounded_text(*first->boundary_weight, 6) + " and " + state.file +
                             " with " + rounded_text(*state.boundary_weight, 6) +
                             "; label them with the same --boundary-weight");
    }
    return first != nullptr ? *first->boundary_weight : default_boundary_weight;
}

SceneGroups group_by_scene(const std::vector<LabelledState>& states) {
    SceneGroups groups;
    for (const LabelledState& state : states) {
        const auto found = std::find(groups.names.begin(), groups.names.end(), state.scene);
        groups.of_state.push_back(static_cast<std::size_t>(found - groups.names.begin()));
        if (found == groups.names.end())
            groups.names.push_back(state.scene);
    }
    return groups;
}

void check_label_threshold(double label_threshold) {
    if (!(label_threshold >= 0 && label_threshold < 1))
        throw InputError("label threshold is " + number_text(label_threshold) +
                         ", expected a number from 0 to below 1 (surface means that a larger "
                         "fraction of the sphere is uncovered)");
}

} // namespace meniscus
