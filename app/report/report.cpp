#include "report.hpp"

#include "page.hpp"
#include "report_state.hpp"

#include <meniscus/runtime/version.hpp>

namespace meniscus {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view place_of_data = "{\"meniscus\":\"report\"}";

/// JSON that may stand in a script element whatever its texts hold: no end tag, no comment, no line
/// break of Unicode's own.
std::string safe_in_script(std::string_view json) {
    std::string text;
    text.reserve(json.size());
    for (std::size_t i = 0; i < json.size(); ++i) {
        const std::string_view letter = json.substr(i, 3);
        if (json[i] == '<')
            text += "\\u003c";
        else if (letter == "\xe2\x80\xa8" || letter == "\xe2\x80\xa9") {
            text += letter.back() == '\xa8' ? "\\u2028" : "\\u2029";
            i += 2;
        } else
            text += json[i];
    }
    return text;
}

std::string page_with(const Json& data) {
    std::string page(report_page_template());
    const std::string json =
        safe_in_script(data.dump(-1, ' ', false, Json::error_handler_t::replace));
    return page.replace(page.find(place_of_data), place_of_data.size(), json);
}

std::string left_out_text(const std::string& file, std::size_t particles) {
    return file + ": " + std::to_string(particles) +
           " particles are not drawn in the report, which holds " +
           std::to_string(max_report_particles) +
           "; they count in its table. Give fewer files to see this one";
}

/// The states of files, in the features of a model, and what is left out of them.
Json states_json(const Model& model, const std::vector<std::filesystem::path>& files,
                 const AuditOptions& options, std::vector<std::string>& warnings) {
    std::size_t particles = 0;
    Json states = Json::array();
    for (const auto& file : files) {
        const Snapshot snapshot = read_audited(file, options);
        LabelledState state = labelled_state(snapshot, file);
        if (!options.scene.empty())
            state.scene = options.scene;
        const Positions boundary = nearby_boundary(snapshot);
        const std::size_t more = state.size() + boundary.size();
        if (particles + more > max_report_particles) {
            warnings.push_back(left_out_text(file.string(), more));
            continue;
        }
        particles += more;
        states.push_back(state_json(snapshot, state, boundary, model, options));
    }
    return states;
}

ReportPage page_of(const Model& model, const std::vector<std::filesystem::path>& files,
                   const AuditOptions& options, Json data) {
    ReportPage page;
    data["program"] = std::string("meniscus ") + program_version;
    data["label_threshold"] = options.label_threshold.value_or(0);
    data["planes"] = planes_json(model);
    data["states"] = states_json(model, files, options, page.warnings);
    data["notes"] = page.warnings;
    page.html = page_with(data);
    return page;
}

} // namespace

ReportPage report_page(const AuditReport& report, const std::vector<std::filesystem::path>& files,
                       const AuditOptions& options) {
    return page_of(report.model, files, options,
                   {{"model_file", std::filesystem::path(report.model.file).filename().string()},
                    {"model", Json::parse(model_to_json(report.model))},
                    {"audit", Json::parse(to_json(report))}});
}

ReportPage report_page(const std::vector<std::filesystem::path>& files,
                       const AuditOptions& options) {
    return page_of(Model(), files, options, {{"model", nullptr}, {"audit", nullptr}});
}

} // namespace meniscus
