#include "audit.hpp"

#include "confidence.hpp"
#include <meniscus/classifier/model/classify_snapshot.hpp>

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/nearest_spacing.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

constexpr double confidence = 0.95;

std::vector<std::uint8_t> valid_particles(const Snapshot& snapshot, const std::string& file) {
    const auto values = naming_file(file, [&] { return scalar_values(snapshot, "valid"); });
    std::vector<std::uint8_t> valid(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        valid[i] = static_cast<std::uint8_t>(values[i] != 0);
    return valid;
}

bool was_trained_on(const Model& model, const std::string& hash) {
    return !hash.empty() &&
           std::any_of(model.training_files.begin(), model.training_files.end(),
                       [&](const TrainingFile& file) { return file.hash == hash; });
}

AuditRow& row_of_scene(const std::string& scene, std::vector<AuditRow>& rows) {
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const AuditRow& row) { return row.scene == scene; });
    if (found != rows.end())
        return *found;
    rows.emplace_back();
    rows.back().scene = scene;
    return rows.back();
}

double threshold_of(const Model& model, const AuditOptions& options) {
    return options.label_threshold.value_or(model.label_threshold);
}

} // namespace

void add_row(const AuditRow& row, AuditRow& sum) {
    sum.add(row);
    sum.files.insert(sum.files.end(), row.files.begin(), row.files.end());
    sum.files_trained_on += row.files_trained_on;
    sum.false_negatives_float += row.false_negatives_float;
    sum.false_positives_float += row.false_positives_float;
    sum.features_differ += row.features_differ;
    sum.unseen_rates.insert(sum.unseen_rates.end(), row.unseen_rates.begin(),
                            row.unseen_rates.end());
}

std::optional<double> false_negative_rate_upper_95(const AuditRow& row) {
    if (row.unseen_rates.empty())
        return {};
    return upper_bound_of_mean_rate(row.unseen_rates, confidence);
}

std::optional<double> snapshot_with_misses_upper_95(const AuditRow& row) {
    if (row.unseen_rates.empty())
        return {};
    return upper_bound_of_probability(unseen_with_misses(row), row.unseen_rates.size(), confidence);
}

std::size_t unseen_with_misses(const AuditRow& row) {
    return static_cast<std::size_t>(std::count_if(row.unseen_rates.begin(), row.unseen_rates.end(),
                                                  [](double rate) { return rate > 0; }));
}

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
    const Snapshot snapshot = read_snapshot(file);
    LabelledState state = labelled_state(snapshot, file);
    state.hash = file_hash(file);
    if (!options.scene.empty())
        state.scene = options.scene;
    AuditedFile audited;
    audited.row =
        audit_state(model, snapshot, state, threshold_of(model, options), options.threads);
    audited.use = {state.file, state.spacing_ratio, bulk_neighbor_count(state)};
    const std::string doubt =
        doubtful_support_radius(snapshot, support_radii(snapshot), valid_particles(snapshot, file));
    if (!doubt.empty())
        audited.warnings.push_back(file.string() + ": " + doubt);
    if (audited.row.features_differ != 0)
        audited.warnings.push_back(
            file.string() + ": the stored neighbor counts of " +
            std::to_string(audited.row.features_differ) +
            " particles are not what its positions give; label it again before training");
    return audited;
}

AuditReport audit_report(const Model& model, const AuditOptions& options,
                         const std::vector<AuditedFile>& files) {
    AuditReport report;
    report.model = model;
    report.label_threshold = threshold_of(model, options);
    report.total.scene = "all";
    std::vector<ModelUse> uses;
    for (const AuditedFile& file : files) {
        add_row(file.row, row_of_scene(file.row.scene, report.scenes));
        add_row(file.row, report.total);
        uses.push_back(file.use);
        report.warnings.insert(report.warnings.end(), file.warnings.begin(), file.warnings.end());
    }
    const std::string warning = outside_trained_range(model, uses);
    if (!warning.empty())
        report.warnings.push_back(warning);
    return report;
}

AuditReport audit(const Model& model, const std::vector<std::filesystem::path>& files,
                  const AuditOptions& options) {
    if (files.empty())
        throw InputError("no labelled file to audit; give at least one");
    std::vector<AuditedFile> audited;
    for (const auto& file : files)
        audited.push_back(audit_file(model, file, options));
    return audit_report(model, options, audited);
}

} // namespace meniscus
