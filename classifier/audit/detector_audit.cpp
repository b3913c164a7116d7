#include "audit.hpp"
#include "detail/audit_files.hpp"

#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

namespace meniscus {
namespace {

/// A row of one file, whose particle i is flagged where flagged(i) says so; `each` is called for
/// the valid ones with whether they are surface by label.
template <class Flagged, class Each>
AuditRow row_of(const LabelledState& state, const std::vector<std::uint8_t>& valid,
                double label_threshold, const Flagged& flagged, const Each& each) {
    AuditRow row;
    row.scene = state.scene;
    row.files = {state.file};
    std::size_t entry = 0;
    for (std::size_t i = 0; i < valid.size(); ++i) {
        if (valid[i] == 0)
            continue;
        const double lambda = state.uncovered_fraction[entry++];
        row.add(lambda, label_threshold, flagged(i));
        each(row, i, lambda > label_threshold);
    }
    if (row.surface_particles != 0)
        row.unseen_rates = {false_negative_rate(row)};
    return row;
}

double threshold_of(const AuditOptions& options) {
    return options.label_threshold.value_or(detector_label_threshold);
}

AuditedDetector checked(const std::string& name, std::optional<double> threshold) {
    const DetectorKind& kind = detector_kind(name);
    if (threshold && !(*threshold >= kind.min_threshold && *threshold <= kind.max_threshold))
        throw InputError("--detector-threshold is " + number_text(*threshold) +
                         ", expected a number from " + rounded_text(kind.min_threshold, 6) +
                         " to " + rounded_text(kind.max_threshold, 6) + " (" + kind.quantity + ")");
    return {kind, threshold.value_or(kind.default_3d)};
}

AuditRow audit_one(const AuditedDetector& detector, const Snapshot& snapshot,
                   const LabelledState& state, const AuditOptions& options) {
    const auto valid = valid_particles(snapshot, state.file);
    const auto responses = naming_file(state.file, [&] {
        const auto neighborhoods =
            find_neighborhoods(snapshot, support_radii(snapshot), valid, 1, options.threads);
        return detector_responses(detector.kind, snapshot, neighborhoods, options.threads);
    });
    const auto flagged = [&](std::size_t i) {
        return detector.kind.flags(responses[i], detector.threshold);
    };
    return row_of(state, valid, threshold_of(options), flagged,
                  [&](AuditRow& row, std::size_t i, bool is_surface) {
                      const double response = detector.kind.sign() * responses[i];
                      if (!is_surface)
                          row.responses.others.push_back(response);
                      else if (!(response <= row.responses.last_surface))
                          row.responses.last_surface = response;
                  });
}

/// Flags of the valid particles; throws InputError where they are none.
std::vector<std::int64_t> flags_of(const AuditedFlag& flag, const Snapshot& snapshot,
                                   const std::vector<std::uint8_t>& valid,
                                   const std::string& file) {
    return naming_file(file, [&] {
        scalar_array(snapshot, flag.array); // refuses what is missing
        return integer_values(snapshot, flag.array, valid);
    });
}

} // namespace

AuditReport audit_detector(const std::string& name, std::optional<double> threshold,
                           const std::vector<std::filesystem::path>& files,
                           const AuditOptions& options) {
    AuditedDetector detector = checked(name, threshold);
    std::string first_file;
    int dimension = 0;
    AuditReport report = audit_files(
        files, options, threshold_of(options),
        [&](const Snapshot& snapshot, const LabelledState& state) {
            if (first_file.empty()) {
                first_file = state.file;
                dimension = state.dimension;
                const double own = naming_file(
                    state.file, [&] { return detector.kind.default_threshold(dimension); });
                detector.threshold = threshold.value_or(own);
            }
            if (state.dimension != dimension)
                throw InputError(first_file + " is " + std::to_string(dimension) + "D and " +
                                 state.file + " is " + std::to_string(state.dimension) +
                                 "D; audit a detector on files of one dimension");
            return audit_one(detector, snapshot, state, options);
        });
    report.detector = detector;
    return report;
}

AuditReport audit_flag(const AuditedFlag& flag, const std::vector<std::filesystem::path>& files,
                       const AuditOptions& options) {
    AuditReport report =
        audit_files(files, options, threshold_of(options),
                    [&](const Snapshot& snapshot, const LabelledState& state) {
                        const auto valid = valid_particles(snapshot, state.file);
                        const auto flags = flags_of(flag, snapshot, valid, state.file);
                        return row_of(
                            state, valid, threshold_of(options),
                            [&](std::size_t i) { return flags[i] >= flag.min; },
                            [](AuditRow& /*row*/, std::size_t /*i*/, bool /*is_surface*/) {});
                    });
    report.flag = flag;
    return report;
}

} // namespace meniscus
