// One labelled state as the page takes it: what is known of the file, and its particles as packed
// arrays. Positions are rounded to 1/65535 of the state's extent, features keep all their digits,
// so that the page counts as the audit does.
#pragma once

#include <meniscus/classifier/audit/audit.hpp>
#include <meniscus/data/particles/snapshot.hpp>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>

namespace meniscus {

/// The planes of a model's lines: {"features", "meanings", "k", "d", "above"} each.
nlohmann::ordered_json planes_json(const Model& model);

/// Boundary particles that can be seen beside the fluid: those within two support radii of the box
/// around it.
Positions nearby_boundary(const Snapshot& snapshot);

/// The state as JSON; `state` is the snapshot's own. Throws InputError where arrays of the snapshot
/// cannot be used.
nlohmann::ordered_json state_json(const Snapshot& snapshot, const LabelledState& state,
                                  const Positions& boundary, const Model& model,
                                  const AuditOptions& options);

} // namespace meniscus
