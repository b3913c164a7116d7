#include "run_study.hpp"

#include "support/memory.hpp"
#include "support/timing.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/threads/threads.hpp>
#include <meniscus/runtime/version.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

std::string program_name() {
    return std::string("meniscus ") + program_version;
}

/// What a run is made from.
Json settings_of(const StudyRun& run) {
    Json settings = {{"program", program_name()}};
    if (!run.scene.empty())
        settings["scene"] = {{"file", run.scene.filename().string()},
                             {"sha256", file_hash(run.scene)},
                             {"variant", run.variant},
                             {"changes", run.changes}};
    settings["numbers"] = run.numbers;
    return settings;
}

Json labels_of(const StudyRun& run) {
    Json labels = Json::object();
    for (const auto& [axis, value] : run.labels)
        labels[axis] = value;
    return labels;
}

/// The values of its axes.
std::string title_of(const StudyRun& run) {
    std::string title;
    for (const auto& [axis, value] : run.labels)
        title += fmt::format("{}{} {}", title.empty() ? "" : ", ", axis, value);
    return title;
}

/// What the file has of the run, where it is of these settings.
std::optional<Json> kept(const fs::path& file, const Json& settings) {
    if (!fs::exists(file))
        return {};
    Json run = parse_json(read_whole(file), file.string(), "a run of a study");
    if (!run.is_object() || !run.contains("settings") || !run.contains("figures"))
        throw InputError(file.string() + ": is no run of a study; move it away");
    return run["settings"] == settings ? std::optional<Json>(run) : std::nullopt;
}

Json measured(const Study& study, const StudyRun& run, const Json& settings,
              const StudyOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    Workplace place{options.work / run.name, options.threads, options.stop};
    if (options.draw)
        place.draw = [&](const fs::path& frame) {
            options.draw(frame, picture_file(run, options.work), title_of(run));
        };
    fs::create_directories(place.folder);
    const Json figures = study.measure(run, place);
    if (!options.keep_frames)
        fs::remove_all(place.folder);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return {{"labels", labels_of(run)},
            {"settings", settings},
            {"figures", figures},
            {"seconds", std::round(10 * passed.count()) / 10},
            {"peak_memory_mib", std::round(peak_bytes() / (1 << 20))}};
}

const Json* run_of(const Json& result, const Json& labels) {
    for (const Json& run : result.at("runs"))
        if (run.at("labels") == labels)
            return &run;
    return nullptr;
}

void compare(const std::string& name, const Json& figures, const Json& committed,
             const StudyPlan& plan, std::vector<std::string>& lines) {
    if (figures.contains("failure") != committed.contains("failure")) {
        lines.push_back(name + (figures.contains("failure") ? " failed and did not before"
                                                            : " failed before and did not now"));
        return;
    }
    for (const auto& [figure, within] : plan.compared) {
        const bool is_there = figures.contains(figure) && figures[figure].is_number();
        const bool was_there = committed.contains(figure) && committed[figure].is_number();
        if (is_there != was_there) {
            lines.push_back(fmt::format("{} has {} '{}'", name, is_there ? "a new" : "no", figure));
            continue;
        }
        if (!is_there)
            continue;
        const double now = figures[figure];
        const double before = committed[figure];
        if (!(std::abs(now - before) <= within))
            lines.push_back(fmt::format("{}: {} is {:.6g}, was {:.6g}, expected within {:g}", name,
                                        figure, now, before, within));
    }
}

} // namespace

fs::path picture_file(const StudyRun& run, const fs::path& work) {
    return work / (run.name + ".png");
}

Json run_study(const Study& study, const StudyPlan& plan, const StudyOptions& options) {
    Json runs = Json::array();
    double seconds = 0;
    double memory = 0;
    for (std::size_t n = 0; n < plan.runs.size(); ++n) {
        const StudyRun& run = plan.runs[n];
        const fs::path file = options.work / (run.name + ".json");
        const Json settings = settings_of(run);
        std::optional<Json> done = kept(file, settings);
        if (!done) {
            if (options.on_run)
                options.on_run(run, n + 1, plan.runs.size());
            done = measured(study, run, settings, options);
            write_whole(file, done->dump(1) + "\n");
        }
        seconds += (*done)["seconds"].get<double>();
        memory = std::max(memory, done->value("peak_memory_mib", 0.0));
        runs.push_back(*done);
    }
    return {{"study", study.name},
            {"size", options.size},
            {"title", plan.title},
            {"program", program_name()},
            {"machine", Json::parse(machine().dump())},
            {"threads", thread_count(options.threads)},
            {"hours", seconds / 3600},
            {"peak_memory_mib", memory},
            {"runs", runs}};
}

std::vector<std::string> differences(const Json& result, const Json& committed,
                                     const StudyPlan& plan) {
    std::vector<std::string> lines;
    for (const StudyRun& run : plan.runs) {
        const Json labels = labels_of(run);
        const Json* now = run_of(result, labels);
        const Json* before = run_of(committed, labels);
        if (now == nullptr || before == nullptr)
            lines.push_back(run.name + " is in one of the results alone");
        else
            compare(run.name, now->at("figures"), before->at("figures"), plan, lines);
    }
    return lines;
}

} // namespace meniscus
