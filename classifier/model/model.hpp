// A model is a half-plane y <= k x + d (or >=) of two features, perhaps with a second one of other
// features for what the first lets through, together with what it was trained on, so that a reader
// knows where it can be trusted. Stored as JSON (docs/file_formats.md).
#pragma once

#include <meniscus/data/text/range.hpp>
#include <meniscus/runtime/features/list.hpp>
#include <meniscus/runtime/surface/surface_options.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

/// The line y = k x + d in the plane of two features, and on which side of it surface lies.
struct Line {
    double k = 0;
    double d = 0;
    bool above = false; ///< surface where y >= k x + d; never with the paper's features
};

/// True for surface: what the runtime answers for a particle with neighbors and these features, up
/// to rounding (which d_margin covers). A particle without a counted neighbor is surface whatever
/// the line.
inline bool predicts_surface(const Line& line, double x, double y) {
    const double height = line.k * x + line.d;
    return line.above ? y >= height : y <= height;
}

/// The line as text, with so many digits: "mass_offset" and "neighbor_count" are x and y, others
/// are named.
std::string line_text(const Line& line, const FeaturePair& features, int digits);

/// A line for what the first lets through, in the plane of two features of its own.
struct SecondModelLine {
    Line line;
    FeaturePair features;
    double d_margin = 0; ///< part of d that is there for rounding
};

struct TrainingFile {
    std::string name; ///< without folder
    std::string hash; ///< of the state (LabelledState::hash)
    std::string scene;
    std::size_t particles = 0;
    std::size_t surface_particles = 0;
};

struct Model {
    Line line;
    FeaturePair features; ///< x and y
    std::optional<SecondModelLine> second;
    int dimension = 3;
    double radius_ratio = 0.8; ///< r2 / r1 of the labels
    /// Support radius over rest spacing that k and d are for, at others following the host's; 0:
    /// counts are taken as they are.
    double reference_spacing_ratio = 0;
    double label_threshold = 0;               ///< surface means lambda above this
    std::string objective;                    ///< "neyman-pearson", "logistic", "network", ...
    double d_margin = 0;                      ///< part of d that is there for rounding
    std::optional<Range> spacing_ratio;       ///< h / spacing of particles at rest seen in training
    std::optional<Range> bulk_neighbor_count; ///< seen in training
    std::string phase_rule = "same phase only";
    double boundary_weight = 0; ///< share of its volume that a boundary particle counts for
    std::vector<TrainingFile> training_files; ///< empty for a line from elsewhere
    std::size_t false_negatives = 0;          ///< on the training files
    std::size_t false_positives = 0;          ///< on the training files
    std::string file;                         ///< where it was read from, for messages; not stored
};

/// Reads a model. Throws InputError, naming file and key, where it is no JSON, where a key is
/// missing or of the wrong type, where a number is not finite or not plausible, or where the
/// format version is unknown.
Model read_model(const std::filesystem::path& file);

/// A model from JSON text; `file` is for messages. Throws as read_model does.
Model model_from_json(const std::string& text, const std::filesystem::path& file);

/// The model as JSON text (stable key order, numbers that read back to the same bits), ending in a
/// line break.
std::string model_to_json(const Model& model);

/// Throws InputError, naming the model and saying what needs it, unless the model is one line of
/// the paper's features.
void check_features_of_paper(const Model& model, const std::string& what);

/// Sets what the runtime needs of a model: lines, for the options' spacing_ratio where they follow
/// it, radius ratio and the weight of boundary particles.
void set_classifier(SurfaceTensionOptions& options, const Model& model);

/// Throws InputError, naming model and file, where the model was trained in another dimension than
/// the file has.
void check_dimension(const Model& model, int dimension, const std::string& file);

/// Throws InputError, naming model and file, where the model was trained on labels of another
/// radius ratio than the file has.
void check_radius_ratio(const Model& model, double radius_ratio, const std::string& file);

/// Throws InputError, naming model and file, where boundary particles count by another weight in
/// the features of the file; nothing: it has none.
void check_boundary_weight(const Model& model, std::optional<double> boundary_weight,
                           const std::string& file);

/// What a model is about to be used on.
struct ModelUse {
    std::string file;                          ///< for messages; may be empty
    std::optional<double> spacing_ratio;       ///< h / spacing of particles at rest
    std::optional<double> bulk_neighbor_count; ///< typical inside, scaled as the model's counts
};

/// One line that names the trained ranges and the value farthest outside each; empty where all
/// uses lie inside, or where the model does not know its ranges.
std::string outside_trained_range(const Model& model, const std::vector<ModelUse>& uses);

} // namespace meniscus
