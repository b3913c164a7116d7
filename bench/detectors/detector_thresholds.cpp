// What the free-surface detectors of other codes miss and flag with their authors' thresholds, and
// the threshold at which each would miss nothing: the audit of `meniscus audit --detector`, on all
// files together.
#include "support/tables.hpp"

#include <meniscus/classifier/audit/audit.hpp>
#include <meniscus/data/formats/snapshot_files.hpp>

namespace meniscus {
namespace {

/// A share of all particles in percent.
double percent_of(std::size_t part, const AuditRow& row) {
    return 100 * fraction(part, row.particles);
}

Tables detector_thresholds(const TableInput& input) {
    Table table = table_of("detector-thresholds",
                           "detector | threshold {:.4g} | surface {:.0f} | missed {:.0f} | "
                           "missed area, % {:.3f} | false positives, % {:.2f} | "
                           "missed none at {:.6g} | false positives then, % {:.2f}");
    AuditOptions options;
    options.label_threshold = detector_label_threshold;
    options.threads = input.threads;
    const int dimension = read_snapshot(input.files.at(0)).dimension;
    for (const DetectorKind& kind : detector_kinds()) {
        if (dimension == 2 && !kind.default_2d)
            continue;
        const AuditReport report = audit_detector(kind.name, std::nullopt, input.files, options);
        const AuditRow& all = report.total;
        const auto threshold = threshold_that_misses_none(kind, all);
        const Cell then =
            threshold ? Cell(percent_of(false_positives_at(kind, all, *threshold), all)) : Cell();
        table.add({kind.name, report.detector->threshold, all.surface_particles,
                   all.false_negatives, 100 * missed_area_fraction(all),
                   percent_of(all.false_positives, all), threshold, then});
    }
    return {table};
}

} // namespace

TableGroup detector_threshold_tables() {
    return {"Detectors of other codes",
            {{"detector-thresholds", "LABELLED...", 1,
              "what their thresholds miss, and which would miss nothing", detector_thresholds}}};
}

} // namespace meniscus
