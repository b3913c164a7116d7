#include "detail/changed_json.hpp"

#include "methods.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>

namespace meniscus {
namespace {

/// "a.b=1" as {"a": {"b": 1}}.
Json patch_of(const std::string& change) {
    const std::size_t equals = change.find('=');
    const std::string key = change.substr(0, equals);
    if (equals == std::string::npos || key.empty() || key.front() == '.' || key.back() == '.' ||
        key.find("..") != std::string::npos)
        throw InputError("the change " + quoted_text(change) +
                         " must be of the form key=value, such as pressure.solver=iisph");
    const std::string value = change.substr(equals + 1);
    if (std::count(key.begin(), key.end(), '.') > max_nesting)
        throw InputError("the change " + quoted_text(change) + " must name a key that is there");
    Json patch = value; // a text needs no quotes
    if (Json::accept(value))
        patch = parse_json(value, "the change " + quoted_text(change), "a value");
    std::size_t end = key.size();
    while (end != std::string::npos) {
        const std::size_t dot = key.rfind('.', end - 1);
        const std::size_t begin = dot == std::string::npos ? 0 : dot + 1;
        Json outer;
        outer[key.substr(begin, end - begin)] = std::move(patch);
        patch = std::move(outer);
        end = dot;
    }
    return patch;
}

/// Adds a patch to those before it, of which it replaces what it names; nulls are kept.
void add_patch(const Json& patch, Json& sum) {
    for (const auto& [key, value] : patch.items())
        if (value.is_object() && sum.contains(key) && sum[key].is_object())
            add_patch(value, sum[key]);
        else
            sum[key] = value;
}

/// The text under a key of a section; empty where there is none.
std::string text_at(const Json& json, const char* section, const char* key) {
    const auto at = json.find(section);
    if (at == json.end() || !at->is_object() || !at->contains(key) || !(*at)[key].is_string())
        return {};
    return (*at)[key];
}

bool names_key(const Json& asked, const char* section, const std::string& key) {
    const auto at = asked.find(section);
    return at != asked.end() && at->is_object() && at->contains(key);
}

/// Takes keys out of a section that `has_meaning` denies, but for those that were asked for.
template <class HasMeaning>
void leave_out(Json& json, const Json& asked, const char* section, const std::string& method,
               const HasMeaning& has_meaning, std::vector<std::string>& left_out) {
    std::vector<std::string> keys;
    for (const auto& item : json[section].items())
        if (!names_key(asked, section, item.key()) && !has_meaning(item.key()))
            keys.push_back(item.key());
    for (const std::string& key : keys) {
        json[section].erase(key);
        left_out.push_back(std::string(section) + "." + key +
                           " is left out: it has no meaning for " + method);
    }
}

/// The row of that name, or nullptr.
template <class Row>
const Row* row_named(const std::vector<Row>& rows, const std::string& name) {
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](const Row& one) { return one.name == name; });
    return row == rows.end() ? nullptr : &*row;
}

void settle_solver(const Json& before, const Json& asked, Json& json,
                   std::vector<std::string>& left_out) {
    const std::string name = text_at(json, "pressure", "solver");
    const PressureSolverRow* solver = row_named(pressure_solvers(), name);
    if (solver == nullptr || name == text_at(before, "pressure", "solver"))
        return;
    const auto has_meaning = [&](const std::string& key) {
        const auto* known = std::find_if(std::begin(pressure_keys), std::end(pressure_keys),
                                         [&](const PressureKey& one) { return key == one.name; });
        return known == std::end(pressure_keys) || reads_key(*solver, key);
    };
    leave_out(json, asked, "pressure", "solver " + name, has_meaning, left_out);
    for (const PressureKey& key : pressure_keys)
        if (!has_default(key) && reads_key(*solver, key.name) &&
            !json["pressure"].contains(key.name))
            throw InputError("solver " + name + " needs pressure." + key.name +
                             ", which the scene does not have; give --set pressure." + key.name +
                             "=VALUE too");
}

void settle_model(const Json& before, const Json& asked, Json& json,
                  std::vector<std::string>& left_out) {
    constexpr const char* section = "surface_tension";
    const std::string name = text_at(json, section, "model");
    const std::string earlier = text_at(before, section, "model");
    const TensionModelRow* model = row_named(tension_models(), name);
    const TensionModelRow* other = row_named(tension_models(), earlier);
    if (model == nullptr || other == nullptr || name == earlier)
        return;
    if (!names_key(asked, section, "coefficient") && !(model->has_sigma && other->has_sigma))
        throw InputError("the scene's surface_tension.coefficient is that of model " + earlier +
                         (other->has_sigma ? " (sigma in N/m)" : "") + ", and model " + name +
                         " has " + (model->has_sigma ? "sigma in N/m" : "one of another unit") +
                         "; give --set surface_tension.coefficient=VALUE too");
    const auto has_meaning = [&](const std::string& key) {
        if (key == "restrict_to_surface")
            return !model->finds_surface;
        const auto& keys = other->keys;
        return std::find(keys.begin(), keys.end(), key) == keys.end();
    };
    leave_out(json, asked, section, "model " + name, has_meaning, left_out);
}

} // namespace

Json changed_json(Json json, const std::vector<std::string>& changes,
                  std::vector<std::string>& left_out) {
    const Json before = json;
    Json asked = Json::object();
    for (const std::string& change : changes) {
        const Json patch = patch_of(change);
        json.merge_patch(patch);
        add_patch(patch, asked);
    }
    settle_solver(before, asked, json, left_out);
    settle_model(before, asked, json, left_out);
    return json;
}

} // namespace meniscus
