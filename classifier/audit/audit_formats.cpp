#include "report.hpp"

#include <meniscus/data/text/text.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace meniscus {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t max_scene = 200; ///< bytes of a name in a table

std::string percent(double fraction, int digits = 2) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f %%", digits, 100 * fraction);
    return text;
}

std::string part_of(std::size_t part, std::size_t whole) {
    return std::to_string(part) + "/" + std::to_string(whole);
}

std::vector<AuditRow> all_rows(const AuditReport& report) {
    std::vector<AuditRow> rows = report.scenes;
    rows.push_back(report.total);
    return rows;
}

/// Cells in columns as wide as their widest cell: the first column to the left, numbers to the
/// right.
std::string aligned(const std::vector<std::vector<std::string>>& lines) {
    std::vector<std::size_t> widths(lines.front().size());
    for (const auto& line : lines)
        for (std::size_t c = 0; c < line.size(); ++c)
            widths[c] = std::max(widths[c], line[c].size());
    std::string text;
    for (const auto& line : lines) {
        for (std::size_t c = 0; c < line.size(); ++c) {
            const std::string padding(widths[c] - line[c].size(), ' ');
            text += c == 0 ? line[c] + padding : "  " + padding + line[c];
        }
        text += "\n";
    }
    return text;
}

/// What a report has columns and keys for.
bool is_for_model(const AuditReport& report) {
    return !report.detector && !report.flag;
}

/// A detector's threshold as the table shows it.
std::string threshold_text(const std::optional<double>& threshold) {
    return threshold ? rounded_text(*threshold, 6) : "none";
}

std::string false_positives_text(const DetectorKind& kind, const AuditRow& row,
                                 const std::optional<double>& threshold) {
    if (!threshold)
        return "-";
    return percent(fraction(false_positives_at(kind, row, *threshold), row.particles));
}

std::vector<std::string> table_titles(const AuditReport& report) {
    std::vector<std::string> titles = {"scene", is_for_model(report) ? "trained on" : "files",
                                       "particles", "surface", "missed"};
    if (is_for_model(report))
        titles.emplace_back("in float");
    for (const char* title : {"missed area", "false pos.", "of all", "of interior", "uncovered",
                              "to 0.5 %", "to 2 %", "above"})
        titles.emplace_back(title);
    if (report.detector) {
        titles.emplace_back("none missed at");
        titles.emplace_back("false pos. then");
    }
    return titles;
}

std::vector<std::string> table_line(const AuditReport& report, const AuditRow& row) {
    std::vector<std::string> line = {
        printable(row.scene, max_scene),
        is_for_model(report) ? part_of(row.files_trained_on, row.files.size())
                             : std::to_string(row.files.size()),
        std::to_string(row.particles), std::to_string(row.surface_particles),
        std::to_string(row.false_negatives)};
    if (is_for_model(report))
        line.push_back(std::to_string(row.false_negatives_float));
    line.insert(line.end(),
                {percent(missed_area_fraction(row), 4), std::to_string(row.false_positives),
                 percent(false_positive_rate(row)), percent(false_positive_rate_interior(row)),
                 std::to_string(row.uncovered_false_positives)});
    for (const LambdaBand& band : row.bands)
        line.push_back(part_of(band.missed, band.particles));
    if (report.detector) {
        const DetectorKind& kind = report.detector->kind;
        const auto threshold = threshold_that_misses_none(kind, row);
        line.push_back(threshold_text(threshold));
        line.push_back(false_positives_text(kind, row, threshold));
    }
    return line;
}

std::string unseen_text(const AuditReport& report) {
    const AuditRow& all = report.total;
    const char* kind = is_for_model(report) ? " snapshots not trained on" : " snapshots";
    if (all.unseen_rates.empty() && !is_for_model(report))
        return "No snapshot has surface particles.\n";
    if (all.unseen_rates.empty())
        return "All snapshots with surface particles were trained on: their false negatives say "
               "nothing of "
               "new ones.\n";
    return std::to_string(unseen_with_misses(all)) + " of " +
           std::to_string(all.unseen_rates.size()) + kind +
           " have false negatives. With 95 % confidence a new one of "
           "their kind\nmisses at most " +
           percent(*false_negative_rate_upper_95(all)) +
           " of its surface particles on average, and misses any with a probability of at most " +
           percent(*snapshot_with_misses_upper_95(all)) + ".\n";
}

Json optional_number(const std::optional<double>& number) {
    return number ? Json(*number) : Json(nullptr);
}

Json bands_json(const AuditRow& row) {
    Json bands = Json::array();
    for (const LambdaBand& band : row.bands)
        bands.push_back({{"lower", band.lower},
                         {"upper", band.upper},
                         {"particles", band.particles},
                         {"missed", band.missed}});
    return bands;
}

Json row_json(const AuditReport& report, const AuditRow& row) {
    Json json = {{"scene", row.scene}, {"files", row.files}};
    if (is_for_model(report))
        json["files_trained_on"] = row.files_trained_on;
    json["particles"] = row.particles;
    json["surface"] = row.surface_particles;
    json["false_negatives"] = row.false_negatives;
    if (is_for_model(report))
        json["false_negatives_float"] = row.false_negatives_float;
    json["false_positives"] = row.false_positives;
    if (is_for_model(report))
        json["false_positives_float"] = row.false_positives_float;
    json["false_positives_after_coverage_check"] = row.uncovered_false_positives;
    json["false_negative_rate"] = false_negative_rate(row);
    json["false_positive_rate"] = false_positive_rate(row);
    json["false_positive_rate_interior"] = false_positive_rate_interior(row);
    json["missed_area"] = missed_area_fraction(row);
    if (report.detector) {
        const DetectorKind& kind = report.detector->kind;
        const auto threshold = threshold_that_misses_none(kind, row);
        json["threshold_that_misses_none"] = optional_number(threshold);
        json["false_positives_then"] =
            threshold ? Json(false_positives_at(kind, row, *threshold)) : Json(nullptr);
    }
    json["bands"] = bands_json(row);
    json["unseen"] = {
        {"snapshots", row.unseen_rates.size()},
        {"snapshots_with_false_negatives", unseen_with_misses(row)},
        {"false_negative_rate_upper_95", optional_number(false_negative_rate_upper_95(row))},
        {"snapshot_with_false_negatives_upper_95",
         optional_number(snapshot_with_misses_upper_95(row))}};
    return json;
}

/// What is judged, with its name as key.
Json judged_json(const AuditReport& report) {
    if (report.flag)
        return {{"flag", {{"array", report.flag->array}, {"min", report.flag->min}}}};
    if (!report.detector)
        return {{"model", Json::parse(model_to_json(report.model))}};
    const DetectorKind& kind = report.detector->kind;
    return {{"detector",
             {{"name", kind.name},
              {"method", kind.method},
              {"source", kind.source},
              {"quantity", kind.quantity},
              {"surface_is_below", kind.surface_is_below},
              {"threshold", report.detector->threshold}}}};
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text)
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

std::string csv_number(const std::optional<double>& number) {
    return number ? number_text(*number) : std::string();
}

/// Which particles are surface for what is judged.
std::string judged_text(const AuditReport& report) {
    if (report.flag)
        return "'" + printable(report.flag->array, max_scene) + "' is at least " +
               std::to_string(report.flag->min);
    if (report.detector) {
        const DetectorKind& kind = report.detector->kind;
        return kind.name + " flags (" + kind.source + ": " + kind.method + "; " + kind.quantity +
               (kind.surface_is_below ? " below " : " above ") +
               rounded_text(report.detector->threshold, 6) + ")";
    }
    const Model& model = report.model;
    std::string text = line_text(model.line, model.features, 6);
    if (model.second)
        text += " and " + line_text(model.second->line, model.second->features, 6);
    return text + " (" + printable(model.objective, max_scene) + ")";
}

/// What is judged against what.
std::string heading(const AuditReport& report) {
    std::string text = "surface where " + judged_text(report) + "; by label where more than " +
                       rounded_text(100 * report.label_threshold, 3) +
                       " % of the sphere is uncovered";
    if (is_for_model(report) && report.model.label_threshold != report.label_threshold)
        text += " (the model was trained at " +
                rounded_text(100 * report.model.label_threshold, 3) + " %)";
    return text + "\n\n";
}

} // namespace

std::string to_table(const AuditReport& report) {
    std::vector<std::vector<std::string>> lines = {table_titles(report)};
    for (const AuditRow& row : all_rows(report))
        lines.push_back(table_line(report, row));
    std::string text =
        heading(report) + aligned(lines) +
        "\nmissed: false negatives; missed area: their share of all uncovered area; uncovered: "
        "false positives\nthat a coverage check leaves; then missed of all particles "
        "by uncovered fraction.\n";
    if (report.detector)
        text += "none missed at: the threshold at which no surface particle would be missed (none: "
                "what follows the\nthreshold leaves some out at any), and what share of all "
                "particles it would flag besides.\n";
    return text + unseen_text(report);
}

std::string to_json(const AuditReport& report) {
    Json scenes = Json::array();
    for (const AuditRow& row : report.scenes)
        scenes.push_back(row_json(report, row));
    Json json = judged_json(report);
    json["label_threshold"] = report.label_threshold;
    json["scenes"] = scenes;
    json["total"] = row_json(report, report.total);
    json["warnings"] = report.warnings;
    return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

std::string to_csv(const AuditReport& report) {
    const bool for_model = is_for_model(report);
    std::string text = for_model ? "scene,files,files_trained_on,particles,surface,false_negatives,"
                                   "false_negatives_float,false_positives,false_positives_float"
                                 : "scene,files,particles,surface,false_negatives,false_positives";
    text += ",false_positives_after_coverage_check,"
            "false_negative_rate,false_positive_rate,false_positive_rate_interior,missed_area";
    for (const char* band : {"0_to_0.005", "0.005_to_0.02", "above_0.02"})
        text += std::string(",particles_") + band + ",missed_" + band;
    text += ",unseen_snapshots,unseen_snapshots_with_false_negatives,"
            "false_negative_rate_upper_95,snapshot_with_false_negatives_upper_95";
    text += report.detector ? ",threshold_that_misses_none,false_positives_then\n" : "\n";
    for (const AuditRow& row : all_rows(report)) {
        text += quoted(printable(row.scene));
        std::vector<std::size_t> numbers = {row.files.size(),      row.particles,
                                            row.surface_particles, row.false_negatives,
                                            row.false_positives,   row.uncovered_false_positives};
        if (for_model)
            numbers = {
                row.files.size(),      row.files_trained_on,      row.particles,
                row.surface_particles, row.false_negatives,       row.false_negatives_float,
                row.false_positives,   row.false_positives_float, row.uncovered_false_positives};
        for (const std::size_t number : numbers)
            text += "," + std::to_string(number);
        for (const double rate : {false_negative_rate(row), false_positive_rate(row),
                                  false_positive_rate_interior(row), missed_area_fraction(row)})
            text += "," + number_text(rate);
        for (const LambdaBand& band : row.bands)
            text += "," + std::to_string(band.particles) + "," + std::to_string(band.missed);
        text += "," + std::to_string(row.unseen_rates.size()) + "," +
                std::to_string(unseen_with_misses(row)) + "," +
                csv_number(false_negative_rate_upper_95(row)) + "," +
                csv_number(snapshot_with_misses_upper_95(row));
        if (report.detector) {
            const auto threshold = threshold_that_misses_none(report.detector->kind, row);
            text += "," + csv_number(threshold) + ",";
            if (threshold)
                text += std::to_string(false_positives_at(report.detector->kind, row, *threshold));
        }
        text += "\n";
    }
    return text;
}

} // namespace meniscus
