// What an audit found, by scene, and how it is printed.
#pragma once

#include <meniscus/classifier/detectors/detectors.hpp>
#include <meniscus/classifier/model/model.hpp>
#include <meniscus/classifier/training_set/error_counts.hpp>
#include <meniscus/data/particles/snapshot.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

struct AuditOptions {
    /// Surface means lambda above this; without, the model's, or detector_label_threshold.
    std::optional<double> label_threshold;
    std::string scene; ///< replaces the files' own scenes where not empty
    int threads = 0;   ///< 0: all cores; the report does not depend on it
    /// Reads a file into a labelled snapshot; null: read_snapshot, as label has written it.
    std::function<Snapshot(const std::filesystem::path&)> read = nullptr;
};

/// The labelled snapshot of a file, as the options say. Throws what their `read` does.
Snapshot read_audited(const std::filesystem::path& file, const AuditOptions& options);

/// What a detector's particles say of its threshold: their responses (detectors.hpp), with the sign
/// turned where surface is above, so that flagged is what lies below.
struct Responses {
    double last_surface = -std::numeric_limits<double>::infinity(); ///< largest of the surface
    std::vector<double> others; ///< of particles that are not surface by label
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
    Responses responses; ///< where a detector is audited
};

/// What the audit says of one file.
struct AuditedFile {
    AuditRow row;
    ModelUse use;
    std::vector<std::string> warnings; ///< one line each, the file's name in front
};

/// Adds the numbers and files of `row` to `sum`, whose scene stays.
void add_row(const AuditRow& row, AuditRow& sum);

/// Snapshots that were not trained on and have false negatives.
std::size_t unseen_with_misses(const AuditRow& row);

/// Upper 95 % confidence bounds for snapshots not trained on (confidence.hpp), snapshots being
/// independent; nothing where no such snapshot was audited.
std::optional<double> false_negative_rate_upper_95(const AuditRow& row);
std::optional<double> snapshot_with_misses_upper_95(const AuditRow& row);

/// A detector with its threshold, or an array of flags: surface where it is at least `min`.
struct AuditedDetector {
    DetectorKind kind;
    double threshold = 0;
};
struct AuditedFlag {
    std::string array;
    std::int64_t min = 1;
};

/// The threshold nearest to the detector's own side, to four decimals, at which it would miss no
/// surface particle of the row; nothing where there is none in its range: what follows the
/// threshold leaves some out.
std::optional<double> threshold_that_misses_none(const DetectorKind& kind, const AuditRow& row);

/// False positives of the row at another threshold.
std::size_t false_positives_at(const DetectorKind& kind, const AuditRow& row, double threshold);

struct AuditReport {
    Model model; ///< where neither of the next two is there
    std::optional<AuditedDetector> detector;
    std::optional<AuditedFlag> flag;
    double label_threshold = 0;
    std::vector<AuditRow> scenes;      ///< in order of first appearance
    AuditRow total;                    ///< over all files, scene "all"
    std::vector<std::string> warnings; ///< one line each, for standard error
};

/// Text in aligned columns, a row a scene, for a terminal.
std::string to_table(const AuditReport& report);

/// JSON: {"model": {...}, "label_threshold", "scenes": [{...}, ...], "total": {...},
/// "warnings": [...]}, ending in a line break; docs/training.md names the keys of a scene. For a
/// detector or a flag, `detector` or `flag` in the place of `model` (docs/detectors.md).
std::string to_json(const AuditReport& report);

/// CSV with a header line, a row a scene and one for all.
std::string to_csv(const AuditReport& report);

} // namespace meniscus
