// What training and audit need of a labelled snapshot: two features and the uncovered fraction of
// each valid particle, and what the file says of itself. 24 bytes a particle for the paper's pair
// of features, so that ten million particles are held with ease; never as tensors.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/runtime/features/list.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

struct LabelledState {
    std::string file; ///< name without folder
    /// Which state it is: SHA-256 of the file that was labelled, as the labels' provenance has it,
    /// or else of this one; empty for a state that was not read from a file.
    std::string hash;
    std::string scene; ///< scene_of() unless overridden
    int dimension = 3;
    std::optional<double> support_radius; ///< h in m; nothing where each particle has its own
    double radius_ratio = 0;              ///< r2 / r1 that it was labelled with
    /// Share of its volume that a boundary particle counts for; nothing where there is none.
    std::optional<double> boundary_weight;
    std::optional<double> spacing_ratio; ///< of support radius and rest spacing
    FeaturePair features;                ///< x and y
    // One entry a valid particle, in the file's order:
    std::vector<double> first;              ///< feature x
    std::vector<double> second;             ///< feature y; empty where that is the neighbor count
    std::vector<double> neighbor_count;     ///< before scaling; whole for one radius, no boundary
    std::vector<double> uncovered_fraction; ///< lambda
    /// Whether a first line lets the particle through, where this state is for a second one, which
    /// the others do not concern; empty: all.
    std::vector<std::uint8_t> candidate;
    /// What features that grow as counts do are multiplied by: they are taken for a support radius
    /// of reference_spacing_ratio spacings. 1 where radii vary.
    double count_scale = 1;

    [[nodiscard]] std::size_t size() const { return first.size(); }
    /// Both features of an entry.
    [[nodiscard]] double x(std::size_t i) const { return scale_of(features.first) * first[i]; }
    [[nodiscard]] double y(std::size_t i) const {
        return scale_of(features.second) * (second.empty() ? neighbor_count[i] : second[i]);
    }
    [[nodiscard]] double scale_of(std::size_t feature) const {
        return feature_list[feature].is_fraction ? 1 : count_scale;
    }
    /// Without a counted neighbor a particle is surface in any case.
    [[nodiscard]] bool is_alone(std::size_t i) const { return neighbor_count[i] == 0; }
    [[nodiscard]] bool is_candidate(std::size_t i) const {
        return candidate.empty() || candidate[i] != 0;
    }
    /// Whether a line decides on the particle.
    [[nodiscard]] bool concerns_line(std::size_t i) const {
        return !is_alone(i) && is_candidate(i);
    }
};

/// Lines are trained on features as they are at this support radius over particle spacing, so that
/// one line serves all masses and, within bounds, all radii.
inline constexpr double reference_spacing_ratio = 2;

/// Takes the state out of a labelled snapshot, with two features that are stored in it; `file` is
/// for its name and for messages, nothing is read from it. Throws InputError, naming the file and
/// what is missing, where it was not labelled
/// (`meniscus label` adds the arrays), where an array has a value that is not finite or out of
/// range, or where its provenance has no such radius ratio or boundary weight.
LabelledState labelled_state(const Snapshot& snapshot, const std::filesystem::path& file,
                             const FeaturePair& features = {});

/// What LabelledState::hash of a snapshot is that was read from this file.
std::string state_hash(const Snapshot& snapshot, const std::filesystem::path& file);

/// Reads and checks one labelled file; `scene` replaces the file's own where it is not empty.
/// Throws as read_snapshot and labelled_state do.
LabelledState read_labelled_state(const std::filesystem::path& file, const std::string& scene,
                                  const FeaturePair& features = {});

/// Neighbor count typical of the bulk, at reference_spacing_ratio: the median over particles with
/// lambda = 0; nothing where there are none.
std::optional<double> bulk_neighbor_count(const LabelledState& state);

/// The weight of boundary particles in the features of those states that have some; the default
/// where none has. Throws InputError, naming both files, where they differ.
double common_boundary_weight(const std::vector<LabelledState>& states);

/// Throws InputError, naming both files, where states differ in dimension, in features, in radius
/// ratio or in the weight of boundary particles: one line cannot be trained or judged on them
/// together.
void check_same_kind(const std::vector<LabelledState>& states);

/// Which states belong to which scene.
struct SceneGroups {
    std::vector<std::string> names;    ///< in order of first appearance
    std::vector<std::size_t> of_state; ///< index into names, one entry a state
};
SceneGroups group_by_scene(const std::vector<LabelledState>& states);

/// The label threshold where nobody says another: a particle is surface where more than this share
/// of its sphere is uncovered. At 0 every pinhole between neighbors counts (docs/accuracy.md).
inline constexpr double default_label_threshold = 0.02;

/// Throws InputError where a label threshold is not in [0, 1).
void check_label_threshold(double label_threshold);

} // namespace meniscus
