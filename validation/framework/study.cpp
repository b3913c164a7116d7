#include "study.hpp"

#include <algorithm>

namespace meniscus {
namespace {

/// What a value of an axis is called in names of files.
std::string file_part(const std::string& label) {
    std::string part;
    for (const char c : label) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '.' || c == '-';
        if (plain)
            part += c;
        else if (!part.empty() && part.back() != '_')
            part += '_';
    }
    return part;
}

/// Where scenes lie.
struct Folders {
    std::filesystem::path study;
    std::filesystem::path scenes; ///< those that ship
};

std::filesystem::path scene_file(const std::string& name, const Folders& folders) {
    const std::filesystem::path file = name;
    return file.extension() == ".json" ? folders.study / file : folders.scenes / (name + ".json");
}

/// The run with what the value says besides.
StudyRun with_value(StudyRun run, const std::string& axis, const JsonReader& value,
                    const Folders& folders) {
    value.expect_only({"name", "scene", "variant", "set", "numbers"});
    const std::string name = value.text("name");
    run.labels.emplace_back(axis, name);
    run.name += (run.name.empty() ? "" : "_") + file_part(name);
    if (value.has("scene"))
        run.scene = scene_file(value.text("scene"), folders);
    if (value.has("variant"))
        run.variant = value.text("variant");
    if (value.has("set"))
        for (const std::string& change : value.texts("set"))
            run.changes.push_back(change);
    if (value.has("numbers")) {
        const JsonReader numbers = value.object_at("numbers");
        for (const auto& [key, number] : value.value("numbers").items())
            run.numbers[key] = numbers.number(key.c_str(), -1e12, 1e12);
    }
    return run;
}

/// Every combination of one value of each axis, the last one changing fastest.
std::vector<StudyRun> combined(const JsonReader& size, const Folders& folders) {
    std::vector<StudyRun> runs(1);
    for (const JsonReader& axis : size.objects("axes")) {
        axis.expect_only({"name", "values"});
        std::vector<StudyRun> more;
        for (const StudyRun& run : runs)
            for (const JsonReader& value : axis.objects("values"))
                more.push_back(with_value(run, axis.text("name"), value, folders));
        runs = std::move(more);
    }
    return runs;
}

void refuse_equal_names(const std::vector<StudyRun>& runs, const JsonReader& size) {
    std::vector<std::string> names;
    for (const StudyRun& run : runs)
        names.push_back(run.name);
    std::sort(names.begin(), names.end());
    if (std::adjacent_find(names.begin(), names.end()) != names.end())
        size.refuse("axes", "such that runs differ in the letters, digits, '.' and '-' of their "
                            "values' names");
}

} // namespace

StudyPlan read_plan(const std::filesystem::path& folder, const std::string& size,
                    const std::filesystem::path& scenes) {
    const std::filesystem::path file = folder / "study.json";
    const Json json = parse_json(text_of_file(file, "a study (JSON)"), file.string(), "a study");
    const JsonReader reader(json, file.string(), "");
    reader.expect_only({"title", "small", "paper", "compared"});
    const JsonReader of_size = reader.object_at(size.c_str());
    of_size.expect_only({"axes"});
    StudyPlan plan;
    plan.title = reader.text("title");
    plan.runs = combined(of_size, {folder, scenes});
    refuse_equal_names(plan.runs, of_size);
    const JsonReader compared = reader.object_at("compared");
    for (const auto& [figure, within] : reader.value("compared").items())
        plan.compared[figure] = compared.number(figure.c_str(), 0, 1e12);
    return plan;
}

} // namespace meniscus
