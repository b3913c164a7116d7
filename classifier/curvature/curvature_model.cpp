#include "curvature_model.hpp"

#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

constexpr const char* curvature_model_format = "meniscus curvature model";
constexpr const char* expectation = "a model file that `meniscus calibrate` wrote";
constexpr double max_coefficient = 1e3; ///< far beyond anything that clouds give
constexpr double max_curvature = 100;   ///< h kappa
constexpr double max_spacing_ratio = 1e3;

Json coefficients_json(const CurvatureMap& map) {
    Json coefficients;
    for (std::size_t term = 0; term < curvature_terms().size(); ++term)
        coefficients[curvature_terms()[term]] = map.coefficients[term];
    return coefficients;
}

Json residual_json(const CurvatureResidual& residual) {
    return {{"shape", residual.shape},         {"arrangement", residual.arrangement},
            {"h_over_r", residual.size},       {"particles", residual.particles},
            {"curvature", residual.curvature}, {"bias", residual.bias},
            {"max_bias", residual.max_bias},   {"deviation", residual.deviation}};
}

CurvatureResidual read_residual(const JsonReader& reader) {
    CurvatureResidual residual;
    residual.shape = reader.text("shape");
    residual.arrangement = reader.text("arrangement");
    residual.size = reader.number("h_over_r", 0, max_curvature);
    residual.particles = reader.count("particles");
    residual.curvature = reader.number("curvature", -max_curvature, max_curvature);
    residual.bias = reader.number("bias", -max_curvature, max_curvature);
    residual.max_bias = reader.number("max_bias", 0, max_curvature);
    residual.deviation = reader.number("deviation", 0, max_curvature);
    return residual;
}

CurvatureMap read_map(const JsonReader& reader) {
    CurvatureMap map{};
    map.dimension = reader.whole_number("dimension", 2, 3);
    const JsonReader coefficients = reader.object_at("coefficients");
    coefficients.expect_only(curvature_terms());
    for (std::size_t term = 0; term < curvature_terms().size(); ++term)
        map.coefficients[term] =
            coefficients.number(curvature_terms()[term].c_str(), -max_coefficient, max_coefficient);
    const auto turning = reader.range("turning", -max_curvature, max_curvature);
    if (!turning)
        reader.refuse("turning", "a range");
    map.min = turning->min;
    map.max = turning->max;
    map.averaged = reader.truth("averaged");
    return map;
}

} // namespace

CurvatureModel curvature_model_from_json(const std::string& text,
                                         const std::filesystem::path& file) {
    const Json json = parse_json(text, file.string(), "a curvature model");
    const JsonReader reader(json, file.string(), "");
    if (reader.value("format") != curvature_model_format)
        reader.refuse("format", std::string("'") + curvature_model_format + "'");
    if (reader.value("format_version") != 1)
        reader.refuse("format_version", "1 for this program to read it");
    CurvatureModel model;
    model.file = file.string();
    model.map = read_map(reader);
    model.clouds = reader.text("clouds");
    if (model.clouds != "filled" && model.clouds != "dense")
        reader.refuse("clouds", "'filled' or 'dense'");
    model.radius_ratio = reader.number("radius_ratio", 0.01, 0.999);
    model.fade = reader.number("fade", 0, 1);
    model.tau = reader.number("tau", 0, 1);
    model.normal_passes = reader.whole_number("normal_passes", 0, 100);
    const auto spacing_ratio = reader.range("spacing_ratio", 0, max_spacing_ratio);
    if (!spacing_ratio)
        reader.refuse("spacing_ratio", "a range");
    model.spacing_ratio = *spacing_ratio;
    model.bias_penalty = reader.number("bias_penalty", 0, 1e9);
    model.min_curvature = reader.number("min_curvature", 0, max_curvature);
    model.seed = reader.count("seed");
    model.cloud_count = reader.count("cloud_count");
    model.particles = reader.count("particles");
    for (const JsonReader& residual : reader.objects("residuals"))
        model.residuals.push_back(read_residual(residual));
    return model;
}

CurvatureModel read_curvature_model(const std::filesystem::path& file) {
    return curvature_model_from_json(text_of_file(file, expectation), file);
}

std::string curvature_model_to_json(const CurvatureModel& model) {
    Json residuals = Json::array();
    for (const CurvatureResidual& residual : model.residuals)
        residuals.push_back(residual_json(residual));
    const Json json = {{"format", curvature_model_format},
                       {"format_version", 1},
                       {"dimension", model.map.dimension},
                       {"coefficients", coefficients_json(model.map)},
                       {"turning", range_json(Range{model.map.min, model.map.max})},
                       {"averaged", model.map.averaged},
                       {"clouds", model.clouds},
                       {"radius_ratio", model.radius_ratio},
                       {"fade", model.fade},
                       {"tau", model.tau},
                       {"normal_passes", model.normal_passes},
                       {"spacing_ratio", range_json(model.spacing_ratio)},
                       {"bias_penalty", model.bias_penalty},
                       {"min_curvature", model.min_curvature},
                       {"seed", model.seed},
                       {"cloud_count", model.cloud_count},
                       {"particles", model.particles},
                       {"residuals", residuals}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::string> residual_lines(const CurvatureModel& model) {
    std::vector<std::string> lines;
    std::vector<std::string> told;
    for (const CurvatureResidual& first : model.residuals) {
        if (std::find(told.begin(), told.end(), first.shape) != told.end())
            continue;
        told.push_back(first.shape);
        Range sizes{first.size, first.size};
        double bias = 0;
        double variance = 0;
        int rows = 0;
        for (const CurvatureResidual& row : model.residuals) {
            if (row.shape != first.shape)
                continue;
            sizes = {std::min(sizes.min, row.size), std::max(sizes.max, row.size)};
            bias = std::max(bias, row.max_bias);
            variance += row.deviation * row.deviation;
            ++rows;
        }
        lines.push_back(first.shape + ", h/R " + rounded_text(sizes.min, 3) +
                        (sizes.min < sizes.max ? " to " + rounded_text(sizes.max, 3) : "") +
                        ": off by at most " + rounded_text(bias, 2) + ", +- " +
                        rounded_text(std::sqrt(variance / rows), 2));
    }
    return lines;
}

bool is_curvature_model(const std::filesystem::path& file) {
    const Json json =
        parse_json(text_of_file(file, "a model file"), file.string(), "a model of either kind");
    const auto format = json.is_object() ? json.find("format") : json.end();
    return format != json.end() && *format == curvature_model_format;
}

void check_dimension(const CurvatureModel& model, int dimension, const std::string& file) {
    if (model.map.dimension != dimension)
        throw InputError("curvature model" + (model.file.empty() ? "" : " " + model.file) +
                         " was trained in " + std::to_string(model.map.dimension) + "D, " + file +
                         " is " + std::to_string(dimension) +
                         "D; use a model trained in that dimension");
}

} // namespace meniscus
