#include "detail/audit_files.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/nearest_spacing.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>

namespace meniscus {
namespace {

AuditRow& row_of_scene(const std::string& scene, std::vector<AuditRow>& rows) {
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const AuditRow& row) { return row.scene == scene; });
    if (found != rows.end())
        return *found;
    rows.emplace_back();
    rows.back().scene = scene;
    return rows.back();
}

} // namespace

std::vector<std::uint8_t> valid_particles(const Snapshot& snapshot, const std::string& file) {
    const auto values = naming_file(file, [&] { return scalar_values(snapshot, "valid"); });
    std::vector<std::uint8_t> valid(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        valid[i] = static_cast<std::uint8_t>(values[i] != 0);
    return valid;
}

Snapshot read_audited(const std::filesystem::path& file, const AuditOptions& options) {
    return options.read ? options.read(file) : read_snapshot(file);
}

AuditedFile judged_file(const std::filesystem::path& file, const AuditOptions& options,
                        const Judge& judge) {
    const Snapshot snapshot = read_audited(file, options);
    LabelledState state = labelled_state(snapshot, file);
    state.hash = state_hash(snapshot, file);
    if (!options.scene.empty())
        state.scene = options.scene;
    AuditedFile judged;
    judged.row = judge(snapshot, state);
    judged.use = {state.file, state.spacing_ratio, bulk_neighbor_count(state)};
    const std::string doubt =
        doubtful_support_radius(snapshot, support_radii(snapshot), valid_particles(snapshot, file));
    if (!doubt.empty())
        judged.warnings.push_back(file.string() + ": " + doubt);
    if (judged.row.features_differ != 0)
        judged.warnings.push_back(
            file.string() + ": the stored neighbor counts of " +
            std::to_string(judged.row.features_differ) +
            " particles are not what its positions give; label it again before training");
    return judged;
}

AuditReport sum_of_files(const std::vector<AuditedFile>& files, double label_threshold) {
    AuditReport report;
    report.label_threshold = label_threshold;
    report.total.scene = "all";
    for (const AuditedFile& file : files) {
        add_row(file.row, row_of_scene(file.row.scene, report.scenes));
        add_row(file.row, report.total);
        report.warnings.insert(report.warnings.end(), file.warnings.begin(), file.warnings.end());
    }
    return report;
}

AuditReport audit_files(const std::vector<std::filesystem::path>& files,
                        const AuditOptions& options, double label_threshold, const Judge& judge) {
    if (files.empty())
        throw InputError("no labelled file to audit; give at least one");
    check_label_threshold(label_threshold);
    std::vector<AuditedFile> judged;
    judged.reserve(files.size());
    for (const auto& file : files)
        judged.push_back(judged_file(file, options, judge));
    return sum_of_files(judged, label_threshold);
}

} // namespace meniscus
