#include "checkpoint.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/sha256.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/runtime/version.hpp>

#include <algorithm>
#include <optional>

namespace meniscus {
namespace {

constexpr double max_number = 1e300;
constexpr const char* advice = "; --restart starts the scene over, another folder keeps both";
constexpr const char* sum_name = "sha256"; // of the provenance

/// Calls visit(key, value) for each number of a checkpoint, so that writing and reading agree.
template <class SomeCheckpoint, class Visit>
void each_number(SomeCheckpoint& checkpoint, const Visit& visit) {
    visit("steps", checkpoint.state.steps);
    visit("time_step", checkpoint.state.time_step);
    visit("next_frame", checkpoint.next_frame);
    visit("usual_step", checkpoint.usual_step);
    auto& sums = checkpoint.since_frame;
    visit("steps_since_frame", sums.steps);
    visit("unconverged_steps", sums.unconverged_steps);
    visit("pressure_iterations", sums.pressure_iterations);
    visit("divergence_iterations", sums.divergence_iterations);
    visit("time_since_frame", sums.time);
    visit("density_error", sums.density_error);
    visit("max_density_error", sums.max_density_error);
    visit("divergence_error", sums.divergence_error);
    visit("max_divergence_error", sums.max_divergence_error);
    visit("tension_force", sums.tension_force);
    visit("tension_force_deviation", sums.tension_force_deviation);
    visit("pressure_force", sums.pressure_force);
    visit("pressure_force_deviation", sums.pressure_force_deviation);
}

std::string program_name() {
    return std::string("meniscus ") + program_version;
}

const std::string& provenance_text(const Snapshot& snapshot, const char* name) {
    const auto entry = snapshot.provenance.find(name);
    if (entry == snapshot.provenance.end())
        throw InputError(std::string("is no checkpoint: it has no '") + name + "'" + advice);
    return entry->second;
}

/// Where two JSON texts first differ, and how: "/duration was 2.0, is 1.0".
std::string first_difference(const std::string& before, const std::string& now) {
    Json was;
    try {
        was = parse_json(before, "", "");
    } catch (const InputError&) {
        return "its scene cannot be read";
    }
    const Json is = parse_json(now, "", "");
    const Json changes = Json::diff(was, is);
    if (changes.empty())
        return "its scene is written in another way";
    const Json::json_pointer place(changes[0]["path"].get<std::string>());
    const auto shown = [&](const Json& json) {
        return json.contains(place)
                   ? json[place].dump(-1, ' ', true, Json::error_handler_t::replace)
                   : std::string("not there");
    };
    return quoted_text(place.to_string()) + " was " + quoted_text(shown(was)) + " and is " +
           quoted_text(shown(is));
}

void add_text(Sha256& sum, const std::string& text) {
    const std::string length = std::to_string(text.size()) + ":"; // where one text ends
    sum.add(length.data(), length.size());
    sum.add(text.data(), text.size());
}

void check_content(const Snapshot& snapshot) {
    if (content_sum(snapshot) != provenance_text(snapshot, sum_name))
        throw InputError("is damaged: its content has not the SHA-256 that it was written with" +
                         std::string(advice));
}

/// The duration of the scene before; nothing where the scenes differ otherwise than by a longer
/// one.
std::optional<double> shorter_duration(const std::string& before, const std::string& now) {
    auto was = Json::parse(before, nullptr, false);
    const auto is = Json::parse(now, nullptr, false);
    if (!was.is_object() || !is.is_object() || !was.contains("duration") ||
        !was["duration"].is_number() || !is.contains("duration"))
        return {};
    const auto duration = was["duration"].get<double>();
    was["duration"] = is["duration"];
    if (was != is || !(duration <= is["duration"].get<double>()))
        return {};
    return duration;
}

/// Returns the duration of the checkpoint's scene.
double check_origin(const Snapshot& snapshot, const std::string& text) {
    if (provenance_text(snapshot, "program") != program_name())
        throw InputError("was made by " + quoted_text(provenance_text(snapshot, "program")) +
                         ", and this is " + program_name() +
                         ", whose steps may differ; go on with that version" + advice);
    check_content(snapshot);
    const std::string& before = provenance_text(snapshot, "scene_text");
    const auto duration = shorter_duration(before, text);
    if (!duration)
        throw InputError("belongs to another scene: " + first_difference(before, text) + advice);
    return *duration;
}

void read_number_of(const JsonReader& reader, const char* key, std::uint64_t& value) {
    value = reader.count(key);
}

void read_number_of(const JsonReader& reader, const char* key, double& value) {
    value = reader.number(key, -max_number, max_number);
}

template <class Value>
const std::vector<Value>& values_of(const Snapshot& snapshot, const char* name, int components) {
    const PointArray* array = find_array(snapshot, name);
    const auto* values =
        array == nullptr ? nullptr : std::get_if<std::vector<Value>>(&array->values);
    if (values == nullptr || array->components != components)
        throw InputError(std::string("is no checkpoint: it has no array '") + name +
                         "' of the right type" + advice);
    return *values;
}

SimulationState state_of(const Snapshot& snapshot) {
    SimulationState state;
    state.time = snapshot.time.value_or(0);
    state.ids = values_of<std::uint32_t>(snapshot, "id", 1);
    state.positions = snapshot.positions;
    const auto& velocities = values_of<double>(snapshot, "velocity", 3);
    for (std::size_t i = 0; i < snapshot.size(); ++i)
        state.velocities.push_back(
            {velocities[3 * i], velocities[3 * i + 1], velocities[3 * i + 2]});
    state.pressures = values_of<double>(snapshot, "solver_pressure", 1);
    state.divergences = values_of<double>(snapshot, "solver_divergence", 1);
    return state;
}

Snapshot readable(const std::filesystem::path& file) {
    try {
        return read_vtkhdf(file);
    } catch (const InputError& error) {
        throw InputError(error.what() + std::string(advice));
    }
}

} // namespace

// HDF5 has sums of its own only for arrays that it compresses, and none for texts. The order of
// arrays does not matter.
std::string content_sum(const Snapshot& snapshot) {
    Sha256 sum;
    for (const auto& [name, text] : snapshot.provenance)
        if (name != sum_name) {
            add_text(sum, name);
            add_text(sum, text);
        }
    const double time = snapshot.time.value_or(0);
    sum.add(&time, sizeof time);
    sum.add(snapshot.positions.data(), snapshot.size() * sizeof(Place));
    std::vector<std::string> names;
    for (const PointArray& array : snapshot.point_data)
        names.push_back(array.name);
    std::sort(names.begin(), names.end());
    for (const std::string& name : names) {
        add_text(sum, name);
        std::visit(
            [&](const auto& values) { sum.add(values.data(), values.size() * sizeof values[0]); },
            find_array(snapshot, name)->values);
    }
    return sum.text();
}

void write_checkpoint(const Checkpoint& checkpoint, const Scene& scene, const std::string& text,
                      const std::filesystem::path& file) {
    Snapshot snapshot;
    snapshot.dimension = scene.dimension;
    snapshot.support_radius = scene.support_radius;
    snapshot.particle_spacing = scene.particle_spacing;
    snapshot.particle_volume = particle_volume(scene);
    snapshot.scene = scene.name;
    const SimulationState& state = checkpoint.state;
    snapshot.time = state.time;
    snapshot.positions = state.positions;
    std::vector<double> velocities;
    velocities.reserve(3 * state.velocities.size());
    for (const Place& velocity : state.velocities)
        velocities.insert(velocities.end(), velocity.begin(), velocity.end());
    set_array(snapshot, {"id", 1, state.ids});
    set_array(snapshot, {"velocity", 3, std::move(velocities)});
    set_array(snapshot, {"solver_pressure", 1, state.pressures});
    set_array(snapshot, {"solver_divergence", 1, state.divergences});
    Json numbers;
    each_number(checkpoint, [&](const char* key, auto value) { numbers[key] = value; });
    snapshot.provenance = {{"program", program_name()},
                           {"scene_text", text},
                           {"run", numbers.dump()},
                           {"log", checkpoint.log}};
    snapshot.provenance[sum_name] = content_sum(snapshot);
    write_vtkhdf(snapshot, file);
}

Checkpoint checkpoint_in(const Snapshot& snapshot, const std::string& text,
                         const std::filesystem::path& file) {
    Checkpoint checkpoint;
    checkpoint.duration = check_origin(snapshot, text);
    checkpoint.state = state_of(snapshot);
    const Json numbers =
        parse_json(provenance_text(snapshot, "run"), file.string(), "the state of a run");
    const JsonReader reader(numbers, file.string(), "");
    each_number(checkpoint,
                [&](const char* key, auto& value) { read_number_of(reader, key, value); });
    checkpoint.log = provenance_text(snapshot, "log");
    return checkpoint;
}

Checkpoint read_checkpoint(const std::filesystem::path& file, const std::string& text) {
    return naming_file(file, [&] { return checkpoint_in(readable(file), text, file); });
}

} // namespace meniscus
