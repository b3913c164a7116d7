// Reading JSON that people write or mend by hand: every value is taken out with what it may be, and
// a value that is not names its file and its key. Integers, texts and lists have one way each.
#pragma once

#include <meniscus/data/text/range.hpp>
#include <meniscus/data/text/spelling.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

using Json = nlohmann::ordered_json;

/// Brackets inside one another, and objects that a key names.
inline constexpr int max_nesting = 100;

/// Parses. Throws InputError that names the file, what it should be ("a model") and the last key
/// that was read, where the text breaks off, a number overflows, an object has a key twice, or
/// brackets nest more than max_nesting deep; and where the file is of another kind (kind_of_json),
/// with what it is and where one of the expected kind comes from.
Json parse_json(const std::string& text, const std::string& file, const std::string& what);

/// What the JSON of a file of the project is, as parse_json() is told: "a model", "a curvature
/// model", "a calibration" or "a scene"; empty for anything else.
std::string kind_of_json(const Json& json);

/// The whole file as text. Throws InputError, with what was expected, where it cannot be read or is
/// longer than any that people write; FailureError where the machine cannot open it.
std::string text_of_file(const std::filesystem::path& file, const std::string& expected);

/// One JSON object of a file, which must outlive it. Every member throws InputError, naming file
/// and key, where the key is missing or the value is not what was asked for.
class JsonReader {
public:
    /// `prefix`: where in the file the object stands, "" for all of it.
    JsonReader(const Json& object, std::string file, std::string prefix);

    [[noreturn]] void refuse(const char* key, const std::string& expected) const;
    [[nodiscard]] bool has(const char* key) const { return object.contains(key); }
    [[nodiscard]] const Json& value(const char* key) const;
    [[nodiscard]] double number(const char* key, double min, double max) const;
    [[nodiscard]] int whole_number(const char* key, int min, int max) const;
    [[nodiscard]] std::size_t count(const char* key) const;
    [[nodiscard]] bool truth(const char* key) const;
    [[nodiscard]] std::string text(const char* key) const;
    [[nodiscard]] std::optional<Range> range(const char* key, double min, double max) const;
    /// A list of numbers, of any length.
    [[nodiscard]] std::vector<double> numbers(const char* key, double min, double max) const;
    [[nodiscard]] std::vector<std::string> texts(const char* key) const;
    [[nodiscard]] JsonReader object_at(const char* key) const;
    [[nodiscard]] std::vector<JsonReader> objects(const char* key) const;
    /// Which of these texts, of which there is at least one, stands there.
    [[nodiscard]] std::size_t choice(const char* key, const std::vector<std::string>& texts) const;
    /// Refuses keys that are none of these, which are mostly misspelt ones, with the nearest of
    /// these and all of them.
    void expect_only(const std::vector<std::string>& keys) const;

private:
    [[nodiscard]] std::string path(const std::string& key) const;
    /// Refuses the object where the key stands in it under a name that it had before.
    void refuse_old_key(const std::string& key) const;
    [[nodiscard]] const Json& list(const char* key) const;

    const Json& object;
    std::string file;
    std::string prefix;
};

/// The range as an object of min and max; null where there is none.
Json range_json(const std::optional<Range>& range);

} // namespace meniscus
