// What every audit does with its files, whatever it judges: reads one after the other and adds up
// rows by scene.
#pragma once

#include <meniscus/classifier/audit/report.hpp>
#include <meniscus/classifier/training_set/labelled_state.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace meniscus {

/// 1 for each particle that the labels are for, else 0. Throws InputError, naming the file.
std::vector<std::uint8_t> valid_particles(const Snapshot& snapshot, const std::string& file);

/// The row of one file.
using Judge = std::function<AuditRow(const Snapshot& snapshot, const LabelledState& state)>;

/// The report but for what was judged. Throws InputError where there are no files, and where a file
/// cannot be read or was not labelled.
AuditReport audit_files(const std::vector<std::filesystem::path>& files,
                        const AuditOptions& options, const Judge& judge);

} // namespace meniscus
