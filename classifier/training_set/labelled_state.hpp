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
    std::string file;  ///< name without folder
    std::string hash;  ///< SHA-256 of the file; empty for a state that was not read from one
    std::string scene; ///< scene_of() unless overridden
    int dimension = 3;
    std::optional<double> support_radius;   ///< h in m; nothing where each particle has its own
    double radius_ratio = 0;                ///< r2 / r1 that it was labelled with
    bool boundary_counts = false;           ///< boundary particles are neighbors in the features
    std::optional<double> particle_spacing; ///< initial distance of particles in m
    FeaturePair features;                   ///< x and y
    // One entry a valid particle, in the file's order:
    std::vector<double> first;              ///< feature x
    std::vector<double> second;             ///< feature y; empty where that is the neighbor count
    std::vector<double> neighbor_count;     ///< before scaling; whole for one radius
    std::vector<double> uncovered_fraction; ///< lambda
    bool relative = false;                  ///< make_relative was called
    double count_scale = 1;                 ///< set by it

    [[nodiscard]] std::size_t size() const { return first.size(); }
    /// Both features of an entry.
    [[nodiscard]] double x(std::size_t i) const { return first[i]; }
    [[nodiscard]] double y(std::size_t i) const {
        return second.empty() ? count_scale * neighbor_count[i] : second[i];
    }
    /// No particle without a counted neighbor constrains a line: it is surface in any case.
    [[nodiscard]] bool is_alone(std::size_t i) const { return neighbor_count[i] == 0; }
};

/// The median neighbor count that relative counts are scaled to, so that lines for them have
/// coefficients of the usual size.
inline constexpr double reference_neighbor_count = 40;

/// Scales the counts so that their median over all particles is reference_neighbor_count: a line
/// trained on such states follows a fluid that is compressed (runtime/features/classifier.hpp).
/// Throws InputError, naming the file, where half of the particles have no neighbors or where the
/// features are not the paper's pair.
void make_relative(LabelledState& state);

/// Takes the state out of a labelled snapshot, with two features that are stored in it; `file` is
/// for its name and for messages, nothing is read from it. Throws InputError, naming the file and
/// what is missing, where it was not labelled
/// (`meniscus label` adds the arrays), where an array has a value that is not finite or out of
/// range, or where its provenance has no such radius ratio or boundary rule. Boundary particles do
/// not count where the provenance has no boundary rule.
LabelledState labelled_state(const Snapshot& snapshot, const std::filesystem::path& file,
                             const FeaturePair& features = {});

/// Reads and checks one labelled file; `scene` replaces the file's own where it is not empty.
/// Throws as read_snapshot and labelled_state do.
LabelledState read_labelled_state(const std::filesystem::path& file, const std::string& scene,
                                  const FeaturePair& features = {});

/// Support radius in particle spacings; nothing where the file does not say the spacing, or where
/// each particle has a radius of its own.
std::optional<double> spacing_ratio(const LabelledState& state);

/// Neighbor count typical of the bulk: the median over particles with lambda = 0; nothing where
/// there are none.
std::optional<double> bulk_neighbor_count(const LabelledState& state);

/// Throws InputError, naming both files, where states differ in dimension, in features, in radius
/// ratio, in whether boundary particles count or in being relative: one line cannot be trained or
/// judged on them together.
void check_same_kind(const std::vector<LabelledState>& states);

/// Which states belong to which scene.
struct SceneGroups {
    std::vector<std::string> names;    ///< in order of first appearance
    std::vector<std::size_t> of_state; ///< index into names, one entry a state
};
SceneGroups group_by_scene(const std::vector<LabelledState>& states);

/// Throws InputError where a label threshold is not in [0, 1).
void check_label_threshold(double label_threshold);

} // namespace meniscus
