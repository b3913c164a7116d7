#include "json_reader.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <utility>

namespace meniscus {
namespace {

/// Keys of scenes, models and calibrations that had another name in 0.1.0, and their names now.
constexpr std::pair<const char*, const char*> renamed_keys[] = {
    {"least_iterations", "min_iterations"},
    {"most_iterations", "max_iterations"},
    {"smallest", "min"},
    {"largest", "max"},
    {"verify", "verification"},
    {"least_curvature", "min_curvature"},
    {"largest_bias", "max_bias"},
};

/// What files of the project are, and where one comes from.
struct FileKind {
    const char* what;
    const char* source;
};

constexpr FileKind file_kinds[] = {
    {"a model", "`meniscus train` writes one, and `meniscus models` lists those that ship"},
    {"a curvature model", "`meniscus calibrate` writes one"},
    {"a calibration", "configs/curvature has some"},
    {"a scene", "docs/scenes.md says how to write one, and configs/scenes has some"},
};

const FileKind* kind_named(const std::string& what) {
    const auto* found = std::find_if(std::begin(file_kinds), std::end(file_kinds),
                                     [&](const FileKind& kind) { return kind.what == what; });
    return found == std::end(file_kinds) ? nullptr : found;
}

constexpr double max_count = 1e15;
constexpr std::size_t max_text = std::size_t{64} << 20U;

std::string shown(const Json& value) {
    std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    return printable(text, 60);
}

bool is_number_between(const Json& value, double min, double max) {
    return value.is_number() && value.get<double>() >= min && value.get<double>() <= max;
}

std::string between(double min, double max) {
    return number_text(min) + " to " + number_text(max);
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : ", ") + word;
    return text;
}

/// Refuses a file of one kind where another is expected.
void check_kind(const Json& json, const std::string& file, const std::string& expected) {
    const FileKind* kind = kind_named(expected);
    const std::string found = kind_of_json(json);
    if (kind != nullptr && !found.empty() && found != expected)
        throw InputError(file + " is " + found + ", not " + expected + "; " + kind->source);
}

/// What a file is that is no text, or nothing.
std::string binary_kind(const std::string& text) {
    if (text.compare(0, 4, "\x89HDF") == 0)
        return "an HDF5 file, perhaps a snapshot";
    const bool is_text =
        std::none_of(text.begin(), text.begin() + std::min<std::size_t>(text.size(), 100),
                     [](unsigned char c) { return c < 9; });
    return is_text ? "" : "binary data";
}

} // namespace

std::string kind_of_json(const Json& json) {
    if (!json.is_object())
        return {};
    const auto format = json.find("format");
    if (format != json.end() && format->is_string()) {
        const std::string name = format->get<std::string>();
        for (const FileKind& kind : file_kinds) // "meniscus model" is "a model"
            if (name == "meniscus " + std::string(kind.what).substr(2))
                return kind.what;
    }
    return json.contains("fluid") && json.contains("particle_spacing") ? "a scene" : "";
}

Json parse_json(const std::string& text, const std::string& file, const std::string& what) {
    std::string key;
    std::vector<std::set<std::string>> keys_of_open_objects;
    const auto watch = [&](int depth, Json::parse_event_t event, Json& parsed) {
        if (depth > max_nesting)
            throw InputError(file + " is not " + what + ": brackets nest more than " +
                             std::to_string(max_nesting) + " deep");
        if (event == Json::parse_event_t::object_start)
            keys_of_open_objects.emplace_back();
        if (event == Json::parse_event_t::object_end)
            keys_of_open_objects.pop_back();
        if (event == Json::parse_event_t::key) {
            key = parsed.get<std::string>();
            if (!keys_of_open_objects.back().insert(key).second)
                throw InputError(file + ": an object has the key " + quoted_text(key) +
                                 " twice; leave one out");
        }
        return true;
    };
    if (const std::string kind = binary_kind(text); !kind.empty())
        throw InputError(
            file + " is " + kind + ", not " + what + " (JSON)" +
            (kind_named(what) == nullptr ? "" : std::string("; ") + kind_named(what)->source));
    try {
        Json json = Json::parse(text, watch);
        check_kind(json, file, what);
        return json;
    } catch (const nlohmann::json::out_of_range&) {
        throw InputError(file + ": " + quoted_text(key) +
                         " must be a finite number, found one too large");
    } catch (const nlohmann::json::parse_error& error) {
        throw InputError(file + " is not JSON, so not " + what + ": syntax error at byte " +
                         std::to_string(error.byte) +
                         (key.empty() ? "" : ", after key " + quoted_text(key)));
    }
}

std::string text_of_file(const std::filesystem::path& file, const std::string& expected) {
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (!stream && is_failure_of_machine(errno))
        throw FailureError(file.string() + ": cannot be opened: " + std::strerror(errno));
    if (!stream || std::filesystem::is_directory(file))
        throw InputError(file.string() + " cannot be read; expected " + expected);
    std::string text;
    constexpr std::size_t part = 1 << 16;
    while (stream && text.size() <= max_text) { // a device may have no end
        const std::size_t size = text.size();
        text.resize(size + part);
        stream.read(text.data() + size, part);
        text.resize(size + static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad())
        throw FailureError(file.string() + ": cannot be read: " + std::strerror(errno));
    if (text.size() > max_text)
        throw InputError(file.string() + ": expected " + expected + " of at most " +
                         std::to_string(max_text >> 20U) + " MiB, found more");
    return text;
}

JsonReader::JsonReader(const Json& object, std::string file, std::string prefix)
    : object(object), file(std::move(file)), prefix(std::move(prefix)) {
    if (!object.is_object())
        throw InputError(this->file + ": " +
                         (this->prefix.empty() ? "the file" : "'" + this->prefix + "'") +
                         " must hold a JSON object, found " + shown(object));
}

void JsonReader::refuse(const char* key, const std::string& expected) const {
    const auto entry = object.find(key);
    throw InputError(file + ": '" + path(key) + "' must be " + expected + ", found " +
                     (entry == object.end() ? "none" : shown(*entry)));
}

const Json& JsonReader::value(const char* key) const {
    const auto entry = object.find(key);
    if (entry == object.end())
        refuse_old_key(key);
    if (entry == object.end())
        throw InputError(file + ": key '" + path(key) +
                         "' is missing; make the file again or add the key");
    return *entry;
}

double JsonReader::number(const char* key, double min, double max) const {
    const Json& entry = value(key);
    if (!is_number_between(entry, min, max))
        refuse(key, "a number from " + between(min, max));
    return entry.get<double>();
}

int JsonReader::whole_number(const char* key, int min, int max) const {
    const Json& entry = value(key);
    if (!is_number_between(entry, min, max) || entry != entry.get<int>())
        refuse(key, "a whole number from " + std::to_string(min) + " to " + std::to_string(max));
    return entry.get<int>();
}

std::size_t JsonReader::count(const char* key) const {
    const Json& entry = value(key);
    if (!entry.is_number_unsigned() || entry.get<double>() > max_count)
        refuse(key, "a whole number that is not negative");
    return entry.get<std::size_t>();
}

bool JsonReader::truth(const char* key) const {
    if (!value(key).is_boolean())
        refuse(key, "true or false");
    return value(key).get<bool>();
}

std::string JsonReader::text(const char* key) const {
    if (!value(key).is_string())
        refuse(key, "text");
    return value(key).get<std::string>();
}

std::optional<Range> JsonReader::range(const char* key, double min, double max) const {
    if (value(key).is_null())
        return {};
    const JsonReader limits = object_at(key);
    const Range range{limits.number("min", min, max), limits.number("max", min, max)};
    if (range.min > range.max)
        refuse(key, "a range whose min is at most its max");
    return range;
}

std::vector<double> JsonReader::numbers(const char* key, double min, double max) const {
    std::vector<double> numbers;
    for (const Json& entry : list(key)) {
        if (!is_number_between(entry, min, max))
            refuse(key, "a list of numbers from " + between(min, max));
        numbers.push_back(entry.get<double>());
    }
    return numbers;
}

std::vector<std::string> JsonReader::texts(const char* key) const {
    std::vector<std::string> texts;
    for (const Json& entry : list(key)) {
        if (!entry.is_string())
            refuse(key, "a list of texts");
        texts.push_back(entry.get<std::string>());
    }
    return texts;
}

JsonReader JsonReader::object_at(const char* key) const {
    return {value(key), file, path(key)};
}

std::vector<JsonReader> JsonReader::objects(const char* key) const {
    std::vector<JsonReader> objects;
    for (const Json& entry : list(key))
        objects.emplace_back(entry, file,
                             path(key + std::string("[") + std::to_string(objects.size()) + "]"));
    return objects;
}

std::size_t JsonReader::choice(const char* key, const std::vector<std::string>& texts) const {
    const std::string found = text(key);
    const auto place = std::find(texts.begin(), texts.end(), found);
    if (place == texts.end())
        refuse(key, "one of " + listed(texts) + " (did you mean '" +
                        nearest_spelling(found, texts) + "'?)");
    return place - texts.begin();
}

void JsonReader::refuse_old_key(const std::string& key) const {
    for (const auto& [old_key, new_key] : renamed_keys)
        if (key == new_key && object.contains(old_key))
            throw InputError(file + ": the key '" + path(old_key) + "' is now named '" + new_key +
                             "'; rename it");
}

void JsonReader::expect_only(const std::vector<std::string>& keys) const {
    for (const std::string& key : keys)
        refuse_old_key(key);
    for (const auto& item : object.items())
        if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
            throw InputError(file + ": there is no key " + quoted_text(path(item.key())) +
                             "; did you mean '" + nearest_spelling(item.key(), keys) +
                             "'? Keys here: " + listed(keys));
}

std::string JsonReader::path(const std::string& key) const {
    return prefix.empty() ? key : prefix + "." + key;
}

const Json& JsonReader::list(const char* key) const {
    if (!value(key).is_array())
        refuse(key, "a list");
    return value(key);
}

Json range_json(const std::optional<Range>& range) {
    if (!range)
        return nullptr;
    return {{"min", range->min}, {"max", range->max}};
}

} // namespace meniscus
