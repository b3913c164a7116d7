#include "model.hpp"

#include <meniscus/data/boundary_rule.hpp>
#include <meniscus/data/errors.hpp>
#include <meniscus/data/text.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace meniscus {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "meniscus model";
constexpr int format_version = 1;

Json feature_names(bool relative) {
    return {"mass_offset", relative ? "relative_neighbor_count" : "neighbor_count"};
}

// Far beyond anything that features give; larger numbers are damage.
constexpr double largest_coefficient = 1e6;
constexpr double largest_spacing_ratio = 1e3;
constexpr double largest_neighbor_count = 1e6;
constexpr double largest_particle_count = 1e15;

/// One JSON object of the file; takes values out of it and names file and key where it cannot.
class Reader {
public:
    Reader(const Json& object, std::string file, std::string prefix)
        : object(object), file(std::move(file)), prefix(std::move(prefix)) {
        if (!object.is_object())
            throw InputError(this->file + ": " +
                             (this->prefix.empty() ? "the file" : "'" + this->prefix + "'") +
                             " must hold a JSON object, found " + shown(object));
    }

    [[noreturn]] void refuse(const char* key, const std::string& expected) const {
        const auto entry = object.find(key);
        throw InputError(file + ": '" + path(key) + "' must be " + expected + ", found " +
                         (entry == object.end() ? "none" : shown(*entry)));
    }

    [[nodiscard]] const Json& value(const char* key) const {
        const auto entry = object.find(key);
        if (entry == object.end())
            throw InputError(file + ": key '" + path(key) +
                             "' is missing; train the model again or add the key");
        return *entry;
    }

    [[nodiscard]] double number(const char* key, double least, double largest) const {
        const Json& entry = value(key);
        if (!entry.is_number() || !(entry.get<double>() >= least && entry.get<double>() <= largest))
            refuse(key, "a number from " + number_text(least) + " to " + number_text(largest));
        return entry.get<double>();
    }

    [[nodiscard]] std::size_t count(const char* key) const {
        const Json& entry = value(key);
        if (!entry.is_number_unsigned() || entry.get<double>() > largest_particle_count)
            refuse(key, "a number of particles");
        return entry.get<std::size_t>();
    }

    [[nodiscard]] std::string text(const char* key) const {
        if (!value(key).is_string())
            refuse(key, "text");
        return value(key).get<std::string>();
    }

    [[nodiscard]] std::optional<Range> range(const char* key, double largest) const {
        if (value(key).is_null())
            return {};
        const Reader limits(value(key), file, path(key));
        const Range range{limits.number("min", 0, largest), limits.number("max", 0, largest)};
        if (range.min > range.max)
            refuse(key, "a range whose min is at most its max");
        return range;
    }

    [[nodiscard]] std::string path(const char* key) const {
        return prefix.empty() ? key : prefix + "." + key;
    }

private:
    static std::string shown(const Json& value) {
        std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
        return text.size() <= 60 ? text : text.substr(0, 57) + "...";
    }

    const Json& object;
    std::string file;
    std::string prefix;
};

/// Parses, and names the last key that was read where the text breaks off or a number overflows.
Json parse(const std::string& text, const std::string& file) {
    std::string key;
    const auto remember_key = [&](int, Json::parse_event_t event, Json& parsed) {
        if (event == Json::parse_event_t::key)
            key = parsed.get<std::string>();
        return true;
    };
    try {
        return Json::parse(text, remember_key);
    } catch (const nlohmann::json::out_of_range&) {
        throw InputError(file + ": '" + key + "' must be a finite number, found one too large");
    } catch (const nlohmann::json::parse_error& error) {
        throw InputError(file + " is not JSON, so not a model: syntax error at byte " +
                         std::to_string(error.byte) +
                         (key.empty() ? "" : ", after key '" + key + "'"));
    }
}

void check_format(const Reader& reader) {
    if (reader.value("format") != format_name)
        reader.refuse("format", std::string("'") + format_name + "'");
    if (reader.value("format_version") != format_version)
        reader.refuse("format_version",
                      std::to_string(format_version) + " for this program to read it");
    const Json& features = reader.value("features");
    if (features != feature_names(false) && features != feature_names(true))
        reader.refuse("features",
                      feature_names(false).dump() + " or " + feature_names(true).dump());
}

TrainingFile training_file(const Reader& reader) {
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

void read_training(const Reader& reader, const std::string& file, Model& model) {
    const Json& files = reader.value("training_files");
    if (!files.is_array())
        reader.refuse("training_files", "a list");
    std::size_t surface = 0;
    std::size_t interior = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string place = "training_files[" + std::to_string(i) + "]";
        model.training_files.push_back(training_file(Reader(files[i], file, place)));
        surface += model.training_files.back().surface_particles;
        interior +=
            model.training_files.back().particles - model.training_files.back().surface_particles;
    }
    model.false_negatives = reader.count("false_negatives");
    model.false_positives = reader.count("false_positives");
    if (model.false_negatives > surface)
        reader.refuse("false_negatives", "at most the surface particles of the training files");
    if (model.false_positives > interior)
        reader.refuse("false_positives", "at most the interior particles of the training files");
}

Json range_json(const std::optional<Range>& range) {
    if (!range)
        return nullptr;
    return {{"min", range->min}, {"max", range->max}};
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
    const std::string least = rounded_text(range.min, 4);
    const std::string largest = rounded_text(range.max, 4);
    return least == largest ? least : least + " to " + largest;
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

bool read_boundary_rule(const Reader& reader) {
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
    const Json json = parse(text, file.string());
    const Reader reader(json, file.string(), "");
    check_format(reader);
    Model model;
    model.file = file.string();
    model.line.k = reader.number("k", -largest_coefficient, largest_coefficient);
    model.line.d = reader.number("d", -largest_coefficient, largest_coefficient);
    model.dimension = static_cast<int>(reader.number("dimension", 2, 3));
    if (reader.value("dimension") != model.dimension)
        reader.refuse("dimension", "2 or 3");
    model.radius_ratio = reader.number("radius_ratio", 0, 1);
    if (model.radius_ratio == 0)
        reader.refuse("radius_ratio", "above 0");
    if (reader.value("features") == feature_names(true))
        model.reference_neighbor_count =
            reader.number("reference_neighbor_count", 1, largest_neighbor_count);
    model.label_threshold = reader.number("label_threshold", 0, 1);
    if (model.label_threshold == 1)
        reader.refuse("label_threshold", "below 1");
    model.objective = reader.text("objective");
    model.d_margin = reader.number("d_margin", 0, largest_coefficient);
    model.spacing_ratio = reader.range("spacing_ratio", largest_spacing_ratio);
    model.bulk_neighbor_count = reader.range("bulk_neighbor_count", largest_neighbor_count);
    model.phase_rule = reader.text("phase_rule");
    model.boundary_counts = read_boundary_rule(reader);
    read_training(reader, file.string(), model);
    return model;
}

Model read_model(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file))
        throw InputError(file.string() + " cannot be read; expected a model file that `meniscus "
                                         "train` wrote");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    return model_from_json(text, file);
}

std::string model_to_json(const Model& model) {
    Json files = Json::array();
    for (const TrainingFile& file : model.training_files)
        files.push_back({{"name", file.name},
                         {"hash", file.hash},
                         {"scene", file.scene},
                         {"particles", file.particles},
                         {"surface_particles", file.surface_particles}});
    const bool relative = model.reference_neighbor_count > 0;
    Json json = {{"format", format_name},
                 {"format_version", format_version},
                 {"k", model.line.k},
                 {"d", model.line.d},
                 {"features", feature_names(relative)},
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
    if (relative)
        json["reference_neighbor_count"] = model.reference_neighbor_count;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
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
