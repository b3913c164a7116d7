// The report is one page of HTML that shows states and how a model judges them: the plane of
// features with its line, the particles in space, the audit's table. It holds everything itself, so
// that it opens from disk without a network. Here the numbers are gathered and put into the page,
// whose own sources lie in page/ (docs/report.md).
#pragma once

#include <meniscus/classifier/audit/audit.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace meniscus {

/// Particles of fluid and walls that a page holds, over all states: some 30 bytes each.
inline constexpr std::size_t max_report_particles = 1'000'000;

struct ReportPage {
    std::string html;
    std::vector<std::string> warnings; ///< one line each: what is left out of the page, and why
};

/// The page for what an audit found in these labelled files, which are read again, in the audit's
/// own `options`. States that would bring it above max_report_particles have their numbers in the
/// table and are not drawn. Throws as read_snapshot and labelled_state do.
ReportPage report_page(const AuditReport& report, const std::vector<std::filesystem::path>& files,
                       const AuditOptions& options);

/// The same for labels alone, without a line: the plane is of the paper's features, and surface is
/// what the options' threshold makes it. Throws likewise.
ReportPage report_page(const std::vector<std::filesystem::path>& files,
                       const AuditOptions& options);

} // namespace meniscus
