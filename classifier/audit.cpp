#include "audit.hpp"

#include "classify_snapshot.hpp"
#include "confidence.hpp"

#include <meniscus/data/errors.hpp>
#include <meniscus/data/particle_arrays.hpp>
#include <meniscus/data/snapshot_files.hpp>
#include <meniscus/data/text.hpp>

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

/// Adds one particle of uncovered fraction lambda to the row.
void count_particle(double lambda, double label_threshold, bool predicted, bool predicted_float,
                    AuditRow& row) {
    const bool surface = lambda > label_threshold;
    row.surface += static_cast<std::size_t>(surface);
    row.false_negatives += static_cast<std::size_t>(surface && !predicted);
    row.false_negatives_float += static_cast<std::size_t>(surface && !predicted_float);
    row.false_positives += static_cast<std::size_t>(!surface && predicted);
    row.false_positives_float += static_cast<std::size_t>(!surface && predicted_float);
    row.false_positives_after_coverage_check +=
        static_cast<std::size_t>(!surface && predicted && lambda > 0);
    row.surface_area += surface ? lambda : 0;
    row.missed_area += surface && !predicted ? lambda : 0;
    for (LambdaBand& band : row.bands)
        if (lambda > band.lower && lambda <= band.upper) {
            ++band.particles;
            band.missed += static_cast<std::size_t>(!predicted);
        }
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

double fraction(double part, double whole) {
    return whole == 0 ? 0 : part / whole;
}

double fraction(std::size_t part, std::size_t whole) {
    return fraction(static_cast<double>(part), static_cast<double>(whole));
}

} // namespace

std::array<LambdaBand, 3> empty_bands() {
    return {LambdaBand{0, 0.005, 0, 0}, LambdaBand{0.005, 0.02, 0, 0}, LambdaBand{0.02, 1, 0, 0}};
}

void add_row(const AuditRow& row, AuditRow& sum) {
    sum.files.insert(sum.files.end(), row.files.begin(), row.files.end());
    sum.files_trained_on += row.files_trained_on;
    sum.particles += row.particles;
    sum.surface += row.surface;
    sum.false_negatives += row.false_negatives;
    sum.false_positives += row.false_positives;
    sum.false_negatives_float += row.false_negatives_float;
    sum.false_positives_float += row.false_positives_float;
    sum.false_positives_after_coverage_check += row.false_positives_after_coverage_check;
    sum.features_differ += row.features_differ;
    for (std::size_t b = 0; b < sum.bands.size(); ++b) {
        sum.bands[b].particles += row.bands[b].particles;
        sum.bands[b].missed += row.bands[b].missed;
    }
    sum.surface_area += row.surface_area;
    sum.missed_area += row.missed_area;
    sum.unseen_rates.insert(sum.unseen_rates.end(), row.unseen_rates.begin(),
                            row.unseen_rates.end());
}

double false_positive_rate(const AuditRow& row) {
    return fraction(row.false_positives, row.particles);
}

double false_positive_rate_interior(const AuditRow& row) {
    return fraction(row.false_positives, row.particles - row.surface);
}

double false_negative_rate(const AuditRow& row) {
    return fraction(row.false_negatives, row.surface);
}

double missed_area_fraction(const AuditRow& row) {
    return fraction(row.missed_area, row.surface_area);
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
    check_boundary_rule(model, state.boundary_counts, state.file);
    const auto valid = valid_particles(snapshot, state.file);
    const auto neighborhoods = naming_file(state.file, [&] {
        return find_neighborhoods(snapshot, support_radii(snapshot), valid, state.boundary_counts,
                                  threads);
    });
    const auto in_double = predict(model, snapshot, neighborhoods, Precision::float64);
    const auto in_float = predict(model, snapshot, neighborhoods, Precision::float32);
    AuditRow row;
    row.scene = state.scene;
    row.files = {state.file};
    row.particles = state.size();
    std::size_t entry = 0;
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
        if (valid[i] == 0)
            continue;
        count_particle(state.uncovered_fraction[entry], label_threshold, in_double.surface[i] != 0,
                       in_float.surface[i] != 0, row);
        // Counts are sums of fractions where radii vary, else whole.
        row.features_differ += static_cast<std::size_t>(
            std::fabs(in_double.neighbor_count[i] - state.neighbor_count[entry]) > 1e-6);
        ++entry;
    }
    const bool trained_on = was_trained_on(model, state.hash);
    row.files_trained_on = static_cast<std::size_t>(trained_on);
    if (!trained_on && row.surface != 0)
        row.unseen_rates = {false_negative_rate(row)};
    return row;
}

AuditReport audit(const Model& model, const std::vector<std::filesystem::path>& files,
                  const AuditOptions& options) {
    if (files.empty())
        throw InputError("no labelled file to audit; give at least one");
    AuditReport report;
    report.model = model;
    report.label_threshold = options.label_threshold;
    check_label_threshold(report.label_threshold);
    report.total.scene = "all";
    std::vector<ModelUse> uses;
    for (const auto& file : files) {
        const Snapshot snapshot = read_snapshot(file);
        LabelledState state = labelled_state(snapshot, file);
        state.hash = file_hash(file);
        if (!options.scene.empty())
            state.scene = options.scene;
        const AuditRow row =
            audit_state(model, snapshot, state, report.label_threshold, options.threads);
        add_row(row, row_of_scene(state.scene, report.scenes));
        add_row(row, report.total);
        uses.push_back({state.file, spacing_ratio(state), bulk_neighbor_count(state)});
        if (row.features_differ != 0)
            report.warnings.push_back(
                file.string() + ": the stored neighbor counts of " +
                std::to_string(row.features_differ) +
                " particles are not what its positions give; label it again before training");
    }
    const std::string warning = outside_trained_range(model, uses);
    if (!warning.empty())
        report.warnings.push_back(warning);
    return report;
}

} // namespace meniscus
