#include "frame_series.hpp"

#include "input_files.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/json/json_reader.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <map>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

struct InNaturalOrder {
    bool operator()(const std::string& a, const std::string& b) const { return is_before(a, b); }
};

/// Times by the frames' names.
using Times = std::map<std::string, double, InNaturalOrder>;

/// Where the number of a frame begins in its stem; its end where it has none.
std::size_t number_place(const std::string& stem) {
    const std::size_t last = stem.find_last_not_of("0123456789");
    return last == std::string::npos ? stem.size() : last + 1;
}

/// "dam" of dam_7.vtkhdf; empty where there is no number, or nothing but one.
std::string name_of_frames(const Path& file) {
    const std::string stem = file.stem().string();
    std::string name = stem.substr(0, number_place(stem));
    if (name.size() == stem.size())
        return {};
    while (!name.empty() && (name.back() == '_' || name.back() == '-' || name.back() == '.'))
        name.pop_back();
    return name;
}

/// What an earlier file lists; nothing where it is not there or cannot be understood.
Times earlier_times(const Path& series) {
    Times times;
    if (!fs::exists(series))
        return times;
    const Json json = Json::parse(read_whole(series), nullptr, false);
    if (!json.is_object() || !json.contains("files") || !json["files"].is_array())
        return times;
    for (const Json& entry : json["files"])
        if (entry.is_object() && entry.contains("name") && entry["name"].is_string() &&
            entry.contains("time") && entry["time"].is_number())
            times[entry["name"]] = entry["time"];
    return times;
}

double time_of(const Path& frame) {
    const std::string stem = frame.stem().string();
    return read_vtkhdf_header(frame).time.value_or(
        number_from_text(stem.substr(number_place(stem))).value_or(0));
}

void write_one(const Path& series, const std::vector<Path>& frames) {
    Times times = earlier_times(series);
    const Path folder = series.parent_path();
    const auto written = times.empty() ? fs::file_time_type::min() : fs::last_write_time(series);
    for (auto entry = times.begin(); entry != times.end();)
        entry = fs::exists(folder / entry->first) ? std::next(entry) : times.erase(entry);
    for (const Path& frame : frames) {
        const std::string name = frame.filename().string();
        if (times.count(name) != 0 && fs::last_write_time(frame) < written)
            continue;
        try {
            times[name] = time_of(frame);
        } catch (const InputError&) { // damaged, which a run may go on without
            times.erase(name);
        }
    }
    Json files = Json::array();
    for (const auto& [name, time] : times)
        files.push_back({{"name", name}, {"time", time}});
    const std::string text = Json{{"file-series-version", "1.0"}, {"files", files}}.dump(
                                 1, ' ', true, Json::error_handler_t::replace) +
                             "\n";
    if (files.size() >= 2 && (!fs::exists(series) || read_whole(series) != text))
        write_whole(series, text);
}

} // namespace

void write_frame_series(const std::vector<Path>& files) {
    std::map<Path, std::vector<Path>> frames_of;
    for (const Path& file : files)
        if (const std::string name = name_of_frames(file); !name.empty() && fs::exists(file))
            frames_of[file.parent_path() / (name + ".vtkhdf.series")].push_back(file);
    for (const auto& [series, frames] : frames_of)
        write_one(series, frames);
}

} // namespace meniscus
