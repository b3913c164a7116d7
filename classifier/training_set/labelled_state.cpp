#include "labelled_state.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/boundary_rule.hpp>
#include <meniscus/data/particles/feature_names.hpp>
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

/// Whole numbers, unless radii vary: each neighbor then counts up to 2^3 (scaled_features.hpp).
std::vector<double> neighbor_counts(const Snapshot& snapshot, bool boundary_counts, bool radii_vary,
                                    const std::vector<double>& valid, const std::string& file) {
    const std::size_t particles =
        snapshot.size() + (boundary_counts ? snapshot.boundary.size() : 0);
    const double max = std::min<double>(static_cast<double>(particles) * (radii_vary ? 8 : 1),
                                        std::numeric_limits<std::uint32_t>::max());
    auto counts = checked_values(snapshot, "neighbor_count", valid, max, file);
    for (const double count : counts)
        if (!radii_vary && count != std::trunc(count))
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

bool labelled_boundary_rule(const Snapshot& snapshot, const std::string& file) {
    const auto entry = snapshot.provenance.find("boundary_rule");
    if (entry == snapshot.provenance.end())
        return false;
    const auto counts = boundary_counts_from(entry->second);
    if (!counts)
        throw InputError(file + ": 'boundary_rule' in its provenance is '" + entry->second +
                         "', expected '" + std::string(boundary_counts_text) + "' or '" +
                         std::string(boundary_ignored_text) + "'; label the snapshot again");
    return *counts;
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
    state.boundary_counts = labelled_boundary_rule(snapshot, file.string());
    state.support_radius = checked_support_radius(snapshot, file.string());
    state.neighbor_count = neighbor_counts(snapshot, state.boundary_counts, !state.support_radius,
                                           valid, file.string());
    const std::size_t count = FeaturePair{}.second;
    state.first = features.first == count
                      ? state.neighbor_count
                      : feature_values(snapshot, features.first, valid, file.string());
    if (features.second != count)
        state.second = feature_values(snapshot, features.second, valid, file.string());
    state.radius_ratio = labelled_radius_ratio(snapshot, file.string());
    if (snapshot.particle_spacing && *snapshot.particle_spacing > 0 &&
        std::isfinite(*snapshot.particle_spacing))
        state.particle_spacing = snapshot.particle_spacing;
    return state;
}

LabelledState read_labelled_state(const std::filesystem::path& file, const std::string& scene,
                                  const FeaturePair& features) {
    LabelledState state = labelled_state(read_snapshot(file), file, features);
    state.hash = file_hash(file);
    if (!scene.empty())
        state.scene = scene;
    return state;
}

std::optional<double> spacing_ratio(const LabelledState& state) {
    if (!state.particle_spacing || !state.support_radius)
        return {};
    return *state.support_radius / *state.particle_spacing;
}

void make_relative(LabelledState& state) {
    if (!is_of_paper(state.features))
        throw InputError(state.file + ": counts can be relative in lines of the features " +
                         names_of({}) + ", not in lines of " + names_of(state.features));
    const int median = median_neighbor_count(state.neighbor_count.data(), state.size());
    if (median == 0)
        throw InputError(state.file + ": half of the particles have no neighbors, so counts cannot "
                                      "be relative to their median; is the support radius right?");
    state.count_scale = reference_neighbor_count / median;
    state.relative = true;
}

std::optional<double> bulk_neighbor_count(const LabelledState& state) {
    std::vector<double> counts;
    for (std::size_t i = 0; i < state.size(); ++i)
        if (state.uncovered_fraction[i] == 0)
            counts.push_back(state.neighbor_count[i]);
    if (counts.empty())
        return {};
    return median_neighbor_count(counts.data(), counts.size());
}

void check_same_kind(const std::vector<LabelledState>& states) {
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
        if (state.boundary_counts != first.boundary_counts)
            throw InputError(first.file + " was labelled by the rule '" +
                             std::string(boundary_rule_text(first.boundary_counts)) + "' and " +
                             state.file + " by '" +
                             std::string(boundary_rule_text(state.boundary_counts)) +
                             "'; label both with --boundary-counts or both without");
        if (state.relative != first.relative)
            throw InputError("counts are relative in one of " + first.file + " and " + state.file +
                             " and not in the other");
    }
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
