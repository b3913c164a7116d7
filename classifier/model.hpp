// A model is the line y <= k x + d together with what it was trained on, so that a reader knows
// where it can be trusted. Stored as JSON (docs/file_formats.md).
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

/// The line y = k x + d in the plane of mass offset x (without unit) and neighbor count y.
struct Line {
    double k = 0;
    double d = 0;
};

struct Range {
    double min = 0;
    double max = 0;
};

struct TrainingFile {
    std::string name; ///< without folder
    std::string hash; ///< SHA-256
    std::string scene;
    std::size_t particles = 0;
    std::size_t surface_particles = 0;
};

struct Model {
    Line line;
    int dimension = 3;
    double radius_ratio = 0.8;
    double label_threshold = 0;               ///< surface means lambda above this
    std::string objective;                    ///< "neyman-pearson", "logistic", "network", ...
    double d_margin = 0;                      ///< part of d that is there for rounding, neighbors
    std::optional<Range> spacing_ratio;       ///< h / particle spacing seen in training
    std::optional<Range> bulk_neighbor_count; ///< seen in training
    std::string phase_rule = "same phase only";
    std::string boundary_rule = "boundary particles do not count";
    std::vector<TrainingFile> training_files; ///< empty for a line from elsewhere
    std::size_t false_negatives = 0;          ///< on the training files
    std::size_t false_positives = 0;
};

/// Reads a model. Throws InputError, naming file and key, where it is no JSON, where a key is
/// missing or of the wrong type, where a number is not finite or not plausible, or where the
/// format version is unknown.
Model read_model(const std::filesystem::path& file);

/// The model as JSON text (stable key order, numbers that read back to the same bits).
std::string model_to_json(const Model& model);

/// The self-contained coefficient header for the runtime: a struct of constexpr values, no include,
/// provenance as comments. `struct_name` must be a C++ identifier, else InputError.
std::string coefficient_header(const Model& model, const std::string& struct_name);

} // namespace meniscus
