#include "audit.hpp"

#include "detail/audit_files.hpp"
#include <meniscus/classifier/model/classify_snapshot.hpp>

#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

bool was_trained_on(const Model& model, const std::string& hash) {
    return !hash.empty() &&
           std::any_of(model.training_files.begin(), model.training_files.end(),
                       [&](const TrainingFile& file) { return file.hash == hash; });
}

double threshold_of(const Model& model, const AuditOptions& options) {
    return options.label_threshold.value_or(model.label_threshold);
}

} // namespace

AuditRow audit_state(const Model& model, const Snapshot& snapshot, const LabelledState& state,
                     double label_threshold, int threads) {
    check_label_threshold(label_threshold);
    check_dimension(model, state.dimension, state.file);
    check_radius_ratio(model, state.radius_ratio, state.file);
    check_boundary_weight(model, state.boundary_weight, state.file);
    const auto valid = valid_particles(snapshot, state.file);
    const auto neighborhoods = naming_file(state.file, [&] {
        return find_neighborhoods(snapshot, support_radii(snapshot), valid,
                                  state.boundary_weight.value_or(0), threads);
    });
    const auto in_double = predict(model, snapshot, neighborhoods, Precision::float64);
    const auto in_float = predict(model, snapshot, neighborhoods, Precision::float32);
    AuditRow row;
    row.scene = state.scene;
    row.files = {state.file};
    ErrorCounts with_float;
    std::size_t entry = 0;
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
        if (valid[i] == 0)
            continue;
        const double lambda = state.uncovered_fraction[entry];
        row.add(lambda, label_threshold, in_double.surface[i] != 0);
        with_float.add(lambda, label_threshold, in_float.surface[i] != 0);
        // Counts are sums of fractions where radii vary, else whole.
        row.features_differ += static_cast<std::size_t>(
            std::fabs(in_double.neighbor_count[i] - state.neighbor_count[entry]) > 1e-6);
        ++entry;
    }
    row.false_negatives_float = with_float.false_negatives;
    row.false_positives_float = with_float.false_positives;
    const bool trained_on = was_trained_on(model, state.hash);
    row.files_trained_on = static_cast<std::size_t>(trained_on);
    if (!trained_on && row.surface_particles != 0)
        row.unseen_rates = {false_negative_rate(row)};
    return row;
}

AuditedFile audit_file(const Model& model, const std::filesystem::path& file,
                       const AuditOptions& options) {
    return judged_file(file, options, [&](const Snapshot& snapshot, const LabelledState& state) {
        return audit_state(model, snapshot, state, threshold_of(model, options), options.threads);
    });
}

AuditReport audit_report(const Model& model, const AuditOptions& options,
                         const std::vector<AuditedFile>& files) {
    AuditReport report = sum_of_files(files, threshold_of(model, options));
    report.model = model;
    std::vector<ModelUse> uses;
    uses.reserve(files.size());
    for (const AuditedFile& file : files)
        uses.push_back(file.use);
    const std::string warning = outside_trained_range(model, uses);
    if (!warning.empty())
        report.warnings.push_back(warning);
    return report;
}

AuditReport audit(const Model& model, const std::vector<std::filesystem::path>& files,
                  const AuditOptions& options) {
    if (files.empty())
        throw InputError("no labelled file to audit; give at least one");
    check_label_threshold(threshold_of(model, options));
    std::vector<AuditedFile> audited;
    audited.reserve(files.size());
    for (const auto& file : files)
        audited.push_back(audit_file(model, file, options));
    return audit_report(model, options, audited);
}

} // namespace meniscus
