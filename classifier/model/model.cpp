#include "model.hpp"

#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/particles/feature_names.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/surface/option_table.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

constexpr const char* model_format = "meniscus model";
constexpr int format_version = 1;

constexpr const char* side_key = "surface_side";

// Far beyond anything that features give; larger numbers are damage.
constexpr double max_coefficient = 1e6;
constexpr double max_spacing_ratio = 1e3;
constexpr double max_neighbor_count = 1e6;

void check_format(const JsonReader& reader) {
    if (reader.value("format") != model_format)
        reader.refuse("format", std::string("'") + model_format + "'");
    if (reader.value("format_version") != format_version)
        reader.refuse("format_version",
                      std::to_string(format_version) + " for this program to read it");
}

/// The two features of a line.
FeaturePair read_features(const JsonReader& reader) {
    const auto names = reader.texts("features");
    FeaturePair pair;
    if (names.size() == 2)
        pair = {find_feature(names[0]), find_feature(names[1])};
    if (names.size() != 2 || names[0] == names[1] || pair.first == feature_count ||
        pair.second == feature_count)
        reader.refuse("features", "two different names of " + feature_names());
    return pair;
}

Json features_json(const FeaturePair& pair) {
    return {feature_list[pair.first].name, feature_list[pair.second].name};
}

bool read_side(const JsonReader& reader) {
    return reader.choice(side_key, {"below", "above"}) == 1;
}

const char* side_text(const Line& line) {
    return line.above ? "above" : "below";
}

constexpr const char* second_key = "second_line";

SecondModelLine second_line(const JsonReader& reader) {
    SecondModelLine second;
    second.features = read_features(reader);
    second.line.k = reader.number("k", -max_coefficient, max_coefficient);
    second.line.d = reader.number("d", -max_coefficient, max_coefficient);
    second.line.above = read_side(reader);
    second.d_margin = reader.number("d_margin", 0, max_coefficient);
    return second;
}

Json second_json(const SecondModelLine& second) {
    return {{"features", features_json(second.features)},
            {side_key, side_text(second.line)},
            {"k", second.line.k},
            {"d", second.line.d},
            {"d_margin", second.d_margin}};
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
    // What is off by less than the digits that messages show, as measured spacings are, is no
    // other.
    constexpr double tolerance = 5e-4;
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
    model.features = read_features(reader);
    if (reader.has(side_key) && !is_of_paper(model.features))
        model.line.above = read_side(reader);
    model.reference_spacing_ratio = reader.number("reference_spacing_ratio", 0, max_spacing_ratio);
    if (reader.has(second_key)) {
        if (!is_of_paper(model.features))
            reader.refuse(second_key,
                          "absent, or after a first line of " + names_of(FeaturePair{}));
        model.second = second_line(reader.object_at(second_key));
    }
    model.label_threshold = reader.number("label_threshold", 0, 1);
    if (model.label_threshold == 1)
        reader.refuse("label_threshold", "below 1");
    model.objective = reader.text("objective");
    model.d_margin = reader.number("d_margin", 0, max_coefficient);
    model.spacing_ratio = reader.range("spacing_ratio", 0, max_spacing_ratio);
    model.bulk_neighbor_count = reader.range("bulk_neighbor_count", 0, max_neighbor_count);
    model.phase_rule = reader.text("phase_rule");
    model.boundary_weight = reader.number("boundary_weight", 0, 10);
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
    Json json = {{"format", model_format},
                 {"format_version", format_version},
                 {"k", model.line.k},
                 {"d", model.line.d},
                 {"features", features_json(model.features)},
                 {"dimension", model.dimension},
                 {"radius_ratio", model.radius_ratio},
                 {"label_threshold", model.label_threshold},
                 {"objective", model.objective},
                 {"d_margin", model.d_margin},
                 {"spacing_ratio", range_json(model.spacing_ratio)},
                 {"bulk_neighbor_count", range_json(model.bulk_neighbor_count)},
                 {"phase_rule", model.phase_rule},
                 {"boundary_weight", model.boundary_weight},
                 {"reference_spacing_ratio", model.reference_spacing_ratio},
                 {"training_files", files},
                 {"false_negatives", model.false_negatives},
                 {"false_positives", model.false_positives}};
    if (!is_of_paper(model.features))
        json[side_key] = side_text(model.line);
    if (model.second)
        json[second_key] = second_json(*model.second);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string line_text(const Line& line, const FeaturePair& features, int digits) {
    const bool plain = is_of_paper(features);
    return std::string(plain ? "y" : feature_list[features.second].name) +
           (line.above ? " >= " : " <= ") + rounded_text(line.k, digits) + " " +
           (plain ? "x" : feature_list[features.first].name) + " + " + rounded_text(line.d, digits);
}

void check_features_of_paper(const Model& model, const std::string& what) {
    if (model.second)
        throw InputError(model_name(model) + " has two lines, and " + what +
                         " needs one; use a model that was trained without --second-features");
    if (!is_of_paper(model.features))
        throw InputError(model_name(model) + " is of the features " + names_of(model.features) +
                         ", and " + what + " needs " + names_of(FeaturePair{}) +
                         "; use a model that was trained with these");
}

void set_classifier(SurfaceTensionOptions& options, const Model& model) {
    const double ratio = options.spacing_ratio / model.reference_spacing_ratio;
    const double scale = model.reference_spacing_ratio > 0 ? std::pow(ratio, model.dimension) : 1;
    const auto as_second = [&](const FeaturePair& pair, const Line& line) {
        return SecondLine{true,
                          pair.first,
                          pair.second,
                          scaled_k(line.k, pair, scale),
                          scaled_d(line.d, pair, scale),
                          line.above};
    };
    const bool of_paper = is_of_paper(model.features);
    set_line(options, of_paper ? SurfaceLine<double>{model.line.k * scale, model.line.d * scale}
                               : line_that_passes_all);
    options.second_line = !of_paper      ? as_second(model.features, model.line)
                          : model.second ? as_second(model.second->features, model.second->line)
                                         : SecondLine{};
    options.boundary_weight = model.boundary_weight;
    options.radius_ratio = model.radius_ratio;
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

void check_boundary_weight(const Model& model, std::optional<double> boundary_weight,
                           const std::string& file) {
    if (boundary_weight && model.boundary_weight != *boundary_weight)
        throw InputError(model_name(model) + " was trained with boundary weight " +
                         rounded_text(model.boundary_weight, 6) + ", " + file +
                         " was labelled with " + rounded_text(*boundary_weight, 6) +
                         "; label it with --boundary-weight " + number_text(model.boundary_weight));
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
