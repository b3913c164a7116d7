// The audit holds a model against labelled snapshots: false negatives (surface particles
// missed, which corrupt the physics) and false positives (which cost time), scene by scene.
// A free-surface detector of another code, or the flags that such a code has stored, can stand in
// the model's place. A model's predictions come from features that are worked out anew from the
// positions with the runtime's own code, in double and in float, not from the ones stored with the
// labels: what counts is what a solver would see.
#pragma once

#include "report.hpp"

#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

/// The uncovered fraction that makes a particle surface for the detectors of other codes, unless
/// somebody says otherwise: less is an opening that none of them is made for.
inline constexpr double detector_label_threshold = 0.02;

/// Audits one labelled snapshot, as one row. Throws InputError, naming the file, where the model is
/// of another dimension, radius ratio or boundary rule, or where arrays of the snapshot cannot be
/// used.
AuditRow audit_state(const Model& model, const Snapshot& snapshot, const LabelledState& state,
                     double label_threshold, int threads = 0);

/// Reads and audits one labelled file with the options' threads. Throws as audit() does. Several
/// threads may call it at once.
AuditedFile audit_file(const Model& model, const std::filesystem::path& file,
                       const AuditOptions& options);

/// The report on files that were audited with this model and these options, in their order.
AuditReport audit_report(const Model& model, const AuditOptions& options,
                         const std::vector<AuditedFile>& files);

/// Audits labelled files, which are read one after the other. Throws InputError where there are no
/// files, where a file cannot be read or was not labelled, and as audit_state does.
AuditReport audit(const Model& model, const std::vector<std::filesystem::path>& files,
                  const AuditOptions& options);

/// The same with a detector in the model's place; without a threshold, its authors'. Throws as
/// audit() and detector_responses() do, where the threshold is out of the kind's range, and where
/// files are of different dimension.
AuditReport audit_detector(const std::string& name, std::optional<double> threshold,
                           const std::vector<std::filesystem::path>& files,
                           const AuditOptions& options);

/// The same with an array of whole numbers, one a particle, that the files have. Throws as audit()
/// does, and InputError, naming the file, where there is no such array of one component or where a
/// valid particle's entry is no whole number.
AuditReport audit_flag(const AuditedFlag& flag, const std::vector<std::filesystem::path>& files,
                       const AuditOptions& options);

} // namespace meniscus
