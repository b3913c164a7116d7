// The audit holds a model against labelled snapshots: false negatives (surface particles
// missed, which corrupt the physics) and false positives (which cost time), scene by scene.
// Predictions come from features that are worked out anew from the positions with the runtime's own
// code, in double and in float, not from the ones stored with the labels: what counts is what a
// solver would see.
#pragma once

#include <meniscus/classifier/model/model.hpp>
#include <meniscus/classifier/training_set/error_counts.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

struct AuditOptions {
    std::optional<double>
        label_threshold; ///< surface means lambda above this; without, the model's
    std::string scene;   ///< replaces the files' own scenes where not empty
    int threads = 0;     ///< 0: all cores; the report does not depend on it
};

/// What the audit says of one file, of one scene, or of all. Numbers of particles throughout, valid
/// ones only; predictions in double where nothing else is said. Of uncovered_false_positives a
/// coverage check leaves all and takes the others away.
struct AuditRow : ErrorCounts {
    std::string scene;                ///< or "all"
    std::vector<std::string> files;   ///< names without folder
    std::size_t files_trained_on = 0; ///< files whose hash is among the model's training files
    std::size_t false_negatives_float = 0;
    std::size_t false_positives_float = 0;
    std::size_t features_differ = 0; ///< stored neighbor count is not what the positions give
    /// False-negative rate of each file that was not trained on and has surface particles.
    std::vector<double> unseen_rates;
};

/// Adds the numbers and files of `row` to `sum`, whose scene stays.
void add_row(const AuditRow& row, AuditRow& sum);

/// Snapshots that were not trained on and have false negatives.
std::size_t unseen_with_misses(const AuditRow& row);

/// Upper 95 % confidence bounds for snapshots not trained on (confidence.hpp), snapshots being
/// independent; nothing where no such snapshot was audited.
std::optional<double> false_negative_rate_upper_95(const AuditRow& row);
std::optional<double> snapshot_with_misses_upper_95(const AuditRow& row);

struct AuditReport {
    Model model;
    double label_threshold = 0;
    std::vector<AuditRow> scenes;      ///< in order of first appearance
    AuditRow total;                    ///< over all files, scene "all"
    std::vector<std::string> warnings; ///< one line each, for standard error
};

/// Audits one labelled snapshot, as one row. Throws InputError, naming the file, where the model is
/// of another dimension, radius ratio or boundary rule, or where arrays of the snapshot cannot be
/// used.
AuditRow audit_state(const Model& model, const Snapshot& snapshot, const LabelledState& state,
                     double label_threshold, int threads = 0);

/// What the audit says of one file.
struct AuditedFile {
    AuditRow row;
    ModelUse use;
    std::vector<std::string> warnings; ///< one line each, the file's name in front
};

/// Reads and audits one labelled file, at the options' threshold or else the model's, with so many
/// threads. Throws as audit() does. Several threads may call it at once.
AuditedFile audit_file(const Model& model, const std::filesystem::path& file,
                       const AuditOptions& options);

/// The report on files that were audited with this model and these options, in their order.
AuditReport audit_report(const Model& model, const AuditOptions& options,
                         const std::vector<AuditedFile>& files);

/// Audits labelled files, which are read one after the other. Throws InputError where there are no
/// files, where a file cannot be read or was not labelled, and as audit_state does.
AuditReport audit(const Model& model, const std::vector<std::filesystem::path>& files,
                  const AuditOptions& options);

/// Text in aligned columns, a row a scene, for a terminal.
std::string to_table(const AuditReport& report);

/// JSON: {"model": {...}, "label_threshold", "scenes": [{...}, ...], "total": {...},
/// "warnings": [...]}, ending in a line break; docs/training.md names the keys of a scene.
std::string to_json(const AuditReport& report);

/// CSV with a header line, a row a scene and one for all.
std::string to_csv(const AuditReport& report);

} // namespace meniscus
