// What every audit does with its files, whatever it judges: reads them and adds up rows by scene.
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

/// Reads a file and judges it; `scene` replaces its own where it is not empty. Throws InputError
/// where the file cannot be read or was not labelled.
AuditedFile judged_file(const std::filesystem::path& file, const AuditOptions& options,
                        const Judge& judge);

/// The report on files in their order, but for what was judged.
AuditReport sum_of_files(const std::vector<AuditedFile>& files, double label_threshold);

/// Both for one file after the other. Throws InputError where there are no files, too.
AuditReport audit_files(const std::vector<std::filesystem::path>& files,
                        const AuditOptions& options, double label_threshold, const Judge& judge);

} // namespace meniscus
