#include "model.hpp"

#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/particles/boundary_rule.hpp>
#include <meniscus/data/particles/feature_names.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>

namespace meniscus {
namespace {

constexpr const char* format_name = "meniscus model";
constexpr int format_version = 1;

/// Neighbor counts by the median of their state, in place of the paper's own.
constexpr const char* relative_count = "relative_neighbor_count";
constexpr const char* side_key = "surface_side";

// Far beyond anything that features give; larger numbers are damage.
constexpr double max_coefficient = 1e6;
constexpr double max_spacing_ratio = 1e3;
constexpr double max_neighbor_count = 1e6;

void check_format(const JsonReader& reader) {
    if (reader.value("format") != format_name)
        reader.refuse("format", std::string("'") + format_name + "'");
    if (reader.value("format_version") != format_version)
        reader.refuse("format_version",
                      std::to_string(format_version) + " for this program to read it");
}

/// Sets features, and the reference count where they are relative.
void read_features(const JsonReader& reader, Model& model) {
    constexpr FeaturePair of_paper;
    auto names = reader.texts("features");
    const std::string expected = "two different names of " + feature_names() + "; or " +
                                 feature_list[of_paper.first].name + " and " + relative_count;
    if (names.size() != 2 || names[0] == names[1])
        reader.refuse("features", expected);
    const bool relative =
        names[0] == feature_list[of_paper.first].name && names[1] == relative_count;
    if (relative) {
        names[1] = feature_list[of_paper.second].name;
        model.reference_neighbor_count =
            reader.number("reference_neighbor_count", 1, max_neighbor_count);
    }
    model.features = {find_feature(names[0]), find_feature(names[1])};
    if (model.features.first == feature_count || model.features.second == feature_count)
        reader.refuse("features", expected);
    if (reader.has(side_key) && !is_of_paper(model.features))
        model.line.above = reader.choice(side_key, {"below", "above"}) == 1;
}

Json features_json(const Model& model) {
    return {feature_list[model.features.first].name,
            model.reference_neighbor_count > 0 ? relative_count
                                               : feature_list[model.features.second].name};
}

TrainingFile training_file(const JsonReader& reader) {
    TrainingFile file;
    file.name = reader.text("name");
    file.hash = reader.text("hash");
    file.scene = reader.text("scene");
    file.particles = reader.count("particles");
    file.surface_particles = reader.count("surface_particles");
    if (file.surface_particles > file.particles)
        reader.refuse("surface_particles", "at most the number of particles");
    return file;
}

void read_training(const JsonReader& reader, Model& model) {
    std::size_t surface = 0;
    std::size_t interior = 0;
    for (const JsonReader& entry : reader.objects("training_files")) {
        const TrainingFile file = training_file(entry);
        surface += file.surface_particles;
        interior += file.particles - file.surface_particles;
        model.training_files.push_back(file);
    }
    model.false_negatives = reader.count("false_negatives");
    model.false_positives = reader.count("false_positives");
    if (model.false_negatives > surface)
        reader.refuse("false_negatives", "at most the surface particles of the training files");
    if (model.false_positives > interior)
        reader.refuse("false_positives", "at most the interior particles of the training files");
}

/// How far outside the range, in units of the value; 0 inside.
double excess(const Range& range, double value) {
    // The ratio of two decimal numbers is off by rounding; that is no other ratio.
    constexpr double tolerance = 1e-6;
    const double below = range.min * (1 - tolerance) - value;
    const double above = value - range.max * (1 + tolerance);
    return std::max({below, above, 0.0});
}

std::string range_text(const Range& range) {
    const std::string min = rounded_text(range.min, 4);
    const std::string max = rounded_text(range.max, 4);
    return min == max ? min : min + " to " + max;
}

std::string worst_use(const std::string& what, const std::optional<Range>& trained,
                      const std::vector<ModelUse>& uses, std::optional<double> ModelUse::*member) {
    const ModelUse* worst = nullptr;
    double worst_excess = 0;
    for (const ModelUse& use : uses)
        if (trained && use.*member && excess(*trained, *(use.*member)) > worst_excess) {
            worst = &use;
            worst_excess = excess(*trained, *(use.*member));
        }
    if (worst == nullptr)
        return {};
    return what + " is " + rounded_text(*(worst->*member), 4) +
           (worst->file.empty() ? "" : " in " + worst->file) + " and was " + range_text(*trained) +
           " in training";
}

bool read_boundary_rule(const JsonReader& reader) {
    constexpr const char* key = "boundary_rule";
    const auto counts = boundary_counts_from(reader.text(key));
    if (!counts)
        reader.refuse(key, "'" + std::string(boundary_counts_text) + "' or '" +
                               std::string(boundary_ignored_text) + "'");
    return *counts;
}

std::string model_name(const Model& model) {
    return model.file.empty() ? std::string("the model") : "model " + model.file;
}

} // namespace

Model model_from_json(const std::string& text, const std::filesystem::path& file) {
    const Json json = parse_json(text, file.string(), "a model");
    const JsonReader reader(json, file.string(), "");
    check_format(reader);
    Model model;
    model.file = file.string();
    model.line.k = reader.number("k", -max_coefficient, max_coefficient);
    model.line.d = reader.number("d", -max_coefficient, max_coefficient);
    model.dimension = reader.whole_number("dimension", 2, 3);
    model.radius_ratio = reader.number("radius_ratio", 0, 1);
    if (model.radius_ratio == 0)
        reader.refuse("radius_ratio", "above 0");
    read_features(reader, model);
    model.label_threshold = reader.number("label_threshold", 0, 1);
    if (model.label_threshold == 1)
        reader.refuse("label_threshold", "below 1");
    model.objective = reader.text("objective");
    model.d_margin = reader.number("d_margin", 0, max_coefficient);
    model.spacing_ratio = reader.range("spacing_ratio", 0, max_spacing_ratio);
    model.bulk_neighbor_count = reader.range("bulk_neighbor_count", 0, max_neighbor_count);
    model.phase_rule = reader.text("phase_rule");
    model.boundary_counts = read_boundary_rule(reader);
    read_training(reader, model);
    return model;
}

Model read_model(const std::filesystem::path& file) {
    return model_from_json(text_of_file(file, "a model file that `meniscus train` wrote"), file);
}

std::string model_to_json(const Model& model) {
    Json files = Json::array();
    for (const TrainingFile& file : model.training_files)
        files.push_back({{"name", file.name},
                         {"hash", file.hash},
                         {"scene", file.scene},
                         {"particles", file.particles},
                         {"surface_particles", file.surface_particles}});
    Json json = {{"format", format_name},
                 {"format_version", format_version},
                 {"k", model.line.k},
                 {"d", model.line.d},
                 {"features", features_json(model)},
                 {"dimension", model.dimension},
                 {"radius_ratio", model.radius_ratio},
                 {"label_threshold", model.label_threshold},
                 {"objective", model.objective},
                 {"d_margin", model.d_margin},
                 {"spacing_ratio", range_json(model.spacing_ratio)},
                 {"bulk_neighbor_count", range_json(model.bulk_neighbor_count)},
                 {"phase_rule", model.phase_rule},
                 {"boundary_rule", boundary_rule_text(model.boundary_counts)},
                 {"training_files", files},
                 {"false_negatives", model.false_negatives},
                 {"false_positives", model.false_positives}};
    if (!is_of_paper(model.features))
        json[side_key] = model.line.above ? "above" : "below";
    if (model.reference_neighbor_count > 0)
        json["reference_neighbor_count"] = model.reference_neighbor_count;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string line_text(const Line& line, const FeaturePair& features, int digits) {
    const bool plain = is_of_paper(features);
    return std::string(plain ? "y" : feature_list[features.second].name) +
           (line.above ? " >= " : " <= ") + rounded_text(line.k, digits) + " " +
           (plain ? "x" : feature_list[features.first].name) + " + " + rounded_text(line.d, digits);
}

void check_features_of_paper(const Model& model, const std::string& what) {
    if (!is_of_paper(model.features))
        throw InputError(model_name(model) + " is of the features " + names_of(model.features) +
                         ", and " + what + " needs " + names_of({}) +
                         "; use a model that was trained with these");
}

void check_dimension(const Model& model, int dimension, const std::string& file) {
    if (model.dimension != dimension)
        throw InputError(model_name(model) + " was trained in " + std::to_string(model.dimension) +
                         "D, " + file + " is " + std::to_string(dimension) +
                         "D; use a model trained in that dimension");
}

void check_radius_ratio(const Model& model, double radius_ratio, const std::string& file) {
    if (model.radius_ratio != radius_ratio)
        throw InputError(model_name(model) + " was trained with radius ratio " +
                         number_text(model.radius_ratio) + ", " + file + " was labelled with " +
                         number_text(radius_ratio) + "; label it with --radius-ratio " +
                         number_text(model.radius_ratio));
}

void check_boundary_rule(const Model& model, bool boundary_counts, const std::string& file) {
    if (model.boundary_counts != boundary_counts)
        throw InputError(model_name(model) + " was trained by the rule '" +
                         std::string(boundary_rule_text(model.boundary_counts)) + "', " + file +
                         " was labelled by '" + std::string(boundary_rule_text(boundary_counts)) +
                         "'; label it " + (model.boundary_counts ? "with" : "without") +
                         " --boundary-counts");
}

std::string outside_trained_range(const Model& model, const std::vector<ModelUse>& uses) {
    const std::string spacing =
        worst_use("h / particle spacing", model.spacing_ratio, uses, &ModelUse::spacing_ratio);
    const std::string bulk = worst_use("bulk neighbor count", model.bulk_neighbor_count, uses,
                                       &ModelUse::bulk_neighbor_count);
    if (spacing.empty() && bulk.empty())
        return {};
    return model_name(model) + " is used outside what it was trained on: " + spacing +
           (spacing.empty() || bulk.empty() ? "" : "; ") + bulk;
}

} // namespace meniscus
