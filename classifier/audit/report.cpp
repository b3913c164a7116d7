#include "report.hpp"

#include "confidence.hpp"

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

constexpr double confidence = 0.95;

/// Thresholds are given to so many parts of one.
constexpr double threshold_parts = 1e4;

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
    sum.responses.last_surface = std::max(sum.responses.last_surface, row.responses.last_surface);
    sum.responses.others.insert(sum.responses.others.end(), row.responses.others.begin(),
                                row.responses.others.end());
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

std::optional<double> threshold_that_misses_none(const DetectorKind& kind, const AuditRow& row) {
    const double sign = kind.sign();
    const double fewest = kind.surface_is_below ? kind.min_threshold : kind.max_threshold;
    const double last = row.responses.last_surface;
    if (last == -std::numeric_limits<double>::infinity())
        return fewest;
    double threshold = std::ceil(last * threshold_parts) / threshold_parts;
    if (!(last < threshold))
        threshold += 1 / threshold_parts;
    threshold *= sign;
    if (!(threshold >= kind.min_threshold && threshold <= kind.max_threshold))
        return {};
    return threshold;
}

std::size_t false_positives_at(const DetectorKind& kind, const AuditRow& row, double threshold) {
    const auto& others = row.responses.others;
    const double limit = kind.sign() * threshold;
    return static_cast<std::size_t>(
        std::count_if(others.begin(), others.end(), [&](double value) { return value < limit; }));
}

} // namespace meniscus
