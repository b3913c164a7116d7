// A study holds what this project does against published or exact figures. It is a folder of
// validation/ with
//     study.json      title, and for each size its axes; a run for each combination of their values
//     reference.json  the published or exact figures, each with its source
//     small.json, paper.json   the results of those sizes, written by the program
// and a source file that measures a run, and makes tables of all runs. A run is independent of the
// others, so that a study which is stopped goes on with those that are missing.
#pragma once

#include "support/table.hpp"

#include <meniscus/data/json/json_reader.hpp>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace meniscus {

/// One run of a study, as the values of the axes make it.
struct StudyRun {
    std::string name;                                        ///< of its files
    std::vector<std::pair<std::string, std::string>> labels; ///< axis and value
    std::map<std::string, double> numbers;                   ///< for the study's own code
    std::filesystem::path scene;                             ///< file; empty: the study needs none
    std::string variant;
    std::vector<std::string> changes; ///< of the scene, as read_scene() takes them
};

/// A size of a study.
struct StudyPlan {
    std::string title;
    std::vector<StudyRun> runs;
    /// How far a figure may be from that of a committed result, in its own unit; others are not
    /// compared.
    std::map<std::string, double> compared;
};

/// The plan of the study in that folder; `size` is "small" or "paper". A scene is a file (*.json)
/// relative to the folder, or the name of one in the folder `scenes`. Throws InputError, naming
/// file and key, where one is unknown, missing or wrong.
StudyPlan read_plan(const std::filesystem::path& folder, const std::string& size,
                    const std::filesystem::path& scenes);

/// Where a run works, and when it is to stop.
struct Workplace {
    std::filesystem::path folder; ///< of this run alone; exists
    int threads = 0;              ///< 0: all cores
    std::function<bool()> stop = [] { return false; };
    /// Makes a state that the run has written its picture.
    std::function<void(const std::filesystem::path& frame)> draw = [](const auto&) {};
};

/// Thrown by a measurement that was told to stop: what it has done is kept.
struct Stopped {};

/// A result: {"study", "size", "program", "machine", "threads", "hours", "peak_memory_mib",
/// "runs": [{"labels", "settings", "figures", "seconds", "peak_memory_mib"}]}, memory being the
/// most that the process had taken by then. Figures are by name numbers, lists of numbers, or one
/// text "failure".
struct Study {
    const char* name; ///< of its folder
    const char* help; ///< half a sentence
    /// The figures of a run. Throws Stopped.
    Json (*measure)(const StudyRun& run, const Workplace& place);
    /// Of a result, beside the reference.
    std::vector<Table> (*tables)(const Json& result, const Json& reference);
    /// What is drawn and not printed; none where it is nullptr.
    std::vector<Table> (*plots)(const Json& result) = nullptr;
};

} // namespace meniscus
