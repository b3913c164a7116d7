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

AuditReport audit_files(const std::vector<std::filesystem::path>& files,
                        const AuditOptions& options, const Judge& judge) {
    if (files.empty())
        throw InputError("no labelled file to audit; give at least one");
    check_label_threshold(options.label_threshold);
    AuditReport report;
    report.label_threshold = options.label_threshold;
    report.total.scene = "all";
    for (const auto& file : files) {
        const Snapshot snapshot = read_snapshot(file);
        LabelledState state = labelled_state(snapshot, file);
        state.hash = file_hash(file);
        if (!options.scene.empty())
            state.scene = options.scene;
        const AuditRow row = judge(snapshot, state);
        add_row(row, row_of_scene(state.scene, report.scenes));
        add_row(row, report.total);
        const std::string doubt = doubtful_support_radius(snapshot, support_radii(snapshot),
                                                          valid_particles(snapshot, file));
        if (!doubt.empty())
            report.warnings.push_back(file.string() + ": " + doubt);
        if (row.features_differ != 0)
            report.warnings.push_back(
                file.string() + ": the stored neighbor counts of " +
                std::to_string(row.features_differ) +
                " particles are not what its positions give; label it again before training");
    }
    return report;
}

} // namespace meniscus
