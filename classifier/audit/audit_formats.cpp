#include "audit.hpp"

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

std::vector<std::string> table_line(const AuditRow& row) {
    return {printable(row.scene, max_scene),
            part_of(row.files_trained_on, row.files.size()),
            std::to_string(row.particles),
            std::to_string(row.surface_particles),
            std::to_string(row.false_negatives),
            std::to_string(row.false_negatives_float),
            percent(missed_area_fraction(row), 4),
            std::to_string(row.false_positives),
            percent(false_positive_rate(row)),
            percent(false_positive_rate_interior(row)),
            std::to_string(row.uncovered_false_positives),
            part_of(row.bands[0].missed, row.bands[0].particles),
            part_of(row.bands[1].missed, row.bands[1].particles),
            part_of(row.bands[2].missed, row.bands[2].particles)};
}

std::string unseen_text(const AuditRow& all) {
    if (all.unseen_rates.empty())
        return "All snapshots with surface particles were trained on: their false negatives say "
               "nothing of "
               "new ones.\n";
    return std::to_string(unseen_with_misses(all)) + " of " +
           std::to_string(all.unseen_rates.size()) +
           " snapshots not trained on have false negatives. With 95 % confidence a new one of "
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

Json row_json(const AuditRow& row) {
    return {{"scene", row.scene},
            {"files", row.files},
            {"files_trained_on", row.files_trained_on},
            {"particles", row.particles},
            {"surface", row.surface_particles},
            {"false_negatives", row.false_negatives},
            {"false_negatives_float", row.false_negatives_float},
            {"false_positives", row.false_positives},
            {"false_positives_float", row.false_positives_float},
            {"false_positives_after_coverage_check", row.uncovered_false_positives},
            {"false_negative_rate", false_negative_rate(row)},
            {"false_positive_rate", false_positive_rate(row)},
            {"false_positive_rate_interior", false_positive_rate_interior(row)},
            {"missed_area", missed_area_fraction(row)},
            {"bands", bands_json(row)},
            {"unseen",
             {{"snapshots", row.unseen_rates.size()},
              {"snapshots_with_false_negatives", unseen_with_misses(row)},
              {"false_negative_rate_upper_95", optional_number(false_negative_rate_upper_95(row))},
              {"snapshot_with_false_negatives_upper_95",
               optional_number(snapshot_with_misses_upper_95(row))}}}};
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

/// What is judged against what.
std::string heading(const AuditReport& report) {
    const Model& model = report.model;
    std::string text = "surface where " + line_text(model.line, model.features, 6) + " (" +
                       printable(model.objective, max_scene) + ")";
    if (model.second)
        text = "surface where " + line_text(model.line, model.features, 6) + " and " +
               line_text(model.second->line, model.second->features, 6) + " (" +
               printable(model.objective, max_scene) + ")";
    text += "; by label where more than " + rounded_text(100 * report.label_threshold, 3) +
            " % of the sphere is uncovered";
    if (model.label_threshold != report.label_threshold)
        text +=
            " (the model was trained at " + rounded_text(100 * model.label_threshold, 3) + " %)";
    return text + "\n\n";
}

} // namespace

std::string to_table(const AuditReport& report) {
    std::vector<std::vector<std::string>> lines = {
        {"scene", "trained on", "particles", "surface", "missed", "in float", "missed area",
         "false pos.", "of all", "of interior", "uncovered", "to 0.5 %", "to 2 %", "above"}};
    for (const AuditRow& row : all_rows(report))
        lines.push_back(table_line(row));
    return heading(report) + aligned(lines) +
           "\nmissed: false negatives; missed area: their share of all uncovered area; uncovered: "
           "false positives\nthat a coverage check leaves; last columns: missed of all particles "
           "by uncovered fraction.\n" +
           unseen_text(report.total);
}

std::string to_json(const AuditReport& report) {
    Json scenes = Json::array();
    for (const AuditRow& row : report.scenes)
        scenes.push_back(row_json(row));
    const Json json = {{"model", Json::parse(model_to_json(report.model))},
                       {"label_threshold", report.label_threshold},
                       {"scenes", scenes},
                       {"total", row_json(report.total)},
                       {"warnings", report.warnings}};
    return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

std::string to_csv(const AuditReport& report) {
    std::string text =
        "scene,files,files_trained_on,particles,surface,false_negatives,false_negatives_float,"
        "false_positives,false_positives_float,false_positives_after_coverage_check,"
        "false_negative_rate,false_positive_rate,false_positive_rate_interior,missed_area";
    for (const char* band : {"0_to_0.005", "0.005_to_0.02", "above_0.02"})
        text += std::string(",particles_") + band + ",missed_" + band;
    text += ",unseen_snapshots,unseen_snapshots_with_false_negatives,"
            "false_negative_rate_upper_95,snapshot_with_false_negatives_upper_95\n";
    for (const AuditRow& row : all_rows(report)) {
        text += quoted(printable(row.scene));
        for (const std::size_t number :
             {row.files.size(), row.files_trained_on, row.particles, row.surface_particles,
              row.false_negatives, row.false_negatives_float, row.false_positives,
              row.false_positives_float, row.uncovered_false_positives})
            text += "," + std::to_string(number);
        for (const double rate : {false_negative_rate(row), false_positive_rate(row),
                                  false_positive_rate_interior(row), missed_area_fraction(row)})
            text += "," + number_text(rate);
        for (const LambdaBand& band : row.bands)
            text += "," + std::to_string(band.particles) + "," + std::to_string(band.missed);
        text += "," + std::to_string(row.unseen_rates.size()) + "," +
                std::to_string(unseen_with_misses(row)) + "," +
                csv_number(false_negative_rate_upper_95(row)) + "," +
                csv_number(snapshot_with_misses_upper_95(row)) + "\n";
    }
    return text;
}

} // namespace meniscus
